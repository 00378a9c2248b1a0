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

// A hit takes 24 bytes of memory until all rays are cast, which is 1.5 GB if each of this many rays
// has one.
inline constexpr std::uint64_t kMaxRays = std::uint64_t(1) << 26;

// A ray is given by four numbers in [0, 1]: two for its start on the front face of a cube around
// the eye, and two for its direction. Equal volumes in the space of these numbers correspond to
// equal fractions of the light that a matte face would receive. The range of each number is divided
// into `strata` parts, and each of the strata^4 boxes (one stratum) gets `rays` random rays.
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

// The four random numbers of a ray of one stratum. `random` was made for the stratum by
// stratum_random(), so that the numbers depend on nothing else.
std::array<double, 4> stratified_numbers(const std::array<int, 4>& stratum, int strata,
                                         Random& random);
Random stratum_random(const std::array<int, 4>& stratum, int strata);

// The rays that one thread casts as one task: all rays of `strata` consecutive strata, or some rays
// of one stratum.
struct RayPart {
  std::uint64_t stratum = 0, strata = 1;
  int rays = 1;   // in each stratum
  Random random;  // the random generator of the first stratum, at the first ray of this part
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
  // Rays of which a part is inside the view frustum. Other rays are not cast, and hits beyond the
  // part that is inside are not searched for.
  std::uint64_t followed = 0;
  std::uint64_t hits = 0;  // hits that the picture shows
};

// Samples of a pixel whose depths differ by at most epsilon times the depth of the nearest one are
// merged: the one nearest to the pixel's centre stays. The view must be a perspective one.
LayeredImage build_layers_by_rays(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const RaySampling& sampling,
                                  double epsilon, RayCounts& counts,
                                  const WantedAttributes& wanted = {});

// A value for epsilon when hits of rays are merged. The hits of a pixel are anywhere in it, unlike
// peeled samples, which are at its centre. On a surface whose normal is at 75 degrees to the
// direction of view, their distances differ by up to 3.7 (tan 75) times a pixel's width. In a
// picture of 300 pixels that shows a scene as wide as it is far, that width is 1/300 of the
// distance, and 3.7/300 is below 1/64.
inline constexpr double kMergedHits = 0x1p-6;

}  // namespace glassbox::views
