// Pixels that a triangle covers partly (D-31): the exact fraction, and the samples that estimate
// it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/stages.h>

namespace glassbox::study::d31 {

// A triangle with corners in whole 1/256 px, in the order that makes its edge functions positive
// inside, and one pixel that it touches.
struct Piece {
  std::array<SnappedVertex, 3> corners;
  std::array<EdgeFunction, 3> edges;
  int x = 0, y = 0;
};

// ---- the covered fraction of a pixel by clipping: T is the exact rational, or double ----

template <class T>
using Polygon = std::vector<std::array<T, 2>>;

// Keeps the part of the polygon with sign * p[axis] >= sign * limit.
template <class T>
Polygon<T> clip_to(const Polygon<T>& polygon, std::size_t axis, int limit, int sign) {
  Polygon<T> kept;
  const auto inside = [&](const auto& p) { return sign > 0 ? p[axis] >= limit : p[axis] <= limit; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) kept.push_back(a);
    if (inside(a) == inside(b)) continue;
    const std::size_t other = 1 - axis;
    std::array<T, 2> crossing;
    crossing[axis] = limit;
    crossing[other] = T(a[other] + (b[other] - a[other]) * (limit - a[axis]) / (b[axis] - a[axis]));
    kept.push_back(crossing);
  }
  return kept;
}

// Computes relative to the pixel's own corner, because small numbers lose less to rounding.
template <class T>
T covered_share(const Piece& piece) {
  Polygon<T> polygon;
  for (const SnappedVertex& v : piece.corners)
    polygon.push_back({T(v.x - piece.x * kSubpixels), T(v.y - piece.y * kSubpixels)});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    polygon = clip_to(polygon, axis, 0, 1);
    polygon = clip_to(polygon, axis, kSubpixels, -1);
  }
  T twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += T(a[0] * b[1] - b[0] * a[1]);
  }
  return T(twice / (2 * kSubpixels * kSubpixels));
}

// ---- samples ----

using Positions = std::vector<std::array<int, 2>>;  // in 1/256 px from the pixel's corner

inline Positions standard(int samples) {
  Positions positions;
  for (const SampleOffset& offset : sample_offsets(samples))
    positions.push_back({kPixelCentre + offset.x, kPixelCentre + offset.y});
  return positions;
}

// The number of columns and rows of cells, as close to a square as a power of two allows.
inline std::array<int, 2> cells(int samples) {
  const int rows = samples == 1 ? 1 : samples <= 4 ? samples / 2 : 4;
  return {samples == 4 ? 2 : samples / rows, samples == 4 ? 2 : rows};
}

// A rotated grid of S samples (`samples`) that fills the pixel, so that the samples of neighbouring
// pixels continue it. It is a lattice of S + 1 points, in which each row advances by k columns,
// without the point in the corner: one sample in each of S columns and S rows. For 4 and 16
// samples, where S + 1 is a sum of two squares, it is a square lattice rotated by arctan(1/2) and
// arctan(1/4). (The S points of an unbounded lattice that are nearest to the centre do not fill a
// pixel: 16 such points had larger errors than 8.)
inline Positions rotated(int samples) {
  const int k = samples == 2 ? 2 : samples == 4 ? 3 : samples == 8 ? 7 : 4;
  const auto place = [&](int i) { return (2 * i + 1) * kSubpixels / (2 * samples); };
  if (samples == 1) return {{place(0), place(0)}};
  Positions positions;
  for (int i = 0; i < samples; ++i) {
    positions.push_back({place(i), place(k * (i + 1) % (samples + 1) - 1)});
  }
  return positions;
}

enum class Pattern { kStandard, kRandom, kJittered, kRotated };
struct NamedPattern {
  Pattern pattern;
  const char* name;
};
inline constexpr NamedPattern kPatterns[] = {{Pattern::kStandard, "D3D standard"},
                                             {Pattern::kRandom, "random"},
                                             {Pattern::kJittered, "jittered"},
                                             {Pattern::kRotated, "rotated grid"}};

// Computes the sample positions of pixel number `pixel`. Patterns that are the same in all pixels
// are already in `positions`.
inline void place_samples(Pattern pattern, std::size_t pixel, Positions& positions) {
  const int samples = int(positions.size());
  if (pattern == Pattern::kStandard || pattern == Pattern::kRotated) return;
  const auto [columns, rows] = pattern == Pattern::kJittered ? cells(samples) : std::array{1, 1};
  for (int i = 0; i < samples; ++i) {
    const std::uint64_t bits = scramble(pixel * 16 + std::size_t(i) + 310000);
    const int width = kSubpixels / columns, height = kSubpixels / rows;
    const int column = columns * rows == 1 ? 0 : i % columns,
              row = columns * rows == 1 ? 0 : i / columns;
    positions[std::size_t(i)] = {column * width + int(bits % std::uint64_t(width)),
                                 row * height + int((bits >> 32) % std::uint64_t(height))};
  }
}

inline int count_covered(const Piece& piece, std::span<const std::array<int, 2>> positions) {
  int covered = 0;
  for (const auto& [dx, dy] : positions) {
    const std::int64_t x = std::int64_t(piece.x) * kSubpixels + dx,
                       y = std::int64_t(piece.y) * kSubpixels + dy;
    covered += piece.edges[0].covers(piece.edges[0].at(x, y)) &&
               piece.edges[1].covers(piece.edges[1].at(x, y)) &&
               piece.edges[2].covers(piece.edges[2].at(x, y));
  }
  return covered;
}

inline double estimate(Pattern pattern, const Piece& piece, std::size_t index,
                       Positions& positions) {
  place_samples(pattern, index, positions);
  return double(count_covered(piece, positions)) / double(positions.size());
}

inline Positions start_positions(Pattern pattern, int samples) {
  if (pattern == Pattern::kStandard) return standard(samples);
  if (pattern == Pattern::kRotated) return rotated(samples);
  return Positions(std::size_t(samples));
}

}  // namespace glassbox::study::d31
