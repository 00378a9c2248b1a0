// Records how near the opaque triangles are that cover each part of the picture: what is behind
// them is occluded.
//
// Each cell of 16 x 16 pixels has a depth code that bounds the whole cell: all of it is covered at
// least as near as that code. A second layer is being built: which of its pixels the later
// triangles have covered, and the farthest of their codes (after Hasselgren, Andersson and
// Akenine-Moeller, Masked Software Occlusion Culling, 2016). As in drawing, edge functions decide
// which pixels a triangle covers.
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

class OcclusionBuffer {
public:
  static constexpr int kCell = 16;  // pixels

  // `points`: the sample points of each pixel, or its centre. Each point is treated separately.
  OcclusionBuffer(const PixelRect& window, std::span<const SampleOffset> points);

  // Adds a triangle. All its fragments have codes of at most `farthest`.
  void add(const TriangleSetup& triangle, std::uint32_t farthest);

  // Whether something that was added is at least as near as `nearest`, at every sample point of
  // `pixels` that is in the window.
  bool occludes(const PixelRect& pixels, std::uint32_t nearest) const;

  bool covers_nothing() const { return closed_ == 0; }

  // The cost of adding so far, in units of one triangle drawn by the vectorised code.
  std::size_t work() const { return work_; }

private:
  using Rows = std::array<std::uint16_t, kCell>;  // pixels of a cell; bit i: pixel i
  struct Cell {
    std::uint32_t farthest = kEmptyDepth;  // of what covers the whole cell
    std::uint32_t next = 0;                // of what covers all but the open pixels
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
  std::vector<Cell> cells_;  // row by row; first those of the first point, then of the second ...
  std::size_t closed_ = 0;   // how often a cell was closed
  std::size_t work_ = 0;
};

}  // namespace glassbox
