#include <glassbox/compare/metrics/flip_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glassbox/base/elementary.h>
#include <glassbox/images/colour/flip_colour.h>
#include <glassbox/images/srgb.h>

namespace glassbox {
namespace {

struct LinearRow {
  static constexpr auto kSize = std::size_t(FlipPlane::kStride);
  std::array<float, kSize> r, g, b;
};

float linear_of(std::uint8_t code) {
  return decode_srgb(code);
}

// The sRGB transfer function (IEC 61966-2-1) for 16-bit samples. The code 257 b gives the same bits
// as the byte b.
float linear_of(std::uint16_t code) {
  static const std::vector<float> table = [] {
    std::vector<float> linear(65536);
    for (std::size_t i = 0; i < linear.size(); ++i) {
      const double stored = double(i) / 65535;
      linear[i] = float(stored <= 0.04045 ? stored / 12.92 : power((stored + 0.055) / 1.055, 2.4));
    }
    return linear;
  }();
  return table[code];
}

float alpha_of(std::uint8_t code) {
  return decode_unorm8(code);
}
float alpha_of(std::uint16_t code) {
  return float(code) / 65535.0f;
}

// Places one pixel over the background. Returns whether the pixel was opaque.
template <class Sample>
bool put(const Sample* pixel, int channels, float background, std::size_t at, LinearRow& row) {
  const bool colour = channels >= 3;
  row.r[at] = linear_of(pixel[0]);
  row.g[at] = colour ? linear_of(pixel[1]) : row.r[at];
  row.b[at] = colour ? linear_of(pixel[2]) : row.r[at];
  if (channels == 1 || channels == 3) return true;
  const float alpha = alpha_of(pixel[channels - 1]);
  if (alpha == 1.0f) return true;
  for (float* value : {&row.r[at], &row.g[at], &row.b[at]}) {
    *value = alpha * *value + (1.0f - alpha) * background;
  }
  return false;
}

void to_opponent(const LinearRow& row, int count, float* lightness, float* red_green,
                 float* blue_yellow) {
  for (int i = 0; i < count; ++i) {
    const auto x = std::size_t(i);
    const auto opponent = flip_colour::opponent_of_linear({row.r[x], row.g[x], row.b[x]});
    lightness[i] = opponent.x;
    red_green[i] = opponent.y;
    blue_yellow[i] = opponent.z;
  }
}

template <class Sample>
bool load(const PicturePair& pair, const std::vector<Sample>& reference,
          const std::vector<Sample>& own, const PixelBox& tile, float background,
          OpponentPlanes& planes) {
  const int channels = pair.reference.channels;
  const bool masked = !pair.selection.includes_all();
  bool opaque = true;
  LinearRow row;
  for (int y = -kFlipHalo; y < tile.height + kFlipHalo; ++y) {
    const int source_y = std::clamp(tile.y + y, 0, pair.reference.height - 1);
    for (int x = -kFlipHalo; x < tile.width + kFlipHalo; ++x) {
      const int source_x = std::clamp(tile.x + x, 0, pair.reference.width - 1);
      const bool compared = !masked || pair.selection.compares(source_x, source_y);
      const std::size_t pixel =
          std::size_t(source_y) * std::size_t(pair.reference.width) + std::size_t(source_x);
      const Sample* samples = (compared ? own : reference).data() + pixel * std::size_t(channels);
      opaque &= put(samples, channels, background, std::size_t(x + kFlipHalo), row);
    }
    to_opponent(row, tile.width + 2 * kFlipHalo, planes.lightness.row(y) - kFlipHalo,
                planes.red_green.row(y) - kFlipHalo, planes.blue_yellow.row(y) - kFlipHalo);
  }
  return opaque;
}

bool load(const PicturePair&, const std::vector<float>&, const std::vector<float>&, const PixelBox&,
          float, OpponentPlanes&) {
  return true;
}

}  // namespace

bool load_opponent(const PicturePair& pair, PairSide side, const PixelBox& tile, float background,
                   OpponentPlanes& planes) {
  const StoredImage& image = side == PairSide::kReference ? pair.reference : pair.test;
  return std::visit(
      [&](const auto& reference) {
        const auto& own = std::get<std::decay_t<decltype(reference)>>(image.samples);
        return load(pair, reference, own, tile, background, planes);
      },
      pair.reference.samples);
}

}  // namespace glassbox
