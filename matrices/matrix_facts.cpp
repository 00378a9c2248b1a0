#include <glassbox/matrices/matrix_facts.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/matrices/decimal.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {
namespace {

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool is_small_beside(double x, double size) {
  return std::abs(x) <= kSmall * size;
}

// Whether the row is 0 0 0 1. The tolerance is relative to 1, not to the size of the other rows,
// because all coordinates are divided by w, which should be 1.
bool is_affine_row(const glm::dvec4& row) {
  return is_small_beside(row.x, 1) && is_small_beside(row.y, 1) && is_small_beside(row.z, 1) &&
         is_small_beside(row.w - 1, 1);
}

// The determinant's sign, or 0 if the determinant is below the error that rounding the entries to
// float causes in its six terms.
int orientation_of(const glm::dmat3& a) {
  const auto term = [&](int i, int j, int k) { return std::abs(a[0][i] * a[1][j] * a[2][k]); };
  const double terms =
      term(0, 1, 2) + term(0, 2, 1) + term(1, 0, 2) + term(1, 2, 0) + term(2, 0, 1) + term(2, 1, 0);
  const double determinant = glm::determinant(a);
  if (!(std::abs(determinant) > gamma<float>(6) * terms)) return 0;
  return determinant > 0 ? 1 : -1;
}

// Divides each column by its length.
glm::dmat3 without_scale(const glm::dmat3& a) {
  glm::dmat3 axes = a;
  for (int i = 0; i < 3; ++i) axes[i] /= std::sqrt(glm::dot(a[i], a[i]));
  return axes;
}

bool is_diagonal(const glm::dmat3& a) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (row != column && a[column][row] != 0) return false;
    }
  }
  return true;
}

MatrixShape shape_of(const glm::dmat3& a, const MatrixFacts& facts) {
  if (facts.orientation == 0) return MatrixShape::kFlat;
  const glm::dmat3 identity(1);
  if (a == identity) {
    return facts.translation == glm::dvec3(0) ? MatrixShape::kIdentity : MatrixShape::kTranslation;
  }
  if (facts.orthogonality <= kRigidTolerance) return MatrixShape::kRigid;
  if (orthogonality_error(without_scale(a)) <= kRigidTolerance) {
    const double longest = largest(facts.scale);
    const double shortest =
        std::min({std::abs(facts.scale.x), std::abs(facts.scale.y), std::abs(facts.scale.z)});
    return longest - shortest <= kRigidTolerance * longest ? MatrixShape::kSimilarity
                                                           : MatrixShape::kScaled;
  }
  if (orthogonality_error(without_scale(glm::transpose(a))) <= kRigidTolerance) {
    return MatrixShape::kScaledAfter;
  }
  return MatrixShape::kSheared;
}

}  // namespace

bool is_small(const glm::dmat4& m, int row, int column) {
  double largest = 0;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(entry_at(m, row, c)));
  return is_small_beside(entry_at(m, row, column), largest);
}

std::string row_text(const glm::dmat4& m, int row) {
  std::string text;
  for (int column = 0; column < 4; ++column) {
    text += (column == 0 ? "(" : ", ") + short_number(entry_at(m, row, column));
  }
  return text + ")";
}

GivenMatrix transposed(const GivenMatrix& matrix) {
  return {glm::transpose(matrix.m), glm::transpose(matrix.uncertainty), matrix.given};
}

bool MatrixFacts::rigid() const {
  return affine && orientation > 0 &&
         (shape == MatrixShape::kIdentity || shape == MatrixShape::kTranslation ||
          shape == MatrixShape::kRigid);
}

std::optional<Entry> first_not_finite(const glm::dmat4& m) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (!std::isfinite(m[column][row])) return Entry{row, column};
    }
  }
  return std::nullopt;
}

MatrixFacts matrix_facts(const glm::dmat4& m) {
  MatrixFacts facts;
  if (first_not_finite(m)) {
    facts.shape = MatrixShape::kNotFinite;
    facts.affine = facts.affine_transposed = false;
    facts.rank = facts.orientation = 0;
    return facts;
  }
  const glm::dmat3 a(m);
  facts.affine = is_affine_row({m[0][3], m[1][3], m[2][3], m[3][3]});
  facts.affine_transposed = is_affine_row(m[3]);
  facts.rank = rank_of(m);
  facts.determinant = glm::determinant(a);
  facts.orientation = orientation_of(a);
  facts.orthogonality = orthogonality_error(a);
  facts.diagonal = is_diagonal(a);
  for (int i = 0; i < 3; ++i) {
    facts.scale[i] = facts.diagonal ? a[i][i] : std::sqrt(glm::dot(a[i], a[i]));
  }
  facts.translation = glm::dvec3(m[3]);
  facts.shape = facts.affine ? shape_of(a, facts) : MatrixShape::kProjective;
  const bool turns = facts.shape == MatrixShape::kRigid ||
                     facts.shape == MatrixShape::kSimilarity || facts.shape == MatrixShape::kScaled;
  if (turns && facts.orientation > 0) {
    if (const auto nearest = nearest_rotation(without_scale(a))) {
      facts.rotation = axis_angle_of(glm::dmat4(nearest->rotation));
    }
  }
  return facts;
}

int rank_of(const glm::dmat4& m) {
  // For each entry, `size` is the sum of the magnitudes that were added up in it. The entry's
  // rounding error is relative to this sum.
  glm::dmat4 a = m, size;
  for (int column = 0; column < 4; ++column) size[column] = glm::abs(m[column]);
  bool row_used[4] = {}, column_used[4] = {};
  for (int rank = 0; rank < 4; ++rank) {
    // Chooses the pivot that is largest relative to its rounding error, so that a row of small
    // numbers, such as that of a near plane close to the eye, does not seem to be zero.
    int row = -1, column = -1;
    double best = 8 * gamma<float>(4);
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) {
        if (row_used[r] || column_used[c] || a[c][r] == 0) continue;
        const double certainty = std::abs(a[c][r]) / size[c][r];
        const bool better = certainty > best || (certainty == best && row >= 0 &&
                                                 std::abs(a[c][r]) > std::abs(a[column][row]));
        if (better) row = r, column = c, best = certainty;
      }
    }
    if (row < 0) return rank;
    row_used[row] = column_used[column] = true;
    for (int r = 0; r < 4; ++r) {
      if (row_used[r] || a[column][r] == 0) continue;
      const double factor = a[column][r] / a[column][row];
      for (int c = 0; c < 4; ++c) {
        if (column_used[c]) continue;
        a[c][r] -= factor * a[c][row];
        size[c][r] += std::abs(factor) * size[c][row];
      }
    }
  }
  return 4;
}

std::optional<Eyepoint> eyepoint_of(const GivenMatrix& view) {
  const auto inverse = affine::inverse(view.m);
  if (!inverse) return std::nullopt;
  Eyepoint eye;
  eye.position = glm::dvec3((*inverse)[3]);
  const glm::dmat4& m = view.m;
  eye.right = {m[0][0], m[1][0], m[2][0]};
  eye.up = {m[0][1], m[1][1], m[2][1]};
  eye.back = {m[0][2], m[1][2], m[2][2]};
  // The eye's position e solves A e + t = 0, where A is the upper 3x3 part and t the last column.
  // Errors dA and dt of the entries move e by at most |A^-1| (dA |e| + dt).
  const glm::dvec3 e = glm::abs(eye.position);
  glm::dvec3 residual(0);
  for (int row = 0; row < 3; ++row) {
    residual[row] = view.uncertainty[3][row];
    for (int k = 0; k < 3; ++k) residual[row] += view.uncertainty[k][row] * e[k];
  }
  for (int row = 0; row < 3; ++row) {
    double moved = 0;
    for (int k = 0; k < 3; ++k) moved += std::abs((*inverse)[k][row]) * residual[k];
    eye.uncertainty = std::max(eye.uncertainty, moved);
  }
  for (int i = 0; i < 3; ++i) {
    eye.digits += simplest_decimal(eye.position[i], eye.uncertainty).digits;
  }
  const double length = std::sqrt(glm::dot(eye.right, eye.right));
  eye.level = is_small_beside(eye.right.y, length) || is_small_beside(eye.right.z, length);
  return eye;
}

std::string position_text(const Eyepoint& eye) {
  const auto text = [&](double x) { return rounded_text(x, eye.uncertainty); };
  return "(" + text(eye.position.x) + ", " + text(eye.position.y) + ", " + text(eye.position.z) +
         ")";
}

}  // namespace glassbox
