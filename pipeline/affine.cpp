#include <glassbox/pipeline/affine.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <optional>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/number_text.h>
#include <glassbox/pipeline/unit_vector.h>

namespace glassbox {
namespace {

constexpr double kRoundoff = unit_roundoff<double>;

// A 3x3 matrix with at[row][column], the order of indices in the formulas. (GLM has
// m[column][row].)
struct Rows {
  double at[3][3] = {};
};

Rows rows_of(const glm::dmat3& m) {
  Rows rows;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rows.at[i][j] = m[j][i];
  }
  return rows;
}

glm::dmat3 glm_of(const Rows& rows) {
  glm::dmat3 m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[j][i] = rows.at[i][j];
  }
  return m;
}

// The cofactor of entry (i, j). The rows and columns after i and j are taken in cyclic order, which
// gives the correct sign without a factor (-1)^(i + j).
double cofactor(const Rows& m, int i, int j) {
  const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
  return m.at[r][c] * m.at[s][d] - m.at[r][d] * m.at[s][c];
}

// The cofactor of entry (i, j) with the absolute value of each product. The cofactor's rounding
// error is at most a few units of roundoff of this sum.
double permanent_minor(const Rows& m, int i, int j) {
  const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
  return std::abs(m.at[r][c] * m.at[s][d]) + std::abs(m.at[r][d] * m.at[s][c]);
}

double largest_entry(const Rows& m) {
  double largest = 0;
  for (const auto& row : m.at) {
    for (double entry : row)
      largest = std::isnan(entry) ? entry : std::max(largest, std::abs(entry));
    if (std::isnan(largest)) return largest;
  }
  return largest;
}

Rows times_power_of_two(const Rows& m, int exponent) {
  Rows scaled;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) scaled.at[i][j] = std::ldexp(m.at[i][j], exponent);
  }
  return scaled;
}

// The inverse matrix: cofactors divided by the determinant. Returns nothing where the determinant
// is not larger than its rounding error. The matrix is scaled by a power of two first, so that the
// products neither overflow nor underflow to 0.
std::optional<Rows> inverse3(const Rows& matrix) {
  const double largest = largest_entry(matrix);
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Rows m = times_power_of_two(matrix, -exponent);
  double det = 0, terms = 0;
  for (int j = 0; j < 3; ++j) {
    det += m.at[0][j] * cofactor(m, 0, j);
    terms += std::abs(m.at[0][j]) * permanent_minor(m, 0, j);
  }
  if (!(std::abs(det) > 16 * kRoundoff * terms)) return std::nullopt;
  Rows inverse;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inverse.at[i][j] = cofactor(m, j, i) / det;
  }
  return times_power_of_two(inverse, -exponent);
}

double norm1(const Rows& m) {
  double norm = 0;
  for (int j = 0; j < 3; ++j) {
    norm = std::max(norm, std::abs(m.at[0][j]) + std::abs(m.at[1][j]) + std::abs(m.at[2][j]));
  }
  return norm;
}

glm::dvec3 times(const Rows& m, const glm::dvec3& v) {
  return {m.at[0][0] * v.x + m.at[0][1] * v.y + m.at[0][2] * v.z,
          m.at[1][0] * v.x + m.at[1][1] * v.y + m.at[1][2] * v.z,
          m.at[2][0] * v.x + m.at[2][1] * v.y + m.at[2][2] * v.z};
}

Rows times(const Rows& a, const Rows& b) {
  Rows product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      product.at[i][j] =
          a.at[i][0] * b.at[0][j] + a.at[i][1] * b.at[1][j] + a.at[i][2] * b.at[2][j];
    }
  }
  return product;
}

glm::dmat4 affine_matrix(const Rows& linear, const glm::dvec3& translation) {
  glm::dmat4 m(1);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[j][i] = linear.at[i][j] + 0.0;  // -0 becomes 0
    m[3][i] = translation[i] + 0.0;
  }
  return m;
}

// Rodrigues' formula for a rotation about the unit vector a: a a^T + cos (I - a a^T) + sin [a]x,
// where [a]x is the matrix of the cross product with a. For cos > 0, where 1 - cos would lose
// digits, it is computed as sin^2/(1 + cos). The diagonal entries are computed as a_i^2 + cos
// (a_j^2 + a_k^2): exactly 1 if a is the coordinate axis i, and exactly cos if a is another
// coordinate axis.
Rows rodrigues(const glm::dvec3& a, const SinCos& angle) {
  const double s = angle.sin, c = angle.cos;
  const double one_minus_c = c > 0 ? s * s / (1 + c) : 1 - c;
  Rows m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m.at[i][i] = a[i] * a[i] + c * (a[j] * a[j] + a[k] * a[k]);
    m.at[i][j] = a[i] * a[j] * one_minus_c - a[k] * s;
    m.at[j][i] = a[i] * a[j] * one_minus_c + a[k] * s;
  }
  return m;
}

std::optional<glm::dvec3> unit3(const glm::dvec3& v) {
  const auto u = unit(Vector<World, double>(v));
  if (!u) return std::nullopt;
  return to_glm(*u);
}

}  // namespace

namespace affine {

Result<glm::dmat4> rotation(const glm::dvec3& axis, double degrees) {
  const auto a = unit3(axis);
  if (!a) {
    return fail("rotation axis", triple_text(axis.x, axis.y, axis.z) + " is not a direction",
                "give three finite numbers that are not all zero");
  }
  const SinCos angle = sin_cos_degrees(degrees);
  if (std::isnan(angle.sin)) {
    return fail("rotation angle", "it is " + number_text(degrees) + " degrees",
                "give a finite angle of at most " + number_text(kMaxDegrees) + " degrees");
  }
  return affine_matrix(rodrigues(*a, angle), glm::dvec3(0));
}

glm::dmat4 inverse_rigid(const glm::dmat4& m) {
  const Rows transposed = rows_of(glm::transpose(glm::dmat3(m)));
  return affine_matrix(transposed, -times(transposed, glm::dvec3(m[3])));
}

Result<glm::dmat4> inverse(const glm::dmat4& m) {
  const auto linear = inverse3(rows_of(glm::dmat3(m)));
  if (!linear) {
    return fail("transform", "it has no inverse: it flattens space, or is not finite",
                "use scale factors that are not zero");
  }
  return affine_matrix(*linear, -times(*linear, glm::dvec3(m[3])));
}

}  // namespace affine

AxisAngle axis_angle_of(const glm::dmat4& rotation) {
  const Rows m = rows_of(glm::dmat3(rotation));
  const glm::dvec3 sine_axis =
      0.5 * glm::dvec3(m.at[2][1] - m.at[1][2], m.at[0][2] - m.at[2][0], m.at[1][0] - m.at[0][1]);
  const double sine =
      std::sqrt(sine_axis.x * sine_axis.x + sine_axis.y * sine_axis.y + sine_axis.z * sine_axis.z);
  const double cosine = 0.5 * (m.at[0][0] + m.at[1][1] + m.at[2][2] - 1);
  AxisAngle result;
  result.radians = arctan2(sine, cosine);
  if (cosine >= 0) {
    if (const auto axis = unit3(sine_axis)) result.axis = *axis;
    return result;
  }
  // For the rotation R about the unit vector a, (R + R^T)/2 - cos I = (1 - cos) a a^T. So every
  // column of this matrix is a multiple of a, and the column of the largest diagonal entry is the
  // longest.
  int column = 0;
  for (int i = 1; i < 3; ++i) {
    if (m.at[i][i] > m.at[column][column]) column = i;
  }
  glm::dvec3 multiple;
  for (int i = 0; i < 3; ++i) multiple[i] = 0.5 * (m.at[i][column] + m.at[column][i]);
  multiple[column] -= cosine;
  if (const auto axis = unit3(multiple)) result.axis = *axis;
  const bool opposed =
      result.axis.x * sine_axis.x + result.axis.y * sine_axis.y + result.axis.z * sine_axis.z < 0;
  if (opposed) result.axis = -result.axis;
  return result;
}

double orthogonality_error(const glm::dmat3& matrix) {
  const Rows m = rows_of(matrix);
  const Rows gram = times(rows_of(glm::transpose(matrix)), m);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double error = std::abs(gram.at[i][j] - (i == j ? 1 : 0));
      if (!(error <= worst)) worst = error;  // also if `error` is NaN
      if (std::isnan(worst)) return worst;
    }
  }
  return worst;
}

// Newton's iteration for the polar factor, X <- (X + X^-T)/2, where X^-T is the transposed inverse
// (Higham 1986). Near the end, each step squares X's distance from the result.
Result<NearestRotation> nearest_rotation(const glm::dmat3& matrix) {
  constexpr int kMaxSteps = 60;  // a singular value of 2^-50 becomes 2^49 and is then halved
  const auto none = fail(
      "rotation", "no rotation is near the matrix: it mirrors or flattens space, or is not finite",
      "give three perpendicular unit axes in right-handed order");
  const Rows given = rows_of(matrix);
  Rows x = given;
  for (int step = 0; step < kMaxSteps; ++step) {
    const auto inverse = inverse3(x);
    if (!inverse) return none;
    double moved = 0;
    Rows next;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        next.at[i][j] = 0.5 * (x.at[i][j] + inverse->at[j][i]);
        moved = std::max(moved, std::abs(next.at[i][j] - x.at[i][j]));
      }
    }
    x = next;
    if (moved > 4 * kRoundoff) continue;

    double det = 0;
    for (int j = 0; j < 3; ++j) det += x.at[0][j] * cofactor(x, 0, j);
    if (det < 0) return none;
    NearestRotation result{glm_of(x), 0};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        result.largest_change =
            std::max(result.largest_change, std::abs(x.at[i][j] - given.at[i][j]));
      }
    }
    return result;
  }
  return none;
}

Result<AffineFit> affine_from_three_points(const std::array<glm::dvec2, 3>& source,
                                           const std::array<glm::dvec2, 3>& target) {
  const glm::dvec2 e = source[1] - source[0], f = source[2] - source[0];
  const glm::dvec2 g = target[1] - target[0], h = target[2] - target[0];
  const double det = e.x * f.y - f.x * e.y;
  const double terms = std::abs(e.x * f.y) + std::abs(f.x * e.y);
  if (!(std::abs(det) > 4 * kRoundoff * terms)) {
    return fail("correspondences", "the three points lie on a line, or are not finite",
                "choose three that span a triangle");
  }
  // The linear part maps the source's edges e and f to the target's edges g and h: it is [g h] [e
  // f]^-1, where [e f]^-1 = [f.y -f.x; -e.y e.x]/det.
  Rows linear;
  for (int i = 0; i < 2; ++i) {
    linear.at[i][0] = (g[i] * f.y - h[i] * e.y) / det;
    linear.at[i][1] = (h[i] * e.x - g[i] * f.x) / det;
  }
  linear.at[2][2] = 1;
  const double norm = std::max(std::abs(e.x) + std::abs(e.y), std::abs(f.x) + std::abs(f.y));
  const double inverse_norm =
      std::max(std::abs(f.y) + std::abs(e.y), std::abs(f.x) + std::abs(e.x)) / std::abs(det);
  const glm::dvec3 moved = times(linear, glm::dvec3(source[0], 0));
  return AffineFit{
      affine_matrix(linear, glm::dvec3(target[0].x - moved.x, target[0].y - moved.y, 0)),
      norm * inverse_norm};
}

Result<AffineFit> affine_from_four_points(const std::array<glm::dvec3, 4>& source,
                                          const std::array<glm::dvec3, 4>& target) {
  Rows edges, images;
  for (int j = 0; j < 3; ++j) {
    const std::size_t corner = std::size_t(j) + 1;
    for (int i = 0; i < 3; ++i) {
      edges.at[i][j] = source[corner][i] - source[0][i];
      images.at[i][j] = target[corner][i] - target[0][i];
    }
  }
  const auto inverse = inverse3(edges);
  if (!inverse) {
    return fail("correspondences", "the four points lie in a plane, or are not finite",
                "choose four that span a tetrahedron");
  }
  const Rows linear = times(images, *inverse);
  return AffineFit{affine_matrix(linear, target[0] - times(linear, source[0])),
                   norm1(edges) * norm1(*inverse)};
}

}  // namespace glassbox
