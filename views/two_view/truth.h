// The right answers: two pictures of a scene from the rasterizer, of which every point's place in the other is known (S2-03).
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
  Image<float>
      distance;  // of what a pixel's centre shows, along the gaze; infinite where nothing was drawn
};

// Of a perspective view.
Result<KnownPicture> known_picture(const Scene& scene, const View& view,
                                   const RenderSettings& settings);

struct TrueMatch {
  float
      x = 0,
      y = 0;  // in the other picture, px; NaN where nothing was drawn, or what is there lies behind the other camera
  OtherEye fate = OtherEye::kNothingDrawn;
};

// Where the other picture has what each pixel's centre shows, and whether it shows it: the other's pixel there, and those around it,
// are asked for their distance. Half a pixel of parallax either way counts as the same, as in render/stereo/monocular.h.
Image<TrueMatch> true_matches(const KnownPicture& own, const KnownPicture& other);

// Pixels of the left picture whose point the right one sees, drawn at random; each coordinate of both points with Gaussian noise
// of `noise` pixels, and a share of `outliers` of them with a right point anywhere in the picture.
struct MatchSampling {
  int count = 500;  // at most, of different pixels
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
