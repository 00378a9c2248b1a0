// Lab 14: the surface of a solid, its polygons in pictures, the views around an eye, and principal
// components of pixels with many bands. The contracts of the seven functions that you write in
// student.cpp. u = 2^-53 is the unit roundoff of double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace lab_14 {

// ---- a cell ----

// The number of a cell's corner: bit 0 is its x, bit 1 its y, bit 2 its z. The edges of a cell,
// each from the corner whose number has fewer bits set:
inline constexpr std::array<std::array<int, 2>, 12> kEdges{{{0, 1},
                                                            {2, 3},
                                                            {4, 5},
                                                            {6, 7},  // along x
                                                            {0, 2},
                                                            {1, 3},
                                                            {4, 6},
                                                            {5, 7},  // along y
                                                            {0, 4},
                                                            {1, 5},
                                                            {2, 6},
                                                            {3, 7}}};  // along z
// The faces of a cell, corners counter-clockwise seen from outside the cell.
inline constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

// Task 14.1. The polygons of the surface in a cell. A polygon is a list of the edges that its
// corners are on. Bit c of `inside` says that corner c is inside. Around a face, counter-clockwise,
// a run of inside corners begins on one edge and ends on another; the surface passes along the face
// from the edge where a run begins to the edge where the same run ends. So inside corners that are
// diagonally opposite are cut off one by one, in both cells that have this face. The lines on all
// faces form closed polygons, counter-clockwise seen from the outside of the solid. Each is listed
// from its edge of lowest number, and the polygons are in the order of those edges. Exact.
std::vector<std::vector<int>> cell_polygons(unsigned inside);

// Task 14.2. Where on an edge the surface is, as a fraction of the edge's length from its first
// end. `from` and `to` are the values at the ends; one is at least the level (inside) and the other
// below it. The answer is where the linear interpolation between these values is equal to the
// level, but at least kMinStep away from both ends (C-96). A value outside the lattice is minus
// infinity; then the answer is one half. All other values, and the level, have magnitudes of at
// most 2^1001. Error bound: 8 u of the answer.
inline constexpr double kMinStep = 0x1p-10;
double crossing(double from, double to, double level);

// ---- layered images of ids ----

struct Sample {
  double distance = 0;
  int id = 0;
};
// The samples of each pixel, the nearest first; among equally near samples the one of lower id
// first.
using Layers = std::vector<std::vector<Sample>>;

// One pixel that a polygon covers, and the polygon's distance there. A polygon covers each pixel at
// most once.
struct Covered {
  std::size_t pixel = 0;
  double distance = 0;
};

// Task 14.3. Adds a polygon to the layers, or removes it. Nothing else of the layers changes. An id
// is added only if it is not there. A polygon that is removed covers what it covered when it was
// added; removing an id that is not there changes nothing. Exact.
void add(Layers& layers, int id, const std::vector<Covered>& covered);
void remove(Layers& layers, int id, const std::vector<Covered>& covered);

// ---- views around an eye ----

using Vector = std::array<double, 3>;

// Task 14.4. The weights of three views in the view from another eye. Solves direction = w0
// views[0] + w1 views[1] + w2 views[2]. A negative weight (of a direction outside the triangle)
// becomes 0, and so does the weight of a view that does not see the polygon. The three weights are
// then divided by their sum. If the sum is 0, the view that sees the polygon and has the smallest
// angle to the direction gets the weight 1, the first among equally near ones; if none sees it, all
// weights are 0. Vectors are of unit length up to rounding. Error bound of each weight: 64 u /
// (|det(views)| s), where s is that sum, or 1 if the sum is larger; exact if the sum is 0. Whether
// the sum is 0, and which of two views is nearer, does not depend on rounding.
std::array<double, 3> view_weights(const Vector& direction, const std::array<Vector, 3>& views,
                                   const std::array<bool, 3>& sees);

// ---- components of many bands (KLT) ----

using Pixels = std::vector<std::vector<double>>;  // for each pixel the values of its bands
using Matrix = std::vector<std::vector<double>>;  // rows

// Task 14.5. The mean of the pixels, and their covariance: entry (i, j) is the mean of (x_i -
// m_i)(x_j - m_j), where x_i is band i of a pixel and m_i the mean of that band. Values may be
// large compared with their differences.
// Error bound of a mean: 2 n u of the largest absolute value, for n pixels; of an entry: 8 n u of
// the largest entry on the diagonal, plus 4 (n u times the largest absolute value)^2. There is at
// least one pixel.
struct Statistics {
  std::vector<double> mean;
  Matrix covariance;
};
Statistics statistics(const Pixels& pixels);

// Task 14.6. The pixels approximated by k components: pixel x becomes x' = mean + sum over the
// first k vectors v of (v . (x - mean)) v. The vectors are the eigenvectors of the covariance, of
// unit length, largest eigenvalue first. `error` is the mean of |x - x'|^2 over the pixels.
// Error bound of the pixels: 64 u d + (k + 2) u of the largest absolute value, where d is the
// largest |x - mean| of a pixel; of the error: 256 u of the mean of |x - mean|^2, plus r (2 d + r),
// where r is the first bound times the root of the number of bands.
struct Reconstruction {
  Pixels pixels;
  double error = 0;
};
Reconstruction reconstruct(const Pixels& pixels, const std::vector<double>& mean,
                           const Matrix& vectors, std::size_t k);

// Given: eigenvalues and eigenvectors of a symmetric matrix by Jacobi rotations, largest eigenvalue
// first.
struct Eigen {
  std::vector<double> values;
  Matrix vectors;
};
inline Eigen eigen_of(Matrix a) {
  const std::size_t n = a.size();
  Matrix v(n, std::vector<double>(n, 0));
  for (std::size_t i = 0; i < n; ++i) v[i][i] = 1;  // its rows become the eigenvectors
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (std::size_t k = 0; k < n; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          const double vp = v[p][k], vq = v[q][k];
          v[p][k] = c * vp - s * vq;
          v[q][k] = s * vp + c * vq;
        }
      }
    }
  }
  std::vector<std::pair<double, std::vector<double>>> pairs;
  for (std::size_t i = 0; i < n; ++i) pairs.emplace_back(a[i][i], v[i]);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  Eigen eigen;
  for (auto& [value, vector] : pairs) {
    eigen.values.push_back(value);
    eigen.vectors.push_back(std::move(vector));
  }
  return eigen;
}

}  // namespace lab_14
