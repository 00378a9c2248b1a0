#include <glassbox/render/plan/depth_cover.h>

#include <algorithm>

#include <glassbox/raster/triangle_setup.h>

namespace glassbox {

namespace {

constexpr int kCell = DepthCover::kCell;

int cells_across(int pixels) {
  return (pixels + kCell - 1) / kCell;
}

// The edge functions of a triangle over the points of a cell. They are linear: what they are largest and smallest at are corners.
class EdgesOverCell {
public:
  EdgesOverCell(const TriangleSetup& triangle, const SampleOffset& point, int cell_x, int cell_y)
      : triangle_(triangle) {
    const std::int64_t x = std::int64_t(cell_x) * kCell * kSubpixels + kPixelCentre + point.x;
    const std::int64_t y = std::int64_t(cell_y) * kCell * kSubpixels + kPixelCentre + point.y;
    for (std::size_t k = 0; k < 3; ++k) {
      const EdgeFunction& edge = triangle.edges[k];
      first_[k] = edge.at(x, y);
      right_[k] = edge.a * kSubpixels;
      down_[k] = edge.b * kSubpixels;
    }
  }

  bool covers_nothing() const {
    const auto misses_all = [&](std::size_t k) {
      const std::int64_t largest = first_[k] + kLast * (std::max<std::int64_t>(right_[k], 0) +
                                                        std::max<std::int64_t>(down_[k], 0));
      return !triangle_.edges[k].covers(largest);
    };
    return misses_all(0) || misses_all(1) || misses_all(2);
  }
  bool covers_all() const {
    const auto covers_all = [&](std::size_t k) {
      const std::int64_t smallest = first_[k] + kLast * (std::min<std::int64_t>(right_[k], 0) +
                                                         std::min<std::int64_t>(down_[k], 0));
      return triangle_.edges[k].covers(smallest);
    };
    return covers_all(0) && covers_all(1) && covers_all(2);
  }
  // Bit i: pixel i of the row.
  unsigned covered(int row) const {
    unsigned bits = 0;
    for (int i = 0; i < kCell; ++i) {
      const auto covers = [&](std::size_t k) {
        return triangle_.edges[k].covers(first_[k] + right_[k] * i + down_[k] * row);
      };
      bits |= unsigned(covers(0) && covers(1) && covers(2)) << i;
    }
    return bits;
  }

private:
  static constexpr int kLast = kCell - 1;
  const TriangleSetup& triangle_;
  std::array<std::int64_t, 3> first_, right_, down_;
};

}  // namespace

DepthCover::DepthCover(const PixelRect& window, std::span<const SampleOffset> points)
    : window_(window),
      across_(cells_across(window.x1)),
      down_(cells_across(window.y1)),
      points_(points.begin(), points.end()),
      cells_(cells_of_point() * points_.size()) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const int cell = int(i % cells_of_point());
    cells_[i].open = pixels_in_window(cell % across_, cell / across_);
  }
}

DepthCover::Rows DepthCover::pixels_in_window(int cell_x, int cell_y) const {
  const int width = std::min(window_.x1 - cell_x * kCell, kCell);
  const int height = std::min(window_.y1 - cell_y * kCell, kCell);
  Rows rows{};
  std::fill_n(rows.begin(), height, std::uint16_t((1u << width) - 1));
  return rows;
}

PixelRect DepthCover::cells_of(const PixelRect& pixels) const {
  const PixelRect seen = intersect(pixels, window_);
  if (seen.empty()) return {};
  return {seen.x0 / kCell, seen.y0 / kCell, cells_across(seen.x1), cells_across(seen.y1)};
}

void DepthCover::add(const TriangleSetup& triangle, std::uint32_t farthest) {
  const PixelRect reached = cells_of(sampled_bounds(triangle.bounds));
  Cell* cells = cells_.data();
  for (const SampleOffset& point : points_) {
    for (int y = reached.y0; y < reached.y1; ++y) {
      for (int x = reached.x0; x < reached.x1; ++x) {
        add_to_cell(triangle, point, x, y, farthest, cells[y * across_ + x]);
      }
    }
    cells += cells_of_point();
  }
}

void DepthCover::add_to_cell(const TriangleSetup& triangle, const SampleOffset& point, int cell_x,
                             int cell_y, std::uint32_t farthest, Cell& cell) {
  ++work_;
  if (farthest >= cell.farthest) return;  // what is there is as near
  const EdgesOverCell edges(triangle, point, cell_x, cell_y);
  if (edges.covers_nothing()) return;
  if (edges.covers_all()) {
    cell.next = farthest;
    cell.open = {};
  } else {
    work_ += 2 * kCell;
    for (int row = 0; row < kCell; ++row) {
      std::uint16_t& open = cell.open[std::size_t(row)];
      const unsigned covered = open & edges.covered(row);
      if (covered != 0) cell.next = std::max(cell.next, farthest);
      open = std::uint16_t(open & ~covered);
    }
  }
  if (cell.open != Rows{}) return;
  cell = {cell.next, 0, pixels_in_window(cell_x, cell_y)};
  ++closed_;
}

bool DepthCover::hides(const PixelRect& pixels, std::uint32_t nearest) const {
  const PixelRect reached = cells_of(pixels);
  const Cell* cells = cells_.data();
  for (std::size_t point = 0; point < points_.size(); ++point) {
    for (int y = reached.y0; y < reached.y1; ++y) {
      for (int x = reached.x0; x < reached.x1; ++x) {
        if (nearest < cells[y * across_ + x].farthest) return false;
      }
    }
    cells += cells_of_point();
  }
  return !reached.empty();
}

}  // namespace glassbox
