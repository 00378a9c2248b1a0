// Triangles that are lost before they have fragments, with the number that decides.
#include <glassbox/render/trace/verdict.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/render/checked_verdict.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// ---- assembly and vertices ----

TEST_CASE("why: a number that does not exist is refused, with how many there are") {
  const Scene two = scene_of_parts({{half_square(10, 10, 8), flat_material(), {}},
                                    {half_square(30, 10, 8), flat_material(), {}}});
  const auto refused = triangle_verdict(two, plain_view(), {}, 2);
  REQUIRE(!refused);
  CHECK(contains(refused.error().message(), "2 triangles, 0 .. 1"));
  CHECK(!triangle_verdict(two, plain_view(), {}, std::uint64_t(1) << 32));
  const auto none = triangle_verdict(scene_of_parts({}), plain_view(), {}, 0);
  REQUIRE(!none);
  CHECK(contains(none.error().message(), "no triangles"));
}

TEST_CASE("why: no area as modelled (C-24, C-25)") {
  const TriangleVerdict repeated =
      checked_verdict({point_at_pixel(10, 10), point_at_pixel(10, 20), point_at_pixel(10, 10)});
  CHECK(repeated.result == TriangleResult::kNoArea);
  CHECK(repeated.no_area->reason == NoArea::kRepeatedPosition);
  CHECK(repeated.no_area->corners.size() == 3);
  CHECK(!repeated.traced);

  const TriangleVerdict line =
      checked_verdict({point_at_pixel(10, 10), point_at_pixel(20, 20), point_at_pixel(40, 40)});
  CHECK(line.result == TriangleResult::kNoArea);
  CHECK(line.no_area->reason == NoArea::kCollinear);

  Mesh bow_tie;
  bow_tie.positions = {point_at_pixel(10, 10), point_at_pixel(20, 20), point_at_pixel(20, 10),
                       point_at_pixel(10, 20)};
  add_face(bow_tie, {0, 1, 2, 3});
  for (const std::uint64_t number : {std::uint64_t(0), std::uint64_t(1)}) {
    const TriangleVerdict crossed = checked_verdict(scene_of(bow_tie, flat_material()), number);
    CHECK(crossed.result == TriangleResult::kNoArea);
    CHECK(crossed.no_area->reason == NoArea::kWholeFace);
    CHECK(crossed.no_area->corners.size() == 4);
  }
}

TEST_CASE("why: a corner that overflows on the way to clip space") {
  // The view is four times as narrow: clip x = 4 x.
  const auto view =
      make_view({"", FrustumLens{-0.25, 0.25, -0.25, 0.25, 1, 2.0}, {}}, kSide, kSide);
  REQUIRE(view);
  const TriangleVerdict verdict = checked_verdict({{0, 0, -1}, {3e38f, 0, -1}, {0, 1, -1}}, *view);
  CHECK(verdict.result == TriangleResult::kNotFinite);
  CHECK(std::isinf(verdict.traced->corners[1].clip.x));
  CHECK(contains(explanation_text(*view, verdict), "inf"));
}

// ---- clip ----

TEST_CASE("why: behind the eye, every w negative; and in its plane (C-34)") {
  const TriangleVerdict behind = checked_verdict({{0, 0, 1}, {1, 0, 2}, {0, 1, 3}});
  CHECK(behind.result == TriangleResult::kBehindEye);
  CHECK(behind.clipping->corners[0].clip.w == -1);
  CHECK(behind.clipping->corners[1].clip.w == -2);
  CHECK(behind.clipping->corners[2].clip.w == -3);
  CHECK(!behind.clipping->corners[0].screen);
  CHECK(contains(explanation_text(plain_view(), behind), "Every w is negative: w = -1, -2 and -3"));
  CHECK(!behind.conventions.hands_mixed);

  const TriangleVerdict in_plane = checked_verdict({{0, 0, 0}, {1, 0, 0}, {0, 1, 3}});
  CHECK(in_plane.result == TriangleResult::kBehindEye);
  CHECK(contains(explanation_text(plain_view(), in_plane), "No w is positive"));
}

TEST_CASE("why: all corners nearer than the near plane, or further than the far one") {
  const TriangleVerdict near = checked_verdict({{0, 0, -0.25f}, {1, 0, -0.5f}, {0, 1, -0.75f}});
  CHECK(near.result == TriangleResult::kOutsidePlane);
  CHECK(std::string(near.clipping->equation.name) == "near");
  CHECK(near.clipping->corners[0].inside == -1.5);  // z = 2 w - 2
  CHECK(near.clipping->corners[1].inside == -1);
  CHECK(near.clipping->corners[2].inside == -0.5);
  CHECK(near.clipping->corners[0].along_gaze == 0.25);
  CHECK(!near.clipping->inside_opengl_depth);
  CHECK(contains(explanation_text(plain_view(), near),
                 "near plane, which is at 1 along the gaze: they are at 0.25, 0.5 and 0.75"));

  const TriangleVerdict far = checked_verdict({{0, 0, -3}, {1, 0, -4}, {0, 1, -5}});
  CHECK(far.result == TriangleResult::kOutsidePlane);
  CHECK(std::string(far.clipping->equation.name) == "far");
  CHECK(far.clipping->corners[0].inside == -1);  // w - z = 2 - w
  CHECK(far.clipping->corners[2].inside == -3);
  CHECK(contains(explanation_text(plain_view(), far), "--far 5.05"));
}

TEST_CASE("why: beyond the guard band on one side (C-40)") {
  const TriangleVerdict verdict = checked_verdict({{2000, 0, -1}, {2001, 0, -1}, {2000, 1, -1}});
  CHECK(verdict.result == TriangleResult::kOutsidePlane);
  CHECK(std::string(verdict.clipping->equation.name) == "guard band, right");
  CHECK(verdict.clipping->corners[0].inside == 65536 - 64 * 2000);
  REQUIRE(verdict.clipping->corners[0].screen);
  CHECK(verdict.clipping->corners[0].screen->x == 32 + 32 * 2000);
  CHECK(contains(explanation_text(plain_view(), verdict), "right of the picture"));
}

TEST_CASE("why: no single plane, but several together leave nothing") {
  // The near plane leaves x >= 1800 at w >= 1, and the guard band ends at 1024 w.
  const TriangleVerdict verdict =
      checked_verdict({{3000, 0, -1.5f}, {-3000, 100, 1}, {-3000, 0, 1}});
  CHECK(verdict.result == TriangleResult::kClippedAway);
  const std::vector<ClipCount>& steps = verdict.clipping->steps;
  REQUIRE(steps.size() == 5);
  CHECK(std::string(steps[0].plane) == "near");
  CHECK(steps[0].vertices_left == 3);
  CHECK(std::string(steps[4].plane) == "guard band, right");
  CHECK(steps[4].vertices_left == 0);
  CHECK(verdict.clipping->plane == 4);
  CHECK(contains(explanation_text(plain_view(), verdict),
                 "the guard band, right plane leaves nothing"));
}

// ---- setup and cull ----

TEST_CASE("why: no area after snapping (C-49)") {
  // 1/1024 px is a quarter of a step.
  constexpr double kTiny = 1.0 / 1024;
  const TriangleVerdict point =
      checked_verdict({point_at_pixel(10.5, 10.5), point_at_pixel(10.5, 10.5 + kTiny),
                       point_at_pixel(10.5 + kTiny, 10.5)});
  CHECK(point.result == TriangleResult::kNoScreenArea);
  CHECK(point.no_screen_area->area_px2 == kTiny * kTiny / 2);
  for (const SnappedVertex& vertex : point.no_screen_area->snapped) {
    CHECK(vertex == SnappedVertex{2688, 2688});
  }
  CHECK(point.pieces_without_area == 1);
  CHECK(contains(explanation_text(plain_view(), point), "one point"));

  const TriangleVerdict line = checked_verdict(
      {point_at_pixel(10, 10), point_at_pixel(15, 10 + kTiny), point_at_pixel(20, 10)});
  CHECK(line.result == TriangleResult::kNoScreenArea);
  CHECK(line.no_screen_area->area_px2 == 10 * kTiny / 2);
  CHECK(contains(explanation_text(plain_view(), line), "on one line"));
}

TEST_CASE("why: turned away, by the winding, the model's mirror or the setting (E11, E18, C-17)") {
  const std::vector<Point<Object>> front = half_square(8, 8, 16),
                                   back = with_reversed_winding(front);
  CHECK(checked_verdict(front).result == TriangleResult::kVisible);

  const TriangleVerdict clockwise = checked_verdict(back);
  CHECK(clockwise.result == TriangleResult::kTurnedAway);
  CHECK(clockwise.cull->area_px2 == -128);
  CHECK(!clockwise.cull->front);
  CHECK(!clockwise.cull->mirrored);
  REQUIRE(clockwise.cull->object_space);
  CHECK(clockwise.cull->object_space->facing == Facing::kBack);
  // (P - eye) . m = -1 * (-2 * 128 px^2 / 32^2).
  CHECK(clockwise.cull->object_space->value == 0.25);
  CHECK(clockwise.pieces_turned_away == 1);

  // A mirroring model transform reverses the winding, and with it which side is the front.
  Transform<World, Object> mirror;
  mirror.at(0, 0) = -1;
  const std::vector<Point<Object>> other_half = half_square(40, 8, 16);
  const Scene shown = scene_of_parts({{other_half, flat_material(), mirror}});
  CHECK(checked_verdict(shown).result == TriangleResult::kVisible);
  const TriangleVerdict mirrored = checked_verdict(
      scene_of_parts({{with_reversed_winding(other_half), flat_material(), mirror}}));
  CHECK(mirrored.result == TriangleResult::kTurnedAway);
  CHECK(mirrored.cull->area_px2 == 128);
  CHECK(mirrored.cull->mirrored);
  CHECK(!mirrored.cull->front);
  CHECK(mirrored.cull->object_space->facing == Facing::kBack);
  CHECK(contains(explanation_text(plain_view(), mirrored), "the model matrix mirrors"));

  RenderSettings settings;
  settings.cull = Cull::kFront;
  const TriangleVerdict front_culled = checked_verdict(front, plain_view(), settings);
  CHECK(front_culled.result == TriangleResult::kTurnedAway);
  CHECK(front_culled.cull->front);
  CHECK(front_culled.cull->area_px2 == 128);
  CHECK(checked_verdict(back, plain_view(), settings).result == TriangleResult::kVisible);

  Material both = flat_material();
  both.double_sided = true;
  CHECK(checked_verdict(scene_of_parts({{back, both, {}}})).result == TriangleResult::kVisible);
  settings.cull = Cull::kBack;
  CHECK(checked_verdict(scene_of_parts({{back, both, {}}}), 0, plain_view(), settings).result ==
        TriangleResult::kTurnedAway);
}

TEST_CASE("why: edge-on from the eye's own plane is no area, not a back (C-27)") {
  const TriangleVerdict verdict = checked_verdict({{0, 0, -1}, {0.25f, 0, -1.5f}, {-0.25f, 0, -2}});
  CHECK(verdict.result == TriangleResult::kNoScreenArea);
  CHECK(verdict.no_screen_area->area_px2 == 0);
}

// ---- coverage ----

TEST_CASE("why: beside the picture, on which side and by how much") {
  const TriangleVerdict left = checked_verdict(half_square(-20, 10, 7.5));
  CHECK(left.result == TriangleResult::kOutsidePicture);
  CHECK(left.outside->left == 3200);  // 12.5 px
  CHECK(left.outside->right == 0);
  CHECK(left.outside->top == 0);
  CHECK(left.outside->bottom == 0);
  CHECK(contains(explanation_text(plain_view(), left), "12.5 px left of"));

  const TriangleVerdict corner = checked_verdict(half_square(70, -9, 4));
  CHECK(corner.outside->right == 6 * 256);
  CHECK(corner.outside->top == 5 * 256);
  CHECK(contains(explanation_text(plain_view(), corner), "6 px right of and 5 px above"));

  // Its box reaches into the picture, but its long edge, x + y = 140, passes outside the corner
  // (64, 64).
  const TriangleVerdict passing =
      checked_verdict({point_at_pixel(90, 50), point_at_pixel(50, 90), point_at_pixel(90, 90)});
  CHECK(passing.result == TriangleResult::kOutsidePicture);
  REQUIRE(passing.outside->beyond_edge);
  CHECK(*passing.outside->beyond_edge == Approx(256 * 12 / std::sqrt(2.0)).epsilon(1e-15));

  // The edge passes through the corner itself: they have only a point in common.
  const TriangleVerdict touching =
      checked_verdict({point_at_pixel(80, 48), point_at_pixel(48, 80), point_at_pixel(80, 80)});
  CHECK(touching.result == TriangleResult::kOutsidePicture);
  CHECK(touching.outside->beyond_edge == 0.0);
  CHECK(
      checked_verdict({point_at_pixel(79.5, 48), point_at_pixel(47.5, 80), point_at_pixel(80, 80)})
          .result == TriangleResult::kBetweenCentres);
}

TEST_CASE("why: between pixel centres, and by how little it misses one") {
  // Snapped to 2714 .. 2790 in x and y; the centre of pixel (10, 10) is at 2688.
  const TriangleVerdict verdict = checked_verdict(
      {point_at_pixel(10.6, 10.6), point_at_pixel(10.6, 10.9), point_at_pixel(10.9, 10.6)});
  CHECK(verdict.result == TriangleResult::kBetweenCentres);
  REQUIRE(verdict.nearest_centre);
  CHECK(verdict.nearest_centre->x == 10);
  CHECK(verdict.nearest_centre->y == 10);
  CHECK(verdict.nearest_centre->subpixels == 26);
  CHECK(verdict.nearest_centre->value == -26 * 76);

  // The centre is on the right-hand edge, which belongs to the neighbour (C-43).
  const TriangleVerdict tie = checked_verdict(
      {point_at_pixel(10.5, 10.25), point_at_pixel(10.25, 10.5), point_at_pixel(10.5, 10.75)});
  CHECK(tie.result == TriangleResult::kBetweenCentres);
  CHECK(tie.nearest_centre->x == 10);
  CHECK(tie.nearest_centre->y == 10);
  CHECK(tie.nearest_centre->value == 0);
  CHECK(tie.nearest_centre->subpixels == 0);
  CHECK(contains(explanation_text(plain_view(), tie), "belongs to the neighbour"));

  // A sliver of 1/64 px along a whole row meets no centre, however long it is (C-47).
  const TriangleVerdict sliver = checked_verdict(
      {point_at_pixel(1, 20.25), point_at_pixel(1, 20.265625), point_at_pixel(60, 20.25)});
  CHECK(sliver.result == TriangleResult::kBetweenCentres);
  CHECK(sliver.nearest_centre->y == 20);
  CHECK(sliver.nearest_centre->subpixels > 59);  // at most 64: the row's centre
  CHECK(sliver.nearest_centre->subpixels <= 64);
}

}  // namespace
}  // namespace glassbox::test
