// A generated scene and two eyes that can look at it.
#pragma once

#include <cstdint>
#include <optional>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

#include "tests/render/tile/generated_case.h"

namespace glassbox::test {

struct GeneratedPair {
  GeneratedCase scene;  // its settings show colours and write all channels
  StereoPair eyes;
};

// None if the eyes cannot be placed, which happens in a few per cent of the cases.
inline std::optional<GeneratedPair> generate_pair(std::uint64_t seed, int largest_side) {
  Random random(0x2e7e5 + seed);
  constexpr int kMaxFaces = 24;
  GeneratedPair made{generate_case(random, kMaxFaces, largest_side), {}};
  RenderSettings& settings = made.scene.settings;
  settings.show = Show::kColor;
  settings.mask = {};
  made.eyes.window = made.scene.view.near + random.unit() * 10;
  made.eyes.half_separation = made.eyes.window * random.unit() / 20;
  if (!check_pair(made.scene.view, made.eyes)) return {};
  return made;
}

// Replaces blending by masking: blended surfaces hide nothing, so they have no layer.
inline void make_opaque_or_masked(Scene& scene) {
  for (Material& material : scene.materials) {
    if (material.alpha_mode == AlphaMode::kBlend) material.alpha_mode = AlphaMode::kMask;
  }
}

}  // namespace glassbox::test
