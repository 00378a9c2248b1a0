#include <glassbox/compare/metrics/flip_tile.h>

#include <algorithm>
#include <cmath>

#include <glassbox/compare/metrics/affected_box.h>
#include <glassbox/compare/metrics/flip_input.h>
#include <glassbox/images/colour/flip_colour.h>

namespace glassbox {
namespace {

using flip_colour::Colour;

constexpr std::ptrdiff_t kAcross = 1;
constexpr std::ptrdiff_t kDown = FlipPlane::kStride;

// Filters along x the rows of the tile, and as many rows above and below the tile as a filter along
// y needs.
template <std::size_t radius>
GLASSBOX_INLINE void even_across(const FlipPlane& in, const PixelBox& tile,
                                 const Taps<float, radius>& taps, float sum, int rows_around,
                                 FlipPlane& out) {
  for (int y = -rows_around; y < tile.height + rows_around; ++y) {
    filter_even<kAcross>(in.row(y), tile.width, taps, sum, out.row(y));
  }
}

// Filters with one Gaussian along both axes.
template <std::size_t radius>
GLASSBOX_INLINE void blur(const FlipPlane& in, const PixelBox& tile,
                          const Taps<float, radius>& taps, FlipPlane& across, FlipPlane& out) {
  even_across(in, tile, taps, 1.0f, int(radius), across);
  for (int y = 0; y < tile.height; ++y) {
    filter_even<kDown>(across.row(y), tile.width, taps, 1.0f, out.row(y));
  }
}

GLASSBOX_INLINE void mix(const FlipPlane& wide, const PixelBox& tile, float wide_share,
                         float narrow_share, FlipPlane& narrow_and_out) {
  for (int y = 0; y < tile.height; ++y) {
    const float* from = wide.row(y);
    float* to = narrow_and_out.row(y);
    for (int x = 0; x < tile.width; ++x) to[x] = wide_share * from[x] + narrow_share * to[x];
  }
}

// The length of the vector of two filter results.
GLASSBOX_INLINE void length(const float* a, const float* b, int count, float* __restrict out) {
  for (int x = 0; x < count; ++x) out[x] = std::sqrt(a[x] * a[x] + b[x] * b[x]);
}

GLASSBOX_INLINE void to_hunt_lab(float* __restrict lightness, float* __restrict a,
                                 float* __restrict b, int count) {
  for (int x = 0; x < count; ++x) {
    const Colour linear = flip_colour::linear_of_opponent({lightness[x], a[x], b[x]});
    const Colour lab = flip_colour::hunt_lab_of_linear(linear);
    lightness[x] = lab.x;
    a[x] = lab.y;
    b[x] = lab.z;
  }
}

GLASSBOX_INLINE void compare_row(const PerceivedPlanes& reference, const PerceivedPlanes& test,
                                 int y, int count, flip_colour::ColourError colour_error,
                                 float* __restrict error) {
  const float *l1 = reference.lightness.row(y), *l2 = test.lightness.row(y);
  const float *a1 = reference.a.row(y), *a2 = test.a.row(y);
  const float *b1 = reference.b.row(y), *b2 = test.b.row(y);
  const float *edges1 = reference.edges.row(y), *edges2 = test.edges.row(y);
  const float *points1 = reference.points.row(y), *points2 = test.points.row(y);
  for (int x = 0; x < count; ++x) {
    const float colour =
        colour_error(flip_colour::hyab({l1[x], a1[x], b1[x]}, {l2[x], a2[x], b2[x]}));
    const float feature = flip_colour::feature_error(
        std::max(std::abs(edges1[x] - edges2[x]), std::abs(points1[x] - points2[x])));
    error[x] = flip_colour::combined_error(colour, feature);
  }
}

}  // namespace

GLASSBOX_WIDE void FlipTile::compute_perceived_colours(const PixelBox& tile,
                                                       PerceivedPlanes& perceived) {
  const FlipFilters& filters = flip_filters();
  blur(opponent_.lightness, tile, filters.lightness, across_[0], perceived.lightness);
  blur(opponent_.red_green, tile, filters.red_green, across_[0], perceived.a);
  blur(opponent_.blue_yellow, tile, filters.wide_blue_yellow, across_[0], across_[1]);
  blur(opponent_.blue_yellow, tile, filters.narrow_blue_yellow, across_[0], perceived.b);
  mix(across_[1], tile, filters.wide_share, filters.narrow_share, perceived.b);
  for (int y = 0; y < tile.height; ++y) {
    to_hunt_lab(perceived.lightness.row(y), perceived.a.row(y), perceived.b.row(y), tile.width);
  }
}

GLASSBOX_WIDE void FlipTile::compute_features(const PixelBox& tile, PerceivedPlanes& perceived) {
  const FlipFilters& filters = flip_filters();
  auto& [smooth, slope, bend] = across_;
  const FlipPlane& lightness = opponent_.lightness;
  even_across(lightness, tile, filters.smooth, 1.0f, kFeatureRadius, smooth);
  even_across(lightness, tile, filters.bend, 0.0f, kFeatureRadius, bend);
  for (int y = -kFeatureRadius; y < tile.height + kFeatureRadius; ++y) {
    filter_odd<kAcross>(lightness.row(y), tile.width, filters.slope, slope.row(y));
  }
  std::array<float, std::size_t(FlipPlane::kStride)> along_x, along_y;
  for (int y = 0; y < tile.height; ++y) {
    filter_even<kDown>(slope.row(y), tile.width, filters.smooth, 1.0f, along_x.data());
    filter_odd<kDown>(smooth.row(y), tile.width, filters.slope, along_y.data());
    length(along_x.data(), along_y.data(), tile.width, perceived.edges.row(y));
    filter_even<kDown>(bend.row(y), tile.width, filters.smooth, 1.0f, along_x.data());
    filter_even<kDown>(smooth.row(y), tile.width, filters.bend, 0.0f, along_y.data());
    length(along_x.data(), along_y.data(), tile.width, perceived.points.row(y));
  }
}

void FlipTile::compute_perceived(const PixelBox& tile, PerceivedPlanes& perceived) {
  compute_perceived_colours(tile, perceived);
  compute_features(tile, perceived);
}

GLASSBOX_WIDE void FlipTile::raise_errors(const PixelBox& tile) {
  static const flip_colour::ColourError colour_error;
  std::array<float, std::size_t(FlipPlane::kStride)> errors;
  for (int y = 0; y < tile.height; ++y) {
    compare_row(reference_, test_, y, tile.width, colour_error, errors.data());
    float* row = error_.row(y);
    for (int x = 0; x < tile.width; ++x) row[x] = std::max(row[x], errors[std::size_t(x)]);
  }
}

PixelBox FlipTile::compute(const PicturePair& pair, const PixelBox& tile) {
  const PixelBox affected = affected_box(pair, tile, kFlipHalo, {0, pair.reference.channels});
  if (affected.width == 0) return affected;
  for (int y = 0; y < affected.height; ++y) std::fill_n(error_.row(y), affected.width, 0.0f);
  bool opaque = true;
  for (const float background : {0.0f, 1.0f}) {
    opaque &= load_opponent(pair, PairSide::kReference, affected, background, opponent_);
    compute_perceived(affected, reference_);
    opaque &= load_opponent(pair, PairSide::kTest, affected, background, opponent_);
    compute_perceived(affected, test_);
    raise_errors(affected);
    if (opaque) break;  // then the second background would give the same errors
  }
  return affected;
}

}  // namespace glassbox
