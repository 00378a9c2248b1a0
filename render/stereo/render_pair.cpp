#include <glassbox/render/stereo/render_pair.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <glassbox/raster/blend.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/draw_pass.h>
#include <glassbox/render/show.h>
#include <glassbox/render/staged.h>
#include <glassbox/render/stereo/culling_list.h>
#include <glassbox/render/stopwatch.h>

namespace glassbox {

namespace {

// Pictures of a plane of the buffer are coloured after the run, all channels at once.
bool painted_by_fragments(Show what) {
  return what == Show::kColor || what == Show::kNormal || what == Show::kUv;
}

// Zero separation: the eyes stand in one place, and one pass serves both.
StereoRendering render_once(const Scene& scene, const View& centre, const RenderSettings& settings,
                            Observer* observer) {
  StereoRendering both;
  Rendering mono = render_staged(scene, centre, settings, observer);
  both.passes = 1;
  both.left_statistics = mono.statistics;
  both.left = std::move(mono.buffers);
  return both;
}

// Both eyes with the settings of each. An anaglyph's have one colour buffer, which is the left eye's.
StereoRendering render_both(const Scene& scene, const View& centre, const StereoPair& pair,
                            StereoCulling culling, const RenderSettings& left_settings,
                            const RenderSettings& right_settings, const StereoObservers& observers,
                            bool one_color_buffer) {
  StereoRendering both;
  const View left_view = eye_view(centre, pair, Side::kLeft);
  const View right_view = eye_view(centre, pair, Side::kRight);
  PreparedScene prepared;
  DrawList list;
  std::vector<Draw> right_draws;
  {
    const Stopwatch watch(both.left_statistics.prepare_ms);
    prepared = prepare(scene, left_settings.transfer);
    list = make_draw_list(scene, prepared, left_view);
    right_draws = draws_of_other_eye(list.draws, scene, right_view);
    const int width = int(centre.viewport.width()), height = int(centre.viewport.height());
    both.left = cleared_framebuffer(width, height, left_settings);
    both.right = cleared_framebuffer(width, height, right_settings, !one_color_buffer);
  }
  const std::array<EyePass, 2> eyes{{{list.draws, left_view, left_settings, both.left,
                                      both.left.color, both.left_statistics, observers.left},
                                     {right_draws, right_view, right_settings, both.right,
                                      one_color_buffer ? both.left.color : both.right.color,
                                      both.right_statistics, observers.right}}};

  CullingList submitted(culling, scene, centre, list.draws);
  for (std::size_t i = 0; i < list.draws.size(); ++i) {
    const DrawTables tables = transform_draw(i, eyes);
    draw_primitives(i, tables, submitted.triangles_of(i, tables), list.lighting, eyes);
  }
  for (Statistics* statistics : {&both.left_statistics, &both.right_statistics}) {
    statistics->rejected += submitted.culled();
  }
  both.culled = submitted.culled();
  both.lost = submitted.lost();
  return both;
}

// Puts the channels of the right eye's mask into the left eye's picture.
void merge_channels(const ColorMask& mask, StereoRendering& both) {
  for (std::size_t i = 0; i < both.left.color.pixels.size(); ++i) {
    write_masked(mask, both.right.color.pixels[i], both.left.color.pixels[i]);
  }
  both.right.color = {};
}

RenderSettings with_mask(RenderSettings settings, const ColorMask& mask) {
  settings.mask = mask;
  return settings;
}

}  // namespace

StereoRendering render_pair(const Scene& scene, const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const StereoObservers& observers) {
  if (pair.half_separation == 0) {
    StereoRendering both = render_once(scene, centre, settings.render, observers.left);
    both.right = both.left;
    return both;
  }
  StereoRendering both = render_both(scene, centre, pair, settings.culling, settings.render,
                                     settings.render, observers, false);
  show(settings.render.show, both.left);
  show(settings.render.show, both.right);
  return both;
}

StereoRendering render_masked_anaglyph(const Scene& scene, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings,
                                       const AnaglyphMasks& masks,
                                       const StereoObservers& observers) {
  if (pair.half_separation == 0) {
    return render_once(scene, centre, with_mask(settings.render, {}), observers.left);
  }
  if (!painted_by_fragments(settings.render.show)) {
    StereoRendering both = render_pair(scene, centre, pair, settings, observers);
    merge_channels(masks.right, both);
    return both;
  }
  return render_both(scene, centre, pair, settings.culling, with_mask(settings.render, masks.left),
                     with_mask(settings.render, masks.right), observers, true);
}

}  // namespace glassbox
