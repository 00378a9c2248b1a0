// Lists the variants of drawing a scene: each knob (an option of drawing) changed alone, and
// changes of shading, filter and samples combined.
#pragma once

#include <set>
#include <vector>

#include "study/curve/render_variant.h"

#include <glassbox/mesh/scene.h>

namespace glassbox::study {

struct VariantRequest {
  RenderSettings settings{};
  std::optional<TextureFilter> filter{};
  std::set<Knob> fixed_knobs{};  // knobs that the user has set: no variant changes them
  bool cull_stage_fixed = false;
  std::vector<int> levels{};  // the other levels at which the scene is available
  int threads = 1;            // the largest number of threads
  TileOptions tile{};         // used by all variants, except for what each one changes
};

// A knob that no variant changes, and the reason.
struct SkippedKnob {
  Knob knob = Knob::kNone;
  std::string why;
};

struct RenderVariants {
  std::vector<RenderVariant> all;  // the first is the picture as it was asked for
  std::vector<SkippedKnob> skipped;
};

// The variants in which exactly one knob is changed.
RenderVariants single_knob_variants(const Scene& scene, const VariantRequest& asked);

// Every combination of two or three of the changes of shading, filter and samples in `turns`.
std::vector<RenderVariant> combined_variants(const std::vector<RenderVariant>& turns);

}  // namespace glassbox::study
