// Mistakes of convention by which something vanishes (errata of the slides): the verdict names
// them.
#include <glassbox/render/trace/scene_verdict.h>

#include <string>
#include <vector>

#include <glassbox/pipeline/dialects.h>

#include "tests/render/checked_verdict.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

TEST_CASE(
    "why: a right-handed eye before a left-handed projection: every w is negative (E12, C-07)") {
  // The view of S4.5 looks along -z, the projection of S4.18-20 has w = +z: all that is in front of
  // the camera has a negative w, as if behind the eye.
  View view = plain_view();
  const auto slides = t_pers(1, 1, 2);
  REQUIRE(slides);
  view.clip_from_eye = Transform<Clip, Eye>(slides->columns);
  const TriangleVerdict verdict = checked_verdict(half_square(8, 8, 8, 1.5), view);
  CHECK(verdict.result == TriangleResult::kBehindEye);
  CHECK(verdict.clipping->corners[0].clip.w == -1.5);
  CHECK(verdict.conventions.hands_mixed);
  CHECK(verdict.conventions.right_handed_eye);
  CHECK(!verdict.conventions.gaze_is_minus_z);
  CHECK(contains(explanation_text(view, verdict), "Every w is negative"));
  CHECK(contains(explanation_text(view, verdict), "Handedness is mixed"));

  const SceneVerdict whole =
      scene_verdict(scene_of_parts({{half_square(8, 8, 8, 1.5), flat_material(), {}}}), view, {});
  CHECK(whole.all_lost());
  CHECK(whole.most_frequent_loss() == TriangleResult::kBehindEye);
  CHECK(whole.conventions.hands_mixed);

  // The opposite case: a left-handed eye and our projection.
  View left = plain_view();
  left.eye_from_world = Transform<Eye, World>(eye_left_from_eye().columns);
  const TriangleVerdict other = checked_verdict(half_square(8, 8, 8, 1.5), left);
  CHECK(other.result == TriangleResult::kBehindEye);
  CHECK(other.conventions.hands_mixed);
  CHECK(!other.conventions.right_handed_eye);

  // Objects behind the camera are drawn instead.
  std::vector<Point<Object>> behind{{-0.5f, 0.5f, 1.5f}, {0.5f, 0.5f, 1.5f}, {0, -0.5f, 1.5f}};
  RenderSettings both_sides;
  both_sides.cull = Cull::kNone;
  CHECK(checked_verdict(behind, left, both_sides).result == TriangleResult::kVisible);

  // With the adaptor, and with a left-handed eye and projection, nothing is mixed.
  View right = plain_view();
  right.clip_from_eye = *slides * eye_left_from_eye();
  CHECK(checked_verdict(half_square(8, 8, 8, 1.5), right).result == TriangleResult::kVisible);
  CHECK(!conventions_of(right).hands_mixed);
  left.clip_from_eye = Transform<Clip, Eye>(slides->columns);
  CHECK(!conventions_of(left).hands_mixed);
  CHECK(checked_verdict(half_square(8, 8, 8, 1.5), left).result == TriangleResult::kVisible);
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
      checked_verdict({{0, 0, -1.5f}, {0, -0.5f, -1.5f}, {0.5f, 0, -1.5f}}, left);
  CHECK(verdict.result == TriangleResult::kOutsidePlane);
  CHECK(contains(explanation_text(left, verdict), "Handedness is mixed"));
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
  const TriangleVerdict verdict = checked_verdict(half_square(8, 8, 8, 1.25), view);
  CHECK(verdict.result == TriangleResult::kOutsidePlane);
  CHECK(std::string(verdict.clipping->equation.name) == "near");
  CHECK(verdict.clipping->corners[0].inside == -0.25);
  CHECK(verdict.clipping->inside_opengl_depth);
  CHECK(verdict.conventions.near_depth == -1);
  CHECK(verdict.conventions.opengl_range);
  CHECK(contains(explanation_text(view, verdict), "OpenGL"));
  CHECK(checked_verdict(half_square(8, 8, 8, 1.5), view).result == TriangleResult::kVisible);
  CHECK(!conventions_of(plain_view()).opengl_range);
}

TEST_CASE("why: a projection without depth hides what is drawn second, however near (E15)") {
  View view = plain_view();
  view.clip_from_eye = singular_projection(1) * eye_left_from_eye();
  // z/w = 1 for all points, which the far plane keeps.
  const Scene scene = scene_of_parts({{half_square(8, 8, 8, 2), flat_material(), {}},
                                      {half_square(8, 8, 8, 1), flat_material(), {}}});
  const TriangleVerdict verdict = checked_verdict(scene, 1, view);
  CHECK(verdict.result == TriangleResult::kHidden);
  CHECK(verdict.details.closest_hidden->code == verdict.details.closest_hidden->stored);
  CHECK(verdict.details.closest_hidden->distance < verdict.details.closest_hidden->stored_distance);
}

TEST_CASE(
    "why: an eye with a skewed frustum sees what the centre camera has outside its edge (E20)") {
  // Half the separation is s = 1/16 and the window is at f = 2: at w = 1 the picture moves by 32 s
  // (1/w - 1/f) = 1 px.
  constexpr double kHalf = 1.0 / 16, kFocus = 2;
  const std::vector<Point<Object>> strip{point_at_pixel(64.125, 8), point_at_pixel(64.125, 16),
                                         point_at_pixel(64.875, 8)};
  const TriangleVerdict centre = checked_verdict(strip);
  CHECK(centre.result == TriangleResult::kOutsidePicture);
  CHECK(centre.outside->right == 32);  // 1/8 px
  // The eye is at +s: x' = x - s (1 - w/f).
  View eye = plain_view();
  eye.clip_from_eye = eye.clip_from_eye * stereo_skew(-kHalf, kFocus);
  const TriangleVerdict seen = checked_verdict(strip, eye);
  CHECK(seen.result == TriangleResult::kVisible);
  CHECK(seen.details.visible_box.x0 == 63);
  CHECK(seen.details.visible_box.x1 == 64);
}

}  // namespace
}  // namespace glassbox::test
