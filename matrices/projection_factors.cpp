#include <glassbox/matrices/projection_factors.h>

#include <algorithm>
#include <cmath>

#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

// ---- projection * view ----

glm::dvec4 row_of(const glm::dmat4& m, int row) {
  return {entry_at(m, row, 0), entry_at(m, row, 1), entry_at(m, row, 2), entry_at(m, row, 3)};
}

double dot3(const glm::dvec4& a, const glm::dvec4& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length3(const glm::dvec4& v) {
  return std::sqrt(dot3(v, v));
}

// The view's third row (`back`), and the factor k by which the projection scales everything.
struct Gaze {
  bool perspective = false;
  double k = 0;
  glm::dvec4 back{0};
};

std::optional<Gaze> gaze_of(const glm::dmat4& m) {
  const glm::dvec4 depth = row_of(m, 2), w = row_of(m, 3);
  Gaze gaze;
  gaze.perspective = length3(w) > kSmall * std::abs(w.w);
  gaze.k = gaze.perspective ? length3(w) : std::abs(w.w);
  const double length = gaze.perspective ? gaze.k : length3(depth);
  if (!(gaze.k > 0 && length > 0)) return std::nullopt;
  gaze.back = (gaze.perspective ? w : depth) * (-1 / length);
  if (!gaze.perspective) gaze.back.w = 0;  // a parallel projection has no eye position
  return gaze;
}

// Finds the factors row by row. Each of the first two rows of the product is a row of the view,
// scaled, plus a multiple of the gaze; the third row is a multiple of the gaze, plus an offset.
std::optional<ProjectionAndView> factor_by(const glm::dmat4& m, const Gaze& gaze) {
  glm::dmat4 projection(0), view(1);
  glm::dvec4 axes[3] = {{}, {}, gaze.back};
  for (int r : {0, 1}) {
    const glm::dvec4 row = row_of(m, r) / gaze.k;
    const double centre = gaze.perspective ? dot3(row, gaze.back) : 0;
    const glm::dvec4 axis = row - centre * gaze.back;
    const double scale = length3(axis);
    if (!(scale > 0)) return std::nullopt;
    axes[r] = axis / scale;
    projection[r][r] = scale;
    projection[2][r] = centre;
  }
  const glm::dvec4 depth = row_of(m, 2) / gaze.k;
  const double alpha = dot3(depth, gaze.back);
  if (!(length3(depth - alpha * gaze.back) <= kRigidTolerance * length3(depth))) {
    return std::nullopt;
  }
  projection[2][2] = alpha;
  projection[3][2] = depth.w - alpha * gaze.back.w;
  projection[2][3] = gaze.perspective ? -1 : 0;
  projection[3][3] = gaze.perspective ? 0 : 1;
  const glm::dvec3 cross = glm::cross(glm::dvec3(axes[0]), glm::dvec3(axes[1]));
  if (glm::dot(cross, glm::dvec3(axes[2])) < 0) {
    // Such a matrix is taken for that of a left-handed eye, not for that of a view that mirrors.
    axes[2] = -axes[2];
    projection[2] = -projection[2];
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) view[c][r] = axes[r][c];
  }
  return ProjectionAndView{{projection, glm::dmat4(0), true}, {view, glm::dmat4(0), true}};
}

// ---- uncertainty of the factors, from that of the entries ----
// These are generous bounds, because each entry comes from two rows.

double row_uncertainty(const GivenMatrix& matrix, int row) {
  return std::max({entry_at(matrix.uncertainty, row, 0), entry_at(matrix.uncertainty, row, 1),
                   entry_at(matrix.uncertainty, row, 2)});
}

glm::dmat4 projection_uncertainty(const GivenMatrix& matrix, const glm::dmat4& projection,
                                  const Gaze& gaze) {
  glm::dmat4 u(0);
  for (int row : {0, 1}) u[row][row] = u[2][row] = 2 * row_uncertainty(matrix, row) / gaze.k;
  const double alpha = std::abs(projection[2][2]);
  u[2][2] = 2 * (row_uncertainty(matrix, 2) + alpha * row_uncertainty(matrix, 3)) / gaze.k;
  u[3][2] =
      (entry_at(matrix.uncertainty, 2, 3) + alpha * entry_at(matrix.uncertainty, 3, 3)) / gaze.k +
      std::abs(gaze.back.w) * u[2][2];
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
                       (entry_at(matrix.uncertainty, from, column) +
                        centre * entry_at(matrix.uncertainty, 3, column)) /
                       (k * size);
    }
  }
  return u;
}

}  // namespace

std::optional<ProjectionAndView> factor_projection(const GivenMatrix& matrix) {
  if (first_not_finite(matrix.m)) return std::nullopt;
  const auto gaze = gaze_of(matrix.m);
  if (!gaze) return std::nullopt;
  auto parts = factor_by(matrix.m, *gaze);
  if (!parts) return std::nullopt;
  const MatrixFacts facts = matrix_facts(parts->view.m);
  if (!facts.rigid() || facts.shape == MatrixShape::kIdentity) return std::nullopt;
  parts->view.uncertainty = view_uncertainty(matrix, parts->projection.m, gaze->k);
  parts->projection.uncertainty = projection_uncertainty(matrix, parts->projection.m, *gaze);
  return parts;
}

GivenMatrix projection_part(const GivenMatrix& matrix) {
  const ProjectionFacts facts = projection_facts(matrix);
  if (facts.kind != ProjectionKind::kNone && facts.w_offset == 0) return matrix;
  if (has_corner_left_over(matrix)) return without_corner(matrix);
  const auto parts = factor_projection(matrix);
  return parts ? parts->projection : matrix;
}

GivenMatrix without_corner(const GivenMatrix& matrix) {
  GivenMatrix cleared = matrix;
  cleared.m[3][3] = 0;
  return cleared;
}

bool has_corner_left_over(const GivenMatrix& matrix) {
  const ProjectionFacts facts = projection_facts(matrix);
  if (facts.kind != ProjectionKind::kPerspective || facts.w_offset == 0) return false;
  if (entry_at(matrix.m, 3, 3) != 1) return false;
  const auto parts = factor_projection(matrix);
  return !parts || projection_facts(without_corner(matrix)).fewest_digits() <
                       projection_facts(parts->projection).fewest_digits();
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

bool is_transposed_projection(const GivenMatrix& matrix) {
  const ProjectionFacts facts = projection_facts(matrix);
  if (facts.looks_transposed) return true;
  if (facts.kind != ProjectionKind::kNone || factor_projection(matrix)) return false;
  const MatrixFacts as_matrix = matrix_facts(matrix.m);
  if (as_matrix.affine_transposed) return !as_matrix.affine;
  const GivenMatrix turned = transposed(matrix);
  const ProjectionFacts turned_facts = projection_facts(turned);
  if (turned_facts.kind == ProjectionKind::kPerspective) return !turned_facts.looks_transposed;
  // The last row of a projection times a view has the direction of view, a unit vector.
  const double gaze = length3(row_of(turned.m, 3));
  return std::abs(gaze - 1) <= kRigidTolerance && factor_projection(turned);
}

}  // namespace glassbox
