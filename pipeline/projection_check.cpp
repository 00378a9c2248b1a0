#include <glassbox/pipeline/projection_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/decimal.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double at(const glm::dmat4& m, int row, int column) {
  return m[column][row];
}

double largest_in_row(const glm::dmat4& m, int row) {
  double largest = 0;
  for (int column = 0; column < 4; ++column) largest = std::max(largest, std::abs(m[column][row]));
  return largest;
}

bool is_small(const glm::dmat4& m, int row, int column) {
  return std::abs(at(m, row, column)) <= kSmall * largest_in_row(m, row);
}

// ---- depth ----

struct Plane {
  double distance = 0, uncertainty = 0;
};

// Where the depth is `z`. Within what the digits leave open, depth may get there at infinity only.
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
    // Depth falls with distance because one of the planes is behind the eye.
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

bool is_whole(const Decimal& number) {
  return number.digits <= 3 && number.value == std::floor(number.value);
}

// cot(D/2) with D, meant as degrees, taken for radians: 1, 2 and 3 are angles in radians already. Whatever computed it
// rounded a few times to float: 2^-21.
std::optional<int> degrees_taken_as_radians(double scale, double uncertainty) {
  for (int degrees = 4; degrees < 180; ++degrees) {
    const SinCos half = sin_cos(degrees * 0.5);
    const double cotangent = half.cos / half.sin;
    if (std::abs(cotangent - scale) <= uncertainty + 0x1p-21 * std::abs(cotangent)) return degrees;
  }
  return std::nullopt;
}

void read_angle(ProjectionFacts& p, double scale_uncertainty) {
  const double scale = std::abs(p.scale.y);
  p.fovy_degrees = degrees_from_radians(2 * arctan2(1, scale));
  p.fovy_uncertainty =
      degrees_from_radians(2 * (scale_uncertainty + 0x1p-22 * scale) / (1 + scale * scale));
  const Decimal angle = simplest_decimal(p.fovy_degrees, p.fovy_uncertainty);
  if (angle.digits <= 3 && p.scale.y > 0) return;  // a round angle is what was meant
  p.degrees_taken_as_radians = degrees_taken_as_radians(p.scale.y, scale_uncertainty);
  const Decimal meant = simplest_decimal(degrees_from_radians(p.fovy_degrees),
                                         degrees_from_radians(p.fovy_uncertainty));
  if (is_whole(meant) && meant.value < 180) p.radians_taken_as_degrees = int(meant.value);
}

// ---- the rows ----

// x and y each scaled and moved on their own, w a multiple of z or constant.
ProjectionKind kind_of(const glm::dmat4& m) {
  for (int row : {0, 1}) {
    const int other = 1 - row;
    if (at(m, row, row) == 0 || !is_small(m, row, other)) return ProjectionKind::kNone;
  }
  if (!is_small(m, 3, 0) || !is_small(m, 3, 1)) return ProjectionKind::kNone;
  if (!is_small(m, 3, 2)) {
    return is_small(m, 0, 3) && is_small(m, 1, 3) ? ProjectionKind::kPerspective
                                                  : ProjectionKind::kNone;
  }
  if (at(m, 3, 3) == 0 || !is_small(m, 0, 2) || !is_small(m, 1, 2)) return ProjectionKind::kNone;
  return ProjectionKind::kParallel;
}

}  // namespace

const DepthReading* ProjectionFacts::likely_range(int digits) const {
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
  p.w_scale = std::abs(perspective ? at(matrix.m, 3, 2) : at(matrix.m, 3, 3));
  const glm::dmat4 m = matrix.m * ((!perspective && at(matrix.m, 3, 3) < 0 ? -1 : 1) / p.w_scale);
  const glm::dmat4 uncertainty = matrix.uncertainty / p.w_scale;
  if (perspective) {
    p.looks_down_minus_z = at(m, 3, 2) < 0;
    p.looks_transposed = p.w_scale != 1 && std::abs(at(matrix.m, 2, 3)) == 1;
    p.w_offset = is_small(m, 3, 3) ? 0 : at(m, 3, 3);
  } else {
    p.looks_down_minus_z = (at(m, 2, 2) < 0) == (expected == DepthRange::kStandard);
  }
  const double along = p.looks_down_minus_z ? -1 : 1;  // z = along * d
  p.scale = {at(m, 0, 0), at(m, 1, 1)};
  p.centre = perspective ? along * glm::dvec2(at(m, 0, 2), at(m, 1, 2))
                         : glm::dvec2(at(m, 0, 3), at(m, 1, 3));
  p.alpha = along * at(m, 2, 2);
  p.beta = at(m, 2, 3);
  p.alpha_uncertainty = uncertainty[2][2];
  p.beta_uncertainty = uncertainty[3][2];
  p.oblique_depth = !is_small(m, 2, 0) || !is_small(m, 2, 1);
  p.aspect = std::abs(p.scale.y / p.scale.x);
  read_depth(p);
  if (perspective) read_angle(p, uncertainty[1][1]);
  return p;
}

namespace {

// What is left open in the factors of matrix = projection * view, generously: each is made of two rows.
double row_uncertainty(const GivenMatrix& matrix, int row) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    largest = std::max(largest, matrix.uncertainty[column][row]);
  }
  return largest;
}

glm::dmat4 projection_uncertainty(const GivenMatrix& matrix, const glm::dmat4& projection,
                                  double eye_depth, double k) {
  glm::dmat4 u(0);
  for (int row : {0, 1}) u[row][row] = u[2][row] = 2 * row_uncertainty(matrix, row) / k;
  const double alpha = std::abs(projection[2][2]);
  u[2][2] = 2 * (row_uncertainty(matrix, 2) + alpha * row_uncertainty(matrix, 3)) / k;
  u[3][2] = (matrix.uncertainty[3][2] + alpha * matrix.uncertainty[3][3]) / k +
            std::abs(eye_depth) * u[2][2];
  return u;
}

glm::dmat4 view_uncertainty(const GivenMatrix& matrix, const glm::dmat4& projection, double k) {
  glm::dmat4 u(0);
  for (int row = 0; row < 3; ++row) {
    const double size = row < 2 ? projection[row][row] : 1;
    const double centre = row < 2 ? std::abs(projection[2][row]) : 0;
    const int from = row < 2 ? row : 3;
    for (int column = 0; column < 4; ++column) {
      u[column][row] = 2 *
                       (matrix.uncertainty[column][from] + centre * matrix.uncertainty[column][3]) /
                       (k * size);
    }
  }
  return u;
}

}  // namespace

std::optional<ProjectionAndView> factor_projection(const GivenMatrix& matrix) {
  if (first_not_finite(matrix.m)) return std::nullopt;
  const glm::dmat4& m = matrix.m;
  const auto row = [&](int r) {
    return glm::dvec4(at(m, r, 0), at(m, r, 1), at(m, r, 2), at(m, r, 3));
  };
  const auto length = [](const glm::dvec4& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  };
  const auto dot3 = [](const glm::dvec4& a, const glm::dvec4& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  };
  const double gaze_length = length(row(3));
  const bool perspective = gaze_length > kSmall * std::abs(at(m, 3, 3));
  // The view's rows as we go: `back` is that of the eye's z, the others have what belongs to it taken out.
  const double k = perspective ? gaze_length : std::abs(at(m, 3, 3));
  const double depth_length = length(row(2));
  if (!(k > 0) || (!perspective && !(depth_length > 0))) return std::nullopt;
  glm::dvec4 back = perspective ? row(3) * (-1 / k) : row(2) * (-1 / depth_length);
  if (!perspective) back.w = 0;  // a parallel projection does not tell where the eye stands
  glm::dmat4 projection(0), view(1);
  glm::dvec4 axes[2];
  for (int r : {0, 1}) {
    const double centre = perspective ? dot3(row(r), back) / k : 0;
    axes[r] = row(r) / k - centre * back;
    const double size = length(axes[r]);
    if (!(size > 0)) return std::nullopt;
    axes[r] /= size;
    projection[r][r] = size;
    projection[2][r] = centre;
  }
  const glm::dvec4 depth = row(2) / k;
  projection[2][2] = dot3(depth, back);
  projection[3][2] = depth.w - projection[2][2] * back.w;
  if (!(length(depth - projection[2][2] * back) <= kRigidTolerance * length(depth)))
    return std::nullopt;
  projection[2][3] = perspective ? -1 : 0;
  projection[3][3] = perspective ? 0 : 1;
  const glm::dvec3 cross = glm::cross(glm::dvec3(axes[0]), glm::dvec3(axes[1]));
  if (glm::dot(cross, glm::dvec3(back)) < 0) {
    // A left-handed eye, rather than a view that mirrors.
    back = -back;
    projection[2] = -projection[2];
  }
  const glm::dvec4 rows[3] = {axes[0], axes[1], back};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) view[c][r] = rows[r][c];
  }
  const MatrixFacts facts = facts_of(view);
  if (!facts.rigid() || facts.shape == Shape::kIdentity) return std::nullopt;
  return ProjectionAndView{
      {projection, projection_uncertainty(matrix, projection, back.w, k), true},
      {view, view_uncertainty(matrix, projection, k), true}};
}

std::string planes_text(const DepthReading& r) {
  const auto plane = [](double distance, double uncertainty) {
    return brief(simplest_decimal(distance, uncertainty).value);
  };
  return "near " + plane(r.near, r.near_uncertainty) + " and far " +
         plane(r.far, r.far_uncertainty);
}

GivenMatrix projection_part(const GivenMatrix& matrix) {
  const ProjectionFacts facts = projection_facts(matrix);
  if (facts.kind != ProjectionKind::kNone && facts.w_offset == 0) return matrix;
  const auto parts = factor_projection(matrix);
  return parts ? parts->projection : matrix;
}

bool is_view_times_projection(const glm::dmat4& m) {
  if (first_not_finite(m)) return false;
  if (!is_small(m, 3, 0) || !is_small(m, 3, 1) || is_small(m, 3, 2) || !is_small(m, 3, 3)) {
    return false;
  }
  const glm::dvec3 columns[3] = {glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[3])};
  bool along_axes = true;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 &a = columns[i], &b = columns[(i + 1) % 3];
    const double size = std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    if (!(size > 0) || std::abs(glm::dot(a, b)) > kRigidTolerance * size) return false;
    for (int row = 0; row < 3; ++row) {
      along_axes = along_axes &&
                   (row == i || std::abs(a[row]) <= kRigidTolerance * std::sqrt(glm::dot(a, a)));
    }
  }
  return !along_axes;
}

GuessedDialect guess_dialect(const GivenMatrix& projection) {
  const auto named = [](std::string_view name) {
    for (const ApiDialect& dialect : api_dialects()) {
      if (dialect.name == name) return &dialect;
    }
    return &api_dialects().front();
  };
  ProjectionFacts facts = projection_facts(projection_part(projection));
  if (facts.looks_transposed || facts.kind == ProjectionKind::kNone) {
    const ProjectionFacts turned = projection_facts(projection_part(transposed(projection)));
    if (turned.kind != ProjectionKind::kNone) facts = turned;
  }
  if (!projection.given || facts.kind == ProjectionKind::kNone || facts.depth_lost) {
    return {named("opengl"), "nothing tells; say --dialect for another"};
  }
  if (facts.kind == ProjectionKind::kPerspective && facts.depth_reversed() &&
      facts.zero_to_one.possible) {
    return {named("reversed"), "the projection's depth falls with distance"};
  }
  const DepthReading* likely = facts.likely_range(1);
  if (likely == nullptr) {
    return {named("opengl"), "the projection may be for either range of depth; say --dialect"};
  }
  const std::string planes = planes_text(*likely);
  if (likely->from_minus_one) {
    return {named("opengl"), "with depth -1 .. 1 the projection has " + planes};
  }
  if (facts.scale.y < 0) {
    return {named("vulkan"),
            "with depth 0 .. 1 the projection has " + planes + ", and y points down"};
  }
  return {named("d3d"), "with depth 0 .. 1 the projection has " + planes};
}

}  // namespace glassbox
