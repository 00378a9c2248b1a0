#include "views/rings/draw_ring.h"

#include <cmath>

#include <glassbox/render/renderer.h>

namespace glassbox::views {

Result<void> draw_each(const Scene& scene, const std::vector<RingView>& ring,
                       RenderSettings settings, Matte matte,
                       const std::function<Result<void>(CalibratedPicture)>& take,
                       const std::function<void(const std::string&)>& report_progress) {
  settings.want_distance = matte == Matte::kDepth;
  if (matte == Matte::kAlpha) settings.background.a = 0;
  Renderer renderer(scene, settings.transfer);
  for (const RingView& one : ring) {
    if (report_progress) report_progress(one.named.picture);
    Framebuffer buffers = renderer.render(one.view, settings).buffers;
    CalibratedPicture picture{one.named.picture, one.named.camera, std::move(buffers.color), {}};
    const auto& pixels = picture.color.pixels;
    if (matte == Matte::kDepth) {
      picture.matte = matte_where(picture.color.width, picture.color.height, [&](std::size_t i) {
        return std::isfinite(buffers.distance.pixels[i]);
      });
    } else if (matte == Matte::kAlpha) {
      picture.matte = matte_where(picture.color.width, picture.color.height,
                                  [&](std::size_t i) { return pixels[i].a >= 128; });
    }
    for (Rgba8& pixel : picture.color.pixels) pixel.a = 255;
    if (const auto taken = take(std::move(picture)); !taken) return taken;
  }
  return {};
}

PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring,
                     const RenderSettings& settings, Matte matte) {
  PictureSet set;
  set.box = box_of(scene);
  const auto keep = [&](CalibratedPicture picture) -> Result<void> {
    set.pictures.push_back(std::move(picture));
    return {};
  };
  (void)draw_each(scene, ring, settings, matte, keep);  // never fails, because keep() does not
  return set;
}

}  // namespace glassbox::views
