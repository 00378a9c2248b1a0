// Draws both eyes' pictures from one display list, submitted twice (S0-03).
//
// The draw list, the textures' mip chains, y, z and w of every vertex, and eye space are computed
// once. From the clipper on, each eye is processed separately: in the reference, the whole left
// picture before the right one; in the tile engine, some triangles for one eye and then the same
// triangles for the other. Each eye's picture has the same bytes as render_staged with
// eye_view(centre, pair, side).
#pragma once

#include <cstdint>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/engine.h>

namespace glassbox {

struct StereoSettings {
  RenderSettings render;  // of each eye; an anaglyph's masks replace render.mask
  StereoCulling culling = StereoCulling::kUnion;
};

// The observers of the two eyes, called in the same way as by render_staged. The run of the left
// eye ends before that of the right eye begins. Null: no observer.
struct StereoObservers {
  Observer* left = nullptr;
  Observer* right = nullptr;
};

struct StereoRendering {
  // If the separation is zero, both eyes share one pass: left and right are then copies.
  Framebuffer left, right;
  // Work that is done once for both eyes is counted and timed in the left eye's statistics.
  Statistics left_statistics, right_statistics;
  int passes = 2;
  std::uint64_t culled = 0;  // triangles culled for both eyes at once
  // How many of the culled ones are in the frustum of an eye; 0 with kUnion.
  std::uint64_t lost = 0;
};

// The channels that each eye may write into the one picture. A channel that both may write has the
// right eye's values, and so has alpha. Alpha is 1 except over a translucent background that the
// right eye sees, perhaps through blended surfaces.
struct AnaglyphMasks {
  ColorMask left{true, false, false, false};
  ColorMask right{false, true, true, true};
};

// Draws with any engine. `prepared` must have been made from the scene with the transfer function
// of the settings, and the pair must have been checked (check_pair). The memory of `into` is
// reused.
void render_pair(Engine& engine, const Scene& scene, const PreparedScene& prepared,
                 const View& centre, const StereoPair& pair, const StereoSettings& settings,
                 StereoRendering& into, const StereoObservers& observers = {});

// Draws an anaglyph as in deck S0 (S0-05): with one colour buffer, which is left.color of the
// result; right.color is empty. Each eye has its own depth, which is equivalent to clearing the
// depth between two passes. The picture has the bytes of the two pictures of render_pair with the
// channels of each eye combined (S0-02).
void render_masked_anaglyph(Engine& engine, const Scene& scene, const PreparedScene& prepared,
                            const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const AnaglyphMasks& masks,
                            StereoRendering& into, const StereoObservers& observers = {});

// These functions draw with the staged reference and prepare the scene for this picture alone.
StereoRendering render_pair(const Scene& scene, const View& centre, const StereoPair& pair,
                            const StereoSettings& settings, const StereoObservers& observers = {});
StereoRendering render_masked_anaglyph(const Scene& scene, const View& centre,
                                       const StereoPair& pair, const StereoSettings& settings,
                                       const AnaglyphMasks& masks,
                                       const StereoObservers& observers = {});

}  // namespace glassbox
