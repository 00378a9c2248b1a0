// Records how near the opaque triangles are that cover each part of the picture: what is behind
// them is occluded.
//
// Each cell of 16 x 16 pixels has a depth code that bounds the whole cell: all of it is covered at
// least as near as that code. In addition, the cell records which of its pixels have been covered
// by triangles since then, and the farthest of their codes; when all pixels are covered, this code
// becomes the new bound of the cell (after Hasselgren, Andersson and Akenine-Moeller, Masked
// Software Occlusion Culling, 2016). As in drawing, edge functions decide which pixels a triangle
// covers.
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

  // Whether at every sample point of the part of `pixels` that is in the window, something that was
  // added has a depth code of at most `nearest`.
  bool occludes(const PixelRect& pixels, std::uint32_t nearest) const;

  bool covers_nothing() const { return closed_ == 0; }

  // The cost of adding so far, in units of one triangle drawn by the vectorised code.
  std::size_t work() const { return work_; }

private:
  // The pixels of a cell, row by row; bit i: pixel i.
  using Rows = std::array<std::uint16_t, kCell>;
  struct Cell {
    std::uint32_t farthest = kEmptyDepth;  // the whole cell is covered at least as near
    std::uint32_t next = 0;                // all pixels but `open` are covered at least as near
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
  std::vector<Cell> cells_;  // row by row, for sample point 0, then for point 1 ...
  std::size_t closed_ = 0;   // how often a cell became wholly covered
  std::size_t work_ = 0;
};

}  // namespace glassbox
