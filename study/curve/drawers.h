// What draws the ways of a scene: one renderer for all ways that share the scene and the engine.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "study/curve/way.h"
#include "study/experiment/timing.h"
#include "study/recommend/pictures.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

class Drawers {
public:
  // `at_levels`: the same scene at other levels, where ways have them. All of them must outlive this.
  Drawers(const Scene& scene, ViewOf view, const std::map<int, Scene>* at_levels = nullptr);

  // An error where its depth format cannot have the view.
  Result<View> view_of(const Way& way);
  // The colours of the picture of a way that has a view.
  Image<Rgba8> draw(const Way& way);

  const Scene& scene_of(const Way& way);

private:
  // Level, filter, engine, target, threads, plan: what a renderer is made for.
  using Key = std::tuple<int, int, EngineKind, Target, int, bool>;
  Renderer& renderer_of(const Way& way);

  const Scene& scene_;
  ViewOf view_;
  const std::map<int, Scene>* at_levels_;
  std::map<TextureFilter, Scene> filtered_;
  std::map<DepthFormat, View> views_;
  std::map<Key, std::unique_ptr<Renderer>> renderers_;
};

// The time of a frame of each way, drawn in turn.
std::vector<Timed> frame_times(Drawers& drawers, const std::vector<Way>& ways, int repetitions);

}  // namespace glassbox::study
