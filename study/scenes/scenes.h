// The scenes of the benchmark (docs/benchmark.md). Any program can build them, and each one puts
// load on one part of a rasterizer.
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

#include "study/scenes/ellipsoid.h"

namespace glassbox::study {

// One pass draws the whole scene on top of the earlier passes' picture, with an empty depth buffer.
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
  RenderSettings settings;  // for all passes; each pass has its own colour mask
  std::vector<BenchPass> passes;
  std::optional<BenchStereo> stereo;  // set if the two passes are the eyes of a pair
  bool reject_objects = true;  // whether a mesh outside the frustum may be rejected as a whole

  int width() const { return int(passes.front().view.viewport.width()); }
  int height() const { return int(passes.front().view.viewport.height()); }
};

struct BenchSceneName {
  std::string_view name, stresses;
};
std::span<const BenchSceneName> bench_scene_names();

bool is_bench_scene(std::string_view name);
// Compares names without regard to upper and lower case.
bool same_name(std::string_view a, std::string_view b);

// Makes the scene "S1" to "S7" (upper or lower case). Width and height are in px. An unknown name
// is an error.
Result<BenchScene> make_bench_scene(std::string_view name, int width, int height);

// The ellipsoid, light and camera of scene S1 with another grid; used to measure how the time grows
// with the number of triangles.
BenchScene make_ellipsoid_scene(std::string name, const EllipsoidGrid& grid, int width, int height);

// Wraps any scene and view into a benchmark scene with one pass.
BenchScene make_bench_scene(std::string name, Scene scene, const View& view);

inline constexpr EllipsoidGrid kFineGrid{500, 1000, 0};    // scene S1
inline constexpr EllipsoidGrid kBandedGrid{500, 1000, 4};  // scene S1b
inline constexpr EllipsoidGrid kScannedGrid{133, 266, 0};  // scene S2
inline constexpr int kQuads = 64;                          // scene S4
inline constexpr int kCheckerSide = 1024;                  // in texels, scene S3

// The texture of scene S3: squares of 32 texels, where each texel is changed by a hash of its
// position.
Image<Rgba8> make_hashed_checker();

}  // namespace glassbox::study
