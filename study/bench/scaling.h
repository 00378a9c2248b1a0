// Measures how the time of a frame grows with the size of the work.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/bench/measure.h"
#include "study/bench/statistics.h"

namespace glassbox::study {

enum class ScaledBy { kTriangles, kPixels, kThreads, kTile };

std::string_view name_of(ScaledBy by);  // for example "triangles"

struct ScalingPoint {
  double x = 0;  // triangles, pixels, threads, or the side of a tile in pixels
  Quartiles ms;
  double peak_bytes = 0;  // peak memory of the process, including the scene
};

// The values at the second of two points divided by the values at the first.
struct GrowthRatios {
  double x = 0, ms = 0;
};

struct Scaling {
  ScaledBy by = ScaledBy::kTriangles;
  std::string what;  // for example "an ellipsoid at 1920 x 1080"
  std::vector<ScalingPoint> points;
  std::optional<GrowthRatios> ratios;  // only if there are exactly two points
  std::optional<PowerLaw> law;         // only if there are three points or more
  std::optional<Bend> bend;
  // memory for each additional triangle, from the smallest number of triangles to the largest
  std::optional<double> bytes_per_triangle;
  std::string stopped;  // why the series ends early; empty if it is complete
};

struct ScalingOptions {
  MeasureOptions measure;
  int width = 1920, height = 1080;  // ignored for kPixels, whose pictures are square
  double most = 0;                  // the largest x; 0: the whole series
};

// The series go from 1000 to 30 million triangles, from 64 x 64 to 16384 x 16384 pixels, from 1
// thread to the number of processors, and from tiles of 16 pixels to tiles of 256. A series ends
// early if the next point would need more than the free memory. `at` is called with x before each
// point.
Scaling measure_scaling(ScaledBy by, const ScalingOptions& options,
                        const std::function<void(double)>& at = {});

}  // namespace glassbox::study
