// Ground truth: two pictures of a scene from the rasterizer. For each point of one picture it is
// known where it is in the other picture (S2-03).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/stereo/monocular.h>

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

namespace glassbox::views {

struct KnownPicture {
  PinholeCamera camera;
  Image<Rgba8> color;
  // How far the surface at a pixel's centre is, along the direction of view; infinite where nothing
  // was drawn.
  Image<float> distance;
};

// Draws the picture of a view, which must be perspective.
Result<KnownPicture> known_picture(const Scene& scene, const View& view,
                                   const RenderSettings& settings);

struct TrueMatch {
  // px in the other picture; NaN: nothing was drawn, or the point is behind the other camera.
  float x = 0, y = 0;
  OtherEyeVisibility visibility = OtherEyeVisibility::kNothingDrawn;
};

// For each pixel: where the other picture has the point at this pixel's centre, and whether it is
// visible there. The point's distance is compared with those of the other picture's pixel and of
// the pixels around it. A difference of up to half a pixel of parallax in either direction is taken
// for the same surface, as in render/stereo/monocular.h.
Image<TrueMatch> true_matches(const KnownPicture& own, const KnownPicture& other);

// Random pixels of the left picture whose point the right picture shows. Each coordinate of both
// points gets Gaussian noise of `noise` pixels, and a fraction `outliers` of the matches gets a
// right point anywhere in the picture.
struct MatchSampling {
  int count = 500;  // at most; all pixels are different
  double noise = 0;
  double outliers = 0;  // fraction of the matches, 0 .. 1
  std::uint64_t seed = 1;
};
struct SampledMatches {
  Matches matches;
  std::vector<bool> is_outlier;
};
SampledMatches sample_matches(const Image<TrueMatch>& truth, const Image<float>& right,
                              const MatchSampling& sampling);

}  // namespace glassbox::views
