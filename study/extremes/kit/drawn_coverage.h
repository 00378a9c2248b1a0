// Which pixels whole runs cover, against 128-bit integers: the stages between the scene and the picture are all in it.
#pragma once

#include <vector>

#include "study/extremes/kit/drawer.h"
#include "study/extremes/kit/screen_scene.h"

namespace glassbox::study {

// Coordinates on the lattice of 1/1024 px, where the camera of screen_scene moves nothing: what is snapped are these very
// numbers, ties included. Up to 2^14 px from the picture's centre, for pictures whose side is a power of two. Triangles that have
// no area there are left out, as a mesh leaves them out: the snap could give them one.
std::vector<ScreenTriangle> on_lattice(std::vector<ScreenTriangle> triangles);

// Pictures more deeply covered than that are not counted further.
inline constexpr int kMostLayers = 5;

// What the triangles cover in a picture of side x side pixels, `times` up to kMostLayers. Of those that are turned away, which is
// decided by the sign of the snapped area, nothing.
TrianglesDrawn covered_exactly(const std::vector<ScreenTriangle>& triangles, int side,
                               Cull cull = Cull::kNone);

struct Culling {
  Cull cull = Cull::kNone;
  CullStage stage = CullStage::kScreen;
};
// By two runs: opaque, where the first drawn stays, for all have one depth; then blended, where colours count the layers.
TrianglesDrawn drawn_by(const Drawer& drawer, const std::vector<ScreenTriangle>& triangles,
                        int side, const Culling& culling = {});

// "3 pixels show another triangle, 4 are covered too often or not often enough, of 1,024"
Outcome compare(const TrianglesDrawn& found, const TrianglesDrawn& exact);

// Triangles and what they cover, worked out once for all drawers.
class CoverageDrawn {
public:
  CoverageDrawn(std::vector<ScreenTriangle> triangles, int side, const Culling& culling = {});
  Outcome judge(const Drawer& drawer) const;

private:
  std::vector<ScreenTriangle> triangles_;
  int side_;
  Culling culling_;
  TrianglesDrawn exact_;
};

// The worst of several pictures.
Outcome worst_of(const std::vector<CoverageDrawn>& pictures, const Drawer& drawer);

// How many half-transparent white layers lie on black in a picture of linear bytes; kMostLayers or more of them are one.
int layers_of(const Rgba8& color);

// Unlit, linear bytes, black behind it.
RenderSettings plain_settings();
// Half-transparent white from both sides.
Material layer_material();

}  // namespace glassbox::study
