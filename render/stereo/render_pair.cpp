#include <glassbox/render/stereo/render_pair.h>

#include <array>
#include <utility>
#include <vector>

#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/show.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/draw_pass.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/stereo/culling_list.h>
#include <glassbox/render/stereo/pair_driver.h>

namespace glassbox {

namespace {

class StagedPair : public PairDriver {
public:
  StagedPair(const Scene& scene, const View& centre, const StereoPair& pair, StereoCulling culling,
             const StereoObservers& observers)
      : scene_(scene),
        centre_(centre),
        left_view_(eye_view(centre, pair, Side::kLeft)),
        right_view_(eye_view(centre, pair, Side::kRight)),
        culling_(culling),
        observers_(observers) {}

  void draw_centre(const RenderSettings& settings, StereoRendering& into) override {
    Rendering mono = render_staged(scene_, centre_, settings, observers_.left);
    into.left_statistics = mono.statistics;
    into.left = std::move(mono.buffers);
  }

  void draw_eyes(const RenderSettings& left_settings, const RenderSettings& right_settings,
                 bool one_color_buffer, StereoRendering& both) override {
    both.left_statistics = both.right_statistics = {};
    PreparedScene prepared;
    DrawList list;
    std::vector<Draw> right_draws;
    {
      const Stopwatch watch(both.left_statistics.prepare_ms);
      prepared = prepare(scene_, left_settings.transfer);
      list = make_draw_list(scene_, prepared, left_view_);
      right_draws = draws_of_other_eye(list.draws, scene_, right_view_);
      const int width = int(centre_.viewport.width()), height = int(centre_.viewport.height());
      both.left = cleared_framebuffer(width, height, left_settings);
      both.right = cleared_framebuffer(width, height, right_settings, !one_color_buffer);
    }
    const std::array<EyePass, 2> eyes{{{list.draws, left_view_, left_settings, both.left,
                                        both.left.color, both.left_statistics, observers_.left},
                                       {right_draws, right_view_, right_settings, both.right,
                                        one_color_buffer ? both.left.color : both.right.color,
                                        both.right_statistics, observers_.right}}};

    CullingList submitted(culling_, scene_, centre_, list.draws);
    for (std::size_t i = 0; i < list.draws.size(); ++i) {
      const DrawTables tables = transform_draw(i, eyes);
      draw_primitives(i, tables, submitted.triangles_of(i, tables), list.lighting, eyes);
    }
    for (Statistics* statistics : {&both.left_statistics, &both.right_statistics}) {
      statistics->rejected += submitted.culled();
    }
    both.culled = submitted.culled();
    both.lost = submitted.lost();
    for (const EyePass& eye : eyes) resolve_samples(eye.settings, eye.target, eye.color);
    if (one_color_buffer) return;
    show(left_settings.show, both.left);
    show(right_settings.show, both.right);
  }

private:
  const Scene& scene_;
  const View& centre_;
  const View left_view_, right_view_;
  const StereoCulling culling_;
  const StereoObservers& observers_;
};

}  // namespace

StereoRendering render_pair(const Scene& scene, const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const StereoObservers& observers) {
  StereoRendering both;
  StagedPair staged(scene, centre, pair, settings.culling, observers);
  draw_pair(staged, pair, settings.render, both);
  return both;
}

StereoRendering render_masked_anaglyph(const Scene& scene, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings,
                                       const AnaglyphMasks& masks,
                                       const StereoObservers& observers) {
  StereoRendering both;
  StagedPair staged(scene, centre, pair, settings.culling, observers);
  draw_masked_anaglyph(staged, pair, settings.render, masks, both);
  return both;
}

}  // namespace glassbox
