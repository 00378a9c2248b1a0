#include "labs/commands/report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "labs/framework/compare.h"

namespace glassbox::labs {

namespace {

constexpr Rgba8 kMissing{179, 38, 30, 255}, kDouble{217, 95, 2, 255}, kExtra{22, 104, 214, 255};

std::uint8_t grey_of(double value, double most) {
  const double share = most > 0 && std::isfinite(value) ? std::clamp(value / most, 0.0, 1.0) : 0;
  return std::uint8_t(std::lround(24 + 216 * share));
}

using Corners = std::vector<std::pair<double, double>>;

// The x and y of each vertex, divided by w if the vertex has a w. Vertices at infinity are left
// out.
Corners corners_of(const std::vector<double>& values, std::size_t columns) {
  Corners corners;
  for (std::size_t i = 0; i + columns <= values.size(); i += columns) {
    const double w = columns >= 4 ? values[i + 3] : 1;
    const double x = values[i] / w, y = values[i + 1] / w;
    if (std::isfinite(x) && std::isfinite(y)) corners.emplace_back(x, y);
  }
  return corners;
}

}  // namespace

CoveragePictures coverage_pictures(const labs::Expected& expected,
                                   const std::vector<double>& actual) {
  const int width = labs::columns_of(expected);
  const int height = int(expected.values.size() / std::size_t(std::max(1, width)));
  CoveragePictures made{Image<Rgba8>(width, height), Image<Rgba8>(width, height),
                        Image<Rgba8>(width, height)};
  double most = 0;
  for (const double value : expected.values) {
    if (std::isfinite(value)) most = std::max(most, value);
  }
  for (std::size_t i = 0; i < made.expected.pixels.size(); ++i) {
    const double wanted = expected.values[i];
    const double given = i < actual.size() ? actual[i] : 0;
    const std::uint8_t grey = grey_of(wanted, most), theirs = grey_of(given, most);
    made.expected.pixels[i] = {grey, grey, grey, 255};
    made.actual.pixels[i] = {theirs, theirs, theirs, 255};
    const std::uint8_t faint = std::uint8_t(grey / 2);
    if (labs::distance_between(wanted, given) <= expected.bound) {
      made.difference.pixels[i] = {faint, faint, faint, 255};
    } else if (!(given >= wanted)) {
      made.difference.pixels[i] = kMissing;
    } else {
      made.difference.pixels[i] = wanted > 0 ? kDouble : kExtra;
    }
  }
  return made;
}

std::string polygon_drawing(const labs::Expected& expected, const std::vector<double>& actual) {
  const auto columns = std::size_t(labs::columns_of(expected));
  if (columns < 2) return {};
  const Corners wanted = corners_of(expected.values, columns), given = corners_of(actual, columns);
  Corners all = wanted;
  all.insert(all.end(), given.begin(), given.end());
  if (all.empty()) return {};
  double left = all[0].first, right = left, low = all[0].second, high = low;
  for (const auto& [x, y] : all) {
    left = std::min(left, x);
    right = std::max(right, x);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  constexpr double kSize = 300, kMargin = 20;  // px
  const double extent = std::max({right - left, high - low, 1e-30});
  const auto points = [&](const Corners& corners) {
    std::string text;
    for (const auto& [x, y] : corners)
      text += fmt::format("{:.2f},{:.2f} ", kMargin + kSize * ((x - left) / extent),
                          kMargin + kSize * ((high - y) / extent));
    return text;
  };
  return fmt::format(
      "<figure><svg role=\"img\" aria-label=\"two polygons\" width=\"{0}\" height=\"{0}\">"
      "<polygon points=\"{1}\" fill=\"#1668d6\" fill-opacity=\".3\" stroke=\"#1668d6\"/>"
      "<polygon points=\"{2}\" fill=\"none\" stroke=\"#d95f02\" stroke-width=\"2\" "
      "stroke-dasharray=\"6 3\"/></svg>"
      "<figcaption>blue: expected; dashed orange: yours (x and y{3})</figcaption></figure>\n",
      kSize + 2 * kMargin, points(wanted), points(given), columns >= 4 ? " over w" : "");
}

}  // namespace glassbox::labs
