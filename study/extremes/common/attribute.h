// Measures the errors of attributes that are interpolated over a triangle.
#pragma once

#include <array>
#include <functional>

#include <glassbox/pipeline/view.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/common/coverage.h"

namespace glassbox::study {

// Computes an attribute at a pixel from its values at the vertices, which are in the order of the
// setup.
using AttributeAt =
    std::function<float(const TriangleSetup&, const Coverage&, const std::array<float, 3>&)>;
float pipeline_attribute(const TriangleSetup& setup, const Coverage& pixel,
                         const std::array<float, 3>& values);

// sum E_k q_k a_k / sum E_k q_k with the given q = 1/w: a quotient of sums of positive numbers,
// right to 2^-60 relative.
struct ExactAttribute {
  long double value = 0;
  std::array<long double, 3> weights{};
};
ExactAttribute exact_attribute(const TriangleSetup& setup, const Coverage& pixel,
                               const std::array<float, 3>& values);

// The bound 13 u (w1 |a1 - a0| + w2 |a2 - a0|) + u |a|, see raster/interpolate.h.
double attribute_bound(const ExactAttribute& exact, const std::array<float, 3>& values);

// The worst of all pixels of a picture, each with its own bound: the error that is nearest to its
// bound, or the largest error if some exceed their bounds. `scale` converts the attribute's unit to
// that of the case.
struct AttributeTriangle {
  ScreenTriangle triangle;
  std::array<float, 3> values{};  // at the vertices, in their original order
};
Outcome measure_attribute_error(const AttributeAt& at, const AttributeTriangle& judged, int side,
                                double scale);

// Projects a point in eye space to the screen of a view.
ScreenVertex project(const View& view, const Point<Eye>& eye);

}  // namespace glassbox::study
