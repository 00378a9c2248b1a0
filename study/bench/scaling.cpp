#include "study/bench/scaling.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "study/bench/machine.h"
#include "study/bench/memory.h"

namespace glassbox::study {

namespace {

struct Step {
  double x;
  BenchScene bench;
  EngineOptions engine;
};

std::vector<double> series(ScaledBy by) {
  switch (by) {
    case ScaledBy::kTriangles:
      return {1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7, 3e7};
    case ScaledBy::kPixels: {
      std::vector<double> all;
      for (double side = 64; side <= 16384; side *= 2) all.push_back(side * side);
      return all;
    }
    case ScaledBy::kThreads: {
      std::vector<double> all;
      for (int threads = 1; threads <= processor_count(); ++threads) all.push_back(threads);
      return all;
    }
    case ScaledBy::kTile:
      return {16, 32, 64, 128, 256};
  }
  return {};
}

// A grid of n stacks and 2 n slices has 4 n (n - 1) triangles.
EllipsoidGrid grid_of(double triangles) {
  const int stacks = int(std::lround(0.5 + std::sqrt(0.25 + triangles / 4)));
  return {stacks, 2 * stacks, 0};
}

Step step_at(ScaledBy by, double x, const ScalingOptions& options) {
  const auto scene = [&](const EllipsoidGrid& grid, int width, int height) {
    return make_ellipsoid_scene(std::string(name_of(by)), grid, width, height);
  };
  EngineOptions engine = options.measure.engine;
  switch (by) {
    case ScaledBy::kTriangles: {
      const EllipsoidGrid grid = grid_of(x);
      return {double(triangles_of(grid)), scene(grid, options.width, options.height), engine};
    }
    case ScaledBy::kPixels: {
      const int side = int(std::lround(std::sqrt(x)));
      return {x, scene(kScannedGrid, side, side), engine};
    }
    case ScaledBy::kThreads:
      engine.tile.threads = int(x);
      break;
    case ScaledBy::kTile:
      engine.tile.tile_side = int(x);
      break;
  }
  return {x, scene(kFineGrid, options.width, options.height), engine};
}

std::string what_of(ScaledBy by, const ScalingOptions& options) {
  const int threads = options.measure.engine.tile.threads;
  const std::string with = by == ScaledBy::kThreads ? ""
                           : threads == 1           ? ", 1 thread"
                                                    : fmt::format(", {} threads", threads);
  if (by == ScaledBy::kPixels) return "S2's ellipsoid in square pictures" + with;
  return fmt::format("{} at {} x {}{}", by == ScaledBy::kTriangles ? "an ellipsoid" : "S1",
                     options.width, options.height, with);
}

ScalingPoint measure_step(const Step& step, const MeasureOptions& options) {
  GlassboxPeer glassbox(step.bench, step.engine);
  std::vector<double> times;
  for (int i = 0; i < kWarmUpFrames; ++i) glassbox.frame_ms();
  for (int i = 0; i < options.frames; ++i) times.push_back(glassbox.frame_ms());
  return {step.x, quartiles(std::move(times)), peak_bytes()};
}

// Whether the next point fits into memory. It needs at most next_x / last.x times the memory of the
// last point, because only a part of the memory grows with x.
bool fits(const ScalingPoint& last, double next_x) {
  const double available = available_bytes();
  return available == 0 || last.peak_bytes * next_x / last.x < 0.8 * available;
}

bool grows_memory(ScaledBy by) {
  return by == ScaledBy::kTriangles || by == ScaledBy::kPixels;
}

void conclude(Scaling& scaling) {
  const std::vector<ScalingPoint>& points = scaling.points;
  if (points.size() < 2) return;
  std::vector<Sample> samples;
  for (const ScalingPoint& point : points) samples.push_back({point.x, point.ms.median});
  if (samples.size() < kMinFitted) {
    scaling.ratios = {samples[1].x / samples[0].x, samples[1].y / samples[0].y};
  } else {
    scaling.law = fit_power_law(samples);
    scaling.bend = find_bend(samples);
  }
  if (scaling.by != ScaledBy::kTriangles || points.back().peak_bytes == 0) return;
  scaling.bytes_per_triangle =
      (points.back().peak_bytes - points.front().peak_bytes) / (points.back().x - points.front().x);
}

}  // namespace

std::string_view name_of(ScaledBy by) {
  switch (by) {
    case ScaledBy::kTriangles:
      return "triangles";
    case ScaledBy::kPixels:
      return "pixels";
    case ScaledBy::kThreads:
      return "threads";
    case ScaledBy::kTile:
      return "tile";
  }
  return "";
}

Scaling measure_scaling(ScaledBy by, const ScalingOptions& options,
                        const std::function<void(double)>& at) {
  Scaling scaling;
  scaling.by = by;
  scaling.what = what_of(by, options);
  for (const double x : series(by)) {
    if (options.most > 0 && x > options.most) break;
    if (grows_memory(by) && !scaling.points.empty() && !fits(scaling.points.back(), x)) {
      scaling.stopped = fmt::format("{:.3g} {} do not fit into memory", x, name_of(by));
      break;
    }
    if (at) at(x);
    reset_peak_bytes();
    scaling.points.push_back(measure_step(step_at(by, x, options), options.measure));
  }
  conclude(scaling);
  return scaling;
}

}  // namespace glassbox::study
