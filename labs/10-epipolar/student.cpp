// Lab 10: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <cmath>

namespace lab_10 {

// ---- task 10.1: the essential matrix ----

Matrix essential(const Pose& pose) {
  // BEGIN SOLUTION
  const Vector& t = pose.translation;
  const Matrix s{{{0, -t[2], t[1]}, {t[2], 0, -t[0]}, {-t[1], t[0], 0}}};
  return times(pose.rotation, s);
  // STUB: return Matrix{{{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}}};  // E = R S
  // END SOLUTION
}

Vector centre_from_shift(const Matrix& rotation, const Vector& shift) {
  // BEGIN SOLUTION
  return times(-1, times(transposed(rotation), shift));
  // STUB: return {NAN, NAN, NAN};  // R (P - T) = R P + t
  // END SOLUTION
}

// ---- task 10.2: the epipolar line ----

Line epipolar_line(const Matrix& essential, const Camera& left, const Camera& right,
                   const Pixel& left_pixel) {
  // BEGIN SOLUTION
  const Vector seen{(left_pixel.x - left.x) / left.f, (left_pixel.y - left.y) / left.f, 1};
  const Vector u = times(essential, seen);
  // u is the line for calibrated points. For pixels (x, y), with the principal point (x0, y0), it
  // is u_x (x - x0)/f + u_y (y - y0)/f + u_z = 0; `line` is this equation times f.
  Line line{u[0], u[1], right.f * u[2] - u[0] * right.x - u[1] * right.y};
  const double size = std::sqrt(line.a * line.a + line.b * line.b);
  if (size == 0) return {};
  const double factor = (line.b < 0 || (line.b == 0 && line.a < 0) ? -1 : 1) / size;
  return {factor * line.a, factor * line.b, factor * line.c};
  // STUB: return {NAN, NAN, NAN};
  // END SOLUTION
}

// ---- task 10.3: points of a size that suits the equations ----

Normaliser normalising(const std::vector<Pixel>& points) {
  // BEGIN SOLUTION
  const double count = double(points.size());
  Normaliser n{0, 0, 0};
  for (const Pixel& p : points) {
    n.x += p.x;
    n.y += p.y;
  }
  n.x /= count;
  n.y /= count;
  double sum = 0;
  for (const Pixel& p : points) sum += std::hypot(p.x - n.x, p.y - n.y);
  n.scale = std::sqrt(2.0) * count / sum;
  return n;
  // STUB: return {NAN, NAN, NAN};
  // END SOLUTION
}

// ---- task 10.4: the essential matrix of eight matches or more ----

// BEGIN SOLUTION
static Matrix matrix_of(const Normaliser& n) {
  return {{{n.scale, 0, -n.scale * n.x}, {0, n.scale, -n.scale * n.y}, {0, 0, 1}}};
}

static Matrix nearest_essential(const Matrix& m) {
  SingularValues svd = decomposed(m);
  const double s = (svd.s[0] + svd.s[1]) / 2;
  const Matrix diagonal{{{s, 0, 0}, {0, s, 0}, {0, 0, 0}}};
  return times(times(svd.u, diagonal), transposed(svd.v));
}
// STUB:
// END SOLUTION

Matrix eight_point(const std::vector<Match>& matches) {
  // BEGIN SOLUTION
  std::vector<Pixel> left, right;
  for (const Match& match : matches) {
    left.push_back(match.left);
    right.push_back(match.right);
  }
  const Matrix to_left = matrix_of(normalising(left));
  const Matrix to_right = matrix_of(normalising(right));
  std::vector<Row> rows;
  for (const Match& match : matches) {
    const Vector l = times(to_left, Vector{match.left.x, match.left.y, 1});
    const Vector r = times(to_right, Vector{match.right.x, match.right.y, 1});
    rows.push_back({r[0] * l[0], r[0] * l[1], r[0] * l[2], r[1] * l[0], r[1] * l[1], r[1] * l[2],
                    r[2] * l[0], r[2] * l[1], r[2] * l[2]});
  }
  const Row x = least_squares_direction(rows);
  const Matrix solved{{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}}};
  const Matrix carried_back = times(times(transposed(to_right), solved), to_left);
  return nearest_essential(carried_back);
  // STUB: return Matrix{{{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}}};
  // END SOLUTION
}

// ---- task 10.5: which of four ----

// BEGIN SOLUTION
static int in_front_of_both(const Pose& pose, const std::vector<Match>& matches) {
  int count = 0;
  for (const Match& match : matches) {
    const Point p = triangulate(match.left, match.right, pose);
    const Vector& t = pose.translation;
    const Vector from_right{p.x - p.w * t[0], p.y - p.w * t[1], p.z - p.w * t[2]};
    count += p.z > 0 && dot(pose.rotation[2], from_right) > 0;
  }
  return count;
}
// STUB:
// END SOLUTION

Pose relative_pose(const Matrix& essential, const std::vector<Match>& matches) {
  // BEGIN SOLUTION
  const SingularValues svd = decomposed(essential);
  const Matrix quarter_turn{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
  // T has this direction, because E T = 0
  const Vector along{svd.v[0][2], svd.v[1][2], svd.v[2][2]};
  Pose best;
  int most = -1;
  for (const Matrix& turn : {quarter_turn, transposed(quarter_turn)}) {
    Matrix rotation = times(times(svd.u, turn), transposed(svd.v));
    if (determinant(rotation) < 0) {
      for (Vector& row : rotation) row = times(-1, row);
    }
    for (const double sign : {1.0, -1.0}) {
      const Pose pose{rotation, times(sign, along)};
      const int count = in_front_of_both(pose, matches);
      if (count > most) {
        best = pose;
        most = count;
      }
    }
  }
  return best;
  // STUB: return {Matrix{{{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}}}, {NAN, NAN, NAN}};
  // END SOLUTION
}

// ---- task 10.6: the point ----

Point triangulate(const Pixel& left, const Pixel& right, const Pose& pose) {
  // BEGIN SOLUTION
  const Vector d{left.x, left.y, 1};
  const Vector e = times(transposed(pose.rotation), Vector{right.x, right.y, 1});
  const Vector& t = pose.translation;
  const Vector across = cross(d, e);
  const double squared = dot(across, across);
  if (std::sqrt(squared) <= 0x1p-49 * length(d) * length(e)) return {d[0], d[1], d[2], 0};
  // Finds the t_l and t_r for which the points t_l d and T + t_r e of the two lines are closest:
  // the least squares solution of t_l d - t_r e = T.
  const double along_left = dot(cross(t, e), across) / squared;
  const double along_right = dot(cross(t, d), across) / squared;
  const Vector sum = plus(times(along_left, d), plus(t, times(along_right, e)));
  return {sum[0] / 2, sum[1] / 2, sum[2] / 2, 1};
  // STUB: return {NAN, NAN, NAN, NAN};
  // END SOLUTION
}

}  // namespace lab_10
