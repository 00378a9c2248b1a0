// A surface whose colours are those of pictures of it, from wherever it is looked at (S1-40: Debevec, Taylor and Malik 1996).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "views/rings/picture_set.h"
#include "views/texture/view_blend.h"

namespace glassbox::views {

// Which polygons each picture shows at a pixel's centre, as the engine draws them there.
class SeenPolygons {
public:
  // The set's cameras must be before the scene's box.
  static Result<SeenPolygons> of(const Scene& scene, const PictureSet& set);

  std::size_t polygons() const { return polygons_; }
  bool sees(std::size_t view, std::uint32_t polygon) const {
    const std::size_t i = view * polygons_ + polygon;
    return polygon < polygons_ && (bits_[i / 64] >> (i % 64) & 1) != 0;
  }
  std::int64_t unseen() const;

private:
  SeenPolygons(std::size_t views, std::size_t polygons)
      : views_(views), polygons_(polygons), bits_((views * polygons + 63) / 64, 0) {}

  std::size_t views_, polygons_;
  std::vector<std::uint64_t> bits_;
};

struct TexturedPicture {
  Image<Rgba8> color;
  Image<std::uint32_t> id;   // 1 + the polygon's number; 0: background
  std::int64_t surface = 0;  // pixels that show a polygon
  std::int64_t without_view =
      0;  // of these, those whose polygon no view sees: they have the surface's own colour
};

class TexturedSurface {
public:
  // The scene and the pictures must outlive it. A scene without polygons is refused.
  static Result<TexturedSurface> of(const Scene& scene, const PictureSet& set, Blend blend,
                                    int neighbours = 4);

  const SeenPolygons& seen() const { return seen_; }
  const ViewBlend& blend() const { return blend_; }
  const Vector3d& middle() const {
    return middle_;
  }  // from which views are told by their directions

  // At a picture's own camera it is that picture, byte for byte, in all pixels of the object that show a polygon.
  Result<TexturedPicture> draw(const PinholeCamera& camera, int width, int height,
                               Rgba8 background) const;

  // What a place on a polygon has in a picture: from the four pixels around it, without those that are background; none where it is
  // beside the picture or all are. Levels.
  static std::optional<Vector3d> sample(const CalibratedPicture& picture, const Vector3d& world);

private:
  TexturedSurface(const Scene& scene, const PictureSet& set, SeenPolygons seen, ViewBlend blend,
                  const Vector3d& middle)
      : scene_(scene),
        set_(set),
        seen_(std::move(seen)),
        blend_(std::move(blend)),
        middle_(middle) {}

  const Scene& scene_;
  const PictureSet& set_;
  SeenPolygons seen_;
  ViewBlend blend_;
  Vector3d middle_;
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
