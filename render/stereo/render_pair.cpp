#include <glassbox/render/stereo/render_pair.h>

#include <array>
#include <optional>

#include <glassbox/raster/blend.h>
#include <glassbox/render/staged/staged.h>

namespace glassbox {

namespace {

// Whether fragments write the colours that are shown. Otherwise (depth, triangle numbers, overdraw)
// the picture is coloured after the run, all channels at once.
bool painted_by_fragments(Show what) {
  return what == Show::kColor || what == Show::kNormal || what == Show::kUv;
}

RenderSettings with_mask(RenderSettings settings, const ColorMask& mask) {
  settings.mask = mask;
  return settings;
}

// Removes from `mask` the channels that `others` also has. If both eyes may write a channel, the
// picture has the right eye's values. The left eye must not write it, because the right eye's
// blended surfaces would then be blended over the left eye's colours.
ColorMask without(const ColorMask& mask, const ColorMask& others) {
  return {mask.r && !others.r, mask.g && !others.g, mask.b && !others.b, mask.a && !others.a};
}

// Copies the channels of the right eye's mask into the left eye's picture.
void merge_channels(const ColorMask& mask, StereoRendering& both) {
  for (std::size_t i = 0; i < both.left.color.pixels.size(); ++i) {
    write_masked(mask, both.right.color.pixels[i], both.left.color.pixels[i]);
  }
  both.right.color = {};
}

// A pair of eyes in a scene, and the engine that draws what they see.
class Pair {
public:
  Pair(Engine& engine, const Scene& scene, const PreparedScene& prepared, const View& centre,
       const StereoPair& pair, StereoCulling culling, const StereoObservers& observers)
      : engine_(engine),
        scene_(scene),
        prepared_(prepared),
        culling_{culling, centre},
        left_view_(eye_view(centre, pair, Side::kLeft)),
        right_view_(eye_view(centre, pair, Side::kRight)),
        observers_(observers) {}

  // Draws one picture for both eyes. It is used if the separation is zero, so that the eyes are at
  // the same place.
  void draw_once(const RenderSettings& settings, StereoRendering& into) {
    into.passes = 1;
    into.right = {};
    into.right_statistics = {};
    into.culled = into.lost = 0;
    const EyePicture eye{culling_.centre,      settings,       into.left, into.left.color,
                         into.left_statistics, observers_.left};
    engine_.draw({scene_, prepared_, {&eye, 1}});
  }

  // Draws both eyes' pictures; their settings differ at most in the masks. With `one_color_buffer`
  // both eyes write to the left eye's colours; then the fragments themselves must write the colours
  // that are shown (painted_by_fragments).
  void draw_eyes(const RenderSettings& left, const RenderSettings& right, bool one_color_buffer,
                 StereoRendering& into) {
    into.passes = 2;
    Image<Rgba8>& right_color = one_color_buffer ? into.left.color : into.right.color;
    const std::array<EyePicture, 2> eyes{
        {{left_view_, left, into.left, into.left.color, into.left_statistics, observers_.left},
         {right_view_, right, into.right, right_color, into.right_statistics, observers_.right}}};
    const PairCullCounts left_out = engine_for_culling().draw({scene_, prepared_, eyes, &culling_});
    into.culled = left_out.culled;
    into.lost = left_out.lost;
  }

private:
  // Returns the engine, or the staged reference if the culling may lose triangles (kCentre) and the
  // engine cannot do it.
  Engine& engine_for_culling() {
    if (culling_.how == StereoCulling::kUnion || engine_.culls_as_centre()) return engine_;
    return reference_;
  }

  Engine& engine_;
  StagedEngine reference_;
  const Scene& scene_;
  const PreparedScene& prepared_;
  const PairCulling culling_;
  const View left_view_, right_view_;
  const StereoObservers observers_;
};

void draw_pair(Pair& eyes, const StereoPair& pair, const RenderSettings& settings,
               StereoRendering& into) {
  if (pair.half_separation == 0) {
    eyes.draw_once(settings, into);
    into.right = into.left;
    return;
  }
  eyes.draw_eyes(settings, settings, false, into);
}

}  // namespace

void render_pair(Engine& engine, const Scene& scene, const PreparedScene& prepared,
                 const View& centre, const StereoPair& pair, const StereoSettings& settings,
                 StereoRendering& into, const StereoObservers& observers) {
  Pair eyes(engine, scene, prepared, centre, pair, settings.culling, observers);
  draw_pair(eyes, pair, settings.render, into);
}

void render_masked_anaglyph(Engine& engine, const Scene& scene, const PreparedScene& prepared,
                            const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const AnaglyphMasks& wanted,
                            StereoRendering& into, const StereoObservers& observers) {
  Pair eyes(engine, scene, prepared, centre, pair, settings.culling, observers);
  const RenderSettings& render = settings.render;
  const AnaglyphMasks masks{without(wanted.left, wanted.right), wanted.right};
  if (pair.half_separation == 0) {
    eyes.draw_once(with_mask(render, {}), into);
  } else if (painted_by_fragments(render.show)) {
    eyes.draw_eyes(with_mask(render, masks.left), with_mask(render, masks.right), true, into);
  } else {
    draw_pair(eyes, pair, render, into);
    merge_channels(masks.right, into);
  }
}

StereoRendering render_pair(const Scene& scene, const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const StereoObservers& observers) {
  StagedEngine engine;
  StereoRendering both;
  render_pair(engine, scene, prepare_scene(scene, settings.render.transfer), centre, pair, settings,
              both, observers);
  return both;
}

StereoRendering render_masked_anaglyph(const Scene& scene, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings,
                                       const AnaglyphMasks& masks,
                                       const StereoObservers& observers) {
  StagedEngine engine;
  StereoRendering both;
  render_masked_anaglyph(engine, scene, prepare_scene(scene, settings.render.transfer), centre,
                         pair, settings, masks, both, observers);
  return both;
}

}  // namespace glassbox
