// The result of each fragment of a triangle is counted.
#include <glassbox/render/trace/verdict.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glassbox/raster/depth.h>
#include <glassbox/render/staged/staged.h>

#include "tests/render/checked_verdict.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// 28 pixels: the half square 8 px wide at (8, 8) contains 8 * 9 / 2 = 36 centres, less the 8 on its
// long edge, which it does not own.
constexpr std::uint32_t kHalfSquare = 28;

TEST_CASE("why: visible, where and in how many pixels") {
  const TriangleVerdict verdict = checked_verdict(half_square(8, 8, 8));
  CHECK(verdict.result == TriangleResult::kVisible);
  CHECK(verdict.fragments.covered == kHalfSquare);
  CHECK(verdict.fragments.visible == kHalfSquare);
  CHECK(verdict.details.visible_box.x0 == 8);
  CHECK(verdict.details.visible_box.y0 == 8);
  CHECK(verdict.details.visible_box.x1 == 15);
  CHECK(verdict.details.visible_box.y1 == 15);
  REQUIRE(verdict.details.example);
  CHECK((*verdict.details.example)[0] == 11);
  CHECK((*verdict.details.example)[1] == 11);
}

TEST_CASE("why: hidden, behind what and how close") {
  const Scene scene = scene_of_parts({{half_square(0, 0, 60), flat_material(), {}},
                                      {half_square(8, 8, 8, 2), flat_material(), {}}});
  const TriangleVerdict verdict = checked_verdict(scene, 1);
  CHECK(verdict.result == TriangleResult::kHidden);
  CHECK(verdict.fragments.hidden == kHalfSquare);
  REQUIRE(verdict.details.hidden_by.size() == 1);
  CHECK(verdict.details.hidden_by[0].number == 0u);
  CHECK(verdict.details.hidden_by[0].pixels == kHalfSquare);
  const auto& closest = *verdict.details.closest_hidden;
  CHECK(closest.stored == depth_code(DepthFormat::kFloat32, 0));  // on the near plane
  CHECK(closest.code == depth_code(DepthFormat::kFloat32, 1));    // on the far plane
  CHECK(closest.distance == 2);
  CHECK(closest.stored_distance == 1);
  CHECK(closest.by == 0u);

  // The same triangle twice: of equal depths, the first one drawn stays (C-58).
  const TriangleVerdict twin =
      checked_verdict(scene_of_parts({{half_square(8, 8, 8), flat_material(), {}},
                                      {half_square(8, 8, 8), flat_material(), {}}}),
                      1);
  CHECK(twin.result == TriangleResult::kHidden);
  CHECK(twin.details.closest_hidden->code == twin.details.closest_hidden->stored);
  CHECK(contains(explanation_text(plain_view(), twin), "the first one drawn stays"));
}

TEST_CASE("why: discarded by the alpha cutoff") {
  Material material = flat_material({1, 1, 1, 0.25f}, AlphaMode::kMask);
  material.alpha_cutoff = 0.375f;
  const TriangleVerdict verdict =
      checked_verdict(scene_of_parts({{half_square(8, 8, 8), material, {}}}));
  CHECK(verdict.result == TriangleResult::kDiscarded);
  CHECK(verdict.fragments.discarded == kHalfSquare);
  CHECK(verdict.details.closest_discarded->alpha == 0.25f);
  CHECK(verdict.details.closest_discarded->cutoff == 0.375f);
}

TEST_CASE("why: written, then overwritten, by whom") {
  const TriangleVerdict verdict =
      checked_verdict(scene_of_parts({{half_square(8, 8, 8, 2), flat_material(), {}},
                                      {half_square(0, 0, 60), flat_material(), {}}}));
  CHECK(verdict.result == TriangleResult::kOverwritten);
  CHECK(verdict.fragments.overwritten == kHalfSquare);
  REQUIRE(verdict.details.overwritten_by.size() == 1);
  CHECK(verdict.details.overwritten_by[0].number == 1u);
  CHECK(verdict.details.overwritten_by[0].pixels == kHalfSquare);
  CHECK(verdict.details.overwritten_at);

  // A blended surface of alpha 1 hides all that is behind it; one of smaller alpha does not.
  for (const float alpha : {1.0f, 0.75f}) {
    const TriangleVerdict under = checked_verdict(scene_of_parts(
        {{half_square(8, 8, 8, 2), flat_material(), {}},
         {half_square(0, 0, 60), flat_material({1, 0, 0, alpha}, AlphaMode::kBlend), {}}}));
    CHECK(under.result ==
          (alpha == 1.0f ? TriangleResult::kOverwritten : TriangleResult::kVisible));
    CHECK(under.fragments.under_translucent == (alpha == 1.0f ? 0 : kHalfSquare));
  }
}

TEST_CASE("why: nothing passes the colour mask") {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  const TriangleVerdict verdict = checked_verdict(half_square(8, 8, 8), plain_view(), settings);
  CHECK(verdict.result == TriangleResult::kMasked);
  CHECK(verdict.fragments.masked == kHalfSquare);
  settings.mask.g = true;
  CHECK(checked_verdict(half_square(8, 8, 8), plain_view(), settings).result ==
        TriangleResult::kVisible);
}

TEST_CASE("why: blended with alpha 0, or painted in the background's own bytes") {
  const TriangleVerdict clear = checked_verdict(
      scene_of_parts({{half_square(8, 8, 8), flat_material({1, 1, 1, 0}, AlphaMode::kBlend), {}}}));
  CHECK(clear.result == TriangleResult::kUnchanged);
  CHECK(clear.fragments.unchanged == kHalfSquare);
  CHECK(clear.details.unchanged->blended);
  CHECK(clear.details.unchanged->alpha == 0);

  RenderSettings settings;
  settings.background = {255, 255, 255, 255};
  const TriangleVerdict white =
      checked_verdict(scene_of_parts({{half_square(8, 8, 8), flat_material({1, 1, 1, 1}), {}}}), 0,
                      plain_view(), settings);
  CHECK(white.result == TriangleResult::kUnchanged);
  CHECK(!white.details.unchanged->blended);
  CHECK(white.details.unchanged->bytes == settings.background);
}

TEST_CASE("why: partly visible, each loss counted") {
  // The first strip is in front of two rows and is drawn before; the last one is drawn later, over
  // the first column.
  const auto strip = [](double x0, double y0, double x1, double y1, double w) {
    return std::vector<Point<Object>>{point_at_pixel(x0, y0, w), point_at_pixel(x0, y1, w),
                                      point_at_pixel(x1, y0, w), point_at_pixel(x1, y0, w),
                                      point_at_pixel(x0, y1, w), point_at_pixel(x1, y1, w)};
  };
  const Scene scene = scene_of_parts({{strip(8, 8, 16, 10, 1), flat_material(), {}},
                                      {half_square(8, 8, 8, 2), flat_material({1, 0, 0, 1}), {}},
                                      {strip(8, 10, 9, 16, 1), flat_material(), {}}});
  const TriangleVerdict verdict = checked_verdict(scene, 2);
  CHECK(verdict.result == TriangleResult::kPartlyVisible);
  CHECK(verdict.fragments.covered == kHalfSquare);
  CHECK(verdict.fragments.hidden == 7 + 6);
  CHECK(verdict.fragments.overwritten == 5);
  CHECK(verdict.fragments.visible == kHalfSquare - 18);
  std::uint32_t hidden = 0;
  for (const Occluder& occluder : verdict.details.hidden_by) {
    CHECK((occluder.number == 0u || occluder.number == 1u));
    hidden += occluder.pixels;
  }
  CHECK(hidden == 13);
  CHECK(verdict.details.hidden_by.front().pixels >= verdict.details.hidden_by.back().pixels);
}

TEST_CASE("why: lines and points hide triangles without a number") {
  Scene scene = scene_of_parts({{half_square(8, 8, 8, 2), flat_material(), {}}});
  Mesh lines;
  lines.positions = {point_at_pixel(0.5, 10.5, 1), point_at_pixel(60.5, 10.5, 1)};
  lines.lines = {{Corner{0}, Corner{1}}};
  scene.meshes.push_back(lines);
  scene.instances.push_back({1, 0});
  const TriangleVerdict verdict = checked_verdict(scene);
  CHECK(verdict.result == TriangleResult::kPartlyVisible);
  REQUIRE(verdict.details.overwritten_by.size() == 1);
  CHECK(!verdict.details.overwritten_by[0].number);
  CHECK(contains(explanation_text(plain_view(), verdict), "lines or points"));
}

TEST_CASE("why: in a wireframe, edges are seen") {
  RenderSettings settings;
  settings.wireframe = true;
  const TriangleVerdict verdict = checked_verdict(half_square(8, 8, 8), plain_view(), settings);
  CHECK(verdict.result == TriangleResult::kLines);
  settings.want_id = true;
  const auto ids = render_staged(scene_of_parts({{half_square(8, 8, 8), flat_material(), {}}}),
                                 plain_view(), settings)
                       .buffers.id;
  CHECK(verdict.line_pixels == std::uint64_t(std::count(ids.pixels.begin(), ids.pixels.end(), 1u)));
  CHECK(verdict.line_pixels >= 21);
  CHECK(
      checked_verdict(with_reversed_winding(half_square(8, 8, 8)), plain_view(), settings).result ==
      TriangleResult::kTurnedAway);
}

TEST_CASE("why: a triangle through the eye plane is cut, and what is left is judged (C-32)") {
  const TriangleVerdict verdict = checked_verdict({{0, 0.5f, -1.5f}, {-1, -1, 1}, {1, -1, 1}});
  CHECK(verdict.traced->polygon.size() == 3);
  CHECK(verdict.result == TriangleResult::kVisible);
  CHECK(checked_verdict({{0, 0.5f, -1.5f}, {1, -1, 1}, {-1, -1, 1}}).result ==
        TriangleResult::kTurnedAway);
}

}  // namespace
}  // namespace glassbox::test
