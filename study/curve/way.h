// One way in which `glassbox render` can draw a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/mesh/texture_filter.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox::study {

// What a way turns, compared with the picture that was asked for. Only the engine's knobs leave every byte alone.
enum class Knob { kNone, kShading, kFilter, kSamples, kDepth, kLevel, kEngine, kSeveral };

std::string_view name_of(Knob knob);  // "shading"

struct Way {
  Knob knob = Knob::kNone;
  // Of glassbox render, beside those that all ways share: "--samples", "4". A level is in the scene's name instead.
  std::vector<std::string> options;
  RenderSettings settings;
  std::optional<TextureFilter> filter;  // absent: as each sampler says
  std::optional<int> level;             // of a built-in scene; absent: the scene that was asked for
  EngineKind engine = EngineKind::kTile;
  TileOptions tile;  // one thread but where threads are what is turned

  int threads() const { return engine == EngineKind::kStaged ? 1 : tile.threads; }
};

// "--shade flat --samples 4", "level 8", "as asked".
std::string name_of(const Way& way);

}  // namespace glassbox::study
