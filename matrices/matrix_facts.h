// Describes a 4x4 matrix by its entries alone, without knowing what it is meant to be.
//
// The numbers may come from a text with few digits, or from many products in float, so no property
// is required to hold exactly. Entries that are smaller than kSmall times the largest of their row
// count as zero. Axes count as a rotation if they differ from perpendicular unit vectors by at most
// kRigidTolerance (view.h); the deviation is reported.
#pragma once

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

#include <glassbox/pipeline/affine.h>

namespace glassbox {

// Entries below this fraction of the largest one in their row are taken for rounding errors. It is
// smaller than 0.0001, the smallest number in a text with four decimals, and than any rotation or
// scale that somebody intends, but larger than the rounding errors of float (7 digits).
inline constexpr double kSmall = 0x1p-16;

inline double entry_at(const glm::dmat4& m, int row, int column) {
  return m[column][row];
}
// Whether an entry is so small compared with the largest one of its row that it counts as zero.
bool is_small(const glm::dmat4& m, int row, int column);

// A matrix as the user's program printed it, as columns[column][row] whatever the order of the text
// was, with the uncertainty of each entry (half a unit of its last digit).
struct GivenMatrix {
  glm::dmat4 m{1};
  glm::dmat4 uncertainty{0};
  bool given = false;    // if false, it is the identity
  std::string origin{};  // where it comes from: "view.txt, read by rows, 6 digits"
};

std::string row_text(const glm::dmat4& m, int row);  // "(0, 0, -1, 0)"

GivenMatrix transposed(const GivenMatrix& matrix);

enum class MatrixShape {
  kNotFinite,
  kIdentity,
  kTranslation,  // only a translation
  kRigid,        // rotation and translation; with `mirror`, a reflection
  kSimilarity,   // like kRigid, but with one scale for all directions
  kScaled,       // rotation after a scale along the axes, R S: columns perpendicular
  kScaledAfter,  // scale after a rotation, S R: rows perpendicular, columns not
  kSheared,      // any other invertible affine map
  kFlat,         // affine, but the upper 3x3 has no inverse
  kProjective,   // the last row is not 0 0 0 1
};

struct MatrixFacts {
  MatrixShape shape = MatrixShape::kIdentity;
  bool affine = true;             // last row 0 0 0 1
  bool affine_transposed = true;  // last column 0 0 0 1, as in an affine matrix for row vectors
  int rank = 4;
  double determinant = 1;    // of the upper 3x3 part, as are the next four
  int orientation = 1;       // the determinant's sign; 0 if it could be a rounding error
  double orthogonality = 0;  // largest entry of |R^T R - I|
  glm::dvec3 scale{1};  // the lengths of the columns; for a diagonal, its entries with their signs
  bool diagonal = true;
  std::optional<AxisAngle> rotation;  // for kRigid, kSimilarity and kScaled without a mirror
  glm::dvec3 translation{0};          // the last column

  bool mirror() const { return orientation < 0; }
  bool rigid() const;  // a rotation and a translation, without a mirror
  bool invertible() const { return affine && orientation != 0; }
};

MatrixFacts matrix_facts(const glm::dmat4& m);

// The number of independent rows, by Gaussian elimination with full pivoting. A pivot counts as
// zero if rounding the entries to float could have made it.
int rank_of(const glm::dmat4& m);

// The first entry that is infinite or NaN.
struct Entry {
  int row = 0, column = 0;
};
std::optional<Entry> first_not_finite(const glm::dmat4& m);

// ---- as a view matrix, eye_from_world ----

struct Eyepoint {
  // The position of the eye in the world. If the matrix is not rigid, it is the point that the
  // matrix maps to the origin.
  glm::dvec3 position{0};
  double uncertainty = 0;  // of each coordinate, from the uncertainty of the entries
  int digits = 0;          // of the simplest decimals of the three coordinates, added up
  glm::dvec3 right{0}, up{0}, back{0};  // the eye's axes in the world: rows of the upper 3x3
  // Whether the right axis is horizontal for y up or for z up, as it is for look-at cameras.
  bool level = false;
};

// The eye of a view matrix; nothing if the upper 3x3 has no inverse.
std::optional<Eyepoint> eyepoint_of(const GivenMatrix& view);

// The position as the simplest decimals within the uncertainty: "(3, 2, 5)".
std::string position_text(const Eyepoint& eye);

}  // namespace glassbox
