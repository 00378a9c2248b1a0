// Compares the pixels that complete runs cover with the right pixels, computed with 128-bit
// integers; a run includes all stages between the scene and the picture.
#pragma once

#include <vector>

#include "study/extremes/common/screen_scene.h"
#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// Moves the coordinates to the lattice of 1/1024 px, which the camera of screen_scene preserves:
// snapping gets exactly these numbers, ties included. Coordinates may be up to 2^14 px from the
// picture's centre, for pictures whose side is a power of two. Triangles without area on the
// lattice are dropped, as a mesh drops them, because snapping could give them an area.
std::vector<ScreenTriangle> on_lattice(std::vector<ScreenTriangle> triangles);

// Layers are counted only up to this number.
inline constexpr int kMaxLayers = 5;

// The pixels that the triangles cover in a picture of side x side pixels; `times` counts up to
// kMaxLayers. Triangles that are culled, which the sign of their snapped area decides, cover
// nothing.
TriangleCoverage covered_exactly(const std::vector<ScreenTriangle>& triangles, int side,
                                 Cull cull = Cull::kNone);

struct Culling {
  Cull cull = Cull::kNone;
  CullStage stage = CullStage::kScreen;
};
// Draws the triangles twice: first opaque, where each pixel keeps the first triangle because all
// have the same depth; then blended, where the colour shows the number of layers.
TriangleCoverage draw_coverage(const TestedEngine& engine,
                               const std::vector<ScreenTriangle>& triangles, int side,
                               const Culling& culling = {});

// The outcome says for example "3 pixels show another triangle, 4 are covered too often or not
// often enough, of 1,024".
Outcome compare(const TriangleCoverage& found, const TriangleCoverage& exact);

// Triangles and the pixels that they cover, computed once for all engines.
class CoverageReference {
public:
  CoverageReference(std::vector<ScreenTriangle> triangles, int side, const Culling& culling = {});
  Outcome measure_error(const TestedEngine& engine) const;

private:
  std::vector<ScreenTriangle> triangles_;
  int side_;
  Culling culling_;
  TriangleCoverage exact_;
};

// The worst outcome of several pictures.
Outcome worst_of(const std::vector<CoverageReference>& pictures, const TestedEngine& engine);

// The number of half-transparent white layers on black, in a picture of linear bytes; the result is
// at most kMaxLayers.
int layers_of(const Rgba8& color);

// Settings for pictures without light, with linear bytes and a black background.
RenderSettings plain_settings();
// A double-sided, half-transparent white material; its colour in the picture shows the number of
// layers.
Material layer_material();

}  // namespace glassbox::study
