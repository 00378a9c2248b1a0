// Finds where two pictures differ and by how much, exactly, in steps of their format: 1/255,
// 1/65535, or ulps of a float.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// A difference larger than any number of steps: between NaN and a number, or an infinity and
// anything else.
inline constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

// Differences that are set aside: they are counted apart, and are no reason to call two pictures
// different.
struct SetAside {
  // Distances up to this one, in [0, 1]: see perceived_distance.h. Not for pictures of floats.
  std::optional<double> threshold = {};
  bool moved_edges = false;  // see moved_edge.h
  bool empty() const { return !threshold && !moved_edges; }
};

enum class PixelKind : std::uint8_t { kSame, kDifferent, kMovedEdge, kBelowThreshold };

// Two pictures of the same size, channels and format, and the pixels of them that are compared.
struct PicturePair {
  const StoredImage& reference;
  const StoredImage& test;
  const Selection& selection;
  bool nan_equals_nan = false;
  SetAside set_aside = {};
  // The kinds of all pixels, row by row, if find_differences has found them already.
  std::span<const PixelKind> kinds = {};
};

// The number of floats from a to b: 0 for the same bits, 1 for neighbours; -0 and +0 are neighbours
// too. The distance from NaN to everything is kUnbounded, also to NaN unless `nan_equals_nan`; so
// is the distance from an infinity to everything else.
std::uint32_t ulp_distance(float a, float b, bool nan_equals_nan);

// Computes the largest difference of a channel in each pixel of row y, in steps; 0 where the
// selection leaves the pixel out. `steps` has one element per pixel. Returns false if the rows are
// equal, so that all steps are 0.
bool row_differences(const PicturePair& pair, int y, std::span<std::uint32_t> steps);

struct PixelPosition {
  int x = 0, y = 0;
  friend bool operator==(const PixelPosition&, const PixelPosition&) = default;
};

// Pixels that differ and touch each other, corners included.
struct Region {
  PixelBox box;
  std::uint64_t pixels = 0;
  std::uint32_t largest = 0;  // steps
  PixelPosition worst;        // the first pixel in row order that differs by `largest`
};

// Differing pixels that are set aside.
struct SetAsidePixels {
  std::uint64_t pixels = 0;
  std::uint32_t largest = 0;  // steps
};

struct Differences {
  std::uint64_t compared = 0;   // pixels
  std::uint64_t differing = 0;  // pixels, without those that are set aside
  std::uint32_t largest = 0;    // steps
  PixelPosition first;          // in row order; valid where differing > 0
  PixelBox box;                 // around all pixels that differ
  std::uint64_t region_count = 0;
  // sorted by largest difference and then by number of pixels, the worst first; `kept_regions` at
  // most
  std::vector<Region> regions;
  SetAsidePixels moved_edges, below_threshold;
  bool has_any() const {
    return differing > 0 || moved_edges.pixels > 0 || below_threshold.pixels > 0;
  }
};

// The rows of a pair from the top: how much each pixel differs, and what its difference is. A pixel
// that is below the threshold is not also counted as a moved edge. Some rows are computed together;
// the memory is proportional to them.
class DifferenceRows {
public:
  explicit DifferenceRows(const PicturePair& pair);

  // Goes to the next row, at first to row 0. Returns false after the last row.
  bool next();
  int y() const { return y_; }
  // In steps, as row_differences computes them. The caller may change them.
  std::span<std::uint32_t> steps() { return row_of(steps_, row()); }
  std::span<const PixelKind> kinds() { return row_of(kinds_, row()); }
  // False if the rows of both pictures are equal.
  bool may_differ() const { return may_differ_[std::size_t(row())]; }

private:
  void compute_together();
  void find_kinds(int rows);
  int row() const { return y_ % rows_together_; }
  template <class T>
  std::span<T> row_of(std::vector<T>& rows, int row) const {
    const auto width = std::size_t(pair_.reference.width);
    return std::span<T>(rows).subspan(std::size_t(row) * width, width);
  }

  PicturePair pair_;
  int rows_together_;  // how many rows are computed together
  int y_ = -1;
  std::vector<std::uint32_t> steps_;
  std::vector<PixelKind> kinds_;
  std::vector<bool> may_differ_;
};

// Makes one pass over the rows; the memory is proportional to a DifferenceRows and to the regions
// kept. If `kinds` is given, it gets the kinds of all pixels, row by row.
Differences find_differences(const PicturePair& pair, std::vector<PixelKind>* kinds = nullptr,
                             std::size_t kept_regions = 100);

}  // namespace glassbox
