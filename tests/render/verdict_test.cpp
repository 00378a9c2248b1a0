// What became of a triangle: one constructed scene for each way in which triangles are lost, with the number that
// decides.
#include <glassbox/render/trace/verdict.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/staged.h>
#include <glassbox/render/trace/verdict_json.h>
#include <glassbox/render/trace/verdict_text.h>

#include <nlohmann/json.hpp>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// ---- a view whose every step is exact ----

// 64 x 64 pixels from the origin down -z, 90 degrees wide: screen x = 32 + 32 x/w, y = 32 - 32 y/w with w = -z, and with
// near 1 and far 2 clip z = 2 w - 2.
constexpr int kSide = 64;

View plain_view(double near = 1, double far = 2) {
  const auto view =
      make_view({"", FrustumLens{-near, near, -near, near, near, far}, {}}, kSide, kSide);
  REQUIRE(view);
  return *view;
}

// The point at the distance w that is drawn at (x, y) pixels. Exact for multiples of 1/256 px and powers of two.
Point<Object> at(double x, double y, double w = 1) {
  return {float((x - 32) / 32 * w), float((32 - y) / 32 * w), float(-w)};
}

Material flat(const Rgba& color = {0.8f, 0.5f, 0.2f, 1}, AlphaMode mode = AlphaMode::kOpaque) {
  Material material;
  material.base_color = color;
  material.alpha_mode = mode;
  material.unlit = true;
  return material;
}

struct Part {
  std::vector<Point<Object>> corners;  // three for each triangle
  Material material = flat();
  Transform<World, Object> world_from_object;
};

// Parts are instances in this order, each with a mesh of its own.
Scene scene_of_parts(const std::vector<Part>& parts) {
  Scene scene;
  for (const Part& part : parts) {
    Mesh mesh;
    mesh.name = "part " + std::to_string(scene.meshes.size());
    mesh.positions = part.corners;
    for (std::uint32_t i = 0; i + 2 < part.corners.size(); i += 3) {
      add_face(mesh, {i, i + 1, i + 2});
    }
    mesh.material = std::uint32_t(scene.materials.size());
    scene.materials.push_back(part.material);
    const std::uint32_t index = std::uint32_t(scene.meshes.size());
    scene.nodes.push_back(Node{"", kNone, part.world_from_object, part.world_from_object});
    scene.instances.push_back({index, index});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

// Counter-clockwise as seen: front. Half a square of `side` px with its right angle at (x, y).
std::vector<Point<Object>> half_square(double x, double y, double side, double w = 1) {
  return {at(x, y, w), at(x, y + side, w), at(x + side, y, w)};
}

std::vector<Point<Object>> turned(const std::vector<Point<Object>>& corners) {
  return {corners[0], corners[2], corners[1]};
}

TriangleVerdict judged(const Scene& scene, std::uint64_t number = 0,
                       const View& view = plain_view(), const RenderSettings& settings = {}) {
  const auto verdict = triangle_verdict(scene, view, settings, number);
  REQUIRE(verdict);
  // What is said holds in every form, and the summary agrees.
  CHECK(!explain(view, *verdict).empty());
  CHECK(to_json(*verdict)["end"] == name_of(verdict->end));
  const SceneVerdict whole = scene_verdict(scene, view, settings);
  CHECK(whole.triangles == count_triangles(scene));
  CHECK(whole.at(verdict->end).triangles > 0);
  return *verdict;
}

TriangleVerdict judged(const std::vector<Point<Object>>& corners, const View& view = plain_view(),
                       const RenderSettings& settings = {}) {
  return judged(scene_of_parts({{corners, flat(), {}}}), 0, view, settings);
}

std::string said(const View& view, const TriangleVerdict& verdict) {
  std::string all;
  for (const std::string& paragraph : explain(view, verdict)) all += paragraph + "\n";
  return all;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// ---- assembly and vertices ----

TEST_CASE("why: a number that does not exist is refused, with how many there are") {
  const Scene two =
      scene_of_parts({{half_square(10, 10, 8), flat(), {}}, {half_square(30, 10, 8), flat(), {}}});
  const auto refused = triangle_verdict(two, plain_view(), {}, 2);
  REQUIRE(!refused);
  CHECK(contains(refused.error().message(), "2 triangles, 0 .. 1"));
  CHECK(!triangle_verdict(two, plain_view(), {}, std::uint64_t(1) << 32));
  const auto none = triangle_verdict(scene_of_parts({}), plain_view(), {}, 0);
  REQUIRE(!none);
  CHECK(contains(none.error().message(), "no triangles"));
}

TEST_CASE("why: no area as modelled (C-24, C-25)") {
  const TriangleVerdict repeated = judged({at(10, 10), at(10, 20), at(10, 10)});
  CHECK(repeated.end == End::kNoArea);
  CHECK(repeated.no_area->reason == NoArea::kRepeatedPosition);
  CHECK(repeated.no_area->corners.size() == 3);
  CHECK(!repeated.traced);

  const TriangleVerdict line = judged({at(10, 10), at(20, 20), at(40, 40)});
  CHECK(line.end == End::kNoArea);
  CHECK(line.no_area->reason == NoArea::kCollinear);

  Mesh bow_tie;
  bow_tie.positions = {at(10, 10), at(20, 20), at(20, 10), at(10, 20)};
  add_face(bow_tie, {0, 1, 2, 3});
  for (const std::uint64_t number : {std::uint64_t(0), std::uint64_t(1)}) {
    const TriangleVerdict crossed = judged(scene_of(bow_tie, flat()), number);
    CHECK(crossed.end == End::kNoArea);
    CHECK(crossed.no_area->reason == NoArea::kWholeFace);
    CHECK(crossed.no_area->corners.size() == 4);
  }
}

TEST_CASE("why: a corner that overflows on the way to clip space") {
  // Four times as narrow: clip x = 4 x.
  const auto view =
      make_view({"", FrustumLens{-0.25, 0.25, -0.25, 0.25, 1, 2.0}, {}}, kSide, kSide);
  REQUIRE(view);
  const TriangleVerdict verdict = judged({{0, 0, -1}, {3e38f, 0, -1}, {0, 1, -1}}, *view);
  CHECK(verdict.end == End::kNotFinite);
  CHECK(std::isinf(verdict.traced->corners[1].clip.x));
  CHECK(contains(said(*view, verdict), "inf"));
}

// ---- clip ----

TEST_CASE("why: behind the eye, every w negative; and in its plane (C-34)") {
  const TriangleVerdict behind = judged({{0, 0, 1}, {1, 0, 2}, {0, 1, 3}});
  CHECK(behind.end == End::kBehindEye);
  CHECK(behind.clipping->corners[0].clip.w == -1);
  CHECK(behind.clipping->corners[1].clip.w == -2);
  CHECK(behind.clipping->corners[2].clip.w == -3);
  CHECK(!behind.clipping->corners[0].screen);
  CHECK(contains(said(plain_view(), behind), "Every w is negative: w = -1, -2 and -3"));
  CHECK(!behind.conventions.hands_mixed);

  const TriangleVerdict in_plane = judged({{0, 0, 0}, {1, 0, 0}, {0, 1, 3}});
  CHECK(in_plane.end == End::kBehindEye);
  CHECK(contains(said(plain_view(), in_plane), "No w is positive"));
}

TEST_CASE("why: all corners nearer than the near plane, or further than the far one") {
  const TriangleVerdict near = judged({{0, 0, -0.25f}, {1, 0, -0.5f}, {0, 1, -0.75f}});
  CHECK(near.end == End::kOutsidePlane);
  CHECK(std::string(near.clipping->equation.name) == "near");
  CHECK(near.clipping->corners[0].inside == -1.5);  // z = 2 w - 2
  CHECK(near.clipping->corners[1].inside == -1);
  CHECK(near.clipping->corners[2].inside == -0.5);
  CHECK(near.clipping->corners[0].along_gaze == 0.25);
  CHECK(!near.clipping->inside_opengl_depth);
  CHECK(contains(said(plain_view(), near),
                 "near plane, which is at 1 along the gaze: they are at 0.25, 0.5 and 0.75"));

  const TriangleVerdict far = judged({{0, 0, -3}, {1, 0, -4}, {0, 1, -5}});
  CHECK(far.end == End::kOutsidePlane);
  CHECK(std::string(far.clipping->equation.name) == "far");
  CHECK(far.clipping->corners[0].inside == -1);  // w - z = 2 - w
  CHECK(far.clipping->corners[2].inside == -3);
  CHECK(contains(said(plain_view(), far), "--far 5.05"));
}

TEST_CASE("why: beyond the guard band on one side (C-40)") {
  const TriangleVerdict verdict = judged({{2000, 0, -1}, {2001, 0, -1}, {2000, 1, -1}});
  CHECK(verdict.end == End::kOutsidePlane);
  CHECK(std::string(verdict.clipping->equation.name) == "guard band, right");
  CHECK(verdict.clipping->corners[0].inside == 65536 - 64 * 2000);
  REQUIRE(verdict.clipping->corners[0].screen);
  CHECK(verdict.clipping->corners[0].screen->x == 32 + 32 * 2000);
  CHECK(contains(said(plain_view(), verdict), "right of the picture"));
}

TEST_CASE("why: no single plane, but several together leave nothing") {
  // What the near plane leaves has x >= 1800 at w >= 1, and the guard band ends at 1024 w.
  const TriangleVerdict verdict = judged({{3000, 0, -1.5f}, {-3000, 100, 1}, {-3000, 0, 1}});
  CHECK(verdict.end == End::kClippedAway);
  const std::vector<ClipCount>& steps = verdict.clipping->steps;
  REQUIRE(steps.size() == 5);
  CHECK(std::string(steps[0].plane) == "near");
  CHECK(steps[0].vertices_left == 3);
  CHECK(std::string(steps[4].plane) == "guard band, right");
  CHECK(steps[4].vertices_left == 0);
  CHECK(verdict.clipping->plane == 4);
  CHECK(contains(said(plain_view(), verdict), "the guard band, right plane leaves nothing"));
}

// ---- setup and cull ----

TEST_CASE("why: no area after snapping (C-49)") {
  // 1/1024 px is a quarter of a step.
  constexpr double kTiny = 1.0 / 1024;
  const TriangleVerdict point =
      judged({at(10.5, 10.5), at(10.5, 10.5 + kTiny), at(10.5 + kTiny, 10.5)});
  CHECK(point.end == End::kNoScreenArea);
  CHECK(point.no_screen_area->area_px2 == kTiny * kTiny / 2);
  for (const SnappedVertex& vertex : point.no_screen_area->snapped) {
    CHECK(vertex == SnappedVertex{2688, 2688});
  }
  CHECK(point.pieces_without_area == 1);
  CHECK(contains(said(plain_view(), point), "one point"));

  const TriangleVerdict line = judged({at(10, 10), at(15, 10 + kTiny), at(20, 10)});
  CHECK(line.end == End::kNoScreenArea);
  CHECK(line.no_screen_area->area_px2 == 10 * kTiny / 2);
  CHECK(contains(said(plain_view(), line), "on one line"));
}

TEST_CASE("why: turned away, by the winding, the model's mirror or the setting (E11, E18, C-17)") {
  const std::vector<Point<Object>> front = half_square(8, 8, 16), back = turned(front);
  CHECK(judged(front).end == End::kVisible);

  const TriangleVerdict clockwise = judged(back);
  CHECK(clockwise.end == End::kTurnedAway);
  CHECK(clockwise.cull->area_px2 == -128);
  CHECK(!clockwise.cull->front);
  CHECK(!clockwise.cull->mirrored);
  REQUIRE(clockwise.cull->object_space);
  CHECK(clockwise.cull->object_space->facing == Facing::kBack);
  // (P - eye) . m = -1 * (-2 * 128 px^2 / 32^2).
  CHECK(clockwise.cull->object_space->value == 0.25);
  CHECK(clockwise.pieces_turned_away == 1);

  // A mirroring model turns the winding round, and what is front with it.
  Transform<World, Object> mirror;
  mirror.at(0, 0) = -1;
  const std::vector<Point<Object>> other_half = half_square(40, 8, 16);
  const Scene shown = scene_of_parts({{other_half, flat(), mirror}});
  CHECK(judged(shown).end == End::kVisible);
  const TriangleVerdict mirrored = judged(scene_of_parts({{turned(other_half), flat(), mirror}}));
  CHECK(mirrored.end == End::kTurnedAway);
  CHECK(mirrored.cull->area_px2 == 128);
  CHECK(mirrored.cull->mirrored);
  CHECK(!mirrored.cull->front);
  CHECK(mirrored.cull->object_space->facing == Facing::kBack);
  CHECK(contains(said(plain_view(), mirrored), "the model matrix mirrors"));

  RenderSettings settings;
  settings.cull = Cull::kFront;
  const TriangleVerdict front_culled = judged(front, plain_view(), settings);
  CHECK(front_culled.end == End::kTurnedAway);
  CHECK(front_culled.cull->front);
  CHECK(front_culled.cull->area_px2 == 128);
  CHECK(judged(back, plain_view(), settings).end == End::kVisible);

  Material both = flat();
  both.double_sided = true;
  CHECK(judged(scene_of_parts({{back, both, {}}})).end == End::kVisible);
  settings.cull = Cull::kBack;
  CHECK(judged(scene_of_parts({{back, both, {}}}), 0, plain_view(), settings).end ==
        End::kTurnedAway);
}

TEST_CASE("why: edge-on from the eye's own plane is no area, not a back (C-27)") {
  const TriangleVerdict verdict = judged({{0, 0, -1}, {0.25f, 0, -1.5f}, {-0.25f, 0, -2}});
  CHECK(verdict.end == End::kNoScreenArea);
  CHECK(verdict.no_screen_area->area_px2 == 0);
}

// ---- coverage ----

TEST_CASE("why: beside the picture, on which side and by how much") {
  const TriangleVerdict left = judged(half_square(-20, 10, 7.5));
  CHECK(left.end == End::kOutsidePicture);
  CHECK(left.outside->left == 3200);  // 12.5 px
  CHECK(left.outside->right == 0);
  CHECK(left.outside->top == 0);
  CHECK(left.outside->bottom == 0);
  CHECK(contains(said(plain_view(), left), "12.5 px left of"));

  const TriangleVerdict corner = judged(half_square(70, -9, 4));
  CHECK(corner.outside->right == 6 * 256);
  CHECK(corner.outside->top == 5 * 256);
  CHECK(contains(said(plain_view(), corner), "6 px right of and 5 px above"));

  // Its box reaches in, but its long edge, x + y = 140, passes the corner (64, 64).
  const TriangleVerdict passing = judged({at(90, 50), at(50, 90), at(90, 90)});
  CHECK(passing.end == End::kOutsidePicture);
  REQUIRE(passing.outside->beyond_edge);
  CHECK(*passing.outside->beyond_edge == Approx(256 * 12 / std::sqrt(2.0)).epsilon(1e-15));

  // Through the corner itself: nothing in common but a point.
  const TriangleVerdict touching = judged({at(80, 48), at(48, 80), at(80, 80)});
  CHECK(touching.end == End::kOutsidePicture);
  CHECK(touching.outside->beyond_edge == 0.0);
  CHECK(judged({at(79.5, 48), at(47.5, 80), at(80, 80)}).end == End::kBetweenCentres);
}

TEST_CASE("why: between pixel centres, and by how little it misses one") {
  // Snapped to 2714 .. 2790 in x and y; the centre of pixel (10, 10) is 2688.
  const TriangleVerdict verdict = judged({at(10.6, 10.6), at(10.6, 10.9), at(10.9, 10.6)});
  CHECK(verdict.end == End::kBetweenCentres);
  REQUIRE(verdict.nearest_centre);
  CHECK(verdict.nearest_centre->x == 10);
  CHECK(verdict.nearest_centre->y == 10);
  CHECK(verdict.nearest_centre->subpixels == 26);
  CHECK(verdict.nearest_centre->value == -26 * 76);

  // On the right-hand edge, which belongs to the neighbour (C-43).
  const TriangleVerdict tie = judged({at(10.5, 10.25), at(10.25, 10.5), at(10.5, 10.75)});
  CHECK(tie.end == End::kBetweenCentres);
  CHECK(tie.nearest_centre->x == 10);
  CHECK(tie.nearest_centre->y == 10);
  CHECK(tie.nearest_centre->value == 0);
  CHECK(tie.nearest_centre->subpixels == 0);
  CHECK(contains(said(plain_view(), tie), "belongs to the neighbour"));

  // A sliver of 1/64 px along a row, from end to end: no centre, however long (C-47).
  const TriangleVerdict sliver = judged({at(1, 20.25), at(1, 20.265625), at(60, 20.25)});
  CHECK(sliver.end == End::kBetweenCentres);
  CHECK(sliver.nearest_centre->y == 20);
  CHECK(sliver.nearest_centre->subpixels > 59);  // of 64 to the row's centre
  CHECK(sliver.nearest_centre->subpixels <= 64);
}

// ---- fragments ----

// 36 pixels: the half square 8 px wide at (8, 8) covers 8 * 9 / 2, less the 8 of its long edge, which it does not own.
constexpr std::uint32_t kHalfSquare = 28;

TEST_CASE("why: visible, where and in how many pixels") {
  const TriangleVerdict verdict = judged(half_square(8, 8, 8));
  CHECK(verdict.end == End::kVisible);
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
  const Scene scene =
      scene_of_parts({{half_square(0, 0, 60), flat(), {}}, {half_square(8, 8, 8, 2), flat(), {}}});
  const TriangleVerdict verdict = judged(scene, 1);
  CHECK(verdict.end == End::kHidden);
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

  // The same triangle twice: of equal depths the first drawn stays (C-58).
  const TriangleVerdict twin = judged(
      scene_of_parts({{half_square(8, 8, 8), flat(), {}}, {half_square(8, 8, 8), flat(), {}}}), 1);
  CHECK(twin.end == End::kHidden);
  CHECK(twin.details.closest_hidden->code == twin.details.closest_hidden->stored);
  CHECK(contains(said(plain_view(), twin), "the first drawn stays"));
}

TEST_CASE("why: discarded by the alpha cutoff") {
  Material material = flat({1, 1, 1, 0.25f}, AlphaMode::kMask);
  material.alpha_cutoff = 0.375f;
  const TriangleVerdict verdict = judged(scene_of_parts({{half_square(8, 8, 8), material, {}}}));
  CHECK(verdict.end == End::kDiscarded);
  CHECK(verdict.fragments.discarded == kHalfSquare);
  CHECK(verdict.details.closest_discarded->alpha == 0.25f);
  CHECK(verdict.details.closest_discarded->cutoff == 0.375f);
}

TEST_CASE("why: written, then overwritten, by whom") {
  const TriangleVerdict verdict = judged(
      scene_of_parts({{half_square(8, 8, 8, 2), flat(), {}}, {half_square(0, 0, 60), flat(), {}}}));
  CHECK(verdict.end == End::kOverwritten);
  CHECK(verdict.fragments.overwritten == kHalfSquare);
  REQUIRE(verdict.details.overwritten_by.size() == 1);
  CHECK(verdict.details.overwritten_by[0].number == 1u);
  CHECK(verdict.details.overwritten_by[0].pixels == kHalfSquare);
  CHECK(verdict.details.overwritten_at);

  // A blended surface of alpha 1 leaves nothing of what is under it; one of less does.
  for (const float alpha : {1.0f, 0.75f}) {
    const TriangleVerdict under = judged(
        scene_of_parts({{half_square(8, 8, 8, 2), flat(), {}},
                        {half_square(0, 0, 60), flat({1, 0, 0, alpha}, AlphaMode::kBlend), {}}}));
    CHECK(under.end == (alpha == 1.0f ? End::kOverwritten : End::kVisible));
    CHECK(under.fragments.veiled == (alpha == 1.0f ? 0 : kHalfSquare));
  }
}

TEST_CASE("why: nothing passes the colour mask") {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  const TriangleVerdict verdict = judged(half_square(8, 8, 8), plain_view(), settings);
  CHECK(verdict.end == End::kMasked);
  CHECK(verdict.fragments.masked == kHalfSquare);
  settings.mask.g = true;
  CHECK(judged(half_square(8, 8, 8), plain_view(), settings).end == End::kVisible);
}

TEST_CASE("why: blended with alpha 0, or painted in the background's own bytes") {
  const TriangleVerdict clear =
      judged(scene_of_parts({{half_square(8, 8, 8), flat({1, 1, 1, 0}, AlphaMode::kBlend), {}}}));
  CHECK(clear.end == End::kUnchanged);
  CHECK(clear.fragments.unchanged == kHalfSquare);
  CHECK(clear.details.unchanged->blended);
  CHECK(clear.details.unchanged->alpha == 0);

  RenderSettings settings;
  settings.background = {255, 255, 255, 255};
  const TriangleVerdict white = judged(
      scene_of_parts({{half_square(8, 8, 8), flat({1, 1, 1, 1}), {}}}), 0, plain_view(), settings);
  CHECK(white.end == End::kUnchanged);
  CHECK(!white.details.unchanged->blended);
  CHECK(white.details.unchanged->bytes == settings.background);
}

TEST_CASE("why: partly visible, each loss counted") {
  // In front of the first 2 rows from the start, and over the last columns later.
  const auto strip = [](double x0, double y0, double x1, double y1, double w) {
    return std::vector<Point<Object>>{at(x0, y0, w), at(x0, y1, w), at(x1, y0, w),
                                      at(x1, y0, w), at(x0, y1, w), at(x1, y1, w)};
  };
  const Scene scene = scene_of_parts({{strip(8, 8, 16, 10, 1), flat(), {}},
                                      {half_square(8, 8, 8, 2), flat({1, 0, 0, 1}), {}},
                                      {strip(8, 10, 9, 16, 1), flat(), {}}});
  const TriangleVerdict verdict = judged(scene, 2);
  CHECK(verdict.end == End::kPartlyVisible);
  CHECK(verdict.fragments.covered == kHalfSquare);
  CHECK(verdict.fragments.hidden == 7 + 6);
  CHECK(verdict.fragments.overwritten == 5);
  CHECK(verdict.fragments.visible == kHalfSquare - 18);
  std::uint32_t hidden = 0;
  for (const Rival& rival : verdict.details.hidden_by) {
    CHECK((rival.number == 0u || rival.number == 1u));
    hidden += rival.pixels;
  }
  CHECK(hidden == 13);
  CHECK(verdict.details.hidden_by.front().pixels >= verdict.details.hidden_by.back().pixels);
}

TEST_CASE("why: lines and points hide triangles without a number") {
  Scene scene = scene_of_parts({{half_square(8, 8, 8, 2), flat(), {}}});
  Mesh lines;
  lines.positions = {at(0.5, 10.5, 1), at(60.5, 10.5, 1)};
  lines.lines = {{Corner{0}, Corner{1}}};
  scene.meshes.push_back(lines);
  scene.instances.push_back({1, 0});
  const TriangleVerdict verdict = judged(scene);
  CHECK(verdict.end == End::kPartlyVisible);
  REQUIRE(verdict.details.overwritten_by.size() == 1);
  CHECK(!verdict.details.overwritten_by[0].number);
  CHECK(contains(said(plain_view(), verdict), "lines or points"));
}

TEST_CASE("why: in a wireframe, edges are seen") {
  RenderSettings settings;
  settings.wireframe = true;
  const TriangleVerdict verdict = judged(half_square(8, 8, 8), plain_view(), settings);
  CHECK(verdict.end == End::kLines);
  settings.want_id = true;
  const auto ids =
      render_staged(scene_of_parts({{half_square(8, 8, 8), flat(), {}}}), plain_view(), settings)
          .buffers.id;
  CHECK(verdict.line_pixels == std::uint64_t(std::count(ids.pixels.begin(), ids.pixels.end(), 1u)));
  CHECK(verdict.line_pixels >= 21);
  CHECK(judged(turned(half_square(8, 8, 8)), plain_view(), settings).end == End::kTurnedAway);
}

TEST_CASE("why: a triangle through the eye plane is cut, and what is left is judged (C-32)") {
  const TriangleVerdict verdict = judged({{0, 0.5f, -1.5f}, {-1, -1, 1}, {1, -1, 1}});
  CHECK(verdict.traced->polygon.size() == 3);
  CHECK(verdict.end == End::kVisible);
  CHECK(judged({{0, 0.5f, -1.5f}, {1, -1, 1}, {-1, -1, 1}}).end == End::kTurnedAway);
}

// ---- slips of convention ----

TEST_CASE(
    "why: a right-handed eye before a left-handed projection: every w is negative (E12, C-07)") {
  // S4.5 looks down -z; S4.18-20 has w = +z. Everything in front of the camera is behind the eye, so to speak.
  View view = plain_view();
  const auto slides = t_pers(1, 1, 2);
  REQUIRE(slides);
  view.clip_from_eye = Transform<Clip, Eye>(slides->columns);
  const TriangleVerdict verdict = judged(half_square(8, 8, 8, 1.5), view);
  CHECK(verdict.end == End::kBehindEye);
  CHECK(verdict.clipping->corners[0].clip.w == -1.5);
  CHECK(verdict.conventions.hands_mixed);
  CHECK(verdict.conventions.right_handed_eye);
  CHECK(!verdict.conventions.gaze_is_minus_z);
  CHECK(contains(said(view, verdict), "Every w is negative"));
  CHECK(contains(said(view, verdict), "Handedness is mixed"));

  const SceneVerdict whole =
      scene_verdict(scene_of_parts({{half_square(8, 8, 8, 1.5), flat(), {}}}), view, {});
  CHECK(whole.all_lost());
  CHECK(whole.commonest_loss() == End::kBehindEye);
  CHECK(whole.conventions.hands_mixed);

  // The other way round: a left-handed eye, our projection.
  View left = plain_view();
  left.eye_from_world = Transform<Eye, World>(eye_left_from_eye().columns);
  const TriangleVerdict other = judged(half_square(8, 8, 8, 1.5), left);
  CHECK(other.end == End::kBehindEye);
  CHECK(other.conventions.hands_mixed);
  CHECK(!other.conventions.right_handed_eye);

  // What is behind the camera is drawn instead.
  std::vector<Point<Object>> behind{{-0.5f, 0.5f, 1.5f}, {0.5f, 0.5f, 1.5f}, {0, -0.5f, 1.5f}};
  RenderSettings both_sides;
  both_sides.cull = Cull::kNone;
  CHECK(judged(behind, left, both_sides).end == End::kVisible);

  // With the adaptor, and with both left-handed, nothing is mixed.
  View right = plain_view();
  right.clip_from_eye = *slides * eye_left_from_eye();
  CHECK(judged(half_square(8, 8, 8, 1.5), right).end == End::kVisible);
  CHECK(!conventions_of(right).hands_mixed);
  left.clip_from_eye = Transform<Clip, Eye>(slides->columns);
  CHECK(!conventions_of(left).hands_mixed);
  CHECK(judged(half_square(8, 8, 8, 1.5), left).end == End::kVisible);
}

TEST_CASE("why: hands mixed before a parallel projection show in the depth") {
  const auto parallel = make_view({"", OrthographicLens{1, 1, 2}, {}}, kSide, kSide);
  REQUIRE(parallel);
  CHECK(!conventions_of(*parallel).hands_mixed);
  CHECK(conventions_of(*parallel).near_depth == 0);
  View left = *parallel;
  left.eye_from_world = Transform<Eye, World>(eye_left_from_eye().columns);
  CHECK(conventions_of(left).hands_mixed);
  const TriangleVerdict verdict =
      judged({{0, 0, -1.5f}, {0, -0.5f, -1.5f}, {0.5f, 0, -1.5f}}, left);
  CHECK(verdict.end == End::kOutsidePlane);
  CHECK(contains(said(left, verdict), "Handedness is mixed"));
  const auto reversed =
      make_view({"", OrthographicLens{1, 1, 2}, {}}, kSide, kSide, DepthRange::kReversed);
  REQUIRE(reversed);
  CHECK(!conventions_of(*reversed).hands_mixed);
  CHECK(conventions_of(*reversed).near_depth == 1);
}

TEST_CASE("why: OpenGL's depth range clipped at z = 0 (E16, C-41)") {
  View view = plain_view();
  view.clip_from_eye = Transform<Clip, Eye>((clip_gl_from_clip() * view.clip_from_eye).columns);
  // z_gl = 2 (2 w - 2) - w = 3 w - 4: negative up to w = 4/3.
  const TriangleVerdict verdict = judged(half_square(8, 8, 8, 1.25), view);
  CHECK(verdict.end == End::kOutsidePlane);
  CHECK(std::string(verdict.clipping->equation.name) == "near");
  CHECK(verdict.clipping->corners[0].inside == -0.25);
  CHECK(verdict.clipping->inside_opengl_depth);
  CHECK(verdict.conventions.near_depth == -1);
  CHECK(verdict.conventions.opengl_range);
  CHECK(contains(said(view, verdict), "OpenGL"));
  CHECK(judged(half_square(8, 8, 8, 1.5), view).end == End::kVisible);
  CHECK(!conventions_of(plain_view()).opengl_range);
}

TEST_CASE("why: a projection without depth hides what is drawn second, however near (E15)") {
  View view = plain_view();
  view.clip_from_eye = singular_projection(1) * eye_left_from_eye();
  // z/w = 1 for all, which the far plane keeps.
  const Scene scene = scene_of_parts(
      {{half_square(8, 8, 8, 2), flat(), {}}, {half_square(8, 8, 8, 1), flat(), {}}});
  const TriangleVerdict verdict = judged(scene, 1, view);
  CHECK(verdict.end == End::kHidden);
  CHECK(verdict.details.closest_hidden->code == verdict.details.closest_hidden->stored);
  CHECK(verdict.details.closest_hidden->distance < verdict.details.closest_hidden->stored_distance);
}

TEST_CASE(
    "why: an eye with a skewed frustum sees what the centre camera has outside its edge (E20)") {
  // Half the eyes' distance s = 1/16, window at f = 2: at w = 1 the picture moves by 32 s (1/w - 1/f) = 1 px.
  constexpr double kHalf = 1.0 / 16, kFocus = 2;
  const std::vector<Point<Object>> strip{at(64.125, 8), at(64.125, 16), at(64.875, 8)};
  const TriangleVerdict centre = judged(strip);
  CHECK(centre.end == End::kOutsidePicture);
  CHECK(centre.outside->right == 32);  // 1/8 px
  // The eye at +s: x' = x - s (1 - w/f).
  View eye = plain_view();
  eye.clip_from_eye = eye.clip_from_eye * stereo_skew(-kHalf, kFocus);
  const TriangleVerdict seen = judged(strip, eye);
  CHECK(seen.end == End::kVisible);
  CHECK(seen.details.visible_box.x0 == 63);
  CHECK(seen.details.visible_box.x1 == 64);
}

// ---- whole scenes ----

TEST_CASE("the ends of all triangles add up to the run's statistics") {
  struct Case {
    const char* name;
    double near, fovy;
    Cull cull;
  };
  for (const Case& c :
       {Case{"room", 0.1, 1.0, Cull::kMaterial}, Case{"room", 2.5, 2.0, Cull::kNone},
        Case{"forest", 6, 0.4, Cull::kBack}, Case{"depth-ladder", 0.5, 0.6, Cull::kMaterial},
        Case{"f-glyph", 0.1, 0.5, Cull::kFront}, Case{"teapot:3", 0.1, 0.3, Cull::kMaterial}}) {
    INFO(c.name << ", near " << c.near);
    const auto scene = make_builtin(c.name);
    REQUIRE(scene);
    Camera camera = camera_for(*scene, 1.5);
    camera.lens = PerspectiveLens{c.fovy, c.near, 30.0};
    const auto view = make_view(camera, 96, 64);
    REQUIRE(view);
    RenderSettings settings;
    settings.cull = c.cull;
    settings.want_id = true;
    const Rendering rendering = render_staged(*scene, *view, settings);
    const Statistics& s = rendering.statistics;
    const SceneVerdict found = scene_verdict(*scene, *view, settings);
    CHECK(found.triangles == s.triangles);
    CHECK(found.at(End::kNoArea).triangles == s.degenerate);
    CHECK(found.at(End::kNotFinite).triangles + found.at(End::kBehindEye).triangles +
              found.at(End::kOutsidePlane).triangles ==
          s.rejected);
    CHECK(found.at(End::kClippedAway).triangles == s.clipped_away);

    Ledger ledger(*view, settings, std::nullopt);
    render_staged(*scene, *view, settings, &ledger);
    ledger.finish();
    FragmentTally sum;
    std::vector<std::uint32_t> visible(ledger.entries().size());
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const FragmentTally& t = ledger.entries()[i].fragments;
      REQUIRE(t.covered == t.hidden + t.discarded + t.masked + t.overwritten + t.visible);
      sum.covered += t.covered;
      sum.hidden += t.hidden;
      sum.discarded += t.discarded;
      visible[i] = t.visible;
    }
    CHECK(sum.covered == s.covered);
    CHECK(sum.hidden == s.depth_failed);
    CHECK(sum.discarded == s.discarded);
    // Nothing here is translucent, so each pixel shows one triangle: the one in the plane of numbers.
    for (const std::uint32_t id : rendering.buffers.id.pixels) {
      if (id > 0) --visible[id - 1];
    }
    CHECK(std::count(visible.begin(), visible.end(), 0u) == std::ptrdiff_t(visible.size()));

    // One by one they end where the summary has them.
    Random random(20);
    for (int i = 0; i < 12; ++i) {
      const auto number = std::uint32_t(random.unit() * double(found.triangles));
      const auto one = triangle_verdict(*scene, *view, settings, number);
      REQUIRE(one);
      CAPTURE(number);
      CHECK(one->end == ledger.entries()[number].end());
      CHECK(one->fragments.visible == ledger.entries()[number].fragments.visible);
    }
  }
}

}  // namespace
}  // namespace glassbox::test
