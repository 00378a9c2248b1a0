#include <glassbox/render/tile/tile_buffers.h>

#include <algorithm>

#include <glassbox/raster/samples.h>

namespace glassbox {

TileBuffers begin_buffers(const TilePass& pass, const PixelRect& window, TileMemory& memory) {
  const RenderSettings& settings = pass.run.settings;
  const Framebuffer& target = pass.target;
  const bool sampled = samples_drawn(settings) > 1;
  const bool planes =
      !target.depth.pixels.empty() || !target.distance.pixels.empty() || !target.id.pixels.empty();
  TileBuffers buffers;
  if (!sampled || planes) {
    buffers.centres = &memory.centres;
    buffers.centres->clear(window, settings.depth);
  }
  if (!sampled || pass.resolve.picture == nullptr) return buffers;
  const std::span<const SampleOffset> points = sample_offsets(settings.samples);
  while (memory.samples.size() < points.size()) memory.samples.emplace_back(pass.run.tile_side);
  buffers.samples = std::span(memory.samples).first(points.size());
  for (std::size_t s = 0; s < points.size(); ++s) {
    buffers.samples[s].clear(window, settings.depth, points[s]);
  }
  return buffers;
}

void mark_as_in_picture(TileBuffer& tile) {
  for (std::size_t i = 0; i < tile.block_count(); ++i) {
    TileBlock& block = tile.block(i);
    if (!block.plain) {
      std::fill_n(tile.reference() + i * kBlockPixels, kBlockPixels, kInPicture);
    } else if (block.reference != kNothing) {
      block.reference = kInPicture;
    }
  }
}

}  // namespace glassbox
