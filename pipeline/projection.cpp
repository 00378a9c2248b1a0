#include <glassbox/pipeline/projection.h>

#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {
namespace {

// ---- checks ----

Result<void> check_perspective_planes(const DepthPlanes& planes) {
  const double n = planes.near, f = planes.far;
  if (!(n > 0) || std::isinf(n)) {
    return fail("near plane",
                "its distance is " + number_text(n) + ", which is not a positive number",
                "give a distance in front of the eye, such as a thousandth of the scene's size");
  }
  if (std::isnan(f) || f <= 0) {
    return fail("far plane",
                "its distance is " + number_text(f) + ", which is not a positive number",
                "give a distance beyond the near plane's " + number_text(n) + ", or inf");
  }
  if (n == f) {
    return fail("far plane", "it is at the same distance as the near plane, " + number_text(n),
                "move the far plane away from the near plane");
  }
  if (n > f) {
    return fail(
        "far plane",
        "its distance " + number_text(f) + " is less than the near plane's " + number_text(n),
        "exchange the two planes; for depth 1 at the near plane choose the reversed range");
  }
  return {};
}

Result<void> check_parallel_planes(const DepthPlanes& planes) {
  const double n = planes.near, f = planes.far;
  if (!std::isfinite(n)) {
    return fail("near plane", "its distance is " + number_text(n), "give a finite distance");
  }
  if (!std::isfinite(f)) {
    return fail(
        "far plane", "its distance is " + number_text(f) + " in a parallel projection",
        "give a finite distance; only a perspective projection can have an infinite far plane");
  }
  if (!(n < f)) {
    return fail(
        "far plane",
        "its distance " + number_text(f) + " is not beyond the near plane's " + number_text(n),
        "give near < far");
  }
  if (!std::isfinite(f - n)) {
    return fail("far plane", "its distance from the near plane overflows",
                "move them closer together");
  }
  return {};
}

Result<void> check_edges(double low, double high, const char* low_name, const char* high_name) {
  const std::string names = std::string(low_name) + " = " + number_text(low) + " and " + high_name +
                            " = " + number_text(high);
  if (!std::isfinite(low) || !std::isfinite(high) || !std::isfinite(high - low) ||
      !std::isfinite(high + low)) {
    return fail("window", names + " are not finite numbers, or are too large",
                "give smaller, finite edges");
  }
  if (!(low < high)) {
    return fail("window", names + " leave no window between them",
                std::string("give ") + low_name + " < " + high_name);
  }
  return {};
}

Result<void> check_window(const Window& w) {
  if (const Result<void> x = check_edges(w.left, w.right, "left", "right"); !x) return x;
  return check_edges(w.bottom, w.top, "bottom", "top");
}

Result<void> check_aspect(double aspect) {
  if (aspect > 0 && std::isfinite(aspect)) return {};
  return fail("aspect ratio", "it is " + number_text(aspect) + ", which is not a positive number",
              "give width/height");
}

// ---- entries ----

struct DepthRow {
  double scale = 0, offset = 0;  // z_clip = scale * z_eye + offset
};

// The offset is the scale times the distance of the plane that gets depth 0, so that scale * z +
// offset is exactly 0 there.
DepthRow perspective_depth(const DepthPlanes& planes) {
  const double n = planes.near, f = planes.far;
  if (std::isinf(f))
    return planes.range == DepthRange::kStandard ? DepthRow{-1, -n} : DepthRow{0, n};
  if (planes.range == DepthRange::kStandard) {
    const double scale = -(f / (f - n));
    return {scale, scale * n};
  }
  const double scale = n / (f - n);
  return {scale, scale * f};
}

DepthRow parallel_depth(const DepthPlanes& planes) {
  const double n = planes.near, f = planes.far;
  const double extent = f - n;
  if (planes.range == DepthRange::kStandard) return {-1 / extent, -(n / extent) + 0.0};
  return {1 / extent, f / extent + 0.0};
}

Transform<Clip, Eye> perspective_matrix(double x_scale, double y_scale, const DepthRow& depth) {
  Transform<Clip, Eye> m;
  m.at(0, 0) = x_scale;
  m.at(1, 1) = y_scale;
  m.at(2, 2) = depth.scale;
  m.at(2, 3) = depth.offset;
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
}

// `cot` is 1/tan(fovy/2).
Result<Transform<Clip, Eye>> perspective_from_cotangent(double cot, double aspect,
                                                        const DepthPlanes& planes) {
  if (const Result<void> ok = check_aspect(aspect); !ok) return tl::unexpected(ok.error());
  if (const Result<void> ok = check_perspective_planes(planes); !ok)
    return tl::unexpected(ok.error());
  if (!std::isfinite(cot) || !std::isfinite(cot / aspect)) {
    return fail("field of view", "it is so narrow that the picture's scale overflows", "widen it");
  }
  return perspective_matrix(cot / aspect, cot, perspective_depth(planes));
}

tl::unexpected<Error> bad_field_of_view(const std::string& angle) {
  return fail("field of view", "it is " + angle,
              "give a full vertical angle between 0 and 180 degrees, such as 45");
}

}  // namespace

Result<Transform<Clip, Eye>> perspective(double fovy_radians, double aspect,
                                         const DepthPlanes& planes) {
  if (!(fovy_radians > 0 && fovy_radians < kPi)) {
    return bad_field_of_view(number_text(fovy_radians) + " radians (" +
                             number_text(degrees_from_radians(fovy_radians)) + " degrees)");
  }
  return perspective_from_cotangent(cot_half(fovy_radians), aspect, planes);
}

Result<Transform<Clip, Eye>> perspective_degrees(double fovy_degrees, double aspect,
                                                 const DepthPlanes& planes) {
  if (!(fovy_degrees > 0 && fovy_degrees < 180)) {
    return bad_field_of_view(number_text(fovy_degrees) + " degrees");
  }
  return perspective_from_cotangent(cot_half_degrees(fovy_degrees), aspect, planes);
}

Result<Transform<Clip, Eye>> frustum(const Window& window, const DepthPlanes& planes) {
  if (const Result<void> ok = check_window(window); !ok) return tl::unexpected(ok.error());
  if (const Result<void> ok = check_perspective_planes(planes); !ok)
    return tl::unexpected(ok.error());
  const double width = window.right - window.left, height = window.top - window.bottom;
  Transform<Clip, Eye> m = perspective_matrix(2 * planes.near / width, 2 * planes.near / height,
                                              perspective_depth(planes));
  m.at(0, 2) = (window.right + window.left) / width;
  m.at(1, 2) = (window.top + window.bottom) / height;
  for (int axis = 0; axis < 2; ++axis) {
    if (!std::isfinite(m.at(axis, axis)) || !std::isfinite(m.at(axis, 2))) {
      return fail("window", "it is so small that the picture's scale overflows", "widen it");
    }
  }
  return m;
}

Result<Transform<Clip, Eye>> orthographic(const Window& window, const DepthPlanes& planes) {
  if (const Result<void> ok = check_window(window); !ok) return tl::unexpected(ok.error());
  if (const Result<void> ok = check_parallel_planes(planes); !ok) return tl::unexpected(ok.error());
  const double width = window.right - window.left, height = window.top - window.bottom;
  const DepthRow depth = parallel_depth(planes);
  Transform<Clip, Eye> m;
  m.at(0, 0) = 2 / width;
  m.at(0, 3) = -((window.right + window.left) / width) + 0.0;
  m.at(1, 1) = 2 / height;
  m.at(1, 3) = -((window.top + window.bottom) / height) + 0.0;
  m.at(2, 2) = depth.scale;
  m.at(2, 3) = depth.offset;
  for (int row = 0; row < 3; ++row) {
    if (!std::isfinite(m.at(row, row)) || !std::isfinite(m.at(row, 3))) {
      return fail("window",
                  "it, or the distance between the near and far planes, is so small that the scale "
                  "overflows",
                  "widen the window, or move the planes apart");
    }
  }
  return m;
}

double fov_condition(double fovy_radians) {
  return fovy_radians == 0 ? 1 : fovy_radians / sin_cos(fovy_radians).sin;
}

// ---- the slides' own forms ----

Result<Transform<Clip, EyeLeft>> t_pers(double h, double d, double f) {
  if (!(h > 0) || std::isinf(h)) {
    return fail("window", "its half-height is " + number_text(h), "give a positive number");
  }
  const DepthPlanes planes{d, f, DepthRange::kStandard};
  if (const Result<void> ok = check_perspective_planes(planes); !ok)
    return tl::unexpected(ok.error());
  const DepthRow depth = perspective_depth(planes);
  Transform<Clip, EyeLeft> m;
  m.at(0, 0) = d / h;
  m.at(1, 1) = d / h;
  m.at(2, 2) = -depth.scale;  // EyeLeft's z is -z of Eye
  m.at(2, 3) = depth.offset;
  m.at(3, 2) = 1;
  m.at(3, 3) = 0;
  if (!std::isfinite(m.at(0, 0))) {
    return fail("window", "it is so small that the picture's scale overflows", "widen it");
  }
  return m;
}

Result<Transform<Clip, EyeLeft>> alpha_beta(double half_angle_degrees, double aspect, double hither,
                                            double yon) {
  if (!(half_angle_degrees > 0 && half_angle_degrees < 90)) {
    return fail("field of view", "half of it is " + number_text(half_angle_degrees) + " degrees",
                "give half of the horizontal angle, between 0 and 90 degrees");
  }
  if (const Result<void> ok = check_aspect(aspect); !ok) return tl::unexpected(ok.error());
  const DepthPlanes planes{hither, yon, DepthRange::kStandard};
  if (const Result<void> ok = check_perspective_planes(planes); !ok)
    return tl::unexpected(ok.error());
  const SinCos theta = sin_cos_degrees(half_angle_degrees);
  const double d_over_s = theta.cos / theta.sin;
  const DepthRow depth = perspective_depth(planes);
  Transform<Clip, EyeLeft> m;
  m.at(0, 0) = d_over_s;
  m.at(1, 1) = aspect * d_over_s;
  m.at(2, 2) = -depth.scale;
  m.at(2, 3) = depth.offset;
  m.at(3, 2) = 1;
  m.at(3, 3) = 0;
  if (!std::isfinite(m.at(0, 0)) || !std::isfinite(m.at(1, 1))) {
    return fail("field of view", "it is so narrow that the picture's scale overflows", "widen it");
  }
  return m;
}

Transform<Clip, EyeLeft> simple_perspective(double d) {
  Transform<Clip, EyeLeft> m;
  m.at(3, 2) = 1 / d;
  m.at(3, 3) = 0;
  return m;
}

Transform<Clip, EyeLeft> singular_projection(double d) {
  Transform<Clip, EyeLeft> m;
  for (int axis = 0; axis < 3; ++axis) m.at(axis, axis) = d;
  m.at(3, 2) = 1;
  m.at(3, 3) = 0;
  return m;
}

Transform<Clip, EyeLeft> drop_depth() {
  Transform<Clip, EyeLeft> m;
  m.at(2, 2) = 0;
  return m;
}

}  // namespace glassbox
