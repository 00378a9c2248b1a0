// What a projection matrix does, read from its entries.
//
// With d the distance along the gaze, a perspective matrix gives w = k d and z = k (alpha d + beta), so depth is
// alpha + beta/d; a parallel one gives w = k and depth alpha d + beta. Two numbers, from which near, far and the range of
// depth are to be had: they are not determined. Every matrix with depth -1 .. 1 between n and f is one with depth 0 .. 1
// between some other n' and f. Both readings are given, and how many digits their planes take: people choose round ones.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/projection.h>

#include "app/step/matrices/matrix_facts.h"

namespace glassbox {

// Near and far plane, if the visible depths were -1 .. 1, or 0 .. 1.
struct DepthReading {
  bool from_minus_one = false;
  bool possible = false;     // both planes exist, and for perspective lie in front of the eye
  bool reversed = false;     // the far plane has the smaller depth
  double near = 0, far = 0;  // distances along the gaze; far may be infinite
  double near_uncertainty = 0, far_uncertainty = 0;  // as the digits of the entries leave them
  int digits = 0;                                    // of the two together, simplified
};

// "near 0.1 and far 100", as round as the digits of the entries leave them.
std::string planes_text(const DepthReading& reading);

enum class ProjectionKind { kNone, kPerspective, kParallel };

struct ProjectionFacts {
  ProjectionKind kind = ProjectionKind::kNone;
  // Perspective: w grows along -z (the eye is right-handed) or along +z. A parallel matrix does not tell; this is what follows
  // from the depth range that was expected.
  bool looks_down_minus_z = true;
  double w_scale = 1;   // k above
  double w_offset = 0;  // w = k (d + w_offset): 0 for a projection that begins at the eye
  // x_ndc = (scale x + shift)/d + centre (perspective) or scale x + centre (parallel): the gaze meets the picture at `centre`,
  // which is 0 for a symmetric frustum, and a shift is that of one eye of a stereo pair.
  glm::dvec2 scale{1}, shift{0}, centre{0};
  double alpha = 0, beta = 0;  // depth, see above
  double alpha_uncertainty = 0, beta_uncertainty = 0;
  bool depth_lost = false;  // the same depth at all distances: rank 3 (E15)
  // Perspective: w is made with an odd factor and the z row ends in 1 or -1, which belongs into the last row.
  bool looks_transposed = false;
  bool oblique_depth = false;  // depth depends on x and y, as with a near plane tilted on purpose
  DepthReading zero_to_one, minus_one_to_one;

  // Perspective: the full vertical angle, and width/height of the window. Parallel: of the window, in world units.
  double fovy_degrees = 0, fovy_uncertainty = 0;
  double aspect = 1;

  bool off_centre() const { return std::abs(centre.x) > kSmall || std::abs(centre.y) > kSmall; }
  // Depth falls from near to far. For parallel matrices it is what was expected.
  bool depth_reversed() const {
    return kind == ProjectionKind::kPerspective ? beta > 0 : alpha < 0;
  }
  // Where the shift and the skewed frustum cancel: the distance without parallax, negative behind the eye (S0.21, E2).
  std::optional<double> without_parallax() const {
    if (shift.x == 0 || centre.x == 0) return std::nullopt;
    return -shift.x / centre.x;
  }
  // How many digits the planes take in the rounder reading that is possible; many where none is.
  int fewest_digits() const;
  // Perspective: the planes in the order that the dialect wants, where they are round ones; nullptr otherwise.
  const DepthReading* round_planes(DepthRange expected) const&;
  // The reading with the rounder planes, if it is rounder by so many digits, or the only possible one.
  const DepthReading* likely_range(int digits = 3) const&;
  // Both point into these facts.
  const DepthReading* round_planes(DepthRange expected) const&& = delete;
  const DepthReading* likely_range(int digits = 3) const&& = delete;

  // The whole angle of view that was meant, where the angle in the entries is what its number of degrees makes as radians,
  // or its number of radians as degrees. Whole degrees only, from 4 on.
  std::optional<int> degrees_taken_as_radians, radians_taken_as_degrees;
  // The whole angle of view that was meant, where the window is twice as large as that angle makes it (E13), across or up and down.
  std::optional<int> degrees_of_half_window;
};

// ProjectionKind::kNone unless x and y are scaled and moved separately, and w is a multiple of d, perhaps with an offset, or
// constant.
ProjectionFacts projection_facts(const GivenMatrix& matrix,
                                 DepthRange expected = DepthRange::kStandard);

}  // namespace glassbox
