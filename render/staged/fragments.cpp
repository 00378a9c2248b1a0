#include <glassbox/render/staged/fragments.h>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/fragment_color.h>
#include <glassbox/render/staged/fragment_planes.h>
#include <glassbox/render/staged/sampled_fragments.h>

namespace glassbox {

namespace {

bool passes_depth_test(const FragmentStage& stage, const FragmentSource& source,
                       const Fragment& fragment, std::uint32_t code) {
  const std::size_t pixel = stage.target.depth.index(fragment.x, fragment.y);
  const std::uint32_t stored = stage.target.depth.pixels[pixel];
  bool passes = in_front(code, stored);
  if (stage.observer != nullptr) {
    stage.observer->compared(source, fragment, code, stored, passes);
  }
  return passes;
}

// The way of a covered pixel through the last stages.
Fate process(const FragmentStage& stage, const FragmentSource& source, const Fragment& fragment,
             std::uint32_t id, const Surface& surface) {
  ++stage.statistics.covered;
  const std::uint32_t code = depth_code(stage.settings.depth, fragment.depth);
  if (!passes_depth_test(stage, source, fragment, code)) {
    ++stage.statistics.depth_failed;
    return Fate::kHidden;
  }
  const Varyings at = interpolate(surface.vertices, fragment.weights);
  Rgba base = surface_color(stage, surface, at, fragment);
  if (stage.observer != nullptr) stage.observer->textured(at, base);
  if (is_discarded(*stage.draw.material, base)) {
    ++stage.statistics.discarded;
    return Fate::kDiscarded;
  }
  const std::size_t pixel = stage.target.depth.index(fragment.x, fragment.y);
  const Rgba8 before = stage.color.pixels[pixel];
  Rgba8 after = encoded(stage, fragment_color(stage, surface, at, fragment, base), before);
  if (stage.observer != nullptr) stage.observer->encoded(fragment, before, after);
  const bool blended = is_blended(stage);
  if (blended) ++stage.statistics.blended;
  // With several samples they have the colour.
  if (stage.samples == nullptr) {
    write_masked(stage.settings.mask, after, stage.color.pixels[pixel]);
  }
  write_planes(stage, fragment, code, id, !blended);
  ++stage.statistics.written;
  return blended ? Fate::kBlended : Fate::kWritten;
}

void process_observed(const FragmentStage& stage, const FragmentSource& source,
                      const Fragment& fragment, std::uint32_t id, const Surface& surface) {
  const Fate fate = process(stage, source, fragment, id, surface);
  if (stage.observer != nullptr) stage.observer->ended(source, fragment, fate);
}

}  // namespace

ColorMask shaded_channels(const Draw& draw, const RenderSettings& settings) {
  ColorMask channels = settings.mask;
  channels.a = channels.a || draw.material->alpha_mode != AlphaMode::kOpaque;
  return channels;
}

void rasterise(const FragmentStage& stage, const ReadyTriangle& triangle) {
  if (stage.samples != nullptr) return rasterise_samples(stage, triangle);
  const Surface surface = surface_of(stage, triangle);
  const FragmentSource source{triangle.number, triangle.piece, true};
  for_each_covered(triangle.setup, stage.window, [&](const Coverage& pixel) {
    Fragment fragment = interpolate(triangle.setup, pixel);
    if (stage.observer != nullptr) stage.observer->interpolated(source, pixel, fragment);
    process_observed(stage, source, fragment, triangle.number + 1, surface);
  });
}

void rasterise(const FragmentStage& stage, const ReadyLine& line) {
  const Surface surface{{line.vertices[0], line.vertices[0], line.vertices[1]}, {}};
  for_each_line_pixel(snap(line.ends[0]), snap(line.ends[1]), stage.window,
                      [&](const LinePixel& pixel) {
                        const Fragment fragment = interpolate(line.ends, pixel);
                        process_observed(stage, kLineOrPoint, fragment, line.id, surface);
                      });
  if (stage.samples != nullptr) rasterise_samples(stage, line);
}

void rasterise(const FragmentStage& stage, const ReadyPoint& point) {
  if (stage.samples != nullptr) rasterise_samples(stage, point);
  const PointPixel pixel = point_pixel(snap(point.position));
  const PixelRect& window = stage.window;
  if (pixel.x < window.x0 || pixel.x >= window.x1 || pixel.y < window.y0 || pixel.y >= window.y1)
    return;
  Fragment fragment;
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  fragment.depth = point.position.position.z;
  fragment.inverse_w = point.position.inverse_w;
  const Surface surface{{point.vertex, point.vertex, point.vertex}, {}};
  process_observed(stage, kLineOrPoint, fragment, 0, surface);
}

}  // namespace glassbox
