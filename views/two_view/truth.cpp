#include "views/two_view/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glassbox/base/elementary.h>
#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/render/renderer.h>

namespace glassbox::views {

namespace {

constexpr double kSame = 0.5;  // px of parallax; a smaller difference is taken for the same surface

// How far apart, in pixels, the other picture can show two points that are in one pixel of this
// picture and have the distances a and b: f B |1/a - 1/b| for the focal length f and the baseline
// B.
double parallax_between(double pixels_per_unit, double a, double b) {
  return pixels_per_unit * std::abs(1 / a - 1 / b);
}

OtherEyeVisibility visibility_in(const KnownPicture& other, const Vector3d& place,
                                 double pixels_per_unit) {
  const auto x = std::int64_t(std::floor(place.x())), y = std::int64_t(std::floor(place.y()));
  if (x < 0 || y < 0 || x >= other.distance.width || y >= other.distance.height) {
    return OtherEyeVisibility::kOutsidePicture;
  }
  const auto distance_at = [&](std::int64_t column, std::int64_t row) {
    return double(other.distance.at(int(column), int(row)));
  };
  const double found = distance_at(x, y);
  if (found < place.z() && parallax_between(pixels_per_unit, found, place.z()) > kSame) {
    return OtherEyeVisibility::kHidden;
  }
  for (auto row = std::max<std::int64_t>(y - 1, 0);
       row <= std::min<std::int64_t>(y + 1, other.distance.height - 1); ++row) {
    for (auto column = std::max<std::int64_t>(x - 1, 0);
         column <= std::min<std::int64_t>(x + 1, other.distance.width - 1); ++column) {
      if (parallax_between(pixels_per_unit, distance_at(column, row), place.z()) <= kSame) {
        return OtherEyeVisibility::kVisible;
      }
    }
  }
  return OtherEyeVisibility::kMissing;
}

TrueMatch match_of(const KnownPicture& own, const KnownPicture& other, int x, int y,
                   double pixels_per_unit) {
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  const double distance = double(own.distance.at(x, y));
  if (!std::isfinite(distance)) return {kNowhere, kNowhere, OtherEyeVisibility::kNothingDrawn};
  const Vector3d at = distance * ray_through(own.camera.intrinsic, {x + 0.5, y + 0.5});
  const Vector3d world = own.camera.camera_from_world.transpose() * at + own.camera.centre;
  const Vector3d place = project(other.camera, world);
  if (!(place.z() > 0)) return {kNowhere, kNowhere, OtherEyeVisibility::kOutsidePicture};
  return {float(place.x()), float(place.y()), visibility_in(other, place, pixels_per_unit)};
}

// Two normally distributed numbers, by the method of Box and Muller.
Vector2d gaussian(Random& random, double sigma) {
  const double radius = sigma * std::sqrt(-2 * logarithm_1p(-random.unit()));
  const double angle = 2 * std::numbers::pi * random.unit();
  const auto [sine, cosine] = sin_cos(angle);
  return {radius * cosine, radius * sine};
}

}  // namespace

Result<KnownPicture> known_picture(const Scene& scene, const View& view,
                                   const RenderSettings& settings) {
  auto camera = camera_of(view);
  if (!camera) return tl::unexpected(camera.error());
  RenderSettings with_distance = settings;
  with_distance.want_distance = true;
  Renderer renderer(scene, settings.transfer);
  Framebuffer drawn = std::move(renderer.render(view, with_distance).buffers);
  return KnownPicture{*camera, std::move(drawn.color), std::move(drawn.distance)};
}

Image<TrueMatch> true_matches(const KnownPicture& own, const KnownPicture& other) {
  const double baseline = (other.camera.centre - own.camera.centre).norm();
  const double pixels_per_unit =
      baseline * std::max(other.camera.intrinsic(0, 0), other.camera.intrinsic(1, 1));
  Image<TrueMatch> matches(own.distance.width, own.distance.height);
  for (int y = 0; y < matches.height; ++y) {
    for (int x = 0; x < matches.width; ++x) {
      matches.at(x, y) = match_of(own, other, x, y, pixels_per_unit);
    }
  }
  return matches;
}

SampledMatches sample_matches(const Image<TrueMatch>& truth, const Image<float>& right,
                              const MatchSampling& sampling) {
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    if (truth.pixels[i].visibility == OtherEyeVisibility::kVisible) seen.push_back(i);
  }
  Random random(sampling.seed);
  const std::size_t count = std::min(seen.size(), std::size_t(sampling.count));
  SampledMatches sampled;
  for (std::size_t i = 0; i < count; ++i) {
    // The first `count` numbers of a shuffled list (Fisher and Yates): each is drawn from those
    // that are left.
    std::swap(seen[i], seen[i + std::size_t(random.integer(0, std::int64_t(seen.size() - i) - 1))]);
    const TrueMatch& match = truth.pixels[seen[i]];
    const auto width = std::size_t(truth.width);
    const Vector2d left(double(seen[i] % width) + 0.5, double(seen[i] / width) + 0.5);
    const bool is_outlier = random.unit() < sampling.outliers;
    const Vector2d anywhere{random.unit() * right.width, random.unit() * right.height};
    const Vector2d place = is_outlier ? anywhere : Vector2d(match.x, match.y);
    sampled.matches.push_back(
        {left + gaussian(random, sampling.noise), place + gaussian(random, sampling.noise)});
    sampled.is_outlier.push_back(is_outlier);
  }
  return sampled;
}

}  // namespace glassbox::views
