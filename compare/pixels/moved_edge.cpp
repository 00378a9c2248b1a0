#include <glassbox/compare/pixels/moved_edge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <type_traits>
#include <variant>

#include <glassbox/compare/pixels/alpha.h>
#include <glassbox/compare/pixels/edge_rows.h>
#include <glassbox/compare/pixels/edge_tile.h>

namespace glassbox {
namespace {

constexpr int kContrast = 2;         // px on each side: what an edge can be made of
constexpr int kAround = 3;           // px on each side: what tells the movement
constexpr int kReach = kAround + 1;  // px on each side: what their slopes are made of
static_assert(kReach == kTileMargin && kMovedEdgeRows == kTileHeight);

constexpr double kSlackOfRange = 1;        // of the first rule, in parts of the range
constexpr double kSlackOfContrast = 0.25;  // of the second rule, in parts of the contrast
// Two steps of whole-number formats: each of the two values is rounded by half a step, and so are
// the values around them.
constexpr double kSlackOfSteps = 2;
// In parts of the largest value. A bound is a sum of four parts with four roundings of 2^-53 each;
// without this slack, a channel that is the same everywhere could lie outside of its bounds.
constexpr double kSlackOfArithmetic = 0x1p-48;

struct Range {
  double low = 0, high = 0;
  double length() const { return high - low; }
  bool has(double value, double slack) const {
    return low - slack <= value && value <= high + slack;
  }
};

// A tile with what is computed for its rows before pixels are judged.
template <class Value>
struct Workspace {
  double rounding = 0;  // the slack for rounded values
  EdgeTile<Value> values;
  std::array<ProductRow<Value>, std::tuple_size_v<TilePlane<Value>>> products;
};

// What the pixels of one row are judged by.
template <class Value>
struct RowFacts {
  int channels = 0;
  // By channel: the 3 x 3 pixels in each picture, and the 5 x 5 in both.
  std::array<RowRanges<Value>, 4> near_reference, near_test, contrast;
  ProductRow<Value> sums;
};

template <class Value>
void find_facts(const Workspace<Value>& work, int y, RowFacts<Value>& facts) {
  facts.channels = work.values.channels;
  const auto above = std::size_t(y - kContrast), below = std::size_t(y + kContrast);
  for (std::size_t c = 0; c < std::size_t(facts.channels); ++c) {
    const TilePlane<Value>&reference = work.values.reference[c], &test = work.values.test[c];
    RowRanges<Value> columns = column_ranges(reference, y);
    const RowRanges<Value> test_columns = column_ranges(test, y);
    facts.near_reference[c] = widened(columns);
    facts.near_test[c] = widened(test_columns);
    add_rows(test_columns.low, test_columns.high, columns);
    add_rows(reference[above], reference[below], columns);
    add_rows(test[above], test[below], columns);
    facts.contrast[c] = widened(widened(columns));
  }
  facts.sums = sums_around(work.products, y);
}

template <class Value>
Range range_at(const RowRanges<Value>& ranges, int x) {
  return {double(ranges.low[std::size_t(x)]), double(ranges.high[std::size_t(x)])};
}

// Whether all values are finite that the verdict on pixel (x, y) of the planes depends on.
template <class Value>
bool is_finite_around(const TilePlane<std::uint8_t>& finite, int x, int y) {
  if constexpr (std::is_same_v<Value, float>) return true;
  for (int row = y - kReach; row <= y + kReach; ++row) {
    const auto first = finite[std::size_t(row)].begin() + x - kReach;
    if (!std::all_of(first, first + 2 * kReach + 1, [](auto is) { return is != 0; })) return false;
  }
  return true;
}

// The first rule, for the value that one picture has among the other's pixels.
bool lies_at_edge(const Range& range, double value, double rounding) {
  return range.has(value, kSlackOfRange * range.length() + rounding);
}

template <class Value>
bool has_edge(const Workspace<Value>& work, const RowFacts<Value>& facts, int x, int y) {
  bool has_contrast = false;
  for (std::size_t c = 0; c < std::size_t(facts.channels); ++c) {
    const Value reference = work.values.reference[c][std::size_t(y)][std::size_t(x)];
    const Value test = work.values.test[c][std::size_t(y)][std::size_t(x)];
    const Range in_reference = range_at(facts.near_reference[c], x);
    const Range in_test = range_at(facts.near_test[c], x);
    if (!lies_at_edge(in_reference, test, work.rounding) ||
        !lies_at_edge(in_test, reference, work.rounding)) {
      return false;
    }
    has_contrast |= std::min(in_reference.length(), in_test.length()) > work.rounding;
  }
  return has_contrast;
}

struct Shift {
  double x = 0, y = 0;  // px
};

// The shift s for which test(p) is nearest to reference(p + s), to first order, over the pixels
// around the middle one. A small multiple of the identity keeps the matrix regular: along an edge
// no movement can be seen, and none is assumed.
template <class Value>
Shift shift_around(const ProductRow<Value>& sums, int x) {
  constexpr double kRegular = 0.01;
  const auto sum = [&](Product product) { return double(sums[product][std::size_t(x)]); };
  double xx = sum(kXX), yy = sum(kYY);
  const double xy = sum(kXY), xt = sum(kXChange), yt = sum(kYChange);
  const double regular = kRegular * (xx + yy);
  if (!(regular > 0)) return {};
  xx += regular;
  yy += regular;
  const double determinant = xx * yy - xy * xy;
  const auto cut = [](double shift) { return std::clamp(shift, -kMaxEdgeShift, kMaxEdgeShift); };
  return {cut((xt * yy - yt * xy) / determinant), cut((yt * xx - xt * xy) / determinant)};
}

// The parts of four pixels that the unit square at a shift from pixel (0, 0) covers.
struct Cover {
  struct Part {
    int x = 0, y = 0;  // the pixel
    double area = 0;
  };
  std::array<Part, 4> parts;
};

Cover cover_at(const Shift& shift) {
  const int step_x = shift.x < 0 ? -1 : 1, step_y = shift.y < 0 ? -1 : 1;
  const double part_x = std::abs(shift.x), part_y = std::abs(shift.y);
  return {{{{0, 0, (1 - part_x) * (1 - part_y)},
            {step_x, 0, part_x * (1 - part_y)},
            {0, step_y, (1 - part_x) * part_y},
            {step_x, step_y, part_x * part_y}}}};
}

// The bounds of the mean over what `cover` covers from pixel (x, y), of a function in `contrast`
// whose means over the pixels are those of the plane.
template <class Value>
Range covered_bounds(const TilePlane<Value>& plane, int x, int y, const Cover& cover,
                     const Range& contrast) {
  Range bounds;
  for (const auto& [step_x, step_y, area] : cover.parts) {
    const double mean = plane[std::size_t(y + step_y)][std::size_t(x + step_x)];
    // What the part has, if the rest of its pixel has as much or as little as it can.
    bounds.low += std::max(contrast.low * area, mean - contrast.high * (1 - area));
    bounds.high += std::min(contrast.high * area, mean - contrast.low * (1 - area));
  }
  return bounds;
}

// The second rule, from one picture to the other.
template <class Value>
bool explains(const std::array<TilePlane<Value>, 4>& from,
              const std::array<TilePlane<Value>, 4>& to, const Shift& shift, double rounding,
              const RowFacts<Value>& facts, int x, int y) {
  const Cover cover = cover_at(shift);
  for (std::size_t c = 0; c < std::size_t(facts.channels); ++c) {
    const Range contrast = range_at(facts.contrast[c], x);
    const Range bounds = covered_bounds(from[c], x, y, cover, contrast);
    const double largest = std::max(std::abs(contrast.low), std::abs(contrast.high));
    const double slack =
        kSlackOfContrast * contrast.length() + rounding + kSlackOfArithmetic * largest;
    if (!bounds.has(to[c][std::size_t(y)][std::size_t(x)], slack)) return false;
  }
  return true;
}

template <class Value>
bool is_moved_edge(const Workspace<Value>& work, const RowFacts<Value>& facts, int x, int y) {
  const auto& [channels, opaque, reference, test, finite] = work.values;
  if (!is_finite_around<Value>(finite, x, y) || !has_edge(work, facts, x, y)) return false;
  const Shift shift = shift_around(facts.sums, x), back{-shift.x, -shift.y};
  return explains(reference, test, shift, work.rounding, facts, x, y) ||
         explains(test, reference, back, work.rounding, facts, x, y);
}

// The kinds of the pixels of a tile. Its rows are shorter where the picture ends.
class TileKinds {
public:
  TileKinds(std::span<PixelKind> band, int width, int first_x)
      : band_(band), width_(std::size_t(width)), first_x_(std::size_t(first_x)) {}
  int rows() const { return int(band_.size() / width_); }
  std::span<PixelKind> row(int y) const {
    const std::size_t columns = std::min(std::size_t(kTileWidth), width_ - first_x_);
    return band_.subspan(std::size_t(y) * width_ + first_x_, columns);
  }

private:
  std::span<PixelKind> band_;
  std::size_t width_, first_x_;
};

bool is_judged(PixelKind kind) {
  return kind == PixelKind::kDifferent;
}

// Which rows of a tile have pixels to judge.
using JudgedRows = std::array<bool, std::size_t(kTileHeight)>;

JudgedRows judged_rows(const TileKinds& kinds) {
  JudgedRows judged{};
  for (int y = 0; y < kinds.rows(); ++y) {
    const auto row = kinds.row(y);
    judged[std::size_t(y)] = std::any_of(row.begin(), row.end(), is_judged);
  }
  return judged;
}

// Whether a row with pixels to judge is up to `distance` from row y of the planes.
bool is_near(const JudgedRows& judged, int y, int distance) {
  for (int row = y - kTileMargin - distance; row <= y - kTileMargin + distance; ++row) {
    if (0 <= row && row < kTileHeight && judged[std::size_t(row)]) return true;
  }
  return false;
}

// Loads the rows that the pixels to judge need, and computes their products.
template <class Sample>
void load_rows(const PicturePair& pair, PixelPosition first, const JudgedRows& judged,
               Workspace<TileValue<Sample>>& work) {
  const int rows = int(work.products.size());
  work.values.channels = pair.reference.channels;
  work.values.opaque = true;
  for (int y = 0; y < rows; ++y) {
    if (is_near(judged, y, kReach)) load_row<Sample>(pair, first, y, work.values);
  }
  // An alpha that is 1 everywhere agrees with every movement.
  if (has_alpha(pair.reference.channels) && work.values.opaque) --work.values.channels;
  for (int y = 1; y + 1 < rows; ++y) {
    if (!is_near(judged, y, kAround)) continue;
    work.products[std::size_t(y)] = products_of_row(work.values, y);
  }
}

template <class Value>
void judge_row(const Workspace<Value>& work, int y, std::span<PixelKind> kinds,
               RowFacts<Value>& facts) {
  find_facts(work, y, facts);
  for (std::size_t x = 0; x < kinds.size(); ++x) {
    if (is_judged(kinds[x]) && is_moved_edge(work, facts, int(x) + kTileMargin, y)) {
      kinds[x] = PixelKind::kMovedEdge;
    }
  }
}

template <class Sample>
void mark_moved_edges(const PicturePair& pair, int y, std::span<PixelKind> kinds) {
  using Value = TileValue<Sample>;
  const auto work = std::make_unique<Workspace<Value>>();
  const auto facts = std::make_unique<RowFacts<Value>>();
  work->rounding = std::is_integral_v<Sample> ? kSlackOfSteps : 0;
  for (int x = 0; x < pair.reference.width; x += kTileWidth) {
    const TileKinds tile(kinds, pair.reference.width, x);
    const JudgedRows judged = judged_rows(tile);
    load_rows<Sample>(pair, {x, y}, judged, *work);
    for (int row = 0; row < tile.rows(); ++row) {
      if (judged[std::size_t(row)]) judge_row(*work, row + kTileMargin, tile.row(row), *facts);
    }
  }
}

}  // namespace

void mark_moved_edges(const PicturePair& pair, int y, std::span<PixelKind> kinds) {
  std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        mark_moved_edges<Sample>(pair, y, kinds);
      },
      pair.reference.samples);
}

}  // namespace glassbox
