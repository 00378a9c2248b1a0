// Measures the errors of depths: from a distance to a code of the depth buffer, over a triangle,
// and which triangle is visible.
#pragma once

#include <functional>
#include <vector>

#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/common/coverage.h"

namespace glassbox::study {

// ---- along the gaze ----

// How a distance becomes a depth code: with the float matrix for the near and far planes, the
// divide, and the depth format.
struct DepthPath {
  DepthFormat format = DepthFormat::kFloat32;
  double near = 0.1, far = 1e4;
  enum Detour { kNone, kThroughGl, kSubtracted } detour = kNone;
};
std::function<std::uint32_t(float distance)> depth_codes(const DepthPath& path);

// The largest relative separation, near `distance`, of two distances whose depth codes are in the
// wrong order. Tests 200 pairs for each separation from 2^-8 to 2^5 times `around`; 0 if no pair is
// in the wrong order.
double coarsest_confused(const DepthPath& path, double distance, double around);

// The relative separation r at the distance z that corresponds to one step of the standard depth
// range (`step` is 2^-bits): r = s z/(1 - s z) with s = step (f - n)/(n f), for the planes at n and
// f. It is infinite if s z is 1 or more. For float, steps are 2^-24 below 1 (B.3).
double standard_separation(double distance, double near, double far, double step);

// The depth code that a run stores for a rectangle at right angles to the gaze, at this distance.
std::uint32_t pane_code_drawn(const TestedEngine& engine, double near, double far,
                              DepthFormat format, float distance);
// The depth that belongs to a code of the reversed float format.
float depth_of_reversed_code(std::uint32_t code);

// ---- over a triangle ----

using DepthAt = std::function<float(const TriangleSetup&, const Coverage&)>;
float pipeline_depth(const TriangleSetup& setup, const Coverage& pixel);

// The exact depth of a triangle at a pixel: sum E_k d_k / sum E_k, with the edge functions E_k and
// the depths d_k of the vertices. The E_k are integers up to 2^52 and all terms are positive, so it
// is right to a relative error of 2^-60.
long double exact_depth(const TriangleSetup& setup, const Coverage& pixel);

// ---- what is visible ----

struct ZBuffer {
  DepthAt depth = pipeline_depth;
  DepthFormat format = DepthFormat::kFloat32;
  bool (*passes)(std::uint32_t incoming, std::uint32_t stored) = in_front;
};

// The number of the triangle that each pixel shows, counted from 1; 0 if it shows none.
Image<int> z_buffered(const std::vector<ScreenTriangle>& triangles, int side,
                      const ZBuffer& buffer);
// The triangle that each pixel shows, counted from 1, as a complete run of an engine draws it: all
// triangles in one draw, or each in a draw of its own.
enum class DrawGrouping { kOne, kEach };
Image<int> visible_triangles(const TestedEngine& engine,
                             const std::vector<ScreenTriangle>& triangles, int side,
                             DrawGrouping draws = DrawGrouping::kOne);

// Compares the depths that a run stores with the exact depth of the triangle that each pixel shows,
// in units of 2^-24 of that depth.
using ExactDepthAt = std::function<long double(int x, int y, std::size_t triangle)>;
Outcome measure_depth_error(const TestedEngine& engine,
                            const std::vector<ScreenTriangle>& triangles, int side,
                            double roundoffs, const ExactDepthAt& exact);

}  // namespace glassbox::study
