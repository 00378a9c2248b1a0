#include "views/features/corners.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace glassbox::views {

namespace {

double least_response(const Image<float>& map, Detector detector) {
  const float largest = *std::ranges::max_element(map.pixels);
  if (detector == Detector::kShiTomasi) {
    return std::max(kLeastShare * double(largest), kFaintestCorner);
  }
  const double faintest = corner_response(detector, kFaintestCorner, 0, kFaintestCorner);
  return std::max(kLeastShare * kLeastShare * double(largest), faintest);
}

bool is_maximum(const Image<float>& map, int x, int y) {
  const float own = map.at(x, y);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const float other = map.at(x + dx, y + dy);
      const bool is_before = dy < 0 || (dy == 0 && dx < 0);
      if (is_before ? other >= own : other > own) return false;
    }
  }
  return true;
}

PictureCorner corner_at(const Image<float>& map, int x, int y) {
  std::array<std::array<double, 3>, 3> around;
  for (int dy = 0; dy < 3; ++dy) {
    for (int dx = 0; dx < 3; ++dx) {
      around[std::size_t(dy)][std::size_t(dx)] = double(map.at(x + dx - 1, y + dy - 1));
    }
  }
  const auto [right, down] = quadratic_peak(around);
  return {x + 0.5 + right, y + 0.5 + down, double(map.at(x, y))};
}

}  // namespace

std::array<double, 2> quadratic_peak(const std::array<std::array<double, 3>, 3>& r) {
  const double gx = (r[1][2] - r[1][0]) / 2, gy = (r[2][1] - r[0][1]) / 2;
  const double hxx = r[1][2] - 2 * r[1][1] + r[1][0], hyy = r[2][1] - 2 * r[1][1] + r[0][1];
  const double hxy = (r[2][2] - r[2][0] - r[0][2] + r[0][0]) / 4;
  const double determinant = hxx * hyy - hxy * hxy;
  if (!(hxx < 0 && determinant > 0)) return {0, 0};
  const double x = (hxy * gy - hyy * gx) / determinant, y = (hxy * gx - hxx * gy) / determinant;
  if (!(std::abs(x) <= 1 && std::abs(y) <= 1)) return {0, 0};
  return {x, y};
}

std::vector<PictureCorner> corners_of(const Image<float>& map, Detector detector, int margin) {
  if (map.pixels.empty()) return {};
  const double least = least_response(map, detector);
  std::vector<std::vector<PictureCorner>> rows(std::size_t(map.height));
  tbb::parallel_for(margin, std::max(margin, map.height - margin), [&](int y) {
    for (int x = margin; x < map.width - margin; ++x) {
      if (double(map.at(x, y)) < least || !is_maximum(map, x, y)) continue;
      rows[std::size_t(y)].push_back(corner_at(map, x, y));
    }
  });
  std::vector<PictureCorner> corners;
  for (const auto& row : rows) corners.insert(corners.end(), row.begin(), row.end());
  return corners;
}

}  // namespace glassbox::views
