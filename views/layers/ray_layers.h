// Layers made of rays that start around the eye, not in it: what other eyes nearby would see is found as well (Shade et al. 1998, S1-03).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glassbox/base/random.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

#include "views/layers/layer_builder.h"
#include "views/layers/ray_caster.h"

namespace glassbox::views {

// A hit takes 24 bytes until all are there: 1.5 GB if each ray has one.
inline constexpr std::uint64_t kMostRays = std::uint64_t(1) << 26;

// Rays have four numbers in [0, 1]: where on the front face of a cube around the eye they start, and two of their direction, so that
// equal shares of the numbers are equal shares of the light that a matte face would receive. Each number is cut into `strata` parts,
// and each of the strata^4 boxes has `rays` rays at random.
struct RaySampling {
  int strata = 32, rays = 16;
  double half_side = 0.1;  // of the cube, in world units
  int threads = 1;         // which change nothing

  std::uint64_t count() const {
    const auto n = std::uint64_t(strata);
    return n * n * n * n * std::uint64_t(rays);
  }
};

// In eye space: towards -z, with the cosine of the angle to it as density.
Ray ray_of(const std::array<double, 4>& numbers, double half_side);

// The numbers of a ray of a stratum; `random` has been made for the stratum, so that they depend on nothing else.
std::array<double, 4> numbers_in(const std::array<int, 4>& stratum, int strata, Random& random);
Random random_of(const std::array<int, 4>& stratum, int strata);

// What one thread casts at a time: all rays of `strata` neighbouring strata, by their numbers, or some of one stratum's.
struct RayPart {
  std::uint64_t stratum = 0, strata = 1;
  int rays = 1;   // of each
  Random random;  // of the first one, where these rays begin
};
std::array<int, 4> stratum_of(std::uint64_t number, int strata);

// All parts of a sampling, one after the other; none has more than kRaysOfPart rays.
inline constexpr int kRaysOfPart = 1 << 14;
class RayParts {
public:
  explicit RayParts(const RaySampling& sampling);
  std::optional<RayPart> next();

private:
  RayPart whole_strata();
  RayPart some_of_a_stratum();
  Random random_here() const;

  RaySampling sampling_;
  std::uint64_t all_, stratum_ = 0;
  int done_ = 0;  // rays of it
  Random random_;
};

struct RayCounts {
  // Those of which a part lies in what the picture shows; the others, and what is behind that part, are not asked what they meet.
  std::uint64_t followed = 0;
  std::uint64_t hits = 0;  // that the picture shows
};

// Samples of a pixel within epsilon are one: that which lies nearest to the pixel's centre. The view must be one of perspective.
LayeredImage build_layers_by_rays(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const RaySampling& sampling,
                                  double epsilon, RayCounts& counts,
                                  const SampleWishes& wishes = {});

// Unlike a peeled pixel's, the hits of one pixel lie anywhere in it: on a surface at 75 degrees to the gaze their distances differ by 3.7
// of a pixel's widths, which are 1/300 of the distance in a picture of 300 pixels that is as wide as it is far.
inline constexpr double kMergedHits = 0x1p-6;

}  // namespace glassbox::views
