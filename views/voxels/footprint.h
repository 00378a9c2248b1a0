// Footprints: the pixels of a picture that belong to a voxel (S1-31).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "views/voxels/grid.h"
#include "views/voxels/kernels.h"
#include "views/voxels/packed_picture.h"
#include "views/voxels/statistics.h"

namespace glassbox::views {

// A camera in grid coordinates: the pixel of (x, y, z) is pixel_from_grid (x, y, z, 1),
// homogeneous. Every look-up of a voxel rounds in the same way: the start of its row is computed in
// double and rounded to float, and the steps along the row are in float (kernels.h).
struct GridPicture {
  ProjectionMatrix pixel_from_grid;
  // Offsets from a voxel's centre to its eight corners, homogeneous: x, y, w.
  std::array<float, 8> corner_x, corner_y, corner_w;
  float width = 0, height = 0;
  std::int32_t stride = 0;
};
GridPicture grid_picture(const VoxelGrid& grid, const ProjectionMatrix& pixel_from_world, int width,
                         int height);
GridPicture grid_picture(const VoxelGrid& grid, const PackedPicture& picture);
// Whether all numbers of the camera are finite as floats; then those of every look-up are, too.
bool is_finite(const GridPicture& lens);

// The row of voxels along `axis` through `at`; its voxel 0 is the one with coordinate 0.
RowPicture row_of(const GridPicture& lens, const PackedPicture& picture, const VoxelPosition& at,
                  int axis);
// The same row of voxels, without the picture's pixels.
RowPicture row_of(const GridPicture& lens, const VoxelPosition& at, int axis);

// The homogeneous position of voxel i of a row in the picture.
struct Projected {
  float x, y, w;
};
inline Projected projected(const RowPicture& row, int i) {
  const float place = float(i);
  return {row.x + place * row.dx, row.y + place * row.dy, row.w + place * row.dw};
}
// The position of one voxel's centre, computed as in its row along x.
Projected centre_of(const GridPicture& lens, const VoxelPosition& at);

// The pixel of a voxel's centre; column < 0 if it is outside of the picture or behind the camera.
struct PixelPosition {
  int column = -1, row = -1;
};
inline PixelPosition centre_pixel(const Projected& p, float width, float height) {
  const float inverse = 1.0f / p.w, u = p.x * inverse, v = p.y * inverse;
  const bool inside = u >= 0 && u < width && v >= 0 && v < height && p.w > 0;
  return inside ? PixelPosition{int(u), int(v)} : PixelPosition{};
}

// Calls visit(column, row) for each pixel of the footprint that is inside the picture. If a corner
// of the voxel is not in front of the camera, or is projected to no finite position, only the pixel
// of its centre is visited.
template <class Visit>
void for_each_pixel(const GridPicture& lens, const Projected& centre, Footprint footprint,
                    const Visit& visit);

namespace footprint_detail {

struct Corner {
  float u, v;
};

// The convex hull, counter-clockwise or clockwise, without points in between: Andrew's monotone
// chain (1979).
inline int hull_of(std::array<Corner, 8>& corners, std::array<Corner, 16>& hull) {
  std::ranges::sort(
      corners, [](const Corner& a, const Corner& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  const auto turn = [](const Corner& o, const Corner& a, const Corner& b) {
    return double(a.u - o.u) * double(b.v - o.v) - double(a.v - o.v) * double(b.u - o.u);
  };
  int n = 0;
  for (int i = 0; i < 8; ++i) {
    while (n >= 2 &&
           turn(hull[std::size_t(n - 2)], hull[std::size_t(n - 1)], corners[std::size_t(i)]) <= 0)
      --n;
    hull[std::size_t(n++)] = corners[std::size_t(i)];
  }
  const int lower = n + 1;
  for (int i = 6; i >= 0; --i) {
    while (n >= lower &&
           turn(hull[std::size_t(n - 2)], hull[std::size_t(n - 1)], corners[std::size_t(i)]) <= 0)
      --n;
    hull[std::size_t(n++)] = corners[std::size_t(i)];
  }
  return n - 1;
}

inline bool is_inside(const std::array<Corner, 16>& hull, int sides, float u, float v) {
  for (int i = 0; i < sides; ++i) {
    const Corner &a = hull[std::size_t(i)], &b = hull[std::size_t((i + 1) % sides)];
    if (double(b.u - a.u) * double(v - a.v) - double(b.v - a.v) * double(u - a.u) < 0) return false;
  }
  return true;
}

}  // namespace footprint_detail

template <class Visit>
void for_each_pixel(const GridPicture& lens, const Projected& centre, Footprint footprint,
                    const Visit& visit) {
  using footprint_detail::Corner;
  const PixelPosition middle = centre_pixel(centre, lens.width, lens.height);
  if (footprint == Footprint::kCentre) {
    if (middle.column >= 0) visit(middle.column, middle.row);
    return;
  }
  std::array<float, 8> u, v, w;
  for (std::size_t i = 0; i < 8; ++i) w[i] = centre.w + lens.corner_w[i];
  float nearest = w[0];
  for (std::size_t i = 1; i < 8; ++i) nearest = std::min(nearest, w[i]);
  if (!(nearest > 0)) {
    if (middle.column >= 0) visit(middle.column, middle.row);
    return;
  }
  for (std::size_t i = 0; i < 8; ++i) {
    u[i] = (centre.x + lens.corner_x[i]) / w[i];
    v[i] = (centre.y + lens.corner_y[i]) / w[i];
  }
  // If one of the numbers is infinite or NaN, the sum is not finite.
  float all = 0;
  for (std::size_t i = 0; i < 8; ++i) all += std::abs(u[i]) + std::abs(v[i]);
  if (!std::isfinite(all)) {
    if (middle.column >= 0) visit(middle.column, middle.row);
    return;
  }
  float left = u[0], right = u[0], top = v[0], bottom = v[0];
  for (std::size_t i = 1; i < 8; ++i) {
    left = std::min(left, u[i]);
    right = std::max(right, u[i]);
    top = std::min(top, v[i]);
    bottom = std::max(bottom, v[i]);
  }
  // The pixels whose centres are inside the bounding box, limited to the picture before conversion
  // to integers.
  const int x0 = int(std::ceil(std::clamp(left - 0.5f, 0.0f, lens.width)));
  const int x1 = int(std::floor(std::clamp(right - 0.5f, -1.0f, lens.width - 1)));
  const int y0 = int(std::ceil(std::clamp(top - 0.5f, 0.0f, lens.height)));
  const int y1 = int(std::floor(std::clamp(bottom - 0.5f, -1.0f, lens.height - 1)));
  bool has_middle = middle.column < 0;
  if (footprint == Footprint::kBox) {
    for (int row = y0; row <= y1; ++row)
      for (int column = x0; column <= x1; ++column) visit(column, row);
    has_middle = has_middle || (middle.column >= x0 && middle.column <= x1 && middle.row >= y0 &&
                                middle.row <= y1);
  } else {
    std::array<Corner, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = {u[i], v[i]};
    std::array<Corner, 16> hull;
    const int sides = footprint_detail::hull_of(corners, hull);
    for (int row = y0; row <= y1; ++row) {
      for (int column = x0; column <= x1; ++column) {
        if (!footprint_detail::is_inside(hull, sides, float(column) + 0.5f, float(row) + 0.5f))
          continue;
        has_middle = has_middle || (column == middle.column && row == middle.row);
        visit(column, row);
      }
    }
  }
  if (!has_middle) visit(middle.column, middle.row);
}

// The pictures' information about one voxel.
struct VoxelObservation {
  ColorSums sums;  // over the pixels where the voxel is not hidden, in codes
  int views = 0;   // pictures with at least one such pixel
  // The deviation around the voxel within each picture that sees it, summed over these pictures, in
  // codes.
  double spread = 0;
  double least_spread = 0;
  bool is_background = false;
  bool is_inconsistent = false;  // found before all pictures were looked at
  Rgba8 color;                   // the mean; for coloured voxels only
};

}  // namespace glassbox::views
