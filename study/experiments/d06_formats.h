// The depth formats that are compared (D-6): how each converts a distance to a code, and its
// precision by the theory.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/depth.h>

namespace glassbox::study::d06 {

inline constexpr double kNear = 0.1, kFar = 10000;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Mapping { kStandard, kReversed, kLogarithmic, kLinear };
enum class Remap { kNone, kGl };  // kGl: depth is in -1 .. 1 before the viewport halves it

struct Format {
  const char* name;
  Mapping mapping;
  int bits;  // 32: float
  double far = kFar;
  Remap remap = Remap::kNone;
};

inline constexpr Format kFormats[] = {
    {"u16", Mapping::kStandard, 16},
    {"u16, reversed", Mapping::kReversed, 16},
    {"u16, logarithmic", Mapping::kLogarithmic, 16},
    {"u16, linear w", Mapping::kLinear, 16},
    {"u24", Mapping::kStandard, 24},
    {"u24, reversed", Mapping::kReversed, 24},
    {"u24, infinite far", Mapping::kStandard, 24, kInfinity},
    {"u24 through [-1, 1]", Mapping::kStandard, 24, kFar, Remap::kGl},
    {"u24, logarithmic", Mapping::kLogarithmic, 24},
    {"u24, linear w", Mapping::kLinear, 24},
    {"float", Mapping::kStandard, 32},
    {"float, infinite far", Mapping::kStandard, 32, kInfinity},
    {"float, reversed", Mapping::kReversed, 32},
    {"float, reversed, infinite far", Mapping::kReversed, 32, kInfinity},
    {"float through [-1, 1]", Mapping::kStandard, 32, kFar, Remap::kGl},
    {"float, reversed through [-1, 1]", Mapping::kReversed, 32, kFar, Remap::kGl},
    {"float, logarithmic", Mapping::kLogarithmic, 32},
    {"float, linear w", Mapping::kLinear, 32},
};

// Transforms points in eye space to vertices on the screen, with the depth range of the format.
class Placement {
public:
  Placement(const Format& format, const Viewport& viewport) : format_(format), viewport_(viewport) {
    const DepthRange range =
        format.mapping == Mapping::kReversed ? DepthRange::kReversed : DepthRange::kStandard;
    const auto clip_from_eye = perspective_degrees(90, 1, {kNear, format.far, range}).value();
    clip_ = round_to_float(clip_from_eye);
    gl_ = round_to_float(clip_gl_from_clip() * clip_from_eye);
  }

  ScreenVertex operator()(const Point<Eye>& p) const {
    NdcVertex ndc = divide(clip_ * p);
    if (format_.remap == Remap::kGl)
      ndc.position.z = 0.5f * (transform_row(gl_, 2, p) / transform_row(gl_, 3, p)) + 0.5f;
    return to_screen(ndc, viewport_);
  }

private:
  Format format_;
  Viewport viewport_;
  Transform<Clip, Eye, float> clip_;
  Transform<ClipGl, Eye, float> gl_;
};

// log2 with IEEE operations in a fixed order, so that errors are the same on every machine. x = 2^e
// m with m near 1, and ln m = 2 artanh((m - 1)/(m + 1)); the series of artanh is cut off where its
// terms are below 2^-48.
inline double log2_of(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x) - 0x3f3504f3u;  // the bits of sqrt(1/2)
  const int exponent = int(std::int32_t(bits) >> 23);
  const double m = double(std::bit_cast<float>((bits & 0x7fffffu) + 0x3f3504f3u));
  const double t = (m - 1) / (m + 1), t2 = t * t;
  double sum = 0;
  for (int k = 17; k >= 1; k -= 2) sum = sum * t2 + 1.0 / k;
  return exponent + 2 * t * sum * 1.442695040888963407360;
}

// The number that is stored for a depth. The nearer of two surfaces has the smaller code.
inline std::uint32_t code_of(const Format& format, float depth, float w) {
  float value = depth;
  if (format.mapping == Mapping::kLogarithmic) {
    static const double kRange = log2_of(float(kFar / kNear));
    value = float(log2_of(w * float(1 / kNear)) / kRange);
  }
  if (format.mapping == Mapping::kLinear) value = (w - float(kNear)) * float(1 / (kFar - kNear));
  if (format.bits == 32)
    return depth_code(format.mapping == Mapping::kReversed ? DepthFormat::kFloat32Reversed
                                                           : DepthFormat::kFloat32,
                      value);
  const std::uint32_t code =
      depth_code(format.bits == 16 ? DepthFormat::kUnorm16 : DepthFormat::kUnorm24, value);
  return format.mapping == Mapping::kReversed ? (1u << format.bits) - 1 - code : code;
}

// ---- theory ----

inline double ulp(double x) {
  return std::ldexp(1.0, std::ilogb(x) - 23);
}

// The largest step of the depth format at the distance z, converted to a relative distance (B.3).
inline double step_law(const Format& format, double z) {
  const double step = std::ldexp(1.0, -format.bits), inverse_far = 1 / format.far;
  // the relative change of the distance z per change of depth, (dz/z) / d(depth)
  const double standard = z * (1 / kNear - inverse_far);
  const double depth = (1 / kNear - 1 / z) / (1 / kNear - inverse_far);
  switch (format.mapping) {
    case Mapping::kLogarithmic: {
      const double v = std::log(z / kNear) / std::log(kFar / kNear);
      return std::log(kFar / kNear) * (format.bits == 32 ? ulp(v) : step);
    }
    case Mapping::kLinear:
      return (kFar - kNear) / z * (format.bits == 32 ? ulp((z - kNear) / (kFar - kNear)) : step);
    case Mapping::kReversed:
      if (format.bits != 32) return standard * step;
      return format.remap == Remap::kGl ? standard * 0x1p-25 : 0x1p-23;
    case Mapping::kStandard:
      return standard * (format.bits == 32 ? ulp(depth) : step);
  }
  return 0;
}

// Standard and reversed depth follow 1/z, and a relative step s of 1/z goes from z to z/(1 - s). No
// step is smaller than 2^-23, because positions are floats, and nothing is beyond the far plane.
inline double predicted_at(const Format& format, double z) {
  double law = std::max(step_law(format, z), 0x1p-23);
  const bool of_inverse =
      format.mapping == Mapping::kStandard || format.mapping == Mapping::kReversed;
  if (of_inverse) law = law < 1 ? law / (1 - law) : kInfinity;
  return std::min(law, (kFar - z) / z);
}

// In a picture, w is computed from the interpolated 1/w: where depth is computed from w, two
// fragments at the same distance may differ by a few rounding errors.
inline double predicted_in_picture(const Format& format, double z) {
  const bool from_w = format.mapping == Mapping::kLinear || format.mapping == Mapping::kLogarithmic;
  return std::max(predicted_at(format, z), from_w ? 0x1p-22 : 0.0);
}

inline std::optional<Finding> finding_on_ladder(const Format& format) {
  const bool near_one = format.mapping == Mapping::kStandard,
             through_gl = format.mapping == Mapping::kReversed && format.remap == Remap::kGl;
  if (format.bits == 16 || !(near_one || through_gl)) return {};
  return Finding{
      "near the far plane, z and its product with f/(f - n) are large; their sum and the quotient "
      "are rounded again, which adds up to three half steps of noise to the step itself",
      2, 2.5};
}

// The mean of three independent rounding errors of the same size is 1/sqrt(3) times as large as one
// of them. Two triangles often have the same errors at some corners, so the difference between
// their depths may be smaller by another factor of 2.
inline std::optional<Finding> finding_in_picture(const Format& format) {
  if (format.bits != 32 || (format.mapping == Mapping::kReversed && format.remap == Remap::kNone))
    return {};
  return Finding{
      "only the corners have depths in these coarse steps. Between them depth is interpolated in "
      "finer steps, so the errors of three corners are averaged, and two triangles with the same "
      "corners on the screen often have the same error",
      0.25, 0.5};
}

}  // namespace glassbox::study::d06
