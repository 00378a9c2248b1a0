#include "views/matching/rendered_pair.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "views/matching/color_planes.h"
#include "views/matching/winner.h"
#include "views/two_view/truth.h"

namespace glassbox::views {

namespace {

constexpr int kContrastAcross = 4, kContrastDown = 3;  // px from the window's centre to its edge
constexpr float kWithinSurface = 1;                    // px of disparity
constexpr int kContrast = 8;                           // codes of grey

// The greatest difference of grey between two pixels in the same row of the window that belong to
// the centre's surface.
int contrast_at(const ColorPlanes& planes, const Image<float>& disparity, int x, int y) {
  int contrast = 0;
  for (int row = std::max(y - kContrastDown, 0);
       row <= std::min(y + kContrastDown, planes.height - 1); ++row) {
    int least = 255, greatest = 0;
    for (int column = std::max(x - kContrastAcross, 0);
         column <= std::min(x + kContrastAcross, planes.width - 1); ++column) {
      if (!(std::abs(disparity.at(column, row) - disparity.at(x, y)) <= kWithinSurface)) continue;
      const int grey = planes.grey[disparity.index(column, row)];
      least = std::min(least, grey);
      greatest = std::max(greatest, grey);
    }
    contrast = std::max(contrast, greatest - least);
  }
  return contrast;
}

StereoTruth truth_of(const KnownPicture& left, const KnownPicture& right) {
  const Image<TrueMatch> matches = true_matches(left, right);
  StereoTruth truth{{matches.width, matches.height, kNoDisparity},
                    {matches.width, matches.height, 0}};
  for (int y = 0; y < matches.height; ++y) {
    for (int x = 0; x < matches.width; ++x) {
      const TrueMatch& match = matches.at(x, y);
      if (!std::isfinite(match.x)) continue;
      truth.disparity.at(x, y) = float(x + 0.5 - double(match.x));
      truth.is_visible.at(x, y) = match.visibility == OtherEyeVisibility::kVisible;
    }
  }
  return truth;
}

}  // namespace

Image<std::uint8_t> has_texture(const Image<Rgba8>& picture, const Image<float>& disparity) {
  const ColorPlanes planes = color_planes(picture);
  Image<std::uint8_t> textured(picture.width, picture.height, 0);
  tbb::parallel_for(0, picture.height, [&](int y) {
    for (int x = 0; x < picture.width; ++x) {
      textured.at(x, y) = contrast_at(planes, disparity, x, y) >= kContrast;
    }
  });
  return textured;
}

Result<RenderedPair> rendered_pair(const Scene& scene, const View& centre, const StereoPair& eyes,
                                   const RenderSettings& settings) {
  auto left = known_picture(scene, eye_view(centre, eyes, Side::kLeft), settings);
  if (!left) return tl::unexpected(left.error());
  auto right = known_picture(scene, eye_view(centre, eyes, Side::kRight), settings);
  if (!right) return tl::unexpected(right.error());
  RenderedPair pair;
  pair.truth = truth_of(*left, *right);
  const double focal = left->camera.intrinsic(0, 0), baseline = 2 * eyes.half_separation;
  const auto& intrinsic = left->camera.intrinsic;
  pair.calibration = {focal, baseline, focal * baseline / eyes.window,
                      Principal{intrinsic(0, 2), intrinsic(1, 2)}};
  pair.is_textured = has_texture(left->color, pair.truth.disparity);
  pair.left = std::move(left->color);
  pair.right = std::move(right->color);
  return pair;
}

}  // namespace glassbox::views
