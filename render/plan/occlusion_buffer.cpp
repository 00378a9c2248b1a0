#include <glassbox/render/plan/occlusion_buffer.h>

#include <algorithm>

#include <glassbox/raster/coverage.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox {

namespace {

constexpr int kCell = OcclusionBuffer::kCell;

int cells_across(int pixels) {
  return (pixels + kCell - 1) / kCell;
}

// Returns a triangle whose edge functions have at each pixel centre the values that `triangle` has
// at a sample point of that pixel.
TriangleSetup seen_at(TriangleSetup triangle, const SampleOffset& point) {
  for (EdgeFunction& edge : triangle.edges) edge.c += edge.a * point.x + edge.b * point.y;
  triangle.bounds = sampled_bounds(triangle.bounds);
  return triangle;
}

enum class CellCoverage { kNothing, kPart, kAll };

// Returns how much the triangle covers of the pixels x0 .. x0 + 15, y0 .. y0 + 15. Edge functions
// are linear, so over a square their largest and smallest values are at corners.
CellCoverage cell_coverage(const TriangleSetup& triangle, int x0, int y0) {
  bool all = true;
  for (const EdgeFunction& edge : triangle.edges) {
    const std::int64_t first = edge.at(std::int64_t(x0) * kSubpixels + kPixelCentre,
                                       std::int64_t(y0) * kSubpixels + kPixelCentre);
    const std::int64_t right = edge.a * kSubpixels * (kCell - 1);
    const std::int64_t down = edge.b * kSubpixels * (kCell - 1);
    const auto [left_end, right_end] = std::minmax({std::int64_t{0}, right});
    const auto [upper_end, lower_end] = std::minmax({std::int64_t{0}, down});
    if (!edge.covers(first + right_end + lower_end)) return CellCoverage::kNothing;
    all = all && edge.covers(first + left_end + upper_end);
  }
  return all ? CellCoverage::kAll : CellCoverage::kPart;
}

}  // namespace

OcclusionBuffer::OcclusionBuffer(const PixelRect& window, std::span<const SampleOffset> points)
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

OcclusionBuffer::Rows OcclusionBuffer::pixels_in_window(int cell_x, int cell_y) const {
  const int width = std::min(window_.x1 - cell_x * kCell, kCell);
  const int height = std::min(window_.y1 - cell_y * kCell, kCell);
  Rows rows{};
  std::fill_n(rows.begin(), height, std::uint16_t((1u << width) - 1));
  return rows;
}

PixelRect OcclusionBuffer::cells_of(const PixelRect& pixels) const {
  const PixelRect seen = intersect(pixels, window_);
  if (seen.empty()) return {};
  return {seen.x0 / kCell, seen.y0 / kCell, cells_across(seen.x1), cells_across(seen.y1)};
}

void OcclusionBuffer::add(const TriangleSetup& triangle, std::uint32_t farthest) {
  Cell* cells = cells_.data();
  for (const SampleOffset& point : points_) {
    const TriangleSetup at_point = seen_at(triangle, point);
    const PixelRect reached = cells_of(at_point.bounds);
    for (int y = reached.y0; y < reached.y1; ++y) {
      for (int x = reached.x0; x < reached.x1; ++x) {
        add_to_cell(at_point, x, y, farthest, cells[y * across_ + x]);
      }
    }
    cells += cells_of_point();
  }
}

void OcclusionBuffer::add_to_cell(const TriangleSetup& triangle, int cell_x, int cell_y,
                                  std::uint32_t farthest, Cell& cell) {
  ++work_;
  if (farthest >= cell.farthest) return;  // the cell is already covered as near or nearer
  const int x0 = cell_x * kCell, y0 = cell_y * kCell;
  switch (cell_coverage(triangle, x0, y0)) {
    case CellCoverage::kNothing:
      return;
    case CellCoverage::kAll:
      cell.next = farthest;
      cell.open = {};
      break;
    case CellCoverage::kPart:
      work_ += 2 * kCell;
      for_each_covered(triangle, {x0, y0, x0 + kCell, y0 + kCell}, [&](const Coverage& at) {
        std::uint16_t& open = cell.open[std::size_t(at.y - y0)];
        const auto pixel = std::uint16_t(1u << (at.x - x0));
        if ((open & pixel) != 0) cell.next = std::max(cell.next, farthest);
        open = std::uint16_t(open & ~pixel);
      });
      break;
  }
  if (cell.open != Rows{}) return;
  cell = {cell.next, 0, pixels_in_window(cell_x, cell_y)};
  ++closed_;
}

bool OcclusionBuffer::occludes(const PixelRect& pixels, std::uint32_t nearest) const {
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
