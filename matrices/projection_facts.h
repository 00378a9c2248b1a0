// Reads what a projection matrix does from its entries.
//
// Let d be the distance along the gaze. A perspective matrix gives w = k d and z = k (alpha d +
// beta), so depth is alpha + beta/d. A parallel matrix gives w = k and depth alpha d + beta. The
// two numbers alpha and beta do not determine near, far and the range of depth: every matrix with
// depth -1 .. 1 between the planes n and f also has depth 0 .. 1 between another plane n' and f.
// Both readings are given, with the number of digits of their planes, because people choose round
// numbers.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <glassbox/matrices/matrix_facts.h>
#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {

// The near and far planes of one reading: visible depths are either -1 .. 1 or 0 .. 1.
struct DepthReading {
  bool from_minus_one = false;
  bool possible = false;     // both planes exist, and for perspective are in front of the eye
  bool reversed = false;     // the far plane has the smaller depth
  double near = 0, far = 0;  // distances along the gaze; far may be infinite
  double near_uncertainty = 0, far_uncertainty = 0;  // from the uncertainty of the entries
  // The digits of the simplest decimals of near and far, added up.
  int digits = 0;
};

// The planes as the simplest decimals within their uncertainty: "near 0.1 and far 100".
std::string planes_text(const DepthReading& reading);

enum class ProjectionKind { kNone, kPerspective, kParallel };

struct ProjectionFacts {
  ProjectionKind kind = ProjectionKind::kNone;
  // For perspective: whether w grows along -z (the eye is right-handed) or along +z. A parallel
  // matrix does not show this; then it follows from the expected depth range.
  bool looks_down_minus_z = true;
  double w_scale = 1;   // the factor k of w = k d
  double w_offset = 0;  // w = k (d + w_offset); 0 if the eye is the centre of projection
  // x_ndc = (scale x + shift)/d + centre (perspective) or scale x + centre (parallel). The gaze
  // meets the picture at `centre`, which is 0 for a symmetric frustum. A shift that is not 0 comes
  // from one eye of a stereo pair.
  glm::dvec2 scale{1}, shift{0}, centre{0};
  double alpha = 0, beta = 0;  // depth is alpha + beta/d or alpha d + beta
  double alpha_uncertainty = 0, beta_uncertainty = 0;
  bool depth_lost = false;  // the depth is the same at all distances: rank 3 (E15)
  // For perspective: whether the factor k of w is not 1 and the z row ends in 1 or -1, an entry
  // that belongs in the last row.
  bool looks_transposed = false;
  // Whether depth depends on x and y, as with a near plane that is tilted on purpose.
  bool oblique_depth = false;
  DepthReading zero_to_one, minus_one_to_one;

  // For perspective: the full vertical angle, and width/height of the window. For parallel: the
  // window's size in world units.
  double fovy_degrees = 0, fovy_uncertainty = 0;
  double aspect = 1;

  bool off_centre() const { return std::abs(centre.x) > kSmall || std::abs(centre.y) > kSmall; }
  // Whether depth falls from near to far. For a parallel matrix this follows from the expected
  // depth range.
  bool depth_reversed() const {
    return kind == ProjectionKind::kPerspective ? beta > 0 : alpha < 0;
  }
  // The distance at which there is no parallax, because the shift and the skewed frustum cancel;
  // negative if that is behind the eye (S0.21, E2).
  std::optional<double> without_parallax() const {
    if (shift.x == 0 || centre.x == 0) return std::nullopt;
    return -shift.x / centre.x;
  }
  // The number of digits of the planes in the possible reading with fewer digits; a large number if
  // no reading is possible.
  int fewest_digits() const;
  // For perspective: the reading with round planes in the order that `expected` gives; nullptr if
  // there is none.
  const DepthReading* round_planes(DepthRange expected) const&;
  // The only possible reading, or the one whose planes have fewer digits by at least `digits`;
  // nullptr if there is no such reading.
  const DepthReading* likely_range(int digits = 3) const&;
  // round_planes and likely_range point into these facts, so the facts must not be a temporary.
  const DepthReading* round_planes(DepthRange expected) const&& = delete;
  const DepthReading* likely_range(int digits = 3) const&& = delete;

  // The whole angle of view that was probably meant, if the program took degrees for radians or
  // radians for degrees. Only whole degrees; degrees_taken_as_radians only from 4 on.
  std::optional<int> degrees_taken_as_radians, radians_taken_as_degrees;
  // The whole angle of view that was probably meant, if the window is twice as wide or twice as
  // high as for that angle (E13).
  std::optional<int> degrees_of_half_window;
};

// Reads the facts. The kind is ProjectionKind::kNone unless x and y are scaled and moved
// separately, and w is constant or a multiple of d, perhaps with an offset.
ProjectionFacts projection_facts(const GivenMatrix& matrix,
                                 DepthRange expected = DepthRange::kStandard);

}  // namespace glassbox
