#include "views/texture/unlit_renderer.h"

namespace glassbox::views {

UnlitRenderer::UnlitRenderer(const Scene& scene)
    : box_(box_of(scene)), renderer_(scene, RenderSettings{}.transfer) {}

Result<Framebuffer> UnlitRenderer::draw(const PinholeCamera& camera, int width, int height,
                                        Rgba8 background) {
  const auto view = view_of(camera, width, height, box_);
  if (!view) return tl::unexpected(view.error());
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.background = background;
  settings.want_id = true;
  settings.want_distance = true;
  return renderer_.render(*view, settings).buffers;
}

}  // namespace glassbox::views
