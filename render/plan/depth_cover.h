// How near the picture is covered, part by part, by opaque triangles: what lies behind them is not seen.
//
// For each cell of 16 x 16 pixels a code that all of it is at least as near as, and another one in the making: which of its pixels
// the triangles since have covered, and the farthest of their codes (after Hasselgren, Andersson and Akenine-Moeller, Masked
// Software Occlusion Culling, 2016). Which pixels a triangle covers is asked of its edge functions, as drawing does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/raster/depth.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

class DepthCover {
public:
  static constexpr int kCell = 16;  // pixels

  // `points` of each pixel: its samples, or its centre. One triangle after the other covers all, or what it covers does not count.
  DepthCover(const PixelRect& window, std::span<const SampleOffset> points);

  // All fragments of the triangle have codes of at most `farthest`.
  void add(const TriangleSetup& triangle, std::uint32_t farthest);

  // Whether something that was added is at least as near as `nearest`, at every point of the pixels that lie in the window.
  bool hides(const PixelRect& pixels, std::uint32_t nearest) const;

  bool covers_nothing() const { return closed_ == 0; }

  // What adding has cost so far: about as much as so many triangles through the lanes.
  std::size_t work() const { return work_; }

private:
  using Rows = std::array<std::uint16_t, kCell>;  // of a cell; bit i: pixel i
  struct Cell {
    std::uint32_t farthest = kEmptyDepth;  // of what covers all of it
    std::uint32_t next = 0;                // the same of what covers all but the open pixels
    Rows open{};
  };

  PixelRect cells_of(const PixelRect& pixels) const;
  Rows pixels_in_window(int cell_x, int cell_y) const;
  void add_to_cell(const TriangleSetup& triangle, int cell_x, int cell_y, std::uint32_t farthest,
                   Cell& cell);
  std::size_t cells_of_point() const { return std::size_t(across_) * std::size_t(down_); }

  PixelRect window_;
  int across_ = 0, down_ = 0;
  std::vector<SampleOffset> points_;
  std::vector<Cell> cells_;  // row by row; of the first point, of the second ...
  std::size_t closed_ = 0;   // times that a cell was
  std::size_t work_ = 0;
};

}  // namespace glassbox
