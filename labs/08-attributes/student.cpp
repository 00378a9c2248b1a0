// Lab 8: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lab_08 {

// ---- task 8.1: one pixel ----

std::array<float, 2> texcoord_at(const PixelOfTriangle& at) {
  // BEGIN SOLUTION
  // share[k] is the edge function times 1/w. The sum of the edge functions is left out: as a common
  // factor it cancels in the divisions by `sum`.
  std::array<float, 3> share;
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    share[k] = float(at.edges[k]) * at.inverse_w[k];
    sum += share[k];
  }
  const float b1 = share[1] / sum, b2 = share[2] / sum;
  std::array<float, 2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    // Interpolates differences from vertex 0, so that a large part that all coordinates have in
    // common is not rounded.
    const float a0 = at.texcoords[0][i], a1 = at.texcoords[1][i], a2 = at.texcoords[2][i];
    result[i] = a0 + (b1 * (a1 - a0) + b2 * (a2 - a0));
  }
  return result;
  // STUB: return {NAN, NAN};  // (sum of edge * u/w) / (sum of edge * 1/w)
  // END SOLUTION
}

// ---- tasks 8.2 and 8.3: a row of pixels ----

// BEGIN SOLUTION
static double inverse_w_at(const Line& line, double x) {
  const double far = x / line.pixels, near = 1 - far;
  return near * line.inverse_w0 + far * line.inverse_w1;
}

static double coordinate_at(const Line& line, double x) {
  // The share of u1: exactly 0 and 1 at the ends. If u0 = u1, the result is exactly u0.
  const double share = x / line.pixels * line.inverse_w1 / inverse_w_at(line, x);
  return line.u0 + share * (line.u1 - line.u0);
}
// STUB:
// END SOLUTION

std::vector<double> span_coordinates(const Line& line, int every) {
  // BEGIN SOLUTION
  std::vector<double> u;
  for (int first = 0; first < line.pixels; first += every) {
    const int end = std::min(first + every, line.pixels);
    const double start = coordinate_at(line, first);
    const double step = (coordinate_at(line, end) - start) / (end - first);
    for (int x = first; x < end; ++x) u.push_back(start + (x - first + 0.5) * step);
  }
  return u;
  // STUB: return {};  // one number for each pixel
  // END SOLUTION
}

SpanChoice longest_span(const Line& line, double tolerance) {
  // BEGIN SOLUTION
  SpanChoice best{1, 0};
  for (int every = 2; every <= line.pixels; every *= 2) {
    double error = 0;
    for (int first = 0; first < line.pixels; first += every) {
      const int end = std::min(first + every, line.pixels);
      const double q0 = inverse_w_at(line, first), q1 = inverse_w_at(line, end);
      const double root = std::sqrt(std::max(q0, q1) / std::min(q0, q1));
      const double du = coordinate_at(line, end) - coordinate_at(line, first);
      error = std::max(error, std::abs(du) * (root - 1) / (root + 1));
    }
    if (error <= tolerance) best = {every, error};
  }
  return best;
  // STUB: return {0, NAN};  // pixels from division to division, and the law's error in texels
  // END SOLUTION
}

// ---- task 8.4: mip levels ----

Footprint footprint_at(const std::array<TexturedVertex, 3>& triangle, double x, double y, int width,
                       int height) {
  // BEGIN SOLUTION
  // 1/w, (u - u0)/w and (v - v0)/w are linear over the screen: they are planes. u0 and v0 are the
  // coordinates of vertex 0.
  const TexturedVertex& a = triangle[0];
  const double x1 = triangle[1].x - a.x, y1 = triangle[1].y - a.y;
  const double x2 = triangle[2].x - a.x, y2 = triangle[2].y - a.y;
  const double area = x1 * y2 - x2 * y1;
  struct Plane {
    double here, along_x, along_y;
  };
  const auto plane = [&](double f0, double f1, double f2) {
    const double along_x = ((f1 - f0) * y2 - (f2 - f0) * y1) / area;
    const double along_y = ((f2 - f0) * x1 - (f1 - f0) * x2) / area;
    return Plane{f0 + along_x * (x - a.x) + along_y * (y - a.y), along_x, along_y};
  };
  const double q1 = triangle[1].inverse_w, q2 = triangle[2].inverse_w;
  const Plane q = plane(a.inverse_w, q1, q2);
  const Plane u = plane(0, (triangle[1].u - a.u) * q1, (triangle[2].u - a.u) * q2);
  const Plane v = plane(0, (triangle[1].v - a.v) * q1, (triangle[2].v - a.v) * q2);
  // The quotient rule for P = (u - u0)/w or (v - v0)/w and Q = 1/w: (P/Q)' = (P' - (P/Q) Q') / Q.
  const auto derivative = [&](const Plane& p, double p_along, double q_along) {
    return (p_along - p.here / q.here * q_along) / q.here;
  };
  Footprint f;
  f.du_dx = derivative(u, u.along_x, q.along_x);
  f.du_dy = derivative(u, u.along_y, q.along_y);
  f.dv_dx = derivative(v, v.along_x, q.along_x);
  f.dv_dy = derivative(v, v.along_y, q.along_y);
  const double longer = std::max(std::hypot(width * f.du_dx, height * f.dv_dx),
                                 std::hypot(width * f.du_dy, height * f.dv_dy));
  const double last = std::log2(double(std::max(width, height)));
  f.level = longer <= 1 ? 0 : std::min(std::log2(longer), last);
  return f;
  // STUB: return {NAN, NAN, NAN, NAN, NAN};  // (P/Q)' = (P' - (P/Q) Q') / Q, with Q = 1/w
  // END SOLUTION
}

// ---- tasks 8.5 and 8.6: curved surfaces ----

// BEGIN SOLUTION
using Place = Point<Object, double>;

// The Bernstein polynomials at i/n, computed from integers, so that at (n - i)/n they are exactly
// the same four numbers in the opposite order.
static std::array<double, 4> bernstein(int i, int n) {
  const double a = n - i, b = i, whole = double(n) * n * n;
  return {a * a * a / whole, 3 * (a * a * b) / whole, 3 * (a * b * b) / whole, b * b * b / whole};
}

// Adds the outer two terms, adds the inner two terms, then adds the two sums. If the points come in
// the opposite order, only the terms within these sums are swapped, so the result has the same
// bits.
static Place on_curve(const std::array<Place, 4>& p, int i, int n) {
  const auto [a, b, c, d] = bernstein(i, n);
  return {(p[0].x * a + p[3].x * d) + (p[1].x * b + p[2].x * c),
          (p[0].y * a + p[3].y * d) + (p[1].y * b + p[2].y * c),
          (p[0].z * a + p[3].z * d) + (p[1].z * b + p[2].z * c)};
}
// STUB:
// END SOLUTION

Tessellation tessellate(const Patch& patch, int level) {
  // BEGIN SOLUTION
  const int n = level;
  const auto& r = patch.rows;
  Tessellation t;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const std::array<Place, 4> down{on_curve(r[0], i, n), on_curve(r[1], i, n),
                                      on_curve(r[2], i, n), on_curve(r[3], i, n)};
      t.positions.push_back(on_curve(down, j, n));
    }
  }
  const bool pole = r[0][0] == r[0][1] && r[0][1] == r[0][2] && r[0][2] == r[0][3];
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      if (j > 0 || !pole) t.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      t.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return t;
  // STUB: return {};  // (level + 1)^2 positions, and two triangles for each cell
  // END SOLUTION
}

int patch_level(const Patch& patch, double px_per_unit, double tolerance_px) {
  // BEGIN SOLUTION
  const auto& p = patch.rows;
  const auto length = [](const Vector<Object, double>& v) { return std::sqrt(dot(v, v)); };
  double muu = 0, muv = 0, mvv = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (i < 2)
        muu = std::max(muu, 6 * length((p[j][i + 2] - p[j][i + 1]) - (p[j][i + 1] - p[j][i])));
      if (j < 2)
        mvv = std::max(mvv, 6 * length((p[j + 2][i] - p[j + 1][i]) - (p[j + 1][i] - p[j][i])));
      if (i < 3 && j < 3)
        muv = std::max(muv, 9 * length((p[j + 1][i + 1] - p[j + 1][i]) - (p[j][i + 1] - p[j][i])));
    }
  }
  const double at_level_1 = (muu + 2 * muv + mvv) * px_per_unit / 8;
  int level = 1;
  while (level < 256 && !(at_level_1 <= tolerance_px * level * level)) ++level;
  return level;
  // STUB: return 0;  // cells along each side
  // END SOLUTION
}

}  // namespace lab_08
