// S2-02, S2-03: rendered pairs of every kind, and the position of each point in the other picture.
#include <tests/support/catch.h>

#include <cmath>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/stereo/disparity.h>

#include "tests/views/two_view/random_rigs.h"
#include "views/two_view/estimate.h"
#include "views/two_view/pose.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"
#include "views/two_view/truth.h"

namespace glassbox::views {
namespace {

constexpr int kWidth = 160, kHeight = 120;

Scene room() {
  auto scene = make_builtin("room");
  REQUIRE(scene);
  return *scene;
}

View centre_of(const Scene& scene) {
  const auto view = make_view(
      scene.cameras.empty() ? *framing_camera(scene, 4.0 / 3) : scene.cameras[0], kWidth, kHeight);
  REQUIRE(view);
  return *view;
}

// The view turned about its own y axis, and moved to the right and forward.
View moved(const View& view, double right, double forward, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dmat4 step(1.0);
  step[0] = {c, 0, -s, 0};
  step[2] = {s, 0, c, 0};
  step[3] = {-right * c + forward * s, 0, right * s + forward * c, 1};
  View other = view;
  other.eye_from_world = Transform<Eye, World>(step * view.eye_from_world.columns);
  return other;
}

struct Pair {
  KnownPicture left, right;
};

Pair drawn(const Scene& scene, const View& left, const View& right) {
  auto one = known_picture(scene, left, {});
  auto other = known_picture(scene, right, {});
  REQUIRE(one);
  REQUIRE(other);
  return {std::move(*one), std::move(*other)};
}

TEST_CASE("of a parallel pair the places are those of the disparity map") {
  const Scene scene = room();
  const View centre = centre_of(scene);
  const StereoPair eyes{0.05, 3};
  const Pair pair =
      drawn(scene, eye_view(centre, eyes, Side::kLeft), eye_view(centre, eyes, Side::kRight));
  const Image<TrueMatch> truth = true_matches(pair.left, pair.right);
  const Image<float> disparity = disparity_map(centre, eyes, pair.left.distance);
  const MonocularMaps maps =
      monocular_maps(disparity, disparity_map(centre, eyes, pair.right.distance));
  std::size_t alike = 0, drawn_pixels = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const TrueMatch& match = truth.at(x, y);
      if (match.visibility == OtherEyeVisibility::kNothingDrawn) continue;
      ++drawn_pixels;
      // Positions in the map are floats of some hundred pixels.
      CHECK(std::abs(double(match.x) - (x + 0.5 + double(disparity.at(x, y)))) < 1e-3);
      CHECK(std::abs(double(match.y) - (y + 0.5)) < 1e-4);
      alike += match.visibility == maps.left.at(x, y);
    }
  }
  // The disparity map looks only along one row.
  CHECK(double(alike) > 0.98 * double(drawn_pixels));
}

TEST_CASE("what the right eye sees, it sees the left one see") {
  const Scene scene = room();
  const View left = centre_of(scene);
  for (const View& right :
       {moved(left, 0.3, 0, 0), moved(left, 0.5, 0, 0.15), moved(left, 0.1, 0.4, -0.1)}) {
    const Pair pair = drawn(scene, left, right);
    const Image<TrueMatch> there = true_matches(pair.left, pair.right);
    const Image<TrueMatch> back = true_matches(pair.right, pair.left);
    std::size_t seen = 0, returned = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const TrueMatch& match = there.at(x, y);
        if (match.visibility != OtherEyeVisibility::kVisible) continue;
        ++seen;
        const TrueMatch& again = back.at(int(match.x), int(match.y));
        returned += std::hypot(double(again.x) - x - 0.5, double(again.y) - y - 0.5) < 1.5;
      }
    }
    CHECK(seen > 5000);
    // The pixel at this position shows another surface where an edge passes through it.
    CHECK(double(returned) > 0.97 * double(seen));
  }
}

TEST_CASE("sampled matches lie on their epipolar lines, and give the cameras back") {
  const Scene scene = room();
  const View left = centre_of(scene);
  const Pair pair = drawn(scene, left, moved(left, 0.5, 0.1, 0.1));
  const Image<TrueMatch> truth = true_matches(pair.left, pair.right);
  const StereoRig rig{pair.left.camera.intrinsic, pair.right.camera.intrinsic,
                      relative_pose(pair.left.camera, pair.right.camera)};
  const SampledMatches exact = sample_matches(truth, pair.right.distance, {400});
  REQUIRE(exact.matches.size() == 400);
  const Matrix3d f = fundamental_of(rig);
  // A position moves along the epipolar line by the rounding of the distance, and is stored as a
  // float.
  for (const Match& match : exact.matches) CHECK(epipolar_distance(f, match) < 1e-4);

  const SampledMatches mixed = sample_matches(truth, pair.right.distance, {400, 0, 0.4, 7});
  const auto outliers = std::ranges::count(mixed.is_outlier, true);
  CHECK(std::abs(double(outliers) - 160) < 4 * std::sqrt(400 * 0.4 * 0.6));
  RansacOptions options;
  options.threshold = 0.01;
  const auto pose = estimate_pose(mixed.matches, rig.left_intrinsic, rig.right_intrinsic,
                                  Estimator::kFivePoint, options);
  REQUIRE(pose);
  // Inliers are right to 1e-4 px for a focal length of about 145 px, and an outlier is within the
  // threshold only by chance.
  CHECK(rotation_error(pose->pose.rotation, rig.pose.rotation) < 1e-4);
  CHECK(direction_error(pose->pose.translation, rig.pose.translation) < 1e-3);
  for (std::size_t i = 0; i < mixed.matches.size(); ++i) {
    CHECK((mixed.is_outlier[i] || pose->is_inlier[i]));
  }
  const SampledMatches noisy = sample_matches(truth, pair.right.distance, {400, 0.3, 0.4, 7});
  // The same seed gives the same matches.
  const SampledMatches again = sample_matches(truth, pair.right.distance, {400, 0.3, 0.4, 7});
  CHECK(again.matches[17].right == noisy.matches[17].right);
}

}  // namespace
}  // namespace glassbox::views
