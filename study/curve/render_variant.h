// A variant: one way in which `glassbox render` can draw a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/mesh/texture_filter.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox::study {

// The option in which a variant differs from the picture that was asked for. Only kEngine never
// changes a byte of the picture.
enum class Knob { kNone, kShading, kFilter, kSamples, kDepth, kLevel, kEngine, kSeveral };

std::string_view name_of(Knob knob);  // for example "shading"

struct RenderVariant {
  Knob knob = Knob::kNone;
  // The options of `glassbox render` for this variant, besides those that are the same for all
  // variants, for example "--samples", "4". A level is part of the scene's name instead.
  std::vector<std::string> options;
  RenderSettings settings;
  std::optional<TextureFilter> filter;  // absent: each sampler has its own filter
  std::optional<int> level;  // level of a built-in scene; absent: the scene that was asked for
  EngineKind engine = EngineKind::kTile;
  TileOptions tile;  // one thread, unless the number of threads is what the variant changes

  int threads() const { return engine == EngineKind::kStaged ? 1 : tile.threads; }
};

// For example "--shade flat --samples 4", "level 8" or "as asked".
std::string name_of(const RenderVariant& variant);

}  // namespace glassbox::study
