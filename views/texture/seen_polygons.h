// What each picture of a surface sees of it: which polygons, and where something hides them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "views/rings/picture_set.h"
#include "views/texture/placed_triangles.h"
#include "views/texture/unlit_renderer.h"

namespace glassbox::views {

class SeenPolygons {
public:
  // As the engine draws the scene in each picture, by a renderer of it. The set's cameras must be before the scene's box.
  static Result<SeenPolygons> of(const Scene& scene, const PictureSet& set,
                                 UnlitRenderer& renderer);

  std::size_t polygons() const { return polygons_; }
  // Whether a picture shows a polygon at a pixel's centre.
  bool sees(std::size_t view, std::uint32_t polygon) const {
    const std::size_t i = view * polygons_ + polygon;
    return polygon < polygons_ && (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  std::int64_t unseen() const;

  // What a place on a polygon has in a picture: from those of the four pixels around it that show the surface there; none where it is
  // beside the picture, or none of the four does. Levels. `picture` is that of the view.
  //
  // A pixel shows the surface there if it is the object's, and what is drawn at it is as far away as the polygon's plane is there, or as
  // the place itself, up to two pixels' widths: a pixel around it is up to sqrt(2) px away, where a surface that turns from the plane by
  // 45 degrees is sqrt(2) px before or behind it. So nothing is taken from what hides the place, or from what is seen beside an edge.
  std::optional<Vector3d> sample(std::size_t view, const CalibratedPicture& picture,
                                 const PlacedTriangle& polygon, const Vector3d& world) const;

  // Bits and distances.
  static double bytes_for(const Scene& scene, const PictureSet& set);

private:
  SeenPolygons(std::size_t views, std::size_t polygons)
      : views_(views), polygons_(polygons), bits_((views * polygons + 63) / 64, 0) {}

  std::size_t views_, polygons_;
  std::vector<std::uint64_t> bits_;
  std::vector<Image<float>> distances_;  // of each view, along the gaze
};

}  // namespace glassbox::views
