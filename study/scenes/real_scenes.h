// What users draw: scenes with textures and their levels, lights, samples, masks, blending and many objects.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "study/scenes/scenes.h"

namespace glassbox::study {

struct RealScene {
  std::string_view name, stresses;
  // What is drawn: a built-in scene, a scene of the benchmark, or a file below the folder of assets. Empty: it is made here.
  std::string_view source;
  bool is_asset = false;
  int samples = 1;
};

// R1 to R12.
std::span<const RealScene> real_scenes();
// In either case; null: there is no such name.
const RealScene* find_real_scene(std::string_view name);

// One of those that are made here. Width and height in px.
Result<BenchScene> make_real_scene(std::string_view name, int width, int height);

inline constexpr int kGlassLayers = 32;        // R9
inline constexpr int kManyInstances = 100000;  // R10
inline constexpr int kHiddenSpheres = 100;     // R11
inline constexpr int kScattered = 200;         // R12
inline constexpr int kScatteredInView = 10;

}  // namespace glassbox::study
