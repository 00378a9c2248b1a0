#include <tests/pipeline/stereo/stereo_cases.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/pipeline/stereo/culling.h>

namespace glassbox {
namespace {

using test::kInfinity;

using FloatMatrix = Transform<Clip, Object, float>;

// The float matrices of a centre camera and of both eyes, as the stages use them.
struct Eyes {
  View centre_view;
  FloatMatrix centre, left, right;

  Eyes(const View& view, const StereoPair& pair) : centre_view(view) {
    const auto rounded = [](const View& v) {
      return FloatMatrix(round_to_float(v.clip_from_eye * v.eye_from_world).columns);
    };
    centre = rounded(view);
    left = rounded(eye_view(view, pair, Side::kLeft));
    right = rounded(eye_view(view, pair, Side::kRight));
  }
  Outcode outcode_of(const Point<Object>& p) const {
    return stereo_outcode(stereo_clip_point(left * p, right * p), centre_view);
  }
  Outcode centre_outcode_of(const Point<Object>& p) const {
    return stereo_outcode(centre_clip_point(centre * p), centre_view);
  }
};

// The planes that decide what is drawn: near, far as `render` clips it, and the sides.
std::vector<ClipPlane> drawn_planes(const View& view) {
  const auto drawn = render_planes(view);
  const auto frustum = frustum_planes(view.depth_range);
  return {drawn[0], drawn[2], frustum[2], frustum[3], frustum[4], frustum[5]};
}

bool is_visible(const FloatMatrix& clip_from_object, const std::vector<Point<Object>>& shape,
                const std::vector<ClipPlane>& planes) {
  if (shape.size() == 1) return clip_point(clip_from_object * shape[0], planes);
  const std::array<ClipVertex, 3> triangle{{{clip_from_object * shape[0], {1, 0, 0}},
                                            {clip_from_object * shape[1], {0, 1, 0}},
                                            {clip_from_object * shape[2], {0, 0, 1}}}};
  return clip_triangle(triangle, planes).count != 0;
}

// A point at a random distance, inside the picture or at most half a picture outside.
Point<Object> around_the_picture(Random& random, const View& view,
                                 const Transform<World, Eye>& pose = {}) {
  const double distance = test::random_distance(random, view);
  const double z = distance * random.between(0.5, 1.1);
  const Point<Eye, double> p = test::random_seen(random, view, z);
  const Point<World, double> world = pose * Point<Eye, double>{p.x * 1.5, p.y * 1.5, p.z};
  return {float(world.x), float(world.y), float(world.z)};
}

// ---- nothing that is seen is culled ----

TEST_CASE("a point is unseen by both exactly where neither eye's frustum holds it (S0-04)") {
  Random random(110);
  int seen = 0, lost_by_centre = 0;
  for (int i = 0; i < 400; ++i) {
    const auto pose = test::random_pose(random);
    const View view = test::random_view(random, pose);
    const Eyes eyes(view, test::random_pair(random, view));
    const auto planes = drawn_planes(view);
    for (int k = 0; k < 500; ++k) {
      const std::vector<Point<Object>> point{around_the_picture(random, view, pose)};
      const bool visible =
          is_visible(eyes.left, point, planes) || is_visible(eyes.right, point, planes);
      const Outcode code[] = {eyes.outcode_of(point[0])};
      if (is_outside_both_views(code) == visible) {
        CAPTURE(i, k, point[0].x, point[0].y, point[0].z, visible);
        CHECK(is_outside_both_views(code) != visible);
      }
      const Outcode centre[] = {eyes.centre_outcode_of(point[0])};
      seen += visible ? 1 : 0;
      lost_by_centre += visible && is_outside_both_views(centre) ? 1 : 0;
    }
  }
  CHECK(seen > 10000);
  CHECK(lost_by_centre > 100);
}

TEST_CASE(
    "no triangle that an eye draws is culled by the union; the centre camera loses some (S0-04, "
    "C-74)") {
  Random random(111);
  int drawn = 0, culled = 0, lost = 0, lost_by_centre = 0, kept_unseen = 0;
  for (int i = 0; i < 400; ++i) {
    const View view = test::random_view(random);
    const Eyes eyes(view, test::random_pair(random, view));
    const auto planes = drawn_planes(view);
    for (int k = 0; k < 250; ++k) {
      const Point<Object> first = around_the_picture(random, view);
      std::vector<Point<Object>> triangle{first};
      const double size = std::exp(random.between(-5, 0)) * std::abs(double(first.z));
      for (int corner = 1; corner < 3; ++corner) {
        triangle.push_back({float(double(first.x) + random.between(-size, size)),
                            float(double(first.y) + random.between(-size, size)),
                            float(double(first.z) + random.between(-size, size))});
      }
      std::array<Outcode, 3> codes{}, centre_codes{};
      for (std::size_t c = 0; c < 3; ++c) {
        codes[c] = eyes.outcode_of(triangle[c]);
        centre_codes[c] = eyes.centre_outcode_of(triangle[c]);
      }
      const bool visible =
          is_visible(eyes.left, triangle, planes) || is_visible(eyes.right, triangle, planes);
      const bool unseen = is_outside_both_views(codes);
      if (visible && unseen)
        FAIL_CHECK("case " << i << ", triangle " << k << " is drawn and culled");
      drawn += visible ? 1 : 0;
      culled += unseen ? 1 : 0;
      lost += visible && unseen ? 1 : 0;
      kept_unseen += !visible && !unseen ? 1 : 0;
      lost_by_centre += visible && is_outside_both_views(centre_codes) ? 1 : 0;
    }
  }
  WARN("C-74: of 100000 triangles "
       << drawn << " are drawn; the union culls " << culled << ", loses " << lost << " and keeps "
       << kept_unseen << " that are not drawn; the centre camera loses " << lost_by_centre);
  CHECK(lost == 0);
  CHECK(drawn > 10000);
  CHECK(culled > 10000);
  CHECK(lost_by_centre > 10);
  CHECK(kept_unseen < 5000);  // triangles that pass a corner of the frustum
}

TEST_CASE("no box is culled that holds a point which an eye sees (S0-04)") {
  Random random(112);
  int culled = 0, kept_for_rounding = 0, culled_by_centre = 0, lost_by_centre = 0;
  for (int i = 0; i < 20000; ++i) {
    const View view = test::random_view(random);
    const Eyes eyes(view, test::random_pair(random, view));
    const StereoPlanes planes = stereo_planes(view);
    const auto drawn = drawn_planes(view);
    const Point<Object> middle = around_the_picture(random, view);
    const double size = std::exp(random.between(-8, -1)) * std::abs(double(middle.z));
    Box<Object> box;
    std::vector<Point<Object>> inside;
    for (int k = 0; k < 20; ++k) {
      inside.push_back({float(double(middle.x) + random.between(-size, size)),
                        float(double(middle.y) + random.between(-size, size)),
                        float(double(middle.z) + random.between(-size, size))});
      box.include(inside.back());
    }
    const bool unseen = is_box_outside_both_views(box, eyes.left, eyes.right, planes);
    std::vector<Outcode> corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Point<Object, double> p = box.corner(corner);
      corners.push_back(eyes.outcode_of({float(p.x), float(p.y), float(p.z)}));
    }
    if (unseen && !is_outside_both_views(corners))
      FAIL_CHECK("case " << i << ": culled, its corners kept");
    kept_for_rounding += !unseen && is_outside_both_views(corners) ? 1 : 0;
    const bool by_centre = is_box_outside_both_views(box, eyes.centre, eyes.centre, planes);
    bool visible = false;
    for (const Point<Object>& p : inside) {
      visible = visible || is_visible(eyes.left, {p}, drawn) || is_visible(eyes.right, {p}, drawn);
    }
    if (visible && unseen)
      FAIL_CHECK("case " << i << ": a point in the box is drawn, the box culled");
    culled += unseen ? 1 : 0;
    culled_by_centre += by_centre ? 1 : 0;
    lost_by_centre += visible && by_centre ? 1 : 0;
  }
  CHECK(culled > 5000);
  CHECK(kept_for_rounding <= 2);  // boxes that touch a plane within rounding
  CHECK(culled_by_centre > culled - 200);
  CHECK(lost_by_centre > 0);
}

TEST_CASE("what only one eye sees, close to the pair, is kept (C-73)") {
  const View view = test::view_of(PerspectiveLens{0.8, 0.1, {}});
  const StereoPair pair{0.25, 10};
  const Eyes eyes(view, pair);
  const auto planes = drawn_planes(view);
  const double z = 0.3;
  CHECK(std::abs(parallax_at(view, pair, z).px) > 1280);  // no point here is in both pictures
  // In front of the left eye, to the left of the centre camera's frustum.
  const std::vector<Point<Object>> triangle{
      {-0.25f, 0, float(-z)}, {-0.24f, 0, float(-z)}, {-0.245f, 0.02f, float(-z)}};
  CHECK(is_visible(eyes.left, triangle, planes));
  CHECK_FALSE(is_visible(eyes.right, triangle, planes));
  std::vector<Outcode> codes, centre_codes;
  for (const auto& p : triangle) {
    codes.push_back(eyes.outcode_of(p));
    centre_codes.push_back(eyes.centre_outcode_of(p));
  }
  CHECK_FALSE(is_outside_both_views(codes));
  CHECK(is_outside_both_views(centre_codes));
  // Between the two eyes' frusta: outside the right plane of the left eye and the left plane of the
  // right eye.
  const Outcode between[] = {eyes.outcode_of({0, 0, float(-z)})};
  CHECK_FALSE(is_visible(eyes.left, {{0, 0, float(-z)}}, planes));
  CHECK(is_outside_both_views(between));
}

TEST_CASE(
    "an infinite far plane culls no distant point that rounding puts beyond it; a finite one "
    "does") {
  const StereoClipPoint beyond{0, 0, 0, 1.0001f, 1}, before{0, 0, 0, -0.0001f, 1};
  struct Case {
    std::optional<double> far;
    DepthRange range;
    bool beyond_unseen;
  };
  const Case cases[] = {
      {100.0, DepthRange::kStandard, true},
      {{}, DepthRange::kStandard, false},
      {100.0, DepthRange::kReversed, true},
      {{}, DepthRange::kReversed, true}};  // reversed: it is in front of the near plane
  for (const Case& c : cases) {
    const View view = test::view_of(PerspectiveLens{0.8, 0.1, c.far}, 64, 64, c.range);
    const Outcode one[] = {stereo_outcode(beyond, view)};
    const Outcode other[] = {stereo_outcode(before, view)};
    CHECK(is_outside_both_views(one) == c.beyond_unseen);
    CHECK(is_outside_both_views(other));
  }
}

TEST_CASE("vertices that are not finite hide their triangle from the eyes that have them so") {
  const View view = test::view_of(PerspectiveLens{0.8, 0.1, {}});
  const float inf = std::numeric_limits<float>::infinity(),
              nan = std::numeric_limits<float>::quiet_NaN();
  const auto unseen = [&](const StereoClipPoint& p) {
    const Outcode codes[] = {stereo_outcode({0, 0, 0, 0.5f, 1}, view), stereo_outcode(p, view)};
    return is_outside_both_views(codes);
  };
  CHECK_FALSE(unseen({0, 0, 0, 0.5f, 1}));
  CHECK_FALSE(unseen({inf, 0, 0, 0.5f, 1}));
  CHECK_FALSE(unseen({0, nan, 0, 0.5f, 1}));
  CHECK(unseen({nan, inf, 0, 0.5f, 1}));
  CHECK(unseen({0, 0, nan, 0.5f, 1}));
  CHECK(unseen({0, 0, 0, 0.5f, inf}));
}

// ---- how much the centre camera loses ----

TEST_CASE(
    "culling by the centre camera loses strips of half the parallax, 0.2 to 1 % of the points "
    "(E20)") {
  // Points are spread evenly over each eye's picture and over the inverse of the distance, from
  // half the window's distance to infinity, the depths for which this window is the best (S0-13).
  // The lens has 40 degrees and 16:9; wider lenses lose less, in proportion to the cotangent.
  const double f = 10;
  const View view = test::view_of(PerspectiveLens{radians_from_degrees(40), 0.1, {}});
  std::ostringstream table;
  table << "E20: eye separation 2s per window distance, points lost of those that an eye sees, "
           "predicted\n";
  double last = 0;
  for (const double percent : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const StereoPair pair{percent / 200 * f, f};
    REQUIRE(check_pair(view, pair));
    const Eyes eyes(view, pair);
    Random random(113);
    const int points = 400000;
    int lost = 0;
    double predicted = 0, by_union = 0;
    for (int i = 0; i < points; ++i) {
      const double z = 1 / random.between(1 / (1e4 * f), 2 / f);
      // A point of the left or the right eye's picture: the eye shifts it to where the centre's
      // picture shows a random point.
      const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
      const Point<Eye, double> p = test::random_seen(random, view, z);
      const Point<Object> seen{float(p.x - eye_shift(pair, side) * (1 - z / f)), float(p.y),
                               float(p.z)};
      const Outcode centre[] = {eyes.centre_outcode_of(seen)};
      const Outcode both[] = {eyes.outcode_of(seen)};
      lost += is_outside_both_views(centre) ? 1 : 0;
      by_union += is_outside_both_views(both) ? 1 : 0;
      predicted += missing_strip_px(view, pair, z) / 1280;
    }
    const double measured = double(lost) / points;
    predicted /= points;
    table << "  " << percent << " %   " << 100 * measured << " %   " << 100 * predicted << " %\n";
    CAPTURE(percent, measured, predicted);
    // Five standard deviations of the count of a rare event.
    CHECK(std::abs(measured - predicted) <= 5 * std::sqrt(predicted / points));
    CHECK(measured > last);
    // Points on the edge of an eye's picture may leave it by rounding.
    CHECK(by_union <= 2);
    last = measured;
  }
  WARN(table.str());
}

TEST_CASE("the strip that is missing at one distance is half the parallax wide (S0-04)") {
  const View view = test::view_of(PerspectiveLens{kPi / 4, 0.1, {}});
  const StereoPair pair{0.25, 10};
  const View left = eye_view(view, pair, Side::kLeft);
  const Eyes eyes(view, pair);
  for (const double z : {2.0, 5.0, 20.0, 1000.0}) {
    // Along the middle row of the left eye's picture, in steps of a hundredth of a pixel.
    int missing = 0, missing_left = 0;
    for (int i = 0; i < 128000; ++i) {
      const double ndc = (i + 0.5) / 64000 - 1;
      const double x = (ndc * z + left.clip_from_eye.at(0, 2) * z - left.clip_from_eye.at(0, 3)) /
                       left.clip_from_eye.at(0, 0);
      const Outcode code[] = {eyes.centre_outcode_of({float(x), 0, float(-z)})};
      if (!is_outside_both_views(code)) continue;
      ++missing;
      missing_left += ndc < 0 ? 1 : 0;
    }
    CAPTURE(z);
    CHECK(std::abs(missing / 100.0 - missing_strip_px(view, pair, z)) <= 0.02);
    CHECK(missing_left == (z < 10 ? missing : 0));
  }
}

}  // namespace
}  // namespace glassbox
