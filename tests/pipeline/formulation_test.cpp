// The formulations of the slides give the same matrices as the program's own, up to rounding.
#include <tests/pipeline/cameras.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/formulation.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

namespace glassbox {
namespace {

using test::u;

std::uint64_t ulps_apart(const glm::dmat4& a, const glm::dmat4& b) {
  std::uint64_t most = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      most = std::max(most, ulp_distance(a[column][row], b[column][row]));
  }
  return most;
}

// A random camera and the size of its picture; the picture stretches.
struct Case {
  Camera camera;
  int width = 100, height = 100;
};
Case random_case(Random& random) {
  const test::LookAtCase look = test::random_look_at(random);
  const test::LensCase lens = test::random_lens(random);
  Case c;
  c.camera.world_from_eye = camera_pose(look.eye, look.target, look.up).value();
  c.camera.lens = PerspectiveLens{radians_from_degrees(lens.fovy_degrees), lens.near, lens.far};
  c.width = int(random.integer(20, 2000));
  c.height = int(random.integer(20, 2000));
  return c;
}

View view_of_case(const Case& c, const Formulation& formulation) {
  return make_view(c.camera, c.width, c.height, DepthRange::kStandard, formulation).value();
}

TEST_CASE("the usual formulation is make_view's own, bit for bit") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Case c = random_case(random);
    const View own = make_view(c.camera, c.width, c.height).value(), view = view_of_case(c, {});
    CHECK(own.eye_from_world == view.eye_from_world);
    CHECK(own.clip_from_eye == view.clip_from_eye);
  }
}

TEST_CASE("frustum, T_pers and alpha/beta differ from gluPerspective by their roundings (S3-14)") {
  Random random(2);
  std::uint64_t largest[2] = {};
  double largest_share = 0;
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(random);
    const glm::dmat4 own = view_of_case(c, {}).clip_from_eye.columns;
    const double across = 2 * std::atan(1 / own[0][0]);
    CAPTURE(i, c.width, c.height, across);
    const ProjectionForm forms[] = {ProjectionForm::kFrustum, ProjectionForm::kTPers};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto ulps =
          ulps_apart(view_of_case(c, {ViewForm::kUvn, forms[k]}).clip_from_eye.columns, own);
      largest[k] = std::max(largest[k], ulps);
      CHECK(ulps <= 12);
    }
    const auto ulps = ulps_apart(
        view_of_case(c, {ViewForm::kUvn, ProjectionForm::kAlphaBeta}).clip_from_eye.columns, own);
    const double bound = 12 + 4 * fov_condition(across);
    largest_share = std::max(largest_share, double(ulps) / bound);
    CHECK(double(ulps) <= bound);
  }
  WARN("S3-14: frustum up to " << largest[0] << " ulps, T_pers " << largest[1]
                               << ", alpha/beta up to " << largest_share << " of its bound");
}

TEST_CASE("turning about an axis and rolling makes the matrix of the three axes (S3-16)") {
  Random random(3);
  double largest = 0, farthest = 0;
  for (int i = 0; i < 3000; ++i) {
    const Case c = random_case(random);
    const auto uvn = view_of_case(c, {}).eye_from_world;
    const auto turned =
        view_of_case(c, {ViewForm::kAxisAngle, ProjectionForm::kPerspective}).eye_from_world;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const double apart = std::abs(uvn.at(row, column) - turned.at(row, column));
        REQUIRE(std::isfinite(apart));
        double& most = column < 3 ? largest : farthest;
        most = std::max(most, apart);
      }
    }
  }
  WARN("S3-16: rotations up to " << largest / u << " u apart, translations " << farthest / u
                                 << " u of eyes within 100");
  CHECK(largest <= 16 * u);
  CHECK(farthest <= 3 * 100 * 24 * u);
}

TEST_CASE("gazes along the axes are turned exactly, +z by half a turn about y (E8, C-05)") {
  const double s[] = {-1, 1};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : s) {
      Vector<World, double> gaze{0, 0, 0};
      (axis == 0 ? gaze.x : axis == 1 ? gaze.y : gaze.z) = sign;
      const Vector<World, double> up =
          axis == 1 ? Vector<World, double>{0, 0, 1} : Vector<World, double>{0, 1, 0};
      Case c;
      c.camera.lens = PerspectiveLens{1, 0.1, {}};
      c.camera.world_from_eye = camera_pose(Point<World, double>{1, 2, 3}, gaze, up).value();
      CAPTURE(axis, sign);
      CHECK(view_of_case(c, {ViewForm::kAxisAngle, ProjectionForm::kPerspective}).eye_from_world ==
            view_of_case(c, {}).eye_from_world);
    }
  }
}

TEST_CASE("the view is the product of its three factors, bit for bit (S3-16)") {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Case c = random_case(random);
    // The axes are within 16 u of a rotation's, so make_view does not repair them.
    CHECK(product(axis_angle_factors(c.camera.world_from_eye)) ==
          view_of_case(c, {ViewForm::kAxisAngle, ProjectionForm::kPerspective}).eye_from_world);
  }
}

Transform<Clip, Eye> product_of(const PerspectiveFactors& f) {
  return f.clip_from_pyramid * f.shear * f.scale * eye_left_from_eye();
}

TEST_CASE("a perspective is a scale, then the pyramid to the box, bit for bit (S4-10)") {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Case c = random_case(random);
    for (const ProjectionForm form : {ProjectionForm::kPerspective, ProjectionForm::kFrustum,
                                      ProjectionForm::kTPers, ProjectionForm::kAlphaBeta}) {
      const View view = view_of_case(c, {ViewForm::kUvn, form});
      const auto factors = perspective_factors(view.clip_from_eye);
      REQUIRE(factors);
      CHECK_FALSE(factors->has_shear);
      CHECK(product_of(*factors) == view.clip_from_eye);
    }
  }
}

TEST_CASE("windows beside the gaze, a pair's eyes, reversed and infinite depth have factors too") {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Transform<Clip, Eye>> all{
      frustum({-1, 3, -0.3, 2}, {0.7, 13}).value(),
      frustum({-1, 3, -0.3, 2}, {0.7, inf, DepthRange::kReversed}).value(),
      perspective_degrees(77, 1.7, {0.3, inf}).value(),
      perspective_degrees(77, 1.7, {0.3, 5, DepthRange::kReversed}).value()};
  all.push_back(all[2] * stereo_skew(0.031, 4));
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(i);
    const auto factors = perspective_factors(all[i]);
    REQUIRE(factors);
    CHECK(factors->has_shear == (i == 0 || i == 1 || i == 4));
    CHECK(product_of(*factors) == all[i]);
  }
  CHECK_FALSE(perspective_factors(orthographic({-1, 1, -1, 1}, {0.1, 10}).value()));
}

TEST_CASE("the scale makes the pyramid regular: its edges lie at |x| = |y| = z (S4-10)") {
  const View view = make_view({"", FrustumLens{-2, 2, -1, 1, 4, 64.0}, {}}, 200, 100).value();
  const PerspectiveFactors f = perspective_factors(view.clip_from_eye).value();
  for (const double z : {4.0, 16.0, 64.0}) {
    const glm::dvec4 edge = f.scale.columns * glm::dvec4(2 * z / 4, 1 * z / 4, z, 1);
    CHECK(edge == glm::dvec4(z, z, z, 1));
  }
  const glm::dvec4 near = f.clip_from_pyramid.columns * glm::dvec4(4, 4, 4, 1);
  CHECK(near == glm::dvec4(4, 4, 0, 4));
  const glm::dvec4 far = f.clip_from_pyramid.columns * glm::dvec4(64, -64, 64, 1);
  CHECK(far.z / far.w == Approx(1));
}

TEST_CASE("a form that cannot express the lens is refused with a reason") {
  const auto refusal = [](const Lens& lens, DepthRange range, ProjectionForm form) {
    const auto view = make_view({"", lens, {}}, 100, 100, range, {ViewForm::kUvn, form});
    REQUIRE(!view);
    return view.error().message();
  };
  const Lens straight = PerspectiveLens{1, 0.1, 10.0}, beside = FrustumLens{-1, 2, -1, 1, 1, 9.0};
  for (const ProjectionForm form :
       {ProjectionForm::kFrustum, ProjectionForm::kTPers, ProjectionForm::kAlphaBeta}) {
    CHECK(refusal(OrthographicLens{1, 0, 9}, DepthRange::kStandard, form).find("parallel") !=
          std::string::npos);
    if (form == ProjectionForm::kFrustum) continue;
    CHECK(refusal(straight, DepthRange::kReversed, form).find("reversed") != std::string::npos);
    CHECK(refusal(beside, DepthRange::kStandard, form).find("not centred") != std::string::npos);
  }
  // The frustum supports both a window off the centre and reversed depth.
  CHECK(make_view({"", beside, {}}, 100, 100, DepthRange::kReversed,
                  {ViewForm::kUvn, ProjectionForm::kFrustum})
            .value()
            .clip_from_eye ==
        make_view({"", beside, {}}, 100, 100, DepthRange::kReversed).value().clip_from_eye);
}

}  // namespace
}  // namespace glassbox
