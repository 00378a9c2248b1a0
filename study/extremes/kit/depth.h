// Depths under judgement: from a distance to a code of the depth buffer, over a triangle, and which triangle is seen.
#pragma once

#include <functional>
#include <vector>

#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>

#include "study/extremes/kit/coverage.h"

namespace glassbox::study {

// ---- along the gaze ----

// The way from a distance to a code: the matrix for the planes, in float, the divide, the format.
struct DepthPath {
  DepthFormat format = DepthFormat::kFloat32;
  double near = 0.1, far = 1e4;
  enum Detour { kNone, kThroughGl, kSubtracted } detour = kNone;
};
std::function<std::uint32_t(float distance)> depth_codes(const DepthPath& path);

// The largest relative separation near `distance` of two depths whose codes are not in order, looking at those of about
// `around` (from 2^-8 to 2^5 times it), 200 pairs each; 0 where none is confused.
double coarsest_confused(const DepthPath& path, double distance, double around);

// What a step of 2^-bits of the standard range amounts to at this distance, relative: r = s z/(1 - s z) with s = step (f -
// n)/(n f); infinite beyond. For float, steps of 2^-24 below 1 (SPEC B.3).
double standard_separation(double distance, double near, double far, double step);

// The code that a run keeps of a pane across the gaze at this distance.
std::uint32_t pane_code_drawn(const Drawer& drawer, double near, double far, DepthFormat format,
                              float distance);
// What the code of reversed float stands for.
float depth_of_reversed_code(std::uint32_t code);

// ---- over a triangle ----

using DepthAt = std::function<float(const TriangleSetup&, const Coverage&)>;
float pipeline_depth(const TriangleSetup& setup, const Coverage& pixel);

// sum E_k d_k / sum E_k: whole numbers up to 2^52 times floats, no cancellation; 2^-60 relative.
long double exact_depth(const TriangleSetup& setup, const Coverage& pixel);

// ---- what is seen ----

struct ZBuffer {
  DepthAt depth = pipeline_depth;
  DepthFormat format = DepthFormat::kFloat32;
  bool (*passes)(std::uint32_t incoming, std::uint32_t stored) = in_front;
};

// 1 + the number of the triangle that each pixel shows; 0: none.
Image<int> z_buffered(const std::vector<ScreenTriangle>& triangles, int side,
                      const ZBuffer& buffer);
// The same where a whole run draws them: as one draw, or each as a draw of its own.
enum class Draws { kOne, kEach };
Image<int> shown_by(const Drawer& drawer, const std::vector<ScreenTriangle>& triangles, int side,
                    Draws draws = Draws::kOne);

// The depths that a run leaves, each against the exact one of the triangle that the pixel shows, in units of 2^-24 of it.
using ExactDepthAt = std::function<long double(int x, int y, std::size_t triangle)>;
Outcome judge_depths(const Drawer& drawer, const std::vector<ScreenTriangle>& triangles, int side,
                     double roundoffs, const ExactDepthAt& exact);

}  // namespace glassbox::study
