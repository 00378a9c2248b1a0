// Ground truth: two pictures of a scene from the rasterizer, for which it is known where each point
// of one is in the other (S2-03).
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

// The view must be perspective.
Result<KnownPicture> known_picture(const Scene& scene, const View& view,
                                   const RenderSettings& settings);

struct TrueMatch {
  float x = 0,
        y = 0;  // px in the other picture; NaN: nothing drawn, or behind the other camera
  OtherEyeVisibility visibility = OtherEyeVisibility::kNothingDrawn;
};

// For each pixel, where the other picture has the point at its centre, and whether it is visible
// there: its distance is compared with those of the other picture's pixel and the pixels around it.
// Half a pixel of parallax in either direction counts as the same, as in render/stereo/monocular.h.
Image<TrueMatch> true_matches(const KnownPicture& own, const KnownPicture& other);

// Random pixels of the left picture whose point the right one shows. Each coordinate of both points
// gets Gaussian noise of `noise` pixels, and a share `outliers` of the matches gets a right point
// anywhere in the picture.
struct MatchSampling {
  int count = 500;  // at most; all pixels are different
  double noise = 0;
  double outliers = 0;  // [0, 1]
  std::uint64_t seed = 1;
};
struct SampledMatches {
  Matches matches;
  std::vector<bool> is_outlier;
};
SampledMatches sample_matches(const Image<TrueMatch>& truth, const Image<float>& right,
                              const MatchSampling& sampling);

}  // namespace glassbox::views
