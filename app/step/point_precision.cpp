// How well the places of points are known, in words: the rounding errors in float, and the digits
// of the printed matrices.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/step/point_texts.h"

#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

using Walk = PointStep::Walk;

// A place is worth nothing if it is known to half a pixel only, or if the depth stands for
// distances that differ by a twentieth.
constexpr double kTooFarPx = 0.5, kTooDeep = 1.0 / 20;

double rounding_px(const Walk& walk) {
  return std::max(walk.chain.screen->bound.x, walk.chain.screen->bound.y);
}

bool is_certain(const VertexChain& chain) {
  return std::all_of(chain.planes.begin(), chain.planes.end(),
                     [](const PlaneStep& at) { return at.is_certain(); });
}

bool is_placed(const Walk& walk) {
  return walk.chain.verdict == VertexVerdict::kVisible ||
         walk.chain.verdict == VertexVerdict::kOutside;
}

}  // namespace

double uncertainty_px(const Walk& walk) {
  return is_placed(walk) ? rounding_px(walk) + walk.digits_uncertainty_px : 0;
}

// The depth is alpha + beta/d at the distance d = w, so an error of the depth becomes an error of d
// that is d^2/|beta| times as large (SPEC C, bound 8).
std::optional<KnownDistance> known_distance(const Walk& walk, const PointStep& step) {
  const ProjectionFacts& p = step.lens;
  if (p.kind != ProjectionKind::kPerspective || p.depth_lost || p.w_offset != 0) return {};
  const double w = double(walk.chain.clip.w) / p.w_scale;
  return KnownDistance{w, walk.chain.screen->bound.z * w * w / std::abs(p.beta)};
}

std::string imprecision_text(const Walk& walk, const PointStep& step) {
  if (!is_placed(walk)) return {};
  const double px = uncertainty_px(walk);
  if (px > kTooFarPx) {
    return fmt::format(
        "the place in the window is known to +- {} px only{}", short_number(px, 3),
        is_certain(walk.chain) ? "" : ", so it is not certain whether the point is in the picture");
  }
  const auto depth = known_distance(walk, step);
  if (!depth || !(depth->uncertainty > kTooDeep * depth->distance)) return {};
  return fmt::format(
      "the depth is known to +- {} of distance only, and the point is {} in front of the eye: the "
      "depth test cannot order it",
      short_number(depth->uncertainty, 2), short_number(depth->distance, 3));
}

std::string imprecision_remedy(const Walk& walk) {
  if (uncertainty_px(walk) <= kTooFarPx) {
    return "move the near plane away from the eye: the error is inversely proportional to it";
  }
  if (rounding_px(walk) <= kTooFarPx) {
    return "print the matrices with more digits (%.9g prints a float without loss)";
  }
  const glm::dvec3 world = glm::abs(glm::dvec3(walk.chain.to_world.after));
  const double size = std::max({world.x, world.y, world.z});
  return fmt::format(
      "coordinates of {} leave steps of {} in float: subtract the eye's position from the model's "
      "in double, before the matrices become float",
      short_number(size, 2), short_number(size * 0x1p-23, 2));
}

}  // namespace glassbox::app
