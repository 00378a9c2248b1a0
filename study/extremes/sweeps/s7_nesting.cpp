#include <algorithm>
#include <cmath>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>

#include "study/extremes/sweep.h"

namespace glassbox::study {

namespace s7 {

template <class T>
using Matrix = Transform<Object, Object, T>;

// The matrix of level i: it turns about the three axes in rotation, alternately enlarges and
// shrinks, and moves a little.
Matrix<double> level(int i) {
  const Vector<Object, double> axis(i % 3 == 0, i % 3 == 1, i % 3 == 2);
  const double size = i % 2 == 0 ? 1.25 : 0.8;
  return rotate_degrees<Object>(axis, 7 + i % 11).value() * scale<Object>(size, size, size) *
         translate<Object>(Vector<Object, double>(0.01, -0.02, 0.005));
}

template <class T, class From>
Matrix<T> converted(const Matrix<From>& m) {
  return Matrix<T>(glm::mat<4, 4, T>(m.columns));
}

// The Frobenius norm of a matrix's linear part, and the length of its translation.
struct Sizes {
  double linear = 0, move = 0;
};
template <class T>
Sizes sizes_of(const Matrix<T>& m) {
  Sizes sizes;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      sizes.linear += double(m.at(row, column)) * double(m.at(row, column));
    }
    sizes.move += double(m.at(row, 3)) * double(m.at(row, 3));
  }
  return {std::sqrt(sizes.linear), std::sqrt(sizes.move)};
}

// Multiplies the matrices M of a chain to a product P, and bounds how far P may be from the product
// in exact arithmetic. L and t are the linear part and the translation of P, dL and dt bound their
// errors; s is the scale of the next matrix M, and m its translation. The next bounds are
//   dL' = dL s + (gamma_4 + u) |L|_F |M|_F,   dt' = dt + dL |m| + (gamma_4 + u) (|L|_F |m| + |t|),
// where the term with u (the unit roundoff) is for the rounded entries of M.
template <class T>
struct Chain {
  Matrix<T> product;
  Sizes off;

  void multiply(int i) {
    const Matrix<double> next = level(i);
    const double rounding = gamma<T>(4) + double(unit_roundoff<T>);
    const Sizes now = sizes_of(product), then = sizes_of(next);
    const double size = then.linear / std::sqrt(3.0) * (1 + 1e-15);
    off = {off.linear * size + rounding * now.linear * then.linear,
           off.move + off.linear * then.move + rounding * (now.linear * then.move + now.move)};
    product = product * converted<T>(next);
  }
};

template <class T>
double difference(const Matrix<T>& found, const Matrix<long double>& exact) {
  long double worst = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      worst = std::max(
          worst, std::abs(static_cast<long double>(found.at(row, column)) - exact.at(row, column)));
    }
  }
  return double(worst);
}

std::vector<SweepSeries> nesting_series() {
  SweepSeries ours{"composed in double, rounded once", true};
  SweepSeries in_double{"double", false}, in_float{"float", false};
  Chain<float> floats;
  Chain<double> doubles;
  Matrix<long double> exact;
  int next_shown = 1;
  for (int depth = 1; depth <= 1000; ++depth) {
    floats.multiply(depth);
    doubles.multiply(depth);
    exact = exact * converted<long double>(level(depth));
    if (depth < next_shown && depth != 1000) continue;
    next_shown = std::max(depth + 1, int(depth * 1.5));
    const auto most = [](const Sizes& sizes) { return std::max(sizes.linear, sizes.move); };
    const Sizes size = sizes_of(doubles.product);
    ours.points.push_back({double(depth), difference(converted<float>(doubles.product), exact),
                           most(doubles.off) + double(unit_roundoff<float>) * most(size)});
    in_double.points.push_back(
        {double(depth), difference(doubles.product, exact), most(doubles.off)});
    in_float.points.push_back({double(depth), difference(floats.product, exact), most(floats.off)});
  }
  return {with_limit(ours, 1e-5), with_limit(in_double, 1e-5), with_limit(in_float, 1e-5)};
}

}  // namespace s7

Sweep s7_nesting() {
  using namespace s7;
  return {.name = "nesting",
          .title = "Depth of nesting",
          .question = "How many nodes may be between a mesh and the world before it drifts away?",
          .axis = "nodes, each with a rotation, a scale and a translation",
          .error = "largest error of an entry of world_from_object (entries are about 1)",
          .reference =
              "the same products with 64 bits of mantissa, whose rounding errors are 2^-11 of "
              "those of double",
          .bound =
              "the sum of the products' rounding errors in the Frobenius norm (Higham 3.5), which "
              "grows linearly with the depth",
          .tolerance = "an error of 1e-5",
          .series = nesting_series};
}

}  // namespace glassbox::study
