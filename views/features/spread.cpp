#include "views/features/spread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include <tbb/parallel_for.h>

#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

// The corners by square cells. Corners are in the order of falling strength, and so are the numbers
// of the corners in a cell.
class CornerCells {
public:
  CornerCells(const std::vector<PictureCorner>& corners, double largest_radius, int width,
              int height)
      : corners_(corners),
        largest_radius_(largest_radius),
        side_(std::max(4.0, largest_radius / 8)),
        columns_(int(width / side_) + 1),
        rows_(int(height / side_) + 1),
        cells_(std::size_t(columns_) * std::size_t(rows_)) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      cells_[cell(column(corners[i]), row(corners[i]))].push_back(std::uint32_t(i));
    }
  }

  // The distance to the nearest clearly stronger corner. Cells of the ring r around the own cell
  // are at least r - 1 sides away.
  double radius_of(const PictureCorner& own) const {
    double square = largest_radius_ * largest_radius_;
    for (int ring = 0;; ++ring) {
      const double reached = std::max(0, ring - 1) * side_;
      if (reached * reached >= square) return std::sqrt(square);
      for (int y = row(own) - ring; y <= row(own) + ring; ++y) {
        const bool is_whole_row = std::abs(y - row(own)) == ring;
        const int step = is_whole_row || ring == 0 ? 1 : 2 * ring;
        for (int x = column(own) - ring; x <= column(own) + ring; x += step) {
          square = std::min(square, nearest_square(own, x, y));
        }
      }
    }
  }

private:
  int column(const PictureCorner& corner) const {
    return std::clamp(int(corner.x / side_), 0, columns_ - 1);
  }
  int row(const PictureCorner& corner) const {
    return std::clamp(int(corner.y / side_), 0, rows_ - 1);
  }
  std::size_t cell(int x, int y) const {
    return std::size_t(y) * std::size_t(columns_) + std::size_t(x);
  }

  double nearest_square(const PictureCorner& own, int x, int y) const {
    double square = largest_radius_ * largest_radius_;
    if (x < 0 || x >= columns_ || y < 0 || y >= rows_) return square;
    for (const std::uint32_t i : cells_[cell(x, y)]) {
      const PictureCorner& other = corners_[i];
      if (!(kClearlyWeaker * other.strength > own.strength)) break;
      const double dx = other.x - own.x, dy = other.y - own.y;
      square = std::min(square, dx * dx + dy * dy);
    }
    return square;
  }

  const std::vector<PictureCorner>& corners_;
  double largest_radius_;
  double side_;  // px
  int columns_, rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::vector<PictureCorner> spread_out(std::vector<PictureCorner> corners, int count, int width,
                                      int height) {
  std::ranges::sort(corners, [](const PictureCorner& a, const PictureCorner& b) {
    return std::tuple(-a.strength, a.y, a.x) < std::tuple(-b.strength, b.y, b.x);
  });
  if (count <= 0) return {};
  if (corners.size() <= std::size_t(count)) return corners;
  const double largest = 2 * std::sqrt(double(width) * double(height) / (kPi * count));
  const CornerCells cells(corners, largest, width, height);
  std::vector<double> radii(corners.size());
  tbb::parallel_for(std::size_t(0), corners.size(),
                    [&](std::size_t i) { radii[i] = cells.radius_of(corners[i]); });
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  order.resize(std::size_t(count));
  std::ranges::sort(order);
  std::vector<PictureCorner> chosen;
  for (const std::size_t i : order) chosen.push_back(corners[i]);
  return chosen;
}

}  // namespace glassbox::views
