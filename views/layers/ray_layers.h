// Layers from rays that start around the eye instead of in it, so that they find what other eyes
// nearby would see, too (Shade et al. 1998, S1-03).
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

// A hit takes 24 bytes until all rays are cast: 1.5 GB if every ray has one.
inline constexpr std::uint64_t kMostRays = std::uint64_t(1) << 26;

// A ray is given by four numbers in [0, 1]: two for its start on the front face of a cube around
// the eye, and two for its direction. Equal shares of the numbers are equal shares of the light
// that a matte face would receive. Each number is divided into `strata` parts, and each of the
// strata^4 boxes gets `rays` random rays.
struct RaySampling {
  int strata = 32, rays = 16;
  double half_side = 0.1;  // half the side of the cube, in world units
  int threads = 1;         // does not change the result

  std::uint64_t count() const {
    const auto n = std::uint64_t(strata);
    return n * n * n * n * std::uint64_t(rays);
  }
};

// The ray in eye space, towards -z; the density of its direction is the cosine of the angle to -z.
Ray ray_of(const std::array<double, 4>& numbers, double half_side);

// The numbers of a ray of a stratum. `random` was made for the stratum by stratum_random(), so that
// the numbers depend on nothing else.
std::array<double, 4> stratified_numbers(const std::array<int, 4>& stratum, int strata,
                                         Random& random);
Random stratum_random(const std::array<int, 4>& stratum, int strata);

// The rays that one thread casts as one task: all rays of `strata` consecutive strata, or some rays
// of one stratum.
struct RayPart {
  std::uint64_t stratum = 0, strata = 1;
  int rays = 1;   // in each stratum
  Random random;  // the generator of the first stratum, at the first ray of this part
};
std::array<int, 4> stratum_of(std::uint64_t number, int strata);

// Enumerates all parts of a sampling; none has more than kRaysOfPart rays.
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
  int done_ = 0;  // rays of the current stratum that are already in parts
  Random random_;
};

struct RayCounts {
  // Rays of which a part is inside the view frustum. Other rays are not cast, and hits behind that
  // part are not searched for.
  std::uint64_t followed = 0;
  std::uint64_t hits = 0;  // hits that the picture shows
};

// Samples of a pixel whose depths differ by at most epsilon are merged: the one nearest to the
// pixel's centre stays. The view must be a perspective one.
LayeredImage build_layers_by_rays(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const RaySampling& sampling,
                                  double epsilon, RayCounts& counts,
                                  const WantedAttributes& wanted = {});

// The hits of one pixel are anywhere in it, unlike the samples of a peeled pixel. On a surface at
// 75 degrees to the direction of view their distances differ by 3.7 times a pixel's width, and that
// is 1/300 of the distance in a picture of 300 pixels that is as wide as it is far.
inline constexpr double kMergedHits = 0x1p-6;

}  // namespace glassbox::views
