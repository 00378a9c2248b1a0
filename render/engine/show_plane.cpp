#include <glassbox/render/engine/show_plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glassbox {

namespace {

void show_depth(Framebuffer& buffers) {
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = -nearest;
  for (const float distance : buffers.distance.pixels) {
    if (!std::isfinite(distance)) continue;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  constexpr float kDarkest = 40.0f / 255.0f;  // the largest distance; still different from black
  // Distances of a parallel view may reach so far in front of and behind the eye that their range
  // would overflow. Then they are halved; otherwise this factor changes nothing.
  const float scale = std::isfinite(farthest - nearest) ? 1.0f : 0.5f;
  const float range = farthest * scale - nearest * scale;
  for (std::size_t i = 0; i < buffers.color.pixels.size(); ++i) {
    const float distance = buffers.distance.pixels[i];
    if (!std::isfinite(distance)) continue;
    const float t = range > 0 ? (distance * scale - nearest * scale) / range : 0.0f;
    const std::uint8_t grey = encode_unorm8(1.0f - t * (1.0f - kDarkest));
    buffers.color.pixels[i] = {grey, grey, grey, 255};
  }
}

// The colour is three bytes of a multiplicative hash (Knuth's golden-ratio constant), each mapped
// to 64 .. 255, so that no colour is close to black.
Rgba8 color_of_id(std::uint32_t id) {
  std::uint32_t h = id * 0x9e3779b1u;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  const auto channel = [&](int shift) {
    return std::uint8_t(64 + ((h >> shift) & 0xffu) * 191 / 255);
  };
  return {channel(0), channel(8), channel(16), 255};
}

void show_id(Framebuffer& buffers) {
  for (std::size_t i = 0; i < buffers.color.pixels.size(); ++i) {
    const std::uint32_t id = buffers.id.pixels[i];
    if (id != 0) buffers.color.pixels[i] = color_of_id(id);
  }
}

void show_overdraw(Framebuffer& buffers) {
  constexpr std::array<Rgba8, 8> kHeat{{{24, 32, 96, 255},
                                        {32, 80, 176, 255},
                                        {40, 144, 176, 255},
                                        {64, 176, 96, 255},
                                        {192, 192, 64, 255},
                                        {232, 144, 48, 255},
                                        {224, 64, 48, 255},
                                        {255, 255, 255, 255}}};
  for (std::size_t i = 0; i < buffers.color.pixels.size(); ++i) {
    const std::uint32_t writes = buffers.writes.pixels[i];
    if (writes != 0)
      buffers.color.pixels[i] = kHeat[std::min<std::size_t>(writes, kHeat.size()) - 1];
  }
}

}  // namespace

void show_plane(Show what, Framebuffer& buffers) {
  if (what == Show::kDepth) show_depth(buffers);
  if (what == Show::kId) show_id(buffers);
  if (what == Show::kOverdraw) show_overdraw(buffers);
}

}  // namespace glassbox
