// The bounds of the condition numbers, compared with exact arithmetic: no error is larger.
#include "study/stiffness/condition_formulas.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/raster/texture.h>

#include "exact/camera.h"
#include "exact/matrix.h"
#include "exact/number.h"
#include "tests/support/catch.h"

namespace glassbox::study {
namespace {

using exact::Decimal;
using exact::Rational;

View view_with(double near, std::optional<double> far, DepthRange range) {
  const auto view = make_view({"", PerspectiveLens{0.8, near, far}, {}}, 1280, 720, range);
  REQUIRE(view);
  return *view;
}

// The distance to which a number in the depth buffer corresponds.
Decimal distance_of(Decimal depth, const View& view) {
  if (view.depth_range == DepthRange::kReversed) depth = Decimal(1) - depth;
  const Decimal n(view.near);
  if (std::isinf(view.far)) return n / (Decimal(1) - depth);
  const Decimal f(view.far);
  return f * n / (f - depth * (f - n));
}

double stored(DepthFormat format, float depth) {
  const double kept = std::clamp(double(depth), 0.0, 1.0);
  if (format == DepthFormat::kFloat32 || format == DepthFormat::kFloat32Reversed) return kept;
  return double(depth_code(format, depth)) / unorm_depth_steps(format);
}

}  // namespace

TEST_CASE("what a depth stands for is within its share of the distance") {
  Random random(10);
  double largest_ratio = 0;
  int unbounded = 0, count = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto format = DepthFormat(random.integer(0, 3));
    const bool reversed = format == DepthFormat::kFloat32Reversed;
    const double near = std::pow(10, random.between(-4, 1));
    std::optional<double> far = near * std::pow(10, random.between(0.1, 7));
    if (random.unit() < 0.3) far.reset();
    const View view =
        view_with(near, far, reversed ? DepthRange::kReversed : DepthRange::kStandard);
    const double reach = far ? std::log10(*far / near) : 7;
    const auto z = float(near * std::pow(10, random.unit() * reach));
    if (double(z) < view.near || double(z) > view.far) continue;
    // A vertex straight ahead, computed by the stages of the run.
    const Transform<Clip, Eye, float> matrix = round_to_float(view.clip_from_eye);
    const Point<Eye> eye(0, 0, -z);
    ClipVertex clip;
    clip.position = matrix * eye;
    const NdcVertex ndc = divide(clip);
    const glm::dvec4 clip_bound = transform_bound(matrix.columns, {0, 0, -z, 1}, glm::dvec4(0),
                                                  rounding_bound(view.clip_from_eye.columns));
    const double ndc_bound = divide_bound(clip.position, clip_bound).position.z;
    const double share = depth_share(view, format, ndc.position.z, double(z), ndc_bound);
    ++count;
    if (!std::isfinite(share)) {
      ++unbounded;
      continue;
    }
    const double depth = stored(format, ndc.position.z);
    const Decimal found = distance_of(Decimal(depth), view);
    const double error = double(abs(found - Decimal(double(z)))) / double(z);
    CAPTURE(near, far.value_or(0), z, int(format), error, share);
    REQUIRE(error <= share);
    largest_ratio = std::max(largest_ratio, error / share);
  }
  std::printf("  depth: largest error / bound = %.3f, %d of %d without bound\n", largest_ratio,
              unbounded, count);
  CHECK(largest_ratio > 0.3);
  CHECK(unbounded < count / 2);
}

TEST_CASE("rounding a position moves it on the screen by no more than half an ulp's worth") {
  Random random(13);
  double largest_ratio = 0;
  const View view = view_with(0.1, {}, DepthRange::kStandard);
  for (int i = 0; i < 20'000; ++i) {
    const double offset = std::pow(10, random.between(-1, 7));
    const auto coordinate = [&] { return offset + random.between(-1, 1); };
    const double x = coordinate(), y = -coordinate(), z = coordinate();
    const Point<Object> rounded{float(x), float(y), float(z)};
    const Vector<Object, double> axis{1, 2, random.between(-3, 3)};
    const auto turn = rotate_degrees<World>(axis, random.between(-180, 180));
    REQUIRE(turn);
    const auto near_origin =
        translate<Object, Object>(Vector<Object, double>{-offset, offset, -offset});
    const auto away = translate<Eye, World>(Vector<Eye, double>{0, 0, -random.between(3, 30)});
    const Transform<Clip, Object> clip_from_object =
        view.clip_from_eye * away * *turn * near_origin;
    const double bound = half_ulp_on_screen(clip_from_object, rounded, view.viewport);
    if (!std::isfinite(bound)) continue;
    const auto matrix = exact::exactly<Rational>(clip_from_object);
    const auto on_screen = [&](const exact::Vector4<Rational>& p) {
      const auto clip = matrix * p;
      return std::array{clip[0] / clip[3] * Rational(640), clip[1] / clip[3] * Rational(360)};
    };
    const auto meant = on_screen({Rational(x), Rational(y), Rational(z), Rational(1)});
    const auto found = on_screen(exact::exactly<Rational>(rounded));
    const double error =
        std::max(double(abs(meant[0] - found[0])), double(abs(meant[1] - found[1])));
    CAPTURE(offset, x, y, z, error, bound);
    REQUIRE(error <= bound);
    largest_ratio = std::max(largest_ratio, error / bound);
  }
  std::printf("  offset: largest error / bound = %.3f\n", largest_ratio);
  CHECK(largest_ratio > 0.5);
}

TEST_CASE("the weights within a sliver are within its share") {
  Random random(47);
  double largest_ratio = 0;
  for (int i = 0; i < 20'000; ++i) {
    using Place = std::array<double, 2>;
    const double height = std::pow(10, random.between(-3, 2)), moved = 1.0 / 512;
    std::array<Place, 3> computed{Place{0, 0}, Place{random.between(10, 100), 0},
                                  Place{random.between(-20, 120), height}};
    const double angle = random.between(-3, 3);
    for (Place& p : computed) {
      p = {std::cos(angle) * p[0] - std::sin(angle) * p[1],
           std::sin(angle) * p[0] + std::cos(angle) * p[1]};
    }
    std::array<Place, 3> meant = computed;
    for (Place& p : meant) {
      for (double& c : p)
        c += moved * (random.unit() < 0.5 ? random.between(-1, 1) : random.unit() < 0.5 ? -1 : 1);
    }
    const double share = sliver_share(computed, moved);
    if (!std::isfinite(share)) continue;
    const double a = random.unit(), b = random.unit() * (1 - a);
    const Place at{a * computed[0][0] + b * computed[1][0] + (1 - a - b) * computed[2][0],
                   a * computed[0][1] + b * computed[1][1] + (1 - a - b) * computed[2][1]};
    const auto area = [](const Place& p, const Place& q, const Place& r) {
      return (Rational(q[0]) - Rational(p[0])) * (Rational(r[1]) - Rational(p[1])) -
             (Rational(r[0]) - Rational(p[0])) * (Rational(q[1]) - Rational(p[1]));
    };
    const auto weight = [&](const std::array<Place, 3>& t, std::size_t k) {
      return area(at, t[(k + 1) % 3], t[(k + 2) % 3]) / area(t[0], t[1], t[2]);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = double(abs(weight(computed, k) - weight(meant, k)));
      CAPTURE(height, k, error, share);
      REQUIRE(error <= share);
      largest_ratio = std::max(largest_ratio, error / share);
    }
  }
  std::printf("  sliver: largest error / bound = %.3f\n", largest_ratio);
  CHECK(largest_ratio > 0.5);
  CHECK(std::isinf(sliver_share({{{0, 0}, {10, 0}, {5, 0.004}}}, 1.0 / 512)));
  CHECK(sliver_factor({{{0, 0}, {10, 0}, {5, 2}}}) == 5);
}

TEST_CASE("the corners of the picture stay within the pixels that the angle to up says") {
  Random random(1);
  double largest_ratio = 0;
  const View view = view_with(0.1, {}, DepthRange::kStandard);
  for (int i = 0; i < 300; ++i) {
    const Point<World, double> eye{random.between(-9, 9), random.between(-9, 9),
                                   random.between(-9, 9)};
    const Vector<World, double> gaze{random.between(-1, 1), random.between(-1, 1),
                                     random.between(-1, 1)};
    const Vector<World, double> across =
        cross(gaze, Vector<World, double>{random.between(-1, 1), 1, random.between(-1, 1)});
    const Vector<World, double> up = gaze + across * std::pow(10, random.between(-5, 1));
    const Point<World, double> target = eye + gaze;
    const auto computed = look_at(eye, target, up);
    if (!computed) continue;
    const UpAngle angle = up_angle(target - eye, up, view);
    const auto meant = exact::look_at(eye, target, up);
    const Decimal focal(pixels_per_unit(view));
    for (const double x : {-640.0, 640.0}) {
      for (const double y : {-360.0, 360.0}) {
        const std::array<Decimal, 3> in_eye{Decimal(x), Decimal(y), -focal};
        std::array<Decimal, 3> in_world, again;
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t row = 0; row < 3; ++row) in_world[k] += meant.at[row][k] * in_eye[row];
        }
        for (std::size_t row = 0; row < 3; ++row) {
          for (std::size_t k = 0; k < 3; ++k) {
            again[row] += Decimal(computed->at(int(row), int(k))) * in_world[k];
          }
        }
        const Decimal right = -focal * again[0] / again[2], above = -focal * again[1] / again[2];
        const double error = std::hypot(double(right - Decimal(x)), double(above - Decimal(y)));
        CAPTURE(angle.sine, error, angle.pixels);
        REQUIRE(error <= angle.pixels);
        largest_ratio = std::max(largest_ratio, error / angle.pixels);
      }
    }
  }
  std::printf("  up: largest error / bound = %.3f\n", largest_ratio);
  CHECK(largest_ratio > 0.01);
}

TEST_CASE("rounding a texture coordinate moves it by no more than half an ulp of texels") {
  Random random(67);
  for (int i = 0; i < 10'000; ++i) {
    const double u = std::pow(10, random.between(-3, 8));
    const double error = double(abs(Rational(double(float(u))) - Rational(u))) * 512;
    REQUIRE(error <= half_ulp_in_texels(float(u), 512));
  }
}

}  // namespace glassbox::study
