// Writes a fragment: its colour to the pixel or to its samples, and depth, distance and id, which
// are stored for pixel centres.
#pragma once

#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/distance.h>
#include <glassbox/render/staged/covered_fragments.h>
#include <glassbox/render/staged/fragment_color.h>

namespace glassbox {

// Whether the fragment's colour is written. With several samples per pixel, only covered samples
// get the colour, and the pixel gets their mean at the end.
inline bool shows_color(const FragmentStage& stage, const CoveredFragment& fragment) {
  return stage.samples == nullptr || fragment.samples != 0;
}

template <class Watch>
void write_over(const FragmentStage& stage, const Watch& watch, const CoveredFragment& fragment,
                const FragmentColor& color, Rgba8& pixel) {
  Rgba8 after = encode_color(stage, color, pixel);
  watch.notify(&Observer::encoded, fragment.place, pixel, after);
  write_masked(stage.settings.mask, after, pixel);
}

template <class Watch>
void write_samples(const FragmentStage& stage, const Watch& watch, const CoveredFragment& fragment,
                   const FragmentColor& color, bool writes_depth) {
  const int x = fragment.place.x, y = fragment.place.y;
  const std::span<Rgba8> colors = stage.samples->colors(x, y);
  const std::span<std::uint32_t> depths = stage.samples->depths(x, y);
  for_each_bit(fragment.samples, [&](std::size_t s) {
    write_over(stage, watch, fragment, color, colors[s]);
    if (writes_depth) depths[s] = fragment.codes[s];
  });
}

template <class Watch>
void write_color(const FragmentStage& stage, const Watch& watch, const CoveredFragment& fragment,
                 const FragmentColor& color, bool writes_depth) {
  if (stage.samples != nullptr) return write_samples(stage, watch, fragment, color, writes_depth);
  write_over(stage, watch, fragment, color, stage.color.at(fragment.place.x, fragment.place.y));
}

// Writes to the images of the framebuffer that store values of pixel centres: all except the
// colours.
inline void write_planes(const FragmentStage& stage, const CoveredFragment& fragment,
                         std::uint32_t id, bool writes_depth) {
  Framebuffer& target = stage.target;
  const std::size_t pixel = target.depth.index(fragment.place.x, fragment.place.y);
  if (writes_depth) target.depth.pixels[pixel] = fragment.centre_code;
  if (!target.distance.pixels.empty()) {
    target.distance.pixels[pixel] =
        distance_along_gaze(stage.view, fragment.place.depth, fragment.place.inverse_w);
  }
  if (!target.id.pixels.empty()) target.id.pixels[pixel] = id;
  if (!target.writes.pixels.empty()) ++target.writes.pixels[pixel];
}

}  // namespace glassbox
