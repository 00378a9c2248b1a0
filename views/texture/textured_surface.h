// A surface whose colours are those of pictures of it, from wherever it is looked at (S1-40: Debevec, Taylor and Malik 1996).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/rings/picture_set.h"
#include "views/texture/seen_polygons.h"
#include "views/texture/view_blend.h"

namespace glassbox::views {

struct TexturedPicture {
  Image<Rgba8> color;
  Image<std::uint32_t> id;   // 1 + the polygon's number; 0: background
  std::int64_t surface = 0;  // pixels that show a polygon
  std::int64_t without_view =
      0;  // of these, those that no view sees: they have the surface's own colour
};

class TexturedSurface {
public:
  // What it takes with the scene: beside what each picture sees the triangles, and those as they are placed.
  static double bytes_for(const Scene& scene, const PictureSet& set);

  // The scene and the pictures must outlive it. A scene without polygons is refused.
  static Result<TexturedSurface> of(const Scene& scene, const PictureSet& set, Blend blend,
                                    int neighbours = 4);

  // The same surface blended in another way, and without one of its pictures; what each sees is not asked again.
  TexturedSurface blended_by(Blend blend, int neighbours = 4,
                             std::optional<std::size_t> left_out = {}) const;

  const SeenPolygons& seen() const { return surface_->seen; }
  const ViewBlend& blend() const { return blend_; }
  // From which views are told by their directions.
  const Vector3d& middle() const { return surface_->middle; }
  const std::vector<PlacedTriangle>& triangles() const { return surface_->triangles; }

  // At a picture's own camera it is that picture, byte for byte, in all pixels of the object that show a polygon. One thread at a time draws,
  // of all surfaces that were made of this one.
  Result<TexturedPicture> draw(const PinholeCamera& camera, int width, int height,
                               Rgba8 background) const;

  // What the views around a direction show of a place on a polygon. Those that do not see the polygon have no weight (S1-40); if
  // something hides the place itself from one of the rest, the weights are those without it. None where no view sees it. Levels.
  class From {
  public:
    From(const TexturedSurface& surface, const Vector3d& direction);
    std::optional<Vector3d> color_of(const PlacedTriangle& polygon, const Vector3d& world);

  private:
    std::optional<Vector3d> sample(std::size_t view, const PlacedTriangle& polygon,
                                   const Vector3d& world) const;

    const TexturedSurface& surface_;
    ViewBlend::From from_;
    std::optional<std::uint32_t> last_;  // the polygon whose weights these are
    ViewWeights weights_;
  };

private:
  // What all ways to blend have in common.
  struct Surface {
    const Scene& scene;
    const PictureSet& set;
    std::unique_ptr<UnlitRenderer> renderer;  // which has prepared the scene for all pictures of it
    SeenPolygons seen;
    std::vector<PlacedTriangle> triangles;
    Vector3d middle;
  };

  TexturedSurface(std::shared_ptr<const Surface> surface, Blend blend, int neighbours,
                  std::optional<std::size_t> left_out);

  std::shared_ptr<const Surface> surface_;
  std::vector<std::size_t> pictures_;  // of the blend's views
  ViewBlend blend_;
};

// Against a picture that was left out.
struct TextureErrors {
  double rms = 0;      // levels, over the object's pixels that show a polygon; NaN where none does
  double psnr = 0;     // dB, of 255; infinite where nothing differs, NaN where no pixel is covered
  double covered = 0;  // share of the object's pixels
  std::int64_t pixels = 0;  // the object's
};
TextureErrors compare(const TexturedPicture& drawn, const CalibratedPicture& picture);

}  // namespace glassbox::views
