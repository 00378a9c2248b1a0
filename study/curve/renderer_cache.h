// Draws a scene in its variants; one renderer is used for all variants that need the same one.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "study/curve/render_variant.h"
#include "study/experiment/timing.h"
#include "study/recommend/pictures.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

class RendererCache {
public:
  // `at_levels` has the same scene at other levels, if variants ask for them. All arguments must
  // outlive this object.
  RendererCache(const Scene& scene, ViewOf view, const std::map<int, Scene>* at_levels = nullptr);

  // Returns an error if the variant's depth format does not allow the view.
  Result<View> view_of(const RenderVariant& variant);
  // The colours of the picture that a variant draws. Its view must exist.
  Image<Rgba8> draw(const RenderVariant& variant);

  const Scene& scene_of(const RenderVariant& variant);

private:
  // What a renderer depends on: level, filter, engine, target, number of threads, and whether the
  // renderer makes a plan.
  using Key = std::tuple<int, int, EngineKind, Target, int, bool>;
  Renderer& renderer_of(const RenderVariant& variant);

  const Scene& scene_;
  ViewOf view_;
  const std::map<int, Scene>* at_levels_;
  std::map<TextureFilter, Scene> filtered_;
  std::map<DepthFormat, View> views_;
  std::map<Key, std::unique_ptr<Renderer>> renderers_;
};

// Draws the variants in turn and returns the time of a frame of each.
std::vector<Timed> frame_times(RendererCache& renderer_cache,
                               const std::vector<RenderVariant>& variants, int repetitions);

}  // namespace glassbox::study
