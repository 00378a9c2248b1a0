#include "views/rings/draw_ring.h"

#include <cmath>

#include <glassbox/render/renderer.h>

namespace glassbox::views {

namespace {

Image<std::uint8_t> matte_where(int width, int height, auto is_object) {
  Image<std::uint8_t> matte(width, height, 0);
  for (std::size_t i = 0; i < matte.pixels.size(); ++i) matte.pixels[i] = is_object(i) ? 255 : 0;
  return matte;
}

}  // namespace

PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring, RenderSettings settings,
                     Matte matte, const std::function<void(const std::string&)>& tell) {
  settings.want_distance = matte == Matte::kDepth;
  if (matte == Matte::kAlpha) settings.background.a = 0;
  PictureSet set;
  set.box = box_of(scene);
  Renderer renderer(scene, settings.transfer);
  for (const RingView& one : ring) {
    if (tell) tell(one.named.picture);
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
    set.pictures.push_back(std::move(picture));
  }
  return set;
}

}  // namespace glassbox::views
