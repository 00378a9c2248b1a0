#include "views/layers/ray_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <Eigen/Geometry>

#include <glassbox/base/trig.h>
#include <glassbox/render/engine/threads.h>

#include "views/layers/ray_surfaces.h"
#include "views/layers/triangle_normals.h"

namespace glassbox::views {

namespace {

constexpr std::size_t kPartsAtATime = 64;

struct VisibleHit {
  std::uint16_t x, y;
  float depth;
  Rgba8 color;
  std::uint32_t from_centre;  // squared distance from the pixel's centre, in pixels, times 2^20
  std::uint32_t triangle;
};

struct PartHits {
  std::vector<VisibleHit> seen;
  std::uint64_t followed = 0;
};

// Casts the rays of a part.
class RayTask {
public:
  RayTask(const RaySurfaces& surfaces, const View& view, const RaySampling& sampling)
      : surfaces_(surfaces), view_(view), sampling_(sampling) {
    View at_eye = view;
    at_eye.eye_from_world = {};
    camera_ = layer_camera(at_eye);
  }

  void run(const RayPart& part, PartHits& into) const {
    const int n = sampling_.strata;
    into.seen.clear();
    into.followed = 0;
    for (std::uint64_t s = 0; s < part.strata; ++s) {
      const std::array<int, 4> stratum = stratum_of(part.stratum + s, n);
      Random random = s == 0 ? part.random : stratum_random(stratum, n);
      for (int i = 0; i < part.rays; ++i)
        cast(ray_of(stratified_numbers(stratum, n, random), sampling_.half_side), into);
    }
  }

private:
  // The distance along the ray up to which the picture can show something: that of the ray's last
  // point inside the view frustum. Below 0 if no part of the ray is inside.
  double last_seen(const Ray& ray) const {
    const Eigen::Vector4d start =
        camera_.screen_from_world * ray.origin.cast<double>().homogeneous();
    const Eigen::Vector4d step = camera_.screen_from_world.leftCols<3>() * ray.direction;
    double from = 0, to = std::numeric_limits<double>::infinity();
    // Limits the interval [from, to] to the distances t with a + t b >= 0.
    const auto keep = [&](double a, double b) {
      if (b > 0) from = std::max(from, -a / b);
      if (b < 0) to = std::min(to, -a / b);
      if (b == 0 && a < 0) to = -1;
    };
    keep(start.x(), step.x());
    keep(camera_.width * start.w() - start.x(), camera_.width * step.w() - step.x());
    keep(start.y(), step.y());
    keep(camera_.height * start.w() - start.y(), camera_.height * step.w() - step.y());
    keep(start.w() - view_.near, step.w());  // w is the distance along the direction of view
    if (std::isfinite(view_.far)) keep(view_.far - start.w(), -step.w());
    return from <= to ? to : -1;
  }

  void cast(const Ray& ray, PartHits& into) const {
    const double last = last_seen(ray);
    if (last < 0) return;
    ++into.followed;
    const auto hit = surfaces_.caster().cast(
        ray, [&](const RayHit& candidate) { return surfaces_.is_drawn_at(candidate); }, last);
    if (!hit) return;
    const Eigen::Vector3d at = surfaces_.caster().hit_point(*hit);
    const Eigen::Vector4d there = camera_.screen_from_world * at.homogeneous();
    const double x = there.x() / there.w(), y = there.y() / there.w();
    const bool in_picture = x >= 0 && x < camera_.width && y >= 0 && y < camera_.height;
    const bool in_depth = -at.z() >= view_.near && -at.z() <= view_.far;
    if (!in_picture || !in_depth) return;
    const double right = x - std::floor(x) - 0.5, down = y - std::floor(y) - 0.5;
    into.seen.push_back(
        {std::uint16_t(x), std::uint16_t(y), float(there.z() / there.w()), surfaces_.color(*hit),
         std::uint32_t(0x1p20 * (right * right + down * down)), surfaces_.number(*hit)});
  }

  const RaySurfaces& surfaces_;
  const View& view_;
  const RaySampling& sampling_;
  LayerCamera camera_;
};

}  // namespace

Ray ray_of(const std::array<double, 4>& numbers, double half_side) {
  // Malley's method: uniform points of a disc are projected up to the hemisphere. The density of
  // the directions is then the cosine of their angle to the axis, because an area on the disc is a
  // projected solid angle.
  const double radius = std::sqrt(numbers[2]);
  const SinCos turn = sin_cos(2 * kPi * numbers[3]);
  const double across_x = half_side * (2 * numbers[0] - 1),
               across_y = half_side * (2 * numbers[1] - 1);
  return {{float(across_x), float(across_y), float(-half_side)},
          {radius * turn.cos, radius * turn.sin, -std::sqrt(1 - numbers[2])}};
}

std::array<double, 4> stratified_numbers(const std::array<int, 4>& stratum, int strata,
                                         Random& random) {
  std::array<double, 4> numbers;
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = (stratum[i] + random.unit()) / strata;
  return numbers;
}

Random stratum_random(const std::array<int, 4>& stratum, int strata) {
  std::uint64_t number = 0;
  for (const int i : stratum) number = number * std::uint64_t(strata) + std::uint64_t(i);
  return Random(Random(number).bits());
}

std::array<int, 4> stratum_of(std::uint64_t number, int strata) {
  std::array<int, 4> stratum{};
  for (std::size_t i = 4; i-- > 0; number /= std::uint64_t(strata))
    stratum[i] = int(number % std::uint64_t(strata));
  return stratum;
}

RayParts::RayParts(const RaySampling& sampling)
    : sampling_(sampling),
      all_(sampling.count() / std::uint64_t(sampling.rays)),
      random_(random_here()) {}

Random RayParts::random_here() const {
  return stratum_random(stratum_of(stratum_, sampling_.strata), sampling_.strata);
}

std::optional<RayPart> RayParts::next() {
  if (stratum_ == all_) return std::nullopt;
  return sampling_.rays <= kRaysOfPart ? whole_strata() : some_of_a_stratum();
}

RayPart RayParts::whole_strata() {
  const std::uint64_t some = std::min(std::uint64_t(kRaysOfPart / sampling_.rays), all_ - stratum_);
  const RayPart part{stratum_, some, sampling_.rays, random_here()};
  stratum_ += some;
  return part;
}

RayPart RayParts::some_of_a_stratum() {
  const RayPart part{stratum_, 1, std::min(kRaysOfPart, sampling_.rays - done_), random_};
  const std::array<int, 4> stratum = stratum_of(stratum_, sampling_.strata);
  for (int i = 0; i < part.rays; ++i) stratified_numbers(stratum, sampling_.strata, random_);
  done_ += part.rays;
  if (done_ == sampling_.rays) {
    done_ = 0;
    ++stratum_;
    random_ = random_here();
  }
  return part;
}

LayeredImage build_layers_by_rays(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const RaySampling& sampling,
                                  double epsilon, RayCounts& counts,
                                  const WantedAttributes& wanted) {
  const RaySurfaces surfaces(scene, view, settings);
  const RayTask task(surfaces, view, sampling);
  LayerBuilder builder(layer_camera(view), epsilon, wanted);
  const std::vector<SampleNormal> normals =
      wanted.normals ? triangle_normals(scene) : std::vector<SampleNormal>();
  allow_threads(sampling.threads);
  tbb::task_arena arena(sampling.threads);
  RayParts left(sampling);
  std::vector<RayPart> parts;
  std::vector<PartHits> hits(kPartsAtATime);
  while (true) {
    parts.clear();
    while (parts.size() < kPartsAtATime) {
      const std::optional<RayPart> part = left.next();
      if (!part) break;
      parts.push_back(*part);
    }
    if (parts.empty()) break;
    arena.execute([&] {
      tbb::parallel_for(std::size_t(0), parts.size(),
                        [&](std::size_t i) { task.run(parts[i], hits[i]); });
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PartHits& here = hits[i];
      counts.followed += here.followed;
      counts.hits += here.seen.size();
      for (const VisibleHit& hit : here.seen)
        builder.add(
            hit.x, hit.y, hit.depth, hit.color, hit.from_centre,
            {hit.triangle < normals.size() ? normals[hit.triangle] : SampleNormal(), hit.triangle});
    }
  }
  return builder.pack();
}

}  // namespace glassbox::views
