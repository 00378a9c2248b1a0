// Ray casting: computes what is visible through a point of the screen, along a ray in extended
// precision. It has no matrices, clipping, divide, snapping or interpolation, so that it shares
// nothing with the code that draws.
//
// Vertices are drawn at their snapped places, and screen coordinates are floats, so the right
// answer is that of a picture whose edges may be moved by about 2^-7 px (the sum is in the case
// C-40). A pixel is checked only if the same is visible at its centre and at eight points 2^-7 px
// around it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "study/extremes/common/outcome.h"
#include "study/extremes/common/ray_scene.h"
#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// What is seen through a point of the screen, given in pixels.
struct RayHits {
  int layers = 0;   // surfaces that the line of sight hits, except culled ones
  int nearest = 0;  // number of the nearest triangle, counted from 1; 0: none
  std::array<int, 2> texel{};
  // How many of the three kinds of stripes are lost at the surface's level of detail.
  int stripes = 0;
  bool unambiguous = true;  // the nearest surface is clearly nearer than the next
  friend bool operator==(const RayHits&, const RayHits&) = default;
};
// `candidates` has the numbers of the triangles that may be hit, in ascending order.
RayHits cast_ray(const RayScene& ray_scene, std::span<const std::size_t> candidates, double x,
                 double y);

// A ray scene and what is visible in it, computed once for all engines.
class RayCastReference {
public:
  explicit RayCastReference(RayScene ray_scene);
  // Counts pixels that show another triangle or texel, drawn with and without triangle ids, and
  // pixels that are covered by another number of layers. Infinite if fewer than half of the pixels
  // can be checked.
  Outcome measure_error(const TestedEngine& engine) const;

  const RayScene& ray_scene() const { return ray_scene_; }
  // What is visible in a pixel (numbered by rows); none if the pixel cannot be checked.
  std::optional<RayHits> hits(std::size_t pixel) const;

private:
  bool shows_face(const RayHits& hits, const Rgba8& color) const;

  RayScene ray_scene_;
  // The scene with a colour for each face of a mesh; used if no texels identify triangles.
  Scene numbered_;
  std::vector<std::uint32_t> faces_;  // indexed by triangle
  // The right answer for a pixel; `hits` is empty if the pixel cannot be checked.
  struct Pixel {
    std::optional<RayHits> hits;
    // Known even beside an edge that two triangles share, where `hits` is not.
    std::optional<int> layers;
  };
  std::vector<Pixel> pixels_;  // row by row
};

// The worst outcome of several pictures.
Outcome worst_of(const std::vector<RayCastReference>& pictures, const TestedEngine& engine);

}  // namespace glassbox::study
