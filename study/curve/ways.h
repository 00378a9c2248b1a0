// Lists the ways to draw a scene: each knob turned alone, and shading, filter and samples combined.
#pragma once

#include <set>
#include <vector>

#include "study/curve/way.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::study {

struct WaysAsked {
  RenderSettings settings{};
  std::optional<TextureFilter> filter{};
  std::set<Knob> held{};  // knobs that the user has set: they are not turned
  bool cull_stage_held = false;
  std::vector<int> levels{};  // the other levels at which the scene is available
  int threads = 1;            // the largest number
  TileOptions tile{};         // used by all ways, except for what they turn
};

// A knob that is not turned, and the reason.
struct NotTurned {
  Knob knob = Knob::kNone;
  std::string why;
};

struct Ways {
  std::vector<Way> all;  // the first is the picture as it was asked for
  std::vector<NotTurned> left_out;
};

// The ways in which exactly one knob is turned.
Ways single_turns(const Scene& scene, const WaysAsked& asked);

// Every combination of two or three of the shading, filter and sample changes in `turns`.
std::vector<Way> combined_turns(const std::vector<Way>& turns);

}  // namespace glassbox::study
