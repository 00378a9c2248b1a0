// The ways to draw a scene: each knob turned alone, and shading, filter and samples together.
#pragma once

#include <set>
#include <vector>

#include "study/curve/way.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::study {

struct WaysAsked {
  RenderSettings settings{};
  std::optional<TextureFilter> filter{};
  std::set<Knob> held{};  // what was asked for, and is not turned
  bool cull_stage_held = false;
  std::vector<int> levels{};  // that the scene may be had at, beside the one that was asked for
  int threads = 1;            // the most
  TileOptions tile{};         // of all ways, but for what they turn
};

// A knob that is not turned, and why.
struct NotTurned {
  Knob knob = Knob::kNone;
  std::string why;
};

struct Ways {
  std::vector<Way> all;  // the picture as it was asked for comes first
  std::vector<NotTurned> left_out;
};

// Each knob turned alone.
Ways single_turns(const Scene& scene, const WaysAsked& asked);

// Every combination of two or three of the turns of shading, filter and samples among `turns`.
std::vector<Way> combined_turns(const std::vector<Way>& turns);

}  // namespace glassbox::study
