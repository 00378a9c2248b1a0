// Disparities, occlusions and window violations of a pair, on scenes whose numbers are known by
// hand.
//
// The picture has 64 x 64 pixels and an angle of view of 90 degrees, so that one unit at distance 1
// is 32 px wide; the eyes are 1 apart and the window is at 4. An object at distance z has the
// disparity 32 (1/4 - 1/z) px: 4 px at 8, -8 px at 2. The left eye sees it displaced by minus half
// of that from where the camera between the eyes does.
#include <array>
#include <cmath>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>
#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/stereo/window_violations.h>

#include "tests/render/stereo/pairs.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr int kPictureSide = 64;
constexpr StereoPair kPair{0.5, 4};
constexpr double kQuarterTurn = 1.57079632679489661923;

View view_at_origin() {
  const auto view = make_view({"test", PerspectiveLens{kQuarterTurn, 0.125, 1000}, {}},
                              kPictureSide, kPictureSide);
  REQUIRE(view);
  return *view;
}

// A wall perpendicular to the gaze, from x0 to x1 and from y0 to y1.
void add_wall(Scene& scene, const std::string& name, double distance, double x0, double x1,
              double y0, double y1) {
  if (scene.materials.empty()) add_material(scene, "grey", {0.5f, 0.5f, 0.5f, 1});
  Mesh mesh;
  mesh.name = name;
  add_rectangle(mesh, {x0, y0, -distance}, {x1 - x0, 0, 0}, {0, y1 - y0, 0});
  add_object(scene, std::move(mesh));
}

void add_backdrop(Scene& scene, double distance) {
  add_wall(scene, "backdrop", distance, -4 * distance, 4 * distance, -4 * distance, 4 * distance);
}

struct Measured {
  StereoRendering rendering;
  Image<float> left, right;  // disparities
  MonocularMaps monocular;
  WindowViolations violations;
};

Measured measure(const Scene& scene) {
  StereoSettings settings;
  settings.render.want_distance = settings.render.want_id = true;
  const View centre = view_at_origin();
  Measured m{render_pair(scene, centre, kPair, settings), {}, {}, {}, {}};
  m.left = disparity_map(centre, kPair, m.rendering.left.distance);
  m.right = disparity_map(centre, kPair, m.rendering.right.distance);
  m.monocular = monocular_maps(m.left, m.right);
  m.violations = window_violations(scene, {m.rendering.left, m.left}, {m.rendering.right, m.right});
  return m;
}

// 32/z px per relative change of the distance, which comes from a float depth interpolated between
// exact corners: a few u.
double tolerance_px(double distance) {
  return 32 / distance * 8 * 0x1p-24 + 0x1p-20;
}

}  // namespace

TEST_CASE(
    "the disparity of a wall is the parallax at its distance, and the bytes of eyes and centre "
    "agree (S0-11)") {
  for (const double distance : {0.5, 2.0, 3.0, 4.0, 4.5, 8.0, 100.0}) {
    INFO("distance " << distance);
    Scene scene;
    add_backdrop(scene, distance);
    const Measured m = measure(scene);
    const double expected = 32 * (1.0 / 4 - 1 / distance);
    for (const Image<float>* map : {&m.left, &m.right}) {
      const DisparitySummary summary = summarise_disparity(*map, {});
      CHECK(summary.drawn == kPictureSide * kPictureSide);
      CHECK(std::abs(summary.least_px - expected) <= tolerance_px(distance));
      CHECK(std::abs(summary.greatest_px - expected) <= tolerance_px(distance));
    }
  }
}

TEST_CASE("nothing drawn has no disparity") {
  Scene scene;
  add_wall(scene, "half", 8, -40, 0, -40, 40);
  const Measured m = measure(scene);
  const DisparitySummary summary = summarise_disparity(m.left, {100, 100});
  CHECK(summary.drawn == 30 * kPictureSide);  // the left eye has its edge 2 px left of the middle
  CHECK(std::isnan(m.left.at(40, 10)));
  CHECK(count_monocular(m.monocular.left).all() == 0);

  const Image<float> empty(3, 2, NAN);
  CHECK(summarise_disparity(empty, {}).drawn == 0);
  CHECK(summarise_disparity(empty, {}).share_beyond() == 0);
  CHECK(histogram_of(empty).counts.empty());
  CHECK(count_monocular(monocular_maps(empty, empty).left).all() == 0);
}

TEST_CASE(
    "pixels beyond the budget are counted on either side, and what is at its limit keeps it "
    "(S0-13)") {
  Image<float> map(5, 1);
  map.pixels = {-3, -2, 0, 2, 2.5};
  const DisparitySummary summary = summarise_disparity(map, {2, 2});
  CHECK(summary.too_near == 1);
  CHECK(summary.too_far == 1);
  CHECK(summary.share_beyond() == 0.4);
  CHECK(summary.least_px == -3);
  CHECK(summary.greatest_px == 2.5);
}

TEST_CASE(
    "the separation that parallax_budget.h chooses for what is seen leaves no pixel beyond the "
    "budget "
    "(S0-13)") {
  for (const PairCase& c : pair_cases()) {
    INFO(c.name);
    StereoSettings settings;
    settings.render.want_distance = true;
    const ParallaxBudget budget{2, 1};
    const StereoRendering wide = render_pair(c.scene, c.centre, c.pair, settings);
    DepthSpan seen{1e30, 0};
    for (const Framebuffer* eye : {&wide.left, &wide.right}) {
      for (const float distance : eye->distance.pixels) {
        if (!std::isfinite(distance)) continue;
        seen = {std::min(seen.nearest, double(distance)),
                std::max(seen.farthest, double(distance))};
      }
    }
    StereoPair pair = c.pair;
    pair.half_separation = largest_half_separation(c.centre, pair.window, seen, budget);
    // The distances are unchanged: what the new eyes would see in addition is not tested.
    for (const Framebuffer* eye : {&wide.left, &wide.right}) {
      CHECK(summarise_disparity(disparity_map(c.centre, pair, eye->distance), budget)
                .share_beyond() == 0);
    }
  }
}

TEST_CASE("the bins of a histogram hold all pixels, and the window lies at the edge of one") {
  Image<float> map(6, 1);
  map.pixels = {-0.5f, -0.001f, 0, 0.001f, 2.25f, NAN};
  for (const int bins : {2, 3, 7, 64, 1000}) {
    INFO(bins);
    const DisparityHistogram histogram = histogram_of(map, bins);
    CHECK(int(histogram.counts.size()) <= bins);
    std::uint64_t all = 0, in_front = 0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
      all += histogram.counts[i];
      if (histogram.first_px + double(i) * histogram.bin_px < -histogram.bin_px / 2) {
        in_front += histogram.counts[i];
      }
    }
    CHECK(all == 5);
    CHECK(in_front == 2);
  }
  map.pixels = {1e30f, 1e30f, 1e30f, 1e30f, -1e30f, 0};  // disparities of points next to the eyes
  CHECK(histogram_of(map).counts.size() <= 64);
  map.pixels.assign(6, -3e38f);
  CHECK(histogram_of(map).counts == std::vector<std::uint64_t>{6});
  map.pixels.assign(6, 3);
  CHECK(histogram_of(map).counts == std::vector<std::uint64_t>{6});
}

TEST_CASE(
    "what stands before a wall hides a strip of it from each eye, as wide as the disparities "
    "differ (C-73)") {
  Scene scene;
  add_backdrop(scene, 8);                                // 4 px
  add_wall(scene, "pillar", 2, -0.5, 0.5, -0.25, 0.25);  // -8 px: 16 columns, 8 rows
  const Measured m = measure(scene);
  for (const Image<OtherEyeVisibility>* map : {&m.monocular.left, &m.monocular.right}) {
    const MonocularCounts counts = count_monocular(*map);
    CHECK(counts.hidden == 12 * 8);
    CHECK(counts.beside == 4 * kPictureSide);  // of the wall, whose parallax is 4 px
    CHECK(counts.missing == 0);
  }
  CHECK(m.monocular.left.at(20, 32) ==
        OtherEyeVisibility::kHidden);  // left of the pillar in the left picture
  CHECK(m.monocular.right.at(40, 32) == OtherEyeVisibility::kHidden);
  CHECK(m.monocular.left.at(63, 5) == OtherEyeVisibility::kOutsidePicture);
  CHECK(m.monocular.right.at(0, 5) == OtherEyeVisibility::kOutsidePicture);
}

TEST_CASE("a slanted floor is seen by both eyes wherever it is in both pictures") {
  Scene scene;
  add_material(scene, "grey", {0.5f, 0.5f, 0.5f, 1});
  Mesh mesh;
  add_rectangle(mesh, {-50, -1, -1}, {100, 0, 0}, {0, 0, -100});
  add_object(scene, std::move(mesh));
  Mesh side;  // and a wall that recedes to the right
  add_rectangle(side, {-30, -30, -20}, {60, 0, -20}, {0, 90, 0});
  add_object(scene, std::move(side));
  const Measured m = measure(scene);
  CHECK(count_monocular(m.monocular.left).hidden == 0);
  CHECK(count_monocular(m.monocular.right).hidden == 0);
  CHECK(count_monocular(m.monocular.left).missing == 0);
  CHECK(count_monocular(m.monocular.right).missing == 0);
  CHECK(count_monocular(m.monocular.left).beside > 0);
}

TEST_CASE("a face that looks away from one eye is missing there") {
  Scene scene;
  add_backdrop(scene, 8);
  Mesh mesh;  // in the plane between the eyes, facing the right eye
  add_rectangle(mesh, {0, -1, -3}, {0, 0, -3}, {0, 2, 0});
  add_object(scene, std::move(mesh));
  const Measured m = measure(scene);
  // It is drawn from -1.33 px at its near edge, 21 rows high, to 1.33 px at its far edge, 11 rows
  // high: 43 square pixels. Those near the window's plane are within half a pixel of the other
  // eye's.
  CHECK(count_monocular(m.monocular.right).missing > 20);
  CHECK(count_monocular(m.monocular.left).missing == 0);
}

TEST_CASE(
    "a thing between the eyes and a tenth of the window is kept for the one eye that sees it "
    "(C-73)") {
  Scene scene;
  add_wall(scene, "finger", 0.25, -0.6, -0.3, -0.1, 0.1);  // -120 px: more than the picture's width
  const Measured m = measure(scene);
  const MonocularCounts left = count_monocular(m.monocular.left),
                        right = count_monocular(m.monocular.right);
  CHECK(left.beside == summarise_disparity(m.left, {}).drawn);
  CHECK(left.beside > 100);
  CHECK(left.hidden + left.missing == 0);
  CHECK(right.all() == 0);
}

TEST_CASE(
    "a thing in front of the window that an edge cuts is found with its rows and disparity "
    "(S0-13)") {
  Scene scene;
  add_backdrop(scene, 8);
  add_wall(scene, "post", 2, -2.5, -1.5, -0.25, 0.25);  // 8 rows at the left edge
  add_wall(scene, "free", 2, 0.25, 0.5, 0.5, 0.75);     // in front of the window, but not cut
  add_wall(scene, "behind", 6, 4, 8, -1, 1);  // cut by the right edge, but behind the window
  const Measured m = measure(scene);
  REQUIRE(m.violations.found.size() == 2);
  for (const WindowViolation& one : m.violations.found) {
    CHECK(one.left_edge);
    CHECK_FALSE(one.right_edge);
    CHECK(one.rows == 8);
    CHECK(one.y0 == 28);
    CHECK(one.y1 == 36);
    CHECK(one.x0 == 0);
    CHECK(one.x1 == (one.eye == Side::kLeft ? 12 : 4));
    CHECK(one.pixels == std::uint64_t(8 * one.x1));
    CHECK(std::abs(one.least_px + 8) <= tolerance_px(2));
    CHECK(std::abs(one.nearest - 2) <= 2 * 8 * 0x1p-24);
    REQUIRE(one.instances.size() == 1);
    CHECK(one.instances[0].instance == 1);
    CHECK(one.instances[0].rows == 8);
    CHECK(scene.meshes[scene.instances[one.instances[0].instance].mesh].name == "post");
  }
  CHECK(m.violations.left.at(5, 30) == 1);
  CHECK(m.violations.left.at(20, 30) == 0);
  CHECK(m.violations.right.at(5, 30) == 0);
}

TEST_CASE(
    "a piece of two things that touch names both, and one that spans the picture touches both "
    "edges") {
  Scene scene;
  add_wall(scene, "upper", 2, -9, 9, 0, 0.5);
  add_wall(scene, "lower", 2.5, -9, 9, -0.625, 0);
  const Measured m = measure(scene);
  REQUIRE(m.violations.found.size() == 2);
  const WindowViolation& one = m.violations.found[0];
  CHECK((one.left_edge && one.right_edge));
  CHECK(one.rows == 32);
  REQUIRE(one.instances.size() == 2);
  CHECK(one.instances[0].rows == 16);
  CHECK(one.instances[1].rows == 16);
}

TEST_CASE("a scene behind the window, or in it, violates nothing (S0-13)") {
  for (const double distance : {4.0, 5.0, 50.0}) {
    Scene scene;
    add_backdrop(scene, distance);
    CHECK(measure(scene).violations.found.empty());
  }
}

}  // namespace glassbox
