#include <glassbox/matrices/projection_facts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glassbox/base/trig.h>
#include <glassbox/matrices/decimal.h>

namespace glassbox {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- depth ----

struct Plane {
  double distance = 0, uncertainty = 0;
};

// The distance at which the depth is `z`; infinity if the uncertainty allows that.
Plane plane_of_depth(const ProjectionFacts& p, double z) {
  if (p.kind == ProjectionKind::kParallel) {
    const double distance = (z - p.beta) / p.alpha;
    return {distance,
            (p.beta_uncertainty + std::abs(distance) * p.alpha_uncertainty) / std::abs(p.alpha)};
  }
  const double slope = z - p.alpha;
  if (std::abs(slope) <= p.alpha_uncertainty) return {kInfinity, 0};
  const double distance = p.beta / slope;
  return {distance, std::abs(distance) * (p.beta_uncertainty / std::abs(p.beta) +
                                          p.alpha_uncertainty / std::abs(slope))};
}

DepthReading reading(const ProjectionFacts& p, bool from_minus_one) {
  DepthReading r;
  r.from_minus_one = from_minus_one;
  if (p.depth_lost) return r;
  r.reversed = p.depth_reversed();
  Plane near = plane_of_depth(p, from_minus_one ? -1 : 0), far = plane_of_depth(p, 1);
  if (r.reversed) std::swap(near, far);
  r.possible =
      p.kind == ProjectionKind::kParallel || (near.distance > 0 && near.distance < far.distance);
  if (!r.possible && r.reversed) {
    // One of the planes is behind the eye; that is why depth falls with distance. Depth is not
    // reversed, so the planes are exchanged back.
    std::swap(near, far);
    r.reversed = false;
  }
  r.near = near.distance, r.near_uncertainty = near.uncertainty;
  r.far = far.distance, r.far_uncertainty = far.uncertainty;
  r.digits = simplest_decimal(r.near, r.near_uncertainty).digits +
             simplest_decimal(r.far, r.far_uncertainty).digits;
  return r;
}

void read_depth(ProjectionFacts& p) {
  p.depth_lost = p.kind == ProjectionKind::kPerspective ? std::abs(p.beta) <= p.beta_uncertainty
                                                        : std::abs(p.alpha) <= p.alpha_uncertainty;
  p.zero_to_one = reading(p, false);
  p.minus_one_to_one = reading(p, true);
}

// ---- the angle of view ----

// The angle as a whole number of degrees, if there is one within the uncertainty.
std::optional<int> whole_degrees(double degrees, double uncertainty) {
  const Decimal number = simplest_decimal(degrees, uncertainty);
  const bool is_whole = number.digits <= 3 && number.value == std::floor(number.value);
  if (!is_whole || !(number.value > 0 && number.value < 180)) return std::nullopt;
  return int(number.value);
}

// The angle of view for a given scale, which is cot(angle/2).
struct Angle {
  double degrees = 0, uncertainty = 0;

  Angle(double scale, double scale_uncertainty)
      : degrees(degrees_from_radians(2 * arctan2(1, scale))),
        uncertainty(
            degrees_from_radians(2 * (scale_uncertainty + 0x1p-22 * scale) / (1 + scale * scale))) {
  }
  std::optional<int> whole() const { return whole_degrees(degrees, uncertainty); }
};

// Finds the whole number D for which the scale is cot(D/2) of D radians: an angle of D degrees was
// passed as radians. The search starts at 4, because 1, 2 and 3 are plausible angles in radians.
// The tolerance 2^-21 allows for a few roundings to float.
std::optional<int> degrees_taken_as_radians(double scale, double uncertainty) {
  for (int degrees = 4; degrees < 180; ++degrees) {
    const SinCos half = sin_cos(degrees * 0.5);
    const double cotangent = half.cos / half.sin;
    if (std::abs(cotangent - scale) <= uncertainty + 0x1p-21 * std::abs(cotangent)) return degrees;
  }
  return std::nullopt;
}

// Finds the whole angle of view for which the window would be half as large. Returns nothing if the
// scale has few digits: then it was probably typed, not computed from an angle.
std::optional<int> degrees_of_half_window(const glm::dvec2& scale, const glm::dvec2& uncertainty) {
  constexpr int kTyped = 3;
  for (const int axis : {1, 0}) {
    const double size = std::abs(scale[axis]), open = uncertainty[axis];
    if (Angle(size, open).whole() || simplest_decimal(size, open).digits <= kTyped) {
      return std::nullopt;
    }
  }
  const auto of = [&](int axis) {
    return Angle(2 * std::abs(scale[axis]), 2 * uncertainty[axis]).whole();
  };
  const std::optional<int> up = of(1);
  return up ? up : of(0);
}

void read_angle(ProjectionFacts& p, const glm::dvec2& uncertainty) {
  const Angle angle(std::abs(p.scale.y), uncertainty.y);
  p.fovy_degrees = angle.degrees;
  p.fovy_uncertainty = angle.uncertainty;
  if (simplest_decimal(angle.degrees, angle.uncertainty).digits <= 3 && p.scale.y > 0) {
    return;  // a round angle is probably what was meant
  }
  p.degrees_taken_as_radians = degrees_taken_as_radians(p.scale.y, uncertainty.y);
  p.radians_taken_as_degrees =
      whole_degrees(degrees_from_radians(angle.degrees), degrees_from_radians(angle.uncertainty));
  if (!p.degrees_taken_as_radians && !p.radians_taken_as_degrees) {
    p.degrees_of_half_window = degrees_of_half_window(p.scale, uncertainty);
  }
}

// ---- the rows ----

// The matrix is perspective or parallel if its first two rows scale and move x and y separately,
// and w is a multiple of z (perspective) or constant (parallel).
ProjectionKind kind_of(const glm::dmat4& m) {
  for (int row : {0, 1}) {
    const int other = 1 - row;
    if (entry_at(m, row, row) == 0 || !is_small(m, row, other)) return ProjectionKind::kNone;
  }
  if (!is_small(m, 3, 0) || !is_small(m, 3, 1)) return ProjectionKind::kNone;
  if (!is_small(m, 3, 2)) {
    const bool shifted = !is_small(m, 0, 3) || !is_small(m, 1, 3);
    return shifted && !is_small(m, 3, 3) ? ProjectionKind::kNone : ProjectionKind::kPerspective;
  }
  if (entry_at(m, 3, 3) == 0 || !is_small(m, 0, 2) || !is_small(m, 1, 2))
    return ProjectionKind::kNone;
  return ProjectionKind::kParallel;
}

}  // namespace

std::string planes_text(const DepthReading& r) {
  return "near " + rounded_text(r.near, r.near_uncertainty) + " and far " +
         rounded_text(r.far, r.far_uncertainty);
}

int ProjectionFacts::fewest_digits() const {
  constexpr int kMany = 99;
  const auto digits = [](const DepthReading& r) { return r.possible ? r.digits : kMany; };
  return std::min(digits(zero_to_one), digits(minus_one_to_one));
}

const DepthReading* ProjectionFacts::round_planes(DepthRange expected) const& {
  constexpr int kRound = 5;  // the most digits of round planes, such as "0.25 and 150"
  if (kind != ProjectionKind::kPerspective) return nullptr;
  const DepthReading* best = nullptr;
  for (const DepthReading* r : {&zero_to_one, &minus_one_to_one}) {
    const bool fits = r->possible && r->reversed == (expected == DepthRange::kReversed);
    if (fits && r->digits <= kRound && (best == nullptr || r->digits < best->digits)) best = r;
  }
  return best;
}

const DepthReading* ProjectionFacts::likely_range(int digits) const& {
  const DepthReading &a = zero_to_one, &b = minus_one_to_one;
  if (a.possible != b.possible) return a.possible ? &a : &b;
  if (!a.possible || std::abs(a.digits - b.digits) < digits) return nullptr;
  return a.digits < b.digits ? &a : &b;
}

ProjectionFacts projection_facts(const GivenMatrix& matrix, DepthRange expected) {
  ProjectionFacts p;
  if (first_not_finite(matrix.m)) return p;
  p.kind = kind_of(matrix.m);
  if (p.kind == ProjectionKind::kNone) return p;
  const bool perspective = p.kind == ProjectionKind::kPerspective;
  p.w_scale = std::abs(perspective ? entry_at(matrix.m, 3, 2) : entry_at(matrix.m, 3, 3));
  const glm::dmat4 m =
      matrix.m * ((!perspective && entry_at(matrix.m, 3, 3) < 0 ? -1 : 1) / p.w_scale);
  const glm::dmat4 uncertainty = matrix.uncertainty / p.w_scale;
  if (perspective) {
    p.looks_down_minus_z = entry_at(m, 3, 2) < 0;
    p.looks_transposed = p.w_scale != 1 && std::abs(entry_at(matrix.m, 2, 3)) == 1;
    p.w_offset = is_small(m, 3, 3) ? 0 : entry_at(m, 3, 3);
  } else {
    p.looks_down_minus_z = (entry_at(m, 2, 2) < 0) == (expected == DepthRange::kStandard);
  }
  const double along = p.looks_down_minus_z ? -1 : 1;  // z = along * d
  p.scale = {entry_at(m, 0, 0), entry_at(m, 1, 1)};
  p.centre = perspective ? along * glm::dvec2(entry_at(m, 0, 2), entry_at(m, 1, 2))
                         : glm::dvec2(entry_at(m, 0, 3), entry_at(m, 1, 3));
  if (perspective) {
    for (const int row : {0, 1}) p.shift[row] = is_small(m, row, 3) ? 0 : entry_at(m, row, 3);
  }
  p.alpha = along * entry_at(m, 2, 2);
  p.beta = entry_at(m, 2, 3);
  p.alpha_uncertainty = uncertainty[2][2];
  p.beta_uncertainty = uncertainty[3][2];
  p.oblique_depth = !is_small(m, 2, 0) || !is_small(m, 2, 1);
  p.aspect = std::abs(p.scale.y / p.scale.x);
  read_depth(p);
  if (perspective) read_angle(p, {uncertainty[0][0], uncertainty[1][1]});
  return p;
}

}  // namespace glassbox
