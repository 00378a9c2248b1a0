#include "tests/compare/plain_moved_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/compare/pixels/moved_edge.h>

namespace glassbox::test {
namespace {

// The values of one channel of one picture, up to 4 px from a pixel.
template <class Value>
class Patch {
public:
  Value& at(int x, int y) { return values_[std::size_t((y + 4) * 9 + x + 4)]; }
  Value at(int x, int y) const { return values_[std::size_t((y + 4) * 9 + x + 4)]; }
  bool is_finite() const {
    return std::all_of(values_.begin(), values_.end(), [](Value v) { return std::isfinite(v); });
  }

private:
  std::array<Value, 81> values_{};
};

// The patches of one channel in the reference and in the test.
template <class Value>
struct Patches {
  Patch<Value> a, b;
};

template <class Value, class Sample>
Value value_at(const std::vector<Sample>& samples, std::size_t first, int channel, int channels) {
  constexpr Sample kFull =
      std::is_integral_v<Sample> ? std::numeric_limits<Sample>::max() : Sample(1);
  const auto value = Value(samples[first + std::size_t(channel)]);
  const bool colour = channels % 2 == 0 && channel < channels - 1;
  return colour ? value * (Value(samples[first + std::size_t(channels - 1)]) / Value(kFull))
                : value;
}

template <class Value>
Patches<Value> load(const PicturePair& pair, PixelPosition pixel, int channel) {
  Patches<Value> patches;
  const int width = pair.reference.width, height = pair.reference.height;
  const int channels = pair.reference.channels;
  for (int y = -4; y <= 4; ++y) {
    for (int x = -4; x <= 4; ++x) {
      const int from_x = std::clamp(pixel.x + x, 0, width - 1);
      const int from_y = std::clamp(pixel.y + y, 0, height - 1);
      const std::size_t first = std::size_t(from_y * width + from_x) * std::size_t(channels);
      const bool compared = pair.selection.compares(from_x, from_y);
      std::visit(
          [&](const auto& reference) {
            const auto& test = std::get<std::decay_t<decltype(reference)>>(pair.test.samples);
            const auto value = [&](const auto& of) {
              return value_at<Value>(of, first, channel, channels);
            };
            patches.a.at(x, y) = value(reference);
            patches.b.at(x, y) = value(compared ? test : reference);
          },
          pair.reference.samples);
    }
  }
  return patches;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  template <class Value>
  void add(const Patch<Value>& patch, int radius) {
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) add(double(patch.at(x, y)));
    }
  }
  bool has(double value, double slack) const {
    return low - slack <= value && value <= high + slack;
  }
};

template <class Value>
bool lies_at_edge_of(const Patch<Value>& other, Value value, double rounding) {
  Interval range;
  range.add(other, 1);
  return range.has(double(value), range.high - range.low + rounding);
}

// xx, xy, yy, and x and y times the change, for one pixel around the middle one.
template <class Value>
std::array<Value, 5> products_at(const std::vector<Patches<Value>>& all, int x, int y) {
  std::array<Value, 5> sums{};
  for (const auto& [a, b] : all) {
    const Value slope_x = (a.at(x + 1, y) - a.at(x - 1, y) + b.at(x + 1, y) - b.at(x - 1, y)) / 4;
    const Value slope_y = (a.at(x, y + 1) - a.at(x, y - 1) + b.at(x, y + 1) - b.at(x, y - 1)) / 4;
    const Value change = b.at(x, y) - a.at(x, y);
    const std::array<Value, 5> own{slope_x * slope_x, slope_x * slope_y, slope_y * slope_y,
                                   slope_x * change, slope_y * change};
    for (std::size_t i = 0; i < 5; ++i) sums[i] += own[i];
  }
  return sums;
}

// Each column is summed from the top, the row of the middle last; then the columns are summed from
// the left. This is the library's order.
template <class Value>
std::array<Value, 5> sums_around(const std::vector<Patches<Value>>& all) {
  std::array<Value, 5> sums{};
  for (int x = -3; x <= 3; ++x) {
    std::array<Value, 5> column{};
    for (const int y : {-3, -2, -1, 1, 2, 3, 0}) {
      if (x == 0 && y == 0) continue;
      const auto products = products_at(all, x, y);
      for (std::size_t i = 0; i < 5; ++i) column[i] += products[i];
    }
    for (std::size_t i = 0; i < 5; ++i) sums[i] += column[i];
  }
  return sums;
}

template <class Value>
std::array<double, 2> shift_of(const std::array<Value, 5>& in) {
  const std::array<double, 5> sums{in[0], in[1], in[2], in[3], in[4]};
  const double regular = 0.01 * (sums[0] + sums[2]);
  if (!(regular > 0)) return {0, 0};
  const double xx = sums[0] + regular, xy = sums[1], yy = sums[2] + regular;
  const double determinant = xx * yy - xy * xy;
  return {std::clamp((sums[3] * yy - sums[4] * xy) / determinant, -kMaxEdgeShift, kMaxEdgeShift),
          std::clamp((sums[4] * xx - sums[3] * xy) / determinant, -kMaxEdgeShift, kMaxEdgeShift)};
}

template <class Value>
bool explains_plainly(const Patch<Value>& from, const Patch<Value>& to, double shift_x,
                      double shift_y, double rounding) {
  Interval contrast;
  contrast.add(from, 2);
  contrast.add(to, 2);
  Interval bounds{0, 0};
  for (const int j : {0, 1}) {
    for (const int i : {0, 1}) {
      const double area = (i == 0 ? 1 - std::abs(shift_x) : std::abs(shift_x)) *
                          (j == 0 ? 1 - std::abs(shift_y) : std::abs(shift_y));
      const double mean = double(from.at(shift_x < 0 ? -i : i, shift_y < 0 ? -j : j));
      bounds.low += std::max(contrast.low * area, mean - contrast.high * (1 - area));
      bounds.high += std::min(contrast.high * area, mean - contrast.low * (1 - area));
    }
  }
  const double largest = std::max(std::abs(contrast.low), std::abs(contrast.high));
  return bounds.has(double(to.at(0, 0)),
                    0.25 * (contrast.high - contrast.low) + rounding + 0x1p-48 * largest);
}

template <class Value>
bool may_be_edge(const Patches<Value>& of, double rounding) {
  return of.a.is_finite() && of.b.is_finite() && lies_at_edge_of(of.a, of.b.at(0, 0), rounding) &&
         lies_at_edge_of(of.b, of.a.at(0, 0), rounding);
}

// Whether both pictures have more contrast than rounding makes.
template <class Value>
bool has_contrast(const Patches<Value>& of, double rounding) {
  Interval a, b;
  a.add(of.a, 1);
  b.add(of.b, 1);
  return a.high - a.low > rounding && b.high - b.low > rounding;
}

template <class Value>
bool follows_plainly(const std::vector<Patches<Value>>& all, double rounding) {
  const auto every = [&](const auto& holds) { return std::all_of(all.begin(), all.end(), holds); };
  if (!every([&](const auto& of) { return may_be_edge(of, rounding); })) return false;
  if (std::none_of(all.begin(), all.end(),
                   [&](const auto& of) { return has_contrast(of, rounding); })) {
    return false;
  }
  const std::array<double, 2> shift = shift_of(sums_around(all));
  const double x = shift[0], y = shift[1];
  return every([&](const auto& of) { return explains_plainly(of.a, of.b, x, y, rounding); }) ||
         every([&](const auto& of) { return explains_plainly(of.b, of.a, -x, -y, rounding); });
}

}  // namespace

template <class Value>
bool is_moved_edge_plainly(const PicturePair& pair, PixelPosition pixel) {
  const bool floats = std::holds_alternative<std::vector<float>>(pair.reference.samples);
  std::vector<Patches<Value>> all;
  for (int c = 0; c < pair.reference.channels; ++c) all.push_back(load<Value>(pair, pixel, c));
  return follows_plainly(all, floats ? 0 : 2);
}

template bool is_moved_edge_plainly<float>(const PicturePair&, PixelPosition);
template bool is_moved_edge_plainly<double>(const PicturePair&, PixelPosition);

}  // namespace glassbox::test
