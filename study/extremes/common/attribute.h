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

// The exact attribute: sum E_k q_k a_k / sum E_k q_k, with the edge functions E_k, the given q_k =
// 1/w and the attributes a_k at the vertices. All E_k q_k are positive, so it is right to a
// relative error of 2^-60.
struct ExactAttribute {
  long double value = 0;
  std::array<long double, 3> weights{};
};
ExactAttribute exact_attribute(const TriangleSetup& setup, const Coverage& pixel,
                               const std::array<float, 3>& values);

// The bound 13 u (w1 |a1 - a0| + w2 |a2 - a0|) + u |a|, see raster/interpolate.h: a0, a1, a2 are
// the values at the vertices, w1 and w2 weights, a is the attribute, and u the unit roundoff,
// 2^-24.
double attribute_bound(const ExactAttribute& exact, const std::array<float, 3>& values);

struct AttributeTriangle {
  ScreenTriangle triangle;
  std::array<float, 3> values{};  // at the vertices, in their original order
};
// The worst error of an attribute over all pixels of a triangle, each with its own bound: the error
// that is nearest to its bound, or the largest error if some exceed their bounds. `scale` converts
// the attribute's unit to that of the case.
Outcome measure_attribute_error(const AttributeAt& at, const AttributeTriangle& judged, int side,
                                double scale);

// Projects a point in eye space to the screen of a view.
ScreenVertex project(const View& view, const Point<Eye>& eye);

}  // namespace glassbox::study
