#include <glassbox/compare/pixels/moved_edge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <vector>

namespace glassbox {
namespace {

constexpr int kEdge = 1;      // px on each side: where the first rule looks for an edge
constexpr int kContrast = 2;  // px on each side: what an edge can be made of
constexpr int kAround = 3;    // px on each side: what tells the movement
constexpr int kReach = kAround + 1;

constexpr double kSlackOfRange = 1;        // of the first rule, in parts of the range
constexpr double kSlackOfContrast = 0.25;  // of the second rule, in parts of the contrast
// Two steps of whole-number formats: each of the two values is rounded by half a step, and so are
// the values around them.
constexpr double kSlackOfSteps = 2;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double length() const { return high - low; }
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool has(double value, double slack) const {
    return low - slack <= value && value <= high + slack;
  }
};

// The values of one channel around a pixel.
class Patch {
public:
  double& at(int x, int y) { return values_[index(x, y)]; }
  double at(int x, int y) const { return values_[index(x, y)]; }

private:
  static constexpr int kSide = 2 * kReach + 1;
  static std::size_t index(int x, int y) { return std::size_t((y + kReach) * kSide + x + kReach); }
  std::array<double, std::size_t(kSide* kSide)> values_;
};

// Both pictures around a pixel, by channel.
struct Surroundings {
  int channels = 0;
  double rounding = 0;  // the slack for rounded values
  std::array<Patch, 4> reference, test;
};

// Loads one picture's pixel (x, y) into the patches. Returns whether it is finite.
template <class Sample>
bool load_pixel(const Sample* pixel, int channels, int x, int y, std::array<Patch, 4>& patches) {
  constexpr double kFull = std::is_integral_v<Sample> ? std::numeric_limits<Sample>::max() : 1;
  const bool has_alpha = channels % 2 == 0;
  const double alpha = has_alpha ? double(pixel[channels - 1]) / kFull : 1;
  bool finite = true;
  for (int channel = 0; channel < channels; ++channel) {
    const bool colour = has_alpha && channel < channels - 1;
    const double value = double(pixel[channel]) * (colour ? alpha : 1);
    patches[std::size_t(channel)].at(x, y) = value;
    finite &= std::isfinite(value);
  }
  return finite;
}

// Loads the pixels with a distance of (inner, outer] from the pixel; beyond the picture's border
// the nearest pixels are repeated. Returns whether all values are finite.
template <class Sample>
bool load_ring(const PicturePair& pair, const std::vector<Sample>& reference, PixelPosition pixel,
               int inner, int outer, Surroundings& around) {
  const auto& test = std::get<std::vector<Sample>>(pair.test.samples);
  const int width = pair.reference.width, height = pair.reference.height;
  around.channels = pair.reference.channels;
  around.rounding = std::is_integral_v<Sample> ? kSlackOfSteps : 0;
  bool finite = true;
  for (int y = -outer; y <= outer; ++y) {
    const int from_y = std::clamp(pixel.y + y, 0, height - 1);
    for (int x = -outer; x <= outer; ++x) {
      if (std::max(std::abs(x), std::abs(y)) <= inner) continue;
      const int from_x = std::clamp(pixel.x + x, 0, width - 1);
      const std::size_t at = (std::size_t(from_y) * std::size_t(width) + std::size_t(from_x)) *
                             std::size_t(around.channels);
      const auto& own = pair.selection.compares(from_x, from_y) ? test : reference;
      finite &= load_pixel(&reference[at], around.channels, x, y, around.reference);
      finite &= load_pixel(&own[at], around.channels, x, y, around.test);
    }
  }
  return finite;
}

bool load_ring(const PicturePair& pair, PixelPosition pixel, int inner, int outer,
               Surroundings& around) {
  return std::visit(
      [&](const auto& samples) { return load_ring(pair, samples, pixel, inner, outer, around); },
      pair.reference.samples);
}

void add_square(const Patch& patch, int radius, Range& range) {
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) range.add(patch.at(x, y));
  }
}

// The first rule, for the value that one picture has among the other's pixels.
bool lies_at_edge(const Patch& other, double value, double rounding) {
  Range range;
  add_square(other, kEdge, range);
  return range.has(value, kSlackOfRange * range.length() + rounding);
}

bool has_edge(const Surroundings& around) {
  for (std::size_t c = 0; c < std::size_t(around.channels); ++c) {
    const Patch &reference = around.reference[c], &test = around.test[c];
    if (!lies_at_edge(reference, test.at(0, 0), around.rounding) ||
        !lies_at_edge(test, reference.at(0, 0), around.rounding)) {
      return false;
    }
  }
  return true;
}

struct Shift {
  double x = 0, y = 0;  // px
};

// The shift s for which test(p) is nearest to reference(p + s), to first order, over the pixels
// around the middle one. A small multiple of the identity keeps the matrix regular: along an edge
// no movement can be seen, and none is assumed.
Shift shift_around(const Surroundings& around) {
  constexpr double kRegular = 0.01;
  double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
  for (std::size_t c = 0; c < std::size_t(around.channels); ++c) {
    const Patch &a = around.reference[c], &b = around.test[c];
    for (int y = -kAround; y <= kAround; ++y) {
      for (int x = -kAround; x <= kAround; ++x) {
        if (x == 0 && y == 0) continue;
        const double slope_x =
            (a.at(x + 1, y) - a.at(x - 1, y) + b.at(x + 1, y) - b.at(x - 1, y)) / 4;
        const double slope_y =
            (a.at(x, y + 1) - a.at(x, y - 1) + b.at(x, y + 1) - b.at(x, y - 1)) / 4;
        const double change = b.at(x, y) - a.at(x, y);
        xx += slope_x * slope_x;
        xy += slope_x * slope_y;
        yy += slope_y * slope_y;
        xt += slope_x * change;
        yt += slope_y * change;
      }
    }
  }
  const double regular = kRegular * (xx + yy);
  if (!(regular > 0)) return {};
  xx += regular;
  yy += regular;
  const double determinant = xx * yy - xy * xy;
  const auto cut = [](double shift) { return std::clamp(shift, -kMaxEdgeShift, kMaxEdgeShift); };
  return {cut((xt * yy - yt * xy) / determinant), cut((yt * xx - xt * xy) / determinant)};
}

// The bounds of the mean over the unit square at `shift`, of a function in `contrast` whose means
// over the pixels are those of the patch.
Range shifted_bounds(const Patch& patch, const Shift& shift, const Range& contrast) {
  const int step_x = shift.x < 0 ? -1 : 1, step_y = shift.y < 0 ? -1 : 1;
  const double part_x = std::abs(shift.x), part_y = std::abs(shift.y);
  Range bounds{0, 0};
  for (const int j : {0, 1}) {
    for (const int i : {0, 1}) {
      const double area = (i == 0 ? 1 - part_x : part_x) * (j == 0 ? 1 - part_y : part_y);
      const double mean = patch.at(i * step_x, j * step_y);
      // What the part has, if the rest of its pixel has as much or as little as it can.
      bounds.low += std::max(contrast.low * area, mean - contrast.high * (1 - area));
      bounds.high += std::min(contrast.high * area, mean - contrast.low * (1 - area));
    }
  }
  return bounds;
}

// The second rule, from one picture to the other.
bool explains(const std::array<Patch, 4>& from, const std::array<Patch, 4>& to, const Shift& shift,
              const Surroundings& around) {
  for (std::size_t c = 0; c < std::size_t(around.channels); ++c) {
    Range contrast;
    add_square(from[c], kContrast, contrast);
    add_square(to[c], kContrast, contrast);
    const Range bounds = shifted_bounds(from[c], shift, contrast);
    const double slack = kSlackOfContrast * contrast.length() + around.rounding;
    if (!bounds.has(to[c].at(0, 0), slack)) return false;
  }
  return true;
}

}  // namespace

bool is_moved_edge(const PicturePair& pair, PixelPosition pixel) {
  Surroundings around;
  if (!load_ring(pair, pixel, -1, kEdge, around) || !has_edge(around)) return false;
  if (!load_ring(pair, pixel, kEdge, kReach, around)) return false;
  const Shift shift = shift_around(around);
  return explains(around.reference, around.test, shift, around) ||
         explains(around.test, around.reference, {-shift.x, -shift.y}, around);
}

}  // namespace glassbox
