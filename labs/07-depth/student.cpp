// Lab 7: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <bit>
#include <cmath>
#include <limits>

namespace lab_07 {

// ---- task 7.1: into depth ----

DepthRow depth_row(double near, double far, Range range) {
  // BEGIN SOLUTION
  if (std::isinf(far)) return range == Range::kReversed ? DepthRow{0, near} : DepthRow{-1, -near};
  const double length = far - near;
  if (range == Range::kReversed) return {near / length, near * (far / length)};
  return {-far / length, -near * (far / length)};
  // STUB: return {NAN, NAN};  // z_clip = a z_eye + b
  // END SOLUTION
}

// ---- task 7.2: and back ----

double distance_of(double depth, double near, double far, Range range) {
  // BEGIN SOLUTION
  // The depth is the weight in a linear interpolation of 1/d (d: the distance) from 1/near to
  // 1/far. The only subtraction is that of the depth from 1.
  const double from_near = range == Range::kReversed ? 1 - depth : depth;
  const double from_far = range == Range::kReversed ? depth : 1 - depth;
  return 1 / (from_far / near + from_near / far);
  // STUB: return NAN;  // world units along the gaze
  // END SOLUTION
}

// ---- task 7.3: what the buffer keeps ----

std::uint32_t depth_code(Format format, float depth) {
  // BEGIN SOLUTION
  const float z = depth > 0 ? (depth < 1 ? depth : 1.0f) : 0.0f;
  if (format == Format::kFloat32) return std::bit_cast<std::uint32_t>(z);
  if (format == Format::kFloat32Reversed)
    return std::bit_cast<std::uint32_t>(1.0f) - std::bit_cast<std::uint32_t>(z);
  const double steps = format == Format::kUnorm16 ? 65535 : 16777215;
  return std::uint32_t(std::floor(double(z) * steps + 0.5));  // 24 bits times 24 bits: exact
  // STUB: return 0xffffffffu;  // the smaller code is nearer
  // END SOLUTION
}

// ---- task 7.4: the z-buffer ----

std::vector<int> visible(const std::vector<Fragment>& fragments, int pixels, Format format) {
  // BEGIN SOLUTION
  constexpr std::uint32_t kEmpty = 0xffffffffu;  // no depth has this code
  std::vector<std::uint32_t> buffer(std::size_t(pixels), kEmpty);
  std::vector<int> seen(std::size_t(pixels), -1);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::size_t pixel = std::size_t(fragments[i].pixel);
    const std::uint32_t code = depth_code(format, fragments[i].depth);
    if (code < buffer[pixel]) {
      buffer[pixel] = code;
      seen[pixel] = int(i);
    }
  }
  return seen;
  // STUB: return {};  // for each pixel, the number of the fragment seen, or -1
  // END SOLUTION
}

// ---- task 7.5: how fine it is ----

double separation(Format format, double near, double far, double d) {
  // BEGIN SOLUTION
  // Depth is affine in 1/d: when it changes by `step`, 1/d changes by step (1/near - 1/far).
  const double whole = 1 / near - 1 / far;
  const double reversed = (1 / d - 1 / far) / whole, standard = (1 / near - 1 / d) / whole;
  double step = 0;
  if (format == Format::kUnorm16) step = 1.0 / 65535;
  if (format == Format::kUnorm24) step = 1.0 / 16777215;
  if (format == Format::kFloat32) step = std::ldexp(1.0, std::ilogb(standard) - 23);
  if (format == Format::kFloat32Reversed) step = std::ldexp(1.0, std::ilogb(reversed) - 23);
  const double q = step * whole * d;  // then 1/d' = (1/d)(1 - q), with d' one step behind d
  if (q >= 1 || d / (1 - q) > far) return std::numeric_limits<double>::infinity();
  return q / (1 - q);
  // STUB: return NAN;  // (d' - d)/d
  // END SOLUTION
}

}  // namespace lab_07
