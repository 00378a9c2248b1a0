// Scenes like those of users, with textures and mipmaps, lights, multisampling, alpha masks,
// blending and many objects.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "study/scenes/scenes.h"

namespace glassbox::study {

struct RealScene {
  std::string_view name, stresses;
  // Where the scene comes from: a built-in scene, a scene of the benchmark, or a file below the
  // assets folder. Empty: it is made in this file.
  std::string_view source;
  bool is_asset = false;
  int samples = 1;
};

// The scenes R1 to R12.
std::span<const RealScene> real_scenes();
// Finds a scene by its name; upper and lower case count as the same. Null if there is none.
const RealScene* find_real_scene(std::string_view name);

// Makes one of the scenes whose source is empty. Width and height are in px.
Result<BenchScene> make_real_scene(std::string_view name, int width, int height);

inline constexpr int kGlassLayers = 32;        // scene R9
inline constexpr int kManyInstances = 100000;  // scene R10
inline constexpr int kHiddenSpheres = 100;     // scene R11
inline constexpr int kScattered = 200;         // scene R12
inline constexpr int kScatteredInView = 10;

}  // namespace glassbox::study
