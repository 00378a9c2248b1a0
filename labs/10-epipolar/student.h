// Lab 10: where in space the point is that two pictures show. The contracts of the seven functions
// that you write in student.cpp.
//
// A camera's space has x to the right, y down and z along the gaze. P_r = R (P_l - T): R turns the
// left camera's axes into those of the right one, and T is the position of the right camera in the
// left camera's space. A *calibrated* point is (X/Z, Y/Z): where the line of sight meets the plane
// z = 1. u = 2^-53 is the unit roundoff of double; |.| of a matrix is the root of the sum of its
// squared entries.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace lab_10 {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  // its rows: m[row][column]

struct Pixel {
  double x = 0, y = 0;
};

// One point as both pictures show it, in calibrated coordinates.
struct Match {
  Pixel left, right;
};

// R is a rotation, whose entries are rounded to double. A length |T| that is given is 0 or between
// 2^-100 and 2^100, and so is the length of any other vector or matrix that is given.
struct Pose {
  Matrix rotation{};     // R
  Vector translation{};  // T
};

// Focal length f and the principal point (x, y), in pixels: the pixel of a calibrated point p is
// (f p.x + x, f p.y + y).
struct Camera {
  double f = 1, x = 0, y = 0;
};

// The line of the pixels (x, y) with a x + b y + c = 0.
struct Line {
  double a = 0, b = 0, c = 0;
};

// Homogeneous: (x, y, z, 1), or a direction with w = 0.
struct Point {
  double x = 0, y = 0, z = 0, w = 0;
};

// Task 10.1. E = R S, where S is the matrix with S P = T x P, so that P_r . (E P_l) = 0. Error
// bound of an entry: 4 u |T|.
Matrix essential(const Pose& pose);

// Task 10.1. Other textbooks have P_r = R P_l + t. Returns the T of the same two cameras for this R
// and t. Error bound: 8 u |t|.
Vector centre_from_shift(const Matrix& rotation, const Vector& shift);

// Task 10.2. The epipolar line of a pixel of the left picture: the point that the left picture
// shows there is on this line of the right picture. a^2 + b^2 = 1, and b > 0, or b = 0 and a > 0.
// Let p_l be the calibrated pixel as (x, y, 1), and v = E p_l. If v_x = v_y = 0 there is no line in
// the picture: a = b = c = 0; this is so where v = 0, and where the line is at infinity. Error
// bound of a and b: r = 64 u |E| |p_l| / |(v_x, v_y)|; of c: r (1 + |c| + the largest absolute
// value of the right camera's numbers). Where |b| <= r, rounding decides about the sign of the
// line. Where |(v_x, v_y)| is not 0, but at most 8 u |E| |p_l|, rounding decides whether there is a
// line: a = b = c = 0 is accepted, and so is any line with a^2 + b^2 = 1 to within 16 u and the
// sign as above. Focal lengths are between 2^-10 and 2^20 and the other numbers of cameras and
// pixels at most 2^30.
Line epipolar_line(const Matrix& essential, const Camera& left, const Camera& right,
                   const Pixel& left_pixel);

// A normalisation of points: each point is moved by -(x, y), then multiplied by `scale`.
struct Normaliser {
  double x = 0, y = 0, scale = 1;
};

// Task 10.3. The normalisation of n >= 2 given points: (x, y) is their mean, and the vectors
// scale (p - (x, y)) of all points p have the mean length sqrt 2. Not all points are the same:
// their mean distance to (x, y) is at least 64 n u times the largest absolute value of a
// coordinate. Error bound of x and y: 8 n u times that value; of the scale: 16 n u scale (1 + scale
// times that value).
Normaliser normalising(const std::vector<Pixel>& points);

// Task 10.4. E of at least 8 matches, of any sign and scale:
//   1. normalise the points of each picture, each picture by itself;
//   2. find the M with |M| = 1 for which the sum of (q_r . (M q_l))^2 is least, where q = (x, y, 1)
//      of normalised points;
//   3. undo the normalisation: the matrix for the points as they were given;
//   4. take the nearest matrix with singular values (s, s, 0): of s_1 >= s_2 >= s_3,
//      s = (s_1 + s_2)/2.
// Error bound of E scaled to |E| = 1: some thousand u times the condition number of step 2; the
// report shows it.
Matrix eight_point(const std::vector<Match>& matches);

// Task 10.5. From E = U diag(s, s, 0) V^T to R and T with |T| = 1. There are four (R, T) with R S =
// E up to sign and scale. Return the one with which more matches are in front of both cameras than
// with any other: the point where their lines of sight meet has a positive depth for the left
// camera and for the right one. Matches whose lines of sight are parallel, or nearly so, are too
// few to decide. R is a rotation: its determinant is 1. Error bound: 256 u.
Pose relative_pose(const Matrix& essential, const std::vector<Match>& matches);

// Task 10.6. The point halfway between the two lines of sight where they come closest to each
// other. The left line is t_l d with d = (x, y, 1) of the left calibrated point. The right line is
// T + t_r e with e = R^T (x, y, 1) of the right calibrated point. The answer is in the left
// camera's space, with w = 1. Lines that are parallel, |d x e| <= 16 u |d| |e|, meet at infinity:
// then the answer is d with w = 0. For |d x e| between 4 u and 32 u times |d| |e| rounding may
// decide: there both answers are right. d and w are exact. Error bound of x, y and z: 64 u (|P| +
// |T|) / sin^2 of the angle between the lines, where P is the answer.
Point triangulate(const Pixel& left, const Pixel& right, const Pose& pose);

// ---- functions that are given ----

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector times(double factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline Vector plus(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}
inline Vector times(const Matrix& m, const Vector& a) {
  return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}
inline Matrix transposed(const Matrix& m) {
  return {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
}
inline Matrix times(const Matrix& a, const Matrix& b) {
  const Matrix columns = transposed(b);
  return {times(columns, a[0]), times(columns, a[1]), times(columns, a[2])};
}
inline double determinant(const Matrix& m) {
  return dot(m[0], cross(m[1], m[2]));
}

// The matrix scaled to |M| = 1, with the sign for which its entry of largest absolute value is
// positive. A matrix that is known only up to sign and scale is compared and printed in this form.
inline Matrix told(const Matrix& m) {
  double squares = 0, largest = 0;
  for (const Vector& row : m) {
    for (const double x : row) {
      squares += x * x;
      if (std::abs(x) > std::abs(largest)) largest = x;
    }
  }
  const double factor = (largest < 0 ? -1 : 1) / std::sqrt(squares);
  return {times(factor, m[0]), times(factor, m[1]), times(factor, m[2])};
}

// Rotates pairs of columns of A until all columns are perpendicular to each other (Hestenes 1958).
// This gives A = U diag(s) V^T, with perpendicular unit vectors as columns of U and of V: s are the
// lengths of the resulting columns, and `turns` becomes V.
template <class Columns>
void make_perpendicular(Columns& columns, Columns& turns) {
  const auto product = [](const auto& a, const auto& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const auto turn = [](auto& a, auto& b, double c, double s) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double x = a[i], y = b[i];
      a[i] = c * x - s * y;
      b[i] = s * x + c * y;
    }
  };
  bool turned = true;
  for (int sweep = 0; sweep < 60 && turned; ++sweep) {
    turned = false;
    for (std::size_t p = 0; p < columns.size(); ++p) {
      for (std::size_t q = p + 1; q < columns.size(); ++q) {
        const double pp = product(columns[p], columns[p]), qq = product(columns[q], columns[q]);
        const double pq = product(columns[p], columns[q]);
        if (std::abs(pq) <= 0x1p-52 * std::sqrt(pp * qq)) continue;
        turned = true;
        const double zeta = (qq - pp) / (2 * pq);
        const double t = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
        const double c = 1 / std::sqrt(1 + t * t);
        turn(columns[p], columns[q], c, c * t);
        turn(turns[p], turns[q], c, c * t);
      }
    }
  }
}

struct SingularValues {
  Matrix u{};
  Vector s{};
  Matrix v{};
};
inline SingularValues decomposed(const Matrix& a) {
  Matrix columns = transposed(a), turns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  make_perpendicular(columns, turns);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return length(columns[i]) > length(columns[j]); });
  SingularValues found;
  Matrix u{}, v{};
  for (std::size_t i = 0; i < 3; ++i) {
    found.s[i] = length(columns[order[i]]);
    v[i] = turns[order[i]];
    if (i < 2 && found.s[i] > 0) u[i] = times(1 / found.s[i], columns[order[i]]);
  }
  u[2] = cross(u[0], u[1]);  // the third direction; its sign makes no difference where s_3 is 0
  if (dot(u[2], columns[order[2]]) < 0) u[2] = times(-1, u[2]);
  found.u = transposed(u);
  found.v = transposed(v);
  return found;
}

// Finds the x of length 1 for which the sum of (row . x)^2 over all rows is least; at least 8 rows.
using Row = std::array<double, 9>;
inline Row least_squares_direction(const std::vector<Row>& rows) {
  std::vector<std::vector<double>> columns(9), turns(9, std::vector<double>(9, 0.0));
  for (std::size_t j = 0; j < 9; ++j) {
    for (const Row& row : rows) columns[j].push_back(row[j]);
    turns[j][j] = 1;
  }
  make_perpendicular(columns, turns);
  std::size_t least = 0;
  double least_square = INFINITY;
  for (std::size_t j = 0; j < 9; ++j) {
    double square = 0;
    for (const double x : columns[j]) square += x * x;
    if (square < least_square) {
      least = j;
      least_square = square;
    }
  }
  Row x{};
  std::copy(turns[least].begin(), turns[least].end(), x.begin());
  return x;
}

}  // namespace lab_10
