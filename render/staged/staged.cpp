#include <glassbox/render/staged/staged.h>

#include <array>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/show.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/draw_pass.h>

namespace glassbox {

Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        Observer* observer) {
  Rendering rendering;
  Framebuffer& buffers = rendering.buffers;
  Statistics& statistics = rendering.statistics;
  PreparedScene prepared;
  DrawList list;
  {
    const Stopwatch watch(statistics.prepare_ms);
    prepared = prepare(scene, settings.transfer);
    list = make_draw_list(scene, prepared, view);
    buffers =
        cleared_framebuffer(int(view.viewport.width()), int(view.viewport.height()), settings);
  }
  const std::array<EyePass, 1> eye{
      {{list.draws, view, settings, buffers, buffers.color, statistics, observer}}};
  for (std::size_t i = 0; i < list.draws.size(); ++i) {
    const DrawTables tables = transform_draw(i, eye);
    draw_primitives(i, tables, list.draws[i].triangulation->triangles, list.lighting, eye);
  }
  resolve_samples(settings, buffers, buffers.color);
  show(settings.show, buffers);
  return rendering;
}

}  // namespace glassbox
