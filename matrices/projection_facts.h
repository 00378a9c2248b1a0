// Reads what a projection matrix does from its entries.
//
// Let d be the distance along the gaze. A perspective matrix gives w = k d and z = k (alpha d +
// beta), so depth is alpha + beta/d. A parallel one gives w = k and depth alpha d + beta. The two
// numbers alpha and beta do not determine near, far and the range of depth: every matrix with depth
// -1 .. 1 between n and f is also one with depth 0 .. 1 between some other n' and f. Both readings
// are given, with the number of digits that their planes have, because people choose round numbers.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <glassbox/matrices/matrix_facts.h>
#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {

// The near and far planes if visible depths are -1 .. 1, or if they are 0 .. 1.
struct DepthReading {
  bool from_minus_one = false;
  bool possible = false;     // both planes exist, and for perspective are in front of the eye
  bool reversed = false;     // the far plane has the smaller depth
  double near = 0, far = 0;  // distances along the gaze; far may be infinite
  double near_uncertainty = 0, far_uncertainty = 0;  // from the uncertainty of the entries
  int digits = 0;                                    // of both as the simplest decimals, together
};

// The planes as the simplest decimals within their uncertainty: "near 0.1 and far 100".
std::string planes_text(const DepthReading& reading);

enum class ProjectionKind { kNone, kPerspective, kParallel };

struct ProjectionFacts {
  ProjectionKind kind = ProjectionKind::kNone;
  // Perspective: whether w grows along -z (the eye is right-handed) or along +z. A parallel matrix
  // does not show it; then this follows from the expected depth range.
  bool looks_down_minus_z = true;
  double w_scale = 1;   // k above
  double w_offset = 0;  // w = k (d + w_offset); 0 if the eye is the centre of projection
  // x_ndc = (scale x + shift)/d + centre (perspective) or scale x + centre (parallel). The gaze
  // meets the picture at `centre`, which is 0 for a symmetric frustum. A shift is that of one eye
  // of a stereo pair.
  glm::dvec2 scale{1}, shift{0}, centre{0};
  double alpha = 0, beta = 0;  // depth is alpha + beta/d or alpha d + beta
  double alpha_uncertainty = 0, beta_uncertainty = 0;
  bool depth_lost = false;  // the depth is the same at all distances: rank 3 (E15)
  // Perspective: the factor k of w is not 1, and the z row ends in 1 or -1, which belongs in the
  // last row.
  bool looks_transposed = false;
  // depth depends on x and y, as with a near plane that is tilted on purpose
  bool oblique_depth = false;
  DepthReading zero_to_one, minus_one_to_one;

  // Perspective: the full vertical angle, and width/height of the window. Parallel: the window's
  // size in world units.
  double fovy_degrees = 0, fovy_uncertainty = 0;
  double aspect = 1;

  bool off_centre() const { return std::abs(centre.x) > kSmall || std::abs(centre.y) > kSmall; }
  // Whether depth falls from near to far. For parallel matrices it is the expected direction.
  bool depth_reversed() const {
    return kind == ProjectionKind::kPerspective ? beta > 0 : alpha < 0;
  }
  // The distance without parallax, where the shift and the skewed frustum cancel; negative if it is
  // behind the eye (S0.21, E2).
  std::optional<double> without_parallax() const {
    if (shift.x == 0 || centre.x == 0) return std::nullopt;
    return -shift.x / centre.x;
  }
  // The number of digits of the planes in the rounder possible reading; a large number if none is
  // possible.
  int fewest_digits() const;
  // Perspective: the reading with round planes in the order that `expected` gives; nullptr if there
  // is none.
  const DepthReading* round_planes(DepthRange expected) const&;
  // The only possible reading, or the one whose planes are rounder by at least `digits` digits;
  // else nullptr.
  const DepthReading* likely_range(int digits = 3) const&;
  // The results of both point into these facts, so these must not be a temporary.
  const DepthReading* round_planes(DepthRange expected) const&& = delete;
  const DepthReading* likely_range(int digits = 3) const&& = delete;

  // The whole angle of view that was probably meant, if the angle in the entries is what its number
  // of degrees gives as radians, or its number of radians as degrees. Whole degrees only, from 4
  // on.
  std::optional<int> degrees_taken_as_radians, radians_taken_as_degrees;
  // The whole angle of view that was probably meant, if the window is twice as large as for that
  // angle (E13), horizontally or vertically.
  std::optional<int> degrees_of_half_window;
};

// Reads the facts. The kind is ProjectionKind::kNone unless x and y are scaled and moved
// separately, and w is constant or a multiple of d, perhaps with an offset.
ProjectionFacts projection_facts(const GivenMatrix& matrix,
                                 DepthRange expected = DepthRange::kStandard);

}  // namespace glassbox
