// What each picture of a surface sees of it: which polygons, and where something hides them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/rings/picture_set.h"
#include "views/texture/unlit_renderer.h"
#include "views/texture/world_triangles.h"

namespace glassbox::views {

class VisiblePolygons {
public:
  // The polygons that the engine shows when it draws the scene with each picture's camera.
  // `renderer` is a renderer of the scene. The set's cameras must be in front of the scene's box.
  static Result<VisiblePolygons> find(const Scene& scene, const PictureSet& set,
                                      UnlitRenderer& renderer);

  std::size_t polygons() const { return polygons_; }
  // Whether a picture shows a polygon at a pixel's centre.
  bool sees(std::size_t view, std::uint32_t polygon) const {
    const std::size_t i = view * polygons_ + polygon;
    return polygon < polygons_ && (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  std::int64_t unseen() const;

  // The colour of a place on a polygon in a picture, in levels, interpolated between those of the
  // four pixels around it that show the surface there. None if the place is outside of the picture,
  // or if none of the four pixels shows the surface. `picture` is the picture of `view`.
  //
  // A pixel shows the surface if it belongs to the object and the distance drawn at it is that of
  // the polygon's plane there, or that of the place itself, to within two pixels' widths: a pixel
  // around the place is up to sqrt(2) px away, where a surface inclined by 45 degrees to the plane
  // is sqrt(2) px in front of it or behind it. So no colour is taken from something that hides the
  // place, or from what is visible next to an edge.
  std::optional<Vector3d> sample(std::size_t view, const CalibratedPicture& picture,
                                 const WorldTriangle& polygon, const Vector3d& world) const;

  // Bytes for the bits and the distances.
  static double bytes_for(const Scene& scene, const PictureSet& set);

private:
  VisiblePolygons(std::size_t views, std::size_t polygons)
      : views_(views), polygons_(polygons), bits_((views * polygons + 63) / 64, 0) {}

  std::size_t views_, polygons_;
  std::vector<std::uint64_t> bits_;
  std::vector<Image<float>> distances_;  // of each view, along the direction of view
};

}  // namespace glassbox::views
