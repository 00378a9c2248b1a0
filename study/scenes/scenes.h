// The scenes of the benchmark (docs/benchmark.md): any program can make them again, and each loads one part of a
// rasterizer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

#include "study/scenes/grid.h"

namespace glassbox::study {

// The scene drawn once, into the picture that the passes before it have left, with an empty depth buffer.
struct BenchPass {
  View view;
  ColorMask mask;
};

struct BenchStereo {
  View centre;
  StereoPair pair;
};

struct BenchScene {
  std::string name;
  Scene scene;
  RenderSettings settings;  // without the mask, which is the pass's
  std::vector<BenchPass> passes;
  std::optional<BenchStereo> stereo;  // whose eyes the two passes are
  bool reject_objects = true;         // whether a mesh that is seen nowhere may be left out whole

  int width() const { return int(passes.front().view.viewport.width()); }
  int height() const { return int(passes.front().view.viewport.height()); }
};

struct BenchSceneName {
  std::string_view name, stresses;
};
std::span<const BenchSceneName> bench_scene_names();

bool is_bench_scene(std::string_view name);
// Names are the same in either case.
bool same_name(std::string_view a, std::string_view b);

// "S1" to "S7", in either case; no such name is an error. Width and height in px.
Result<BenchScene> make_bench_scene(std::string_view name, int width, int height);

// S1's ellipsoid, light and camera with another grid: what scaling is measured with.
BenchScene make_ellipsoid_scene(std::string name, const Grid& grid, int width, int height);

// Any scene, seen through any view.
BenchScene make_bench_scene(std::string name, Scene scene, const View& view);

inline constexpr Grid kFineGrid{500, 1000, 0};    // S1
inline constexpr Grid kBandedGrid{500, 1000, 4};  // S1b
inline constexpr Grid kScannedGrid{133, 266, 0};  // S2
inline constexpr int kQuads = 64;                 // S4
inline constexpr int kCheckerSide = 1024;         // texels, S3

// S3's texture: checks of 32 texels, each texel changed by a hash of its place.
Image<Rgba8> make_hashed_checker();

}  // namespace glassbox::study
