#include "views/layers/ray_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

#include "views/layers/layer_builder.h"
#include "views/layers/ray_surfaces.h"

namespace glassbox::views {

namespace {

constexpr int kTasksAtATime = 64;

struct SeenHit {
  std::uint16_t x, y;
  float depth;
  Rgba8 color;
  std::uint32_t from_centre;  // of the pixel: 2^20 times the distance's square, in pixels
};

struct TaskHits {
  std::vector<SeenHit> seen;
  std::uint64_t followed = 0;
};

// All rays that start in one of the face's squares.
class RayTask {
public:
  RayTask(const RaySurfaces& surfaces, const View& view, const RaySampling& sampling)
      : surfaces_(surfaces), view_(view), sampling_(sampling) {
    View at_eye = view;
    at_eye.eye_from_world = {};
    camera_ = layer_camera(at_eye);
  }

  void run(int square, TaskHits& into) const {
    const int n = sampling_.strata;
    into.seen.clear();
    into.followed = 0;
    for (int k = 0; k < n; ++k) {
      for (int l = 0; l < n; ++l) {
        const std::array<int, 4> stratum{square / n, square % n, k, l};
        Random random = random_of(stratum, n);
        for (int i = 0; i < sampling_.rays; ++i)
          cast(ray_of(numbers_in(stratum, n, random), sampling_.half_side), into);
      }
    }
  }

private:
  // How far a part of the ray reaches that lies in what the picture shows: between the planes through its edges, and those of the view.
  // Below 0 where there is none.
  double last_seen(const Ray& ray) const {
    const Eigen::Vector4d start =
        camera_.screen_from_world * ray.origin.cast<double>().homogeneous();
    const Eigen::Vector4d step = camera_.screen_from_world.leftCols<3>() * ray.direction;
    double from = 0, to = std::numeric_limits<double>::infinity();
    // Where a + t b is not below 0.
    const auto keep = [&](double a, double b) {
      if (b > 0) from = std::max(from, -a / b);
      if (b < 0) to = std::min(to, -a / b);
      if (b == 0 && a < 0) to = -1;
    };
    keep(start.x(), step.x());
    keep(camera_.width * start.w() - start.x(), camera_.width * step.w() - step.x());
    keep(start.y(), step.y());
    keep(camera_.height * start.w() - start.y(), camera_.height * step.w() - step.y());
    keep(start.w() - view_.near, step.w());  // w is the distance along the gaze
    if (std::isfinite(view_.far)) keep(view_.far - start.w(), -step.w());
    return from <= to ? to : -1;
  }

  void cast(const Ray& ray, TaskHits& into) const {
    const double last = last_seen(ray);
    if (last < 0) return;
    ++into.followed;
    const auto hit = surfaces_.caster().cast(
        ray, [&](const RayHit& candidate) { return surfaces_.shows(candidate); }, last);
    if (!hit) return;
    const Eigen::Vector3d at = surfaces_.caster().place(*hit);
    const Eigen::Vector4d there = camera_.screen_from_world * at.homogeneous();
    const double x = there.x() / there.w(), y = there.y() / there.w();
    const bool in_picture = x >= 0 && x < camera_.width && y >= 0 && y < camera_.height;
    const bool in_depth = -at.z() >= view_.near && -at.z() <= view_.far;
    if (!in_picture || !in_depth) return;
    const double right = x - std::floor(x) - 0.5, down = y - std::floor(y) - 0.5;
    into.seen.push_back({std::uint16_t(x), std::uint16_t(y), float(there.z() / there.w()),
                         surfaces_.color(*hit),
                         std::uint32_t(0x1p20 * (right * right + down * down))});
  }

  const RaySurfaces& surfaces_;
  const View& view_;
  const RaySampling& sampling_;
  LayerCamera camera_;
};

}  // namespace

Ray ray_of(const std::array<double, 4>& numbers, double half_side) {
  // A disc's points, uniform in area, lifted to the hemisphere: the projected solid angle is the area (Malley's method).
  const double radius = std::sqrt(numbers[2]);
  const SinCos turn = sin_cos(2 * kPi * numbers[3]);
  const double across_x = half_side * (2 * numbers[0] - 1),
               across_y = half_side * (2 * numbers[1] - 1);
  return {{float(across_x), float(across_y), float(-half_side)},
          {radius * turn.cos, radius * turn.sin, -std::sqrt(1 - numbers[2])}};
}

std::array<double, 4> numbers_in(const std::array<int, 4>& stratum, int strata, Random& random) {
  std::array<double, 4> numbers;
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = (stratum[i] + random.unit()) / strata;
  return numbers;
}

Random random_of(const std::array<int, 4>& stratum, int strata) {
  std::uint64_t number = 0;
  for (const int i : stratum) number = number * std::uint64_t(strata) + std::uint64_t(i);
  return Random(Random(number).bits());
}

LayeredImage build_layers_by_rays(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const RaySampling& sampling,
                                  double epsilon, RayCounts& counts) {
  const RaySurfaces surfaces(scene, view, settings);
  const RayTask task(surfaces, view, sampling);
  LayerBuilder builder(layer_camera(view), epsilon);
  tbb::task_arena arena(sampling.threads);
  std::vector<TaskHits> hits(kTasksAtATime);
  const int squares = sampling.strata * sampling.strata;
  for (int first = 0; first < squares; first += kTasksAtATime) {
    const int some = std::min(kTasksAtATime, squares - first);
    arena.execute([&] {
      tbb::parallel_for(0, some, [&](int i) { task.run(first + i, hits[std::size_t(i)]); });
    });
    for (int i = 0; i < some; ++i) {
      const TaskHits& here = hits[std::size_t(i)];
      counts.followed += here.followed;
      counts.hits += here.seen.size();
      for (const SeenHit& hit : here.seen)
        builder.add(hit.x, hit.y, hit.depth, hit.color, hit.from_centre);
    }
  }
  return builder.pack();
}

}  // namespace glassbox::views
