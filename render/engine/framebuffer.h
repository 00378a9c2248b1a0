// The images that a run writes; other comments call them the planes of the framebuffer. Images that
// are not wanted stay empty. Depth, distance, id and writes are always those of pixel centres: for
// any number of samples they have the values that they have with one sample.
#pragma once

#include <cstdint>
#include <limits>

#include <glassbox/images/image.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/engine/sample_planes.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

struct Framebuffer {
  Image<Rgba8> color;          // bytes as stored in files
  Image<std::uint32_t> depth;  // the depth as an integer: depth_code()
  Image<float> distance;       // along the gaze, world units; +inf where nothing was drawn
  Image<std::uint32_t> id;  // 1 + the triangle's number in the scene; 0 where no triangle is seen
  Image<std::uint32_t> writes;  // how many fragments were written (for Show::kOverdraw)
  // The samples, while a picture with several samples per pixel is drawn. The tile engine uses them
  // only if it draws the scene in several rounds (parts).
  SamplePlanes samples;
};

inline Framebuffer cleared_framebuffer(int width, int height, const RenderSettings& settings,
                                       bool want_color = true) {
  Framebuffer buffer;
  if (want_color) buffer.color = Image<Rgba8>(width, height, settings.background);
  buffer.depth = Image<std::uint32_t>(width, height, kEmptyDepth);
  if (settings.want_distance || settings.show == Show::kDepth) {
    buffer.distance = Image<float>(width, height, std::numeric_limits<float>::infinity());
  }
  if (settings.want_id || settings.show == Show::kId) {
    buffer.id = Image<std::uint32_t>(width, height, 0);
  }
  if (settings.show == Show::kOverdraw) buffer.writes = Image<std::uint32_t>(width, height, 0);
  if (const int count = samples_drawn(settings); count > 1) {
    buffer.samples.clear({0, 0, width, height}, count, settings.background);
  }
  return buffer;
}

// Called at the end of a run: writes the mean of each pixel's samples to `color` and frees the
// samples' memory.
inline void resolve_samples(const RenderSettings& settings, Framebuffer& buffer,
                            Image<Rgba8>& color) {
  if (buffer.samples.empty()) return;
  buffer.samples.resolve(settings, color);
  buffer.samples = {};
}

}  // namespace glassbox
