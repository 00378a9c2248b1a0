// Draws a scene in its various ways: all ways that need the same renderer share it.
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
  // `at_levels` has the same scene at other levels, if ways ask for them. All arguments must
  // outlive this object.
  Drawers(const Scene& scene, ViewOf view, const std::map<int, Scene>* at_levels = nullptr);

  // An error if the way's depth format does not allow the view.
  Result<View> view_of(const Way& way);
  // The colours of the picture that a way draws. Its view must exist.
  Image<Rgba8> draw(const Way& way);

  const Scene& scene_of(const Way& way);

private:
  // What a renderer depends on: level, filter, engine, target, number of threads, whether a plan is
  // used.
  using Key = std::tuple<int, int, EngineKind, Target, int, bool>;
  Renderer& renderer_of(const Way& way);

  const Scene& scene_;
  ViewOf view_;
  const std::map<int, Scene>* at_levels_;
  std::map<TextureFilter, Scene> filtered_;
  std::map<DepthFormat, View> views_;
  std::map<Key, std::unique_ptr<Renderer>> renderers_;
};

// Draws the ways in turn and returns the time of a frame of each.
std::vector<Timed> frame_times(Drawers& drawers, const std::vector<Way>& ways, int repetitions);

}  // namespace glassbox::study
