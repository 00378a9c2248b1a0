#include <glassbox/render/trace/depth_fights.h>

#include <algorithm>
#include <cmath>

#include <glassbox/mesh/triangulate.h>
#include <glassbox/render/engine/distance.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/numbering.h>

namespace glassbox {

namespace {

// ---- corners in common ----

// The corners of the triangles of a mesh in the world. The triangulation is made once for a mesh.
class WorldCorners {
public:
  explicit WorldCorners(const Scene& scene) : scene_(scene) {
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      first_.push_back(count_);
      count_ += count_triangles(scene, i);
    }
  }

  bool have_common_corner(std::uint32_t a, std::uint32_t b) {
    const auto of_a = of(a), of_b = of(b);
    return std::ranges::any_of(of_a, [&](const Point<World, double>& p) {
      return std::ranges::find(of_b, p) != of_b.end();
    });
  }

private:
  std::vector<Point<World, double>> of(std::uint32_t number) {
    const auto after = std::ranges::upper_bound(first_, number);
    const std::size_t i = std::size_t(after - first_.begin()) - 1;
    const Instance& instance = scene_.instances[i];
    const Mesh& mesh = scene_.meshes[instance.mesh];
    auto [at, is_new] = triangulations_.try_emplace(instance.mesh);
    if (is_new) at->second = triangulate(mesh);
    const auto& triangles = at->second.triangles;
    const auto found = std::ranges::lower_bound(triangles, std::uint32_t(number - first_[i]), {},
                                                &Triangle::number);
    std::vector<Point<World, double>> corners;
    for (const std::uint32_t corner : found->corners) {
      const Point<Object>& p = mesh.positions[mesh.corners[corner].position];
      corners.push_back(scene_.nodes[instance.node].world_from_node *
                        Point<Object, double>(double(p.x), double(p.y), double(p.z)));
    }
    return corners;
  }

  const Scene& scene_;
  std::uint64_t count_ = 0;
  std::vector<std::uint64_t> first_;  // by instance: the number of its first triangle
  std::map<std::uint32_t, Triangulation> triangulations_;
};

// ---- how fine depth is ----

// The distance that a small change of depth stands for at distance d, if the near plane were at
// `near`. With the planes at n and f, depth is f/(f - n) (1 - n/d), so it changes by f n/((f - n)
// d^2) per unit of distance; in a parallel view by 1/(f - n).
double distance_per_depth(const View& view, double d, double near) {
  if (!view.perspective) return view.far - near;
  const double range = std::isinf(view.far) ? 1 : (view.far - near) / view.far;
  return d * d * range / near;
}

// The distance that one code stands for. A code of a float is at most 2^-24 of depth 1; with
// reversed depth, which is about n/d, it is at most 2^-23 of the depth itself.
double step_at(const View& view, DepthFormat format, double d, double near) {
  double code = 0x1p-24;
  if (format == DepthFormat::kFloat32Reversed) {
    code = 0x1p-23 * (view.perspective ? near / d : 1);
  } else if (format != DepthFormat::kFloat32) {
    code = 1 / unorm_depth_steps(format);
  }
  return code * distance_per_depth(view, d, near);
}

double doubtful_at(const View& view, DepthFormat format, double d, double near) {
  return step_at(view, format, d, near) * doubtful_codes(format);
}

}  // namespace

DepthRemedy remedy_of(const View& view, DepthFormat format, const DepthFight& fight) {
  const double first = double(fight.first_distance), second = double(fight.second_distance);
  const double d = std::max(first, second), apart = std::abs(first - second);
  const double snapping = fight.snapping * distance_per_depth(view, d, view.near);
  DepthRemedy remedy;
  remedy.step = step_at(view, format, d, view.near);
  remedy.offset = 2 * (doubtful_at(view, format, d, view.near) + snapping);
  // Positions are floats, so distances that differ by less than 2^-21 are those of one plane.
  if (!(apart > 0x1p-21 * d + snapping)) return remedy;
  for (const DepthFormat finer :
       {DepthFormat::kUnorm24, DepthFormat::kFloat32, DepthFormat::kFloat32Reversed}) {
    if (remedy.format || finer == format) continue;
    if (doubtful_at(view, finer, d, view.near) <= apart / 2) remedy.format = finer;
  }
  const double needed = view.near * remedy.offset / apart;
  const bool enough = doubtful_at(view, format, d, needed) <= 0.51 * apart;
  if (view.perspective && enough && needed < std::min(first, second) / 2) remedy.near = needed;
  return remedy;
}

DepthFights::DepthFights(const View& view, DepthFormat format)
    : view_(view),
      format_(format),
      width_(int(view.viewport.width())),
      nearest_(std::size_t(width_) * std::size_t(view.viewport.height())) {}

// The depth is the sum of depth[k] E_k / double_area, and E_k changes by a per subpixel along x and
// by b along y.
void DepthFights::piece_ready(const ReadyTriangle& triangle) {
  constexpr double kHalfASubpixel = 0.5;
  const TriangleSetup& setup = triangle.setup;
  double along_x = 0, along_y = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along_x += double(setup.depth[k]) * double(setup.edges[k].a);
    along_y += double(setup.depth[k]) * double(setup.edges[k].b);
  }
  snapping_ = kHalfASubpixel * (std::abs(along_x) + std::abs(along_y)) / double(setup.double_area);
}

void DepthFights::compared(const FragmentSource& source, const Fragment& fragment,
                           std::uint32_t code, std::uint32_t stored, bool&) {
  const Nearest& behind = nearest_at(fragment);
  if (!source.is_triangle || behind.number == kNone || behind.number == source.number) return;
  const double snapping = snapping_ + behind.snapping;
  const double apart = std::abs(double(fragment.depth) - double(behind.depth));
  if (!are_doubtful(format_, code, stored) && apart > snapping) return;
  DepthFight& fight = fights_[{behind.number, source.number}];
  if (fight.pixels++ > 0) return;
  fight = {behind.number,
           source.number,
           1,
           fragment.x,
           fragment.y,
           behind.distance,
           distance_along_gaze(view_, fragment.depth, fragment.inverse_w),
           snapping};
}

void DepthFights::fragment_finished(const FragmentSource& source, const Fragment& fragment,
                                    FragmentResult result) {
  if (result != FragmentResult::kWritten) return;
  nearest_at(fragment) = {source.is_triangle ? source.number : kNone,
                          distance_along_gaze(view_, fragment.depth, fragment.inverse_w),
                          fragment.depth, snapping_};
}

std::vector<DepthFight> DepthFights::fights(const Scene& scene) const {
  WorldCorners corners(scene);
  std::vector<DepthFight> all;
  for (const auto& [pair, fight] : fights_) {
    if (fight.pixels < kFewestFightingPixels) continue;
    if (!corners.have_common_corner(pair.first, pair.second)) all.push_back(fight);
  }
  std::ranges::stable_sort(all, std::ranges::greater(), &DepthFight::pixels);
  return all;
}

std::vector<DepthFight> depth_fights(const Scene& scene, const View& view,
                                     const RenderSettings& settings) {
  DepthFights watcher(view, settings.depth);
  render_staged(scene, view, with_one_sample(settings), &watcher);
  return watcher.fights(scene);
}

}  // namespace glassbox
