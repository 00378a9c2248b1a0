// What a matrix is: sixteen numbers, judged without knowing what they were meant to be.
//
// The numbers may come from a text with few digits or have passed through many float products, so nothing is asked to hold
// exactly. Entries that are small by kSmall in their row count as zero, and axes within kRigidTolerance (view.h) of
// perpendicular unit vectors count as a rotation; how far off they are is reported.
#pragma once

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

#include <glassbox/pipeline/affine.h>

namespace glassbox {

// Entries below this part of the largest of their row are taken for rounding: four decimals short of float's 7 digits, and
// finer than any rotation or scale that somebody means.
inline constexpr double kSmall = 0x1p-16;

inline double at(const glm::dmat4& m, int row, int column) {
  return m[column][row];
}
// Whether an entry is small beside the largest one of its row.
bool is_small(const glm::dmat4& m, int row, int column);

// A matrix as its user's program printed it: columns[column][row], whatever order the text had, and how far each entry may
// be from what the program held (half a unit of the last digit).
struct GivenMatrix {
  glm::dmat4 m{1};
  glm::dmat4 uncertainty{0};
  bool given = false;    // the identity otherwise
  std::string origin{};  // how it came in: "view.txt, read by rows, 6 digits"
};

std::string row_text(const glm::dmat4& m, int row);  // "(0, 0, -1, 0)"

GivenMatrix transposed(const GivenMatrix& matrix);

enum class Shape {
  kNotFinite,
  kIdentity,
  kTranslation,  // and nothing else
  kRigid,        // rotation and translation; with `mirror`, a reflection
  kSimilarity,   // the same with one scale for all directions
  kScaled,       // rotation after a scale along the axes, R S: columns perpendicular
  kScaledAfter,  // scale after a rotation, S R: rows perpendicular, columns not
  kSheared,      // any other invertible affine map
  kFlat,         // affine, but the upper 3x3 has no inverse
  kProjective,   // the last row is not 0 0 0 1
};

struct MatrixFacts {
  Shape shape = Shape::kIdentity;
  bool affine = true;             // last row 0 0 0 1
  bool affine_transposed = true;  // last column 0 0 0 1, as of an affine map for row vectors
  int rank = 4;
  double determinant = 1;    // of the upper 3x3, as are the next four
  int orientation = 1;       // the determinant's sign; 0 where rounding could have made it
  double orthogonality = 0;  // largest entry of |R^T R - I|
  glm::dvec3 scale{1};  // the lengths of the columns; for a diagonal, its entries with their signs
  bool diagonal = true;
  std::optional<AxisAngle> rotation;  // of kRigid, kSimilarity and kScaled without a mirror
  glm::dvec3 translation{0};          // the last column

  bool mirror() const { return orientation < 0; }
  bool rigid() const;  // a proper one
  bool invertible() const { return affine && orientation != 0; }
};

MatrixFacts facts_of(const glm::dmat4& m);

// The number of independent rows: elimination with full pivoting, a pivot counting as zero where rounding the entries to
// float could have made it.
int rank_of(const glm::dmat4& m);

// The first entry that is infinite or NaN.
struct Entry {
  int row = 0, column = 0;
};
std::optional<Entry> first_not_finite(const glm::dmat4& m);

// ---- as a view matrix, eye from world ----

struct Eyepoint {
  glm::dvec3 position{0};  // in the world; of the plane of the eye's origin if the matrix is rigid
  double uncertainty = 0;  // of each coordinate, as the digits of the entries leave it
  int digits = 0;          // of the three coordinates together, simplified
  glm::dvec3 right{0}, up{0}, back{0};  // the eye's axes in the world: rows of the upper 3x3
  // The right axis is horizontal for y or z up, as look-at cameras have it.
  bool level = false;
};

// Nothing where the upper 3x3 has no inverse.
std::optional<Eyepoint> eyepoint_of(const GivenMatrix& view);

// "(3, 2, 5)", as round as the digits leave it.
std::string position_text(const Eyepoint& eye);

}  // namespace glassbox
