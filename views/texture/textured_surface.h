// A surface that takes its colours from pictures of it and can be viewed from anywhere (S1-40:
// Debevec, Taylor and Malik 1996).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/rings/picture_set.h"
#include "views/texture/view_blend.h"
#include "views/texture/visible_polygons.h"

namespace glassbox::views {

struct TexturedPicture {
  Image<Rgba8> color;
  Image<std::uint32_t> id;   // 1 + the polygon's number; 0: background
  std::int64_t surface = 0;  // pixels that show a polygon
  // Pixels that show a polygon at a place that no view sees; they have the surface's own colour.
  std::int64_t without_view = 0;
};

class TexturedSurface {
public:
  // Bytes needed for the surface together with the scene: the polygons that each picture sees, and
  // the placed triangles.
  static double bytes_for(const Scene& scene, const PictureSet& set);

  // The scene and the pictures must outlive the surface. A scene without polygons is refused.
  static Result<TexturedSurface> create(const Scene& scene, const PictureSet& set, Blend blend,
                                        int neighbours = 4);

  // The same surface with another blend, and optionally without one of its pictures. What each
  // picture sees is not computed again.
  TexturedSurface with_blend(Blend blend, int neighbours = 4,
                             std::optional<std::size_t> left_out = {}) const;

  const VisiblePolygons& visible_polygons() const { return surface_->visible_polygons; }
  const ViewBlend& blend() const { return blend_; }
  // The point from which the directions to the views are measured.
  const Vector3d& middle() const { return surface_->middle; }
  const std::vector<WorldTriangle>& triangles() const { return surface_->triangles; }

  // Seen from a picture's own camera, the result equals that picture byte for byte in all pixels of
  // the object that show a polygon. Only one thread may draw at a time, counting all surfaces that
  // with_blend() made from this one.
  Result<TexturedPicture> draw(const PinholeCamera& camera, int width, int height,
                               Rgba8 background) const;

  // The colour that the views around a direction show at a place on a polygon, in levels. Views
  // that do not see the polygon have no weight (S1-40). If something hides the place itself from a
  // view that sees the polygon, the weights are computed again without that view. None where no
  // view sees the place.
  class ColorsFromDirection {
  public:
    ColorsFromDirection(const TexturedSurface& surface, const Vector3d& direction);
    std::optional<Vector3d> color_of(const WorldTriangle& polygon, const Vector3d& world);

  private:
    std::optional<Vector3d> sample(std::size_t view, const WorldTriangle& polygon,
                                   const Vector3d& world) const;

    const TexturedSurface& surface_;
    ViewBlend::FromDirection from_;
    std::optional<std::uint32_t> last_;  // the polygon for which weights_ was computed
    ViewWeights weights_;
  };

private:
  // The data that all surfaces made by with_blend() share.
  struct Surface {
    const Scene& scene;
    const PictureSet& set;
    std::unique_ptr<UnlitRenderer> renderer;  // has prepared the scene, for all pictures of it
    VisiblePolygons visible_polygons;
    std::vector<WorldTriangle> triangles;
    Vector3d middle;
  };

  TexturedSurface(std::shared_ptr<const Surface> surface, Blend blend, int neighbours,
                  std::optional<std::size_t> left_out);

  std::shared_ptr<const Surface> surface_;
  std::vector<std::size_t> pictures_;  // for each view that is blended, the number of its picture
  ViewBlend blend_;
};

// The differences between a drawn picture and the real one, which the surface was drawn without.
struct TextureErrors {
  double rms = 0;   // levels, over the object's pixels that show a polygon; NaN if none does
  double psnr = 0;  // dB, relative to 255; infinite if nothing differs, NaN if no pixel is covered
  double covered = 0;       // fraction of the object's pixels that show a polygon
  std::int64_t pixels = 0;  // the object's pixels
};
TextureErrors textured_picture_errors(const TexturedPicture& drawn,
                                      const CalibratedPicture& picture);

}  // namespace glassbox::views
