#include <glassbox/mesh/ply/colors.h>

#include <algorithm>
#include <cmath>

#include <glassbox/images/srgb.h>

namespace glassbox::ply {
namespace {

constexpr const char* kTypeNames[] = {"char", "uchar", "short", "ushort",
                                      "int",  "uint",  "float", "double"};

double largest_of(Type type) {
  constexpr double kLargest[] = {127, 255, 32767, 65535, 2147483647, 4294967295, 1, 1};
  return kLargest[std::size_t(type)];
}

// The end of the range of numbers of a type, the largest of which is `largest`.
double range_end(Type type, double largest) {
  const double own = largest_of(type);
  if (is_integer(type) ? own <= 255 : largest < 2) return own;
  if (largest <= 255) return 255;
  return is_integer(type) && (own < 65535 || largest > 65535) ? own : 65535;
}

// The number as a fraction of its range, clamped to [0, 1]; NaN becomes 0.
double fraction(double number, double end) {
  return number > 0 ? std::min(number / end, 1.0) : 0.0;
}

float light(double number, double end) {
  return decode_srgb(std::uint8_t(std::floor(fraction(number, end) * 255 + 0.5)));
}

}  // namespace

void ColorTable::add(const Element& element, const ColorPropertyIndices& indices,
                     const std::vector<double>& row) {
  std::array<double, 4> color{};
  const PropertyIndex channels[] = {indices.red, indices.green, indices.blue, indices.alpha};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!channels[i]) continue;
    const double number = row[*channels[i]];
    color[i] = number;
    types_[i] = element.properties[*channels[i]].type;
    double& largest = largest_[std::size_t(types_[i])];
    if (number > largest && std::isfinite(number)) largest = number;
  }
  has_alpha_ = indices.alpha.has_value();
  written_.push_back(color);
}

std::vector<Rgba> ColorTable::take(const std::string& element, obj::Warnings& warnings) {
  std::array<double, kTypes> ends{};
  for (std::size_t i = 0; i < kTypes; ++i) {
    ends[i] = range_end(Type(i), largest_[i]);
    if (largest_[i] == 0 || ends[i] == largest_of(Type(i))) continue;
    warnings.add("the colours of element '" + element + "' are of the type " + kTypeNames[i] +
                 ", and none is above " + std::to_string(std::int64_t(std::ceil(largest_[i]))) +
                 ": they are read as 0 to " + std::to_string(std::int64_t(ends[i])));
  }
  const auto end = [&](std::size_t channel) { return ends[std::size_t(types_[channel])]; };
  std::vector<Rgba> colors;
  colors.reserve(written_.size());
  for (const auto& [r, g, b, a] : written_) {
    colors.push_back({light(r, end(0)), light(g, end(1)), light(b, end(2)),
                      has_alpha_ ? float(fraction(a, end(3))) : 1.0f});
  }
  written_ = {};
  return colors;
}

}  // namespace glassbox::ply
