// What is interpolated over a triangle, under judgement.
#pragma once

#include <array>
#include <functional>

#include <glassbox/pipeline/view.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/kit/coverage.h"

namespace glassbox::study {

// An attribute at a pixel from its values at the vertices, in the order of the setup.
using AttributeAt =
    std::function<float(const TriangleSetup&, const Coverage&, const std::array<float, 3>&)>;
float pipeline_attribute(const TriangleSetup& setup, const Coverage& pixel,
                         const std::array<float, 3>& values);

// sum E_k q_k a_k / sum E_k q_k with q = 1/w as given: a quotient of sums of positive numbers, 2^-60 relative.
struct ExactAttribute {
  long double value = 0;
  std::array<long double, 3> weights{};
};
ExactAttribute exact_attribute(const TriangleSetup& setup, const Coverage& pixel,
                               const std::array<float, 3>& values);

// 13 u (w1 |a1 - a0| + w2 |a2 - a0|) + u |a|: raster/interpolate.h.
double attribute_bound(const ExactAttribute& exact, const std::array<float, 3>& values);

// The worst over all pixels of a picture, each with its own bound: the one nearest to its bound, or the largest error where
// one is beyond; `scale` turns the attribute's unit into that of the case.
struct JudgedTriangle {
  ScreenTriangle triangle;
  std::array<float, 3> values{};  // at its vertices as they come
};
Outcome judge_attribute(const AttributeAt& at, const JudgedTriangle& judged, int side,
                        double scale);

// Points in eye space seen through a view, where they lie on its screen.
ScreenVertex project(const View& view, const Point<Eye>& eye);

}  // namespace glassbox::study
