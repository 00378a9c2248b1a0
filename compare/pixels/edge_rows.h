// What the pixels of a row need from the pixels around them: the ranges of values, and the sums
// from which the movement is computed. The loops over columns are what compilers turn into
// instructions for several columns. Each result is computed in the same order, wherever its pixel
// lies and whichever other pixels are judged.
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/compare/pixels/edge_tile.h>

namespace glassbox {

// std::min takes references, which keeps compilers from using such instructions.
template <class Value>
Value smaller(Value a, Value b) {
  return a < b ? a : b;
}
template <class Value>
Value larger(Value a, Value b) {
  return a > b ? a : b;
}

// The smallest and largest values around each pixel of a row.
template <class Value>
struct RowRanges {
  TileRow<Value> low, high;
};

// The ranges of each column's pixels in row y and its two neighbours.
template <class Value>
RowRanges<Value> column_ranges(const TilePlane<Value>& plane, int y) {
  const TileRow<Value>& above = plane[std::size_t(y - 1)];
  const TileRow<Value>& here = plane[std::size_t(y)];
  const TileRow<Value>& below = plane[std::size_t(y + 1)];
  RowRanges<Value> ranges;
  for (std::size_t x = 0; x < here.size(); ++x) {
    ranges.low[x] = smaller(smaller(above[x], here[x]), below[x]);
    ranges.high[x] = larger(larger(above[x], here[x]), below[x]);
  }
  return ranges;
}

// Makes each column's range contain its values in two more rows.
template <class Value>
void add_rows(const TileRow<Value>& a, const TileRow<Value>& b, RowRanges<Value>& ranges) {
  for (std::size_t x = 0; x < a.size(); ++x) {
    ranges.low[x] = smaller(ranges.low[x], smaller(a[x], b[x]));
    ranges.high[x] = larger(ranges.high[x], larger(a[x], b[x]));
  }
}

// Each column's range together with those of the columns on both sides; the first and the last
// column have one side only, and keep their own.
template <class Value>
RowRanges<Value> widened(const RowRanges<Value>& of) {
  RowRanges<Value> ranges = of;
  for (std::size_t x = 1; x + 1 < of.low.size(); ++x) {
    ranges.low[x] = smaller(smaller(of.low[x - 1], of.low[x]), of.low[x + 1]);
    ranges.high[x] = larger(larger(of.high[x - 1], of.high[x]), of.high[x + 1]);
  }
  return ranges;
}

// The products of the slopes along x and y and of the change from the reference to the test.
enum Product : std::size_t { kXX, kXY, kYY, kXChange, kYChange, kProducts };

template <class Value>
using ProductRow = std::array<TileRow<Value>, kProducts>;

// The products of the pixels of row y, summed over the channels in their order. The first and the
// last column have none.
template <class Value>
ProductRow<Value> products_of_row(const EdgeTile<Value>& tile, int y) {
  ProductRow<Value> sums{};
  for (std::size_t channel = 0; channel < std::size_t(tile.channels); ++channel) {
    const auto& a = tile.reference[channel];
    const auto& b = tile.test[channel];
    const auto above = std::size_t(y - 1), here = std::size_t(y), below = std::size_t(y + 1);
    for (std::size_t x = 1; x + 1 < a[here].size(); ++x) {
      const Value slope_x = (a[here][x + 1] - a[here][x - 1] + b[here][x + 1] - b[here][x - 1]) / 4;
      const Value slope_y = (a[below][x] - a[above][x] + b[below][x] - b[above][x]) / 4;
      const Value change = b[here][x] - a[here][x];
      sums[kXX][x] += slope_x * slope_x;
      sums[kXY][x] += slope_x * slope_y;
      sums[kYY][x] += slope_y * slope_y;
      sums[kXChange][x] += slope_x * change;
      sums[kYChange][x] += slope_y * change;
    }
  }
  return sums;
}

// The sums over the 7 x 7 pixels around each pixel of row y, without that pixel. They are made of
// the sums of columns with and without their middle, and nothing is subtracted. The first and the
// last 3 columns have none.
template <class Value, std::size_t kRows>
ProductRow<Value> sums_around(const std::array<ProductRow<Value>, kRows>& rows, int y) {
  const ProductRow<Value>* const middle = &rows[std::size_t(y)];
  ProductRow<Value> sums{};
  for (std::size_t i = 0; i < kProducts; ++i) {
    const TileRow<Value>&a = middle[-3][i], &b = middle[-2][i], &c = middle[-1][i];
    const TileRow<Value>&d = middle[1][i], &e = middle[2][i], &f = middle[3][i];
    TileRow<Value> without, with;
    for (std::size_t x = 0; x < a.size(); ++x) {
      without[x] = a[x] + b[x] + c[x] + d[x] + e[x] + f[x];
      with[x] = without[x] + middle[0][i][x];
    }
    for (std::size_t x = 3; x + 3 < a.size(); ++x) {
      sums[i][x] = with[x - 3] + with[x - 2] + with[x - 1] + without[x] + with[x + 1] +
                   with[x + 2] + with[x + 3];
    }
  }
  return sums;
}

}  // namespace glassbox
