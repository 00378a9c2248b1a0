#include <glassbox/compare/pixels/edge_tile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glassbox/compare/pixels/alpha.h>

namespace glassbox {
namespace {

// The columns [first, end) of a tile's row that lie in the picture.
struct TileColumns {
  int first = 0, end = 0;
};

TileColumns columns_inside(int width, PixelPosition first) {
  const int last = int(std::tuple_size_v<TileRow<float>>);
  return {std::max(0, kTileMargin - first.x), std::min(last, width - first.x + kTileMargin)};
}

// Returns whether every alpha is 1.
template <class Sample>
bool load_alpha(const Sample* pixels, int channels, TileColumns inside,
                TileRow<TileValue<Sample>>& alpha) {
  using Value = TileValue<Sample>;
  // 255 / 255 is exactly 1, so that opaque colours remain exact.
  constexpr Value kOpaque =
      std::is_integral_v<Sample> ? Value(std::numeric_limits<Sample>::max()) : 1;
  bool opaque = true;
  for (int x = inside.first; x < inside.end; ++x, pixels += channels) {
    alpha[std::size_t(x)] = Value(pixels[channels - 1]) / kOpaque;
    opaque &= alpha[std::size_t(x)] == 1;
  }
  return opaque;
}

// Loads the values of row y that lie in the picture. `pixels` are those of the row in the picture,
// from the first one that lies in the tile.
template <class Sample>
void load_inside(const Sample* pixels, int channels, TileColumns inside, int y,
                 std::array<TilePlane<TileValue<Sample>>, 4>& planes, bool& opaque) {
  using Value = TileValue<Sample>;
  TileRow<Value> alpha;
  const bool row_is_opaque = !has_alpha(channels) || load_alpha(pixels, channels, inside, alpha);
  opaque &= row_is_opaque;
  for (int channel = 0; channel < channels; ++channel) {
    auto& values = planes[std::size_t(channel)][std::size_t(y)];
    const Sample* sample = pixels + channel;
    for (int x = inside.first; x < inside.end; ++x, sample += channels) {
      values[std::size_t(x)] = Value(*sample);
    }
    if (row_is_opaque || channel == channels - 1) continue;
    for (int x = inside.first; x < inside.end; ++x) values[std::size_t(x)] *= alpha[std::size_t(x)];
  }
}

template <class Value>
void repeat_border(TileColumns inside, TileRow<Value>& values) {
  std::fill(values.begin(), values.begin() + inside.first, values[std::size_t(inside.first)]);
  std::fill(values.begin() + inside.end, values.end(), values[std::size_t(inside.end - 1)]);
}

template <class Value>
void copy_left_out(const Selection& selection, PixelPosition from, TileColumns inside,
                   const TileRow<Value>& reference, TileRow<Value>& test) {
  for (int x = inside.first; x < inside.end; ++x) {
    const auto i = std::size_t(x);
    if (!selection.compares(from.x + x - inside.first, from.y)) test[i] = reference[i];
  }
}

template <class Value>
void find_finite(int y, EdgeTile<Value>& tile) {
  auto& finite = tile.finite[std::size_t(y)];
  finite.fill(1);
  for (int channel = 0; channel < tile.channels; ++channel) {
    const auto& reference = tile.reference[std::size_t(channel)][std::size_t(y)];
    const auto& test = tile.test[std::size_t(channel)][std::size_t(y)];
    for (std::size_t x = 0; x < finite.size(); ++x) {
      finite[x] &= std::uint8_t(std::isfinite(reference[x]) && std::isfinite(test[x]));
    }
  }
}

}  // namespace

template <class Sample>
void load_row(const PicturePair& pair, PixelPosition first, int y,
              EdgeTile<TileValue<Sample>>& tile) {
  const int width = pair.reference.width, channels = pair.reference.channels;
  const TileColumns inside = columns_inside(width, first);
  const PixelPosition from{first.x + inside.first - kTileMargin,
                           std::clamp(first.y + y - kTileMargin, 0, pair.reference.height - 1)};
  const std::size_t at =
      (std::size_t(from.y) * std::size_t(width) + std::size_t(from.x)) * std::size_t(channels);
  using Samples = std::vector<Sample>;
  load_inside(&std::get<Samples>(pair.reference.samples)[at], channels, inside, y, tile.reference,
              tile.opaque);
  load_inside(&std::get<Samples>(pair.test.samples)[at], channels, inside, y, tile.test,
              tile.opaque);
  for (int channel = 0; channel < channels; ++channel) {
    auto& reference = tile.reference[std::size_t(channel)][std::size_t(y)];
    auto& test = tile.test[std::size_t(channel)][std::size_t(y)];
    if (!pair.selection.includes_all()) {
      copy_left_out(pair.selection, from, inside, reference, test);
    }
    repeat_border(inside, reference);
    repeat_border(inside, test);
  }
  if constexpr (!std::is_integral_v<Sample>) find_finite(y, tile);
}

template void load_row<std::uint8_t>(const PicturePair&, PixelPosition, int, EdgeTile<float>&);
template void load_row<std::uint16_t>(const PicturePair&, PixelPosition, int, EdgeTile<float>&);
template void load_row<float>(const PicturePair&, PixelPosition, int, EdgeTile<double>&);

}  // namespace glassbox
