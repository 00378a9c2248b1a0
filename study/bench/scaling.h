// How the time of a frame grows.
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

std::string_view name_of(ScaledBy by);  // "triangles"

struct ScalingPoint {
  double x = 0;  // triangles, pixels, threads, or pixels of a tile's side
  Quartiles ms;
  double peak_bytes = 0;  // the most memory that the process had, scene included
};

// From the first of two points to the second.
struct GrowthRatios {
  double x = 0, ms = 0;
};

struct Scaling {
  ScaledBy by = ScaledBy::kTriangles;
  std::string what;  // "an ellipsoid at 1920 x 1080"
  std::vector<ScalingPoint> points;
  std::optional<GrowthRatios> ratios;  // of two points
  std::optional<PowerLaw> law;         // of three points or more
  std::optional<Bend> bend;
  std::optional<double> bytes_per_triangle;  // from the least number of triangles to the greatest
  std::string stopped;                       // why the series ends early, empty where it does not
};

struct ScalingOptions {
  MeasureOptions measure;
  int width = 1920, height = 1080;  // not of kPixels, whose pictures are square
  double most = 0;                  // of x; 0: the whole series
};

// 1000 to 30 million triangles; 64 x 64 to 16384 x 16384 pixels; 1 thread to as many as there are processors; tiles of
// 16 to 256 pixels. A series ends where the next point would need more than the memory that is free. `at` is told x before
// each point.
Scaling measure_scaling(ScaledBy by, const ScalingOptions& options,
                        const std::function<void(double)>& at = {});

}  // namespace glassbox::study
