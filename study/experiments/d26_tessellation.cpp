// Measures into how many triangles a curved surface should be divided (D-26).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/builtin/teapot.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/view.h>

#include "study/bench/glassbox_peer.h"
#include "study/experiment/experiment.h"
#include "study/experiments/d26_decimation.h"
#include "study/experiments/d26_surface.h"
#include "study/experiments/memoize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace d26 {

constexpr int kWidth = 1280, kHeight = 720;
// level of the teapot whose outline counts as exact: its error is a 16th of that of level 16
constexpr int kFineLevel = 64;

constexpr const char* kPatches = "teapot, 32 patches of level x level cells";
// The names of the measures.
constexpr const char* kDeviation = "deviation";
constexpr const char* kOutline = "outline";

View view_of_teapot() {
  const Camera camera = *framing_camera(make_teapot(), double(kWidth) / kHeight);
  return *make_view(camera, kWidth, kHeight);
}

// The number of pixels that a unit of length, across the line of sight, covers at a place.
class Magnification {
public:
  Magnification() {
    const View view = view_of_teapot();
    eye_from_world_ = view.eye_from_world;
    focal_px_ = view.clip_from_eye.at(1, 1) * kHeight / 2;
  }
  double at(const glm::dvec3& p) const {
    return focal_px_ / -transform_row(eye_from_world_, 2, Point<World, double>(p));
  }

private:
  Transform<Eye, World> eye_from_world_;
  double focal_px_;
};

// ---- the error ----

// A triangle, and the parameters (u, v) of its corners on their patch.
struct Piece {
  std::size_t patch = 0;
  std::array<glm::dvec3, 3> corners;
  std::array<glm::dvec2, 3> uv;
};

// Visits all triangles. The faces are stored patch by patch; only the last face of a patch has the
// corners (1, 1) and (1, 1 - 1/level), so the next patch begins after it.
template <class Visit>
void for_each_piece(const Mesh& mesh, int level, const Visit& visit) {
  Piece piece;
  for (const Face& face : mesh.faces) {
    bool at_corner = false, below_corner = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& corner = mesh.corners[face.first + k];
      const TexCoord& uv = mesh.texcoords[corner.texcoord];
      piece.corners[k] = glm::dvec3(to_glm(mesh.positions[corner.position]));
      // The place on the grid, without the rounding error of the texture coordinate.
      const glm::dvec2 cell(std::floor(double(uv.u) * level + 0.5),
                            std::floor(double(uv.v) * level + 0.5));
      piece.uv[k] = cell / double(level);
      at_corner = at_corner || cell == glm::dvec2(level, level);
      below_corner = below_corner || cell == glm::dvec2(level, level - 1);
    }
    visit(piece);
    if (at_corner && below_corner) ++piece.patch;
  }
}

// The largest distance along the normal between the surface and a triangle, at the midpoints of the
// triangle's sides and at its centre, in px. Only this part of an error moves an outline, for any
// direction of the view. A displacement along the surface moves nothing visible.
double largest_deviation_px(int level) {
  constexpr std::array<std::array<double, 3>, 4> kPlaces{
      {{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1.0 / 3, 1.0 / 3, 1.0 / 3}}};
  const Magnification magnification;
  std::vector<Surface> surfaces;
  for (std::size_t patch = 0; patch < kTeapotPatches.size(); ++patch) surfaces.emplace_back(patch);
  double largest = 0;
  for_each_piece(tessellate_teapot(level), level, [&](const Piece& piece) {
    for (const auto& [a, b, c] : kPlaces) {
      const glm::dvec2 uv = piece.uv[0] * a + piece.uv[1] * b + piece.uv[2] * c;
      const glm::dvec3 flat = piece.corners[0] * a + piece.corners[1] * b + piece.corners[2] * c;
      const SurfacePoint surface = surfaces[piece.patch].at(uv.x, uv.y);
      const glm::dvec3 normal = surface.normal();
      const double length = std::sqrt(glm::dot(normal, normal));
      if (length < 1e-6) continue;  // a pole
      const double off = std::abs(glm::dot(flat - surface.at, normal)) / length;
      largest = std::max(largest, off * magnification.at(surface.at));
    }
  });
  return largest;
}

// ---- fewer triangles of a fine mesh ----

// The level of the fine teapot that is decimated; all its corners are on the exact surface.
int source_level(Effort effort) {
  return effort == Effort::kFull ? 64 : 16;
}

d26::Decimation decimated(int source, std::size_t triangles) {
  d26::Decimation mesh(tessellate_teapot(source));
  mesh.reduce_to(triangles);
  return mesh;
}

// The largest distance, in px, from a corner of the fine mesh to the nearest triangle around the
// vertex into which it was collapsed.
double largest_deviation_px(const d26::Decimation& mesh) {
  const Magnification magnification;
  double largest = 0;
  for (std::uint32_t v = 0; v < mesh.places().size(); ++v) {
    const glm::dvec3& p = mesh.places()[v];
    double nearest = HUGE_VAL;
    for (const auto& [a, b, c] : mesh.triangles_near(mesh.place_of(v)))
      nearest = std::min(nearest,
                         d26::distance_to(p, mesh.places()[a], mesh.places()[b], mesh.places()[c]));
    largest = std::max(largest, nearest * magnification.at(p));
  }
  return largest;
}

// Makes a scene of the decimated mesh, whose corners keep their normals.
Scene scene_of(const d26::Decimation& decimated, int source) {
  Scene scene = make_teapot(source);
  Mesh& mesh = scene.meshes.front();
  std::map<std::tuple<float, float, float>, std::uint32_t> normals;
  for (const Corner& corner : mesh.corners) {
    const auto& p = mesh.positions[corner.position];
    normals.try_emplace({p.x, p.y, p.z}, corner.normal);
  }
  mesh.positions.clear();
  for (const glm::dvec3& p : decimated.places())
    mesh.positions.emplace_back(float(p.x), float(p.y), float(p.z));
  mesh.corners.clear(), mesh.faces.clear(), mesh.texcoords.clear();
  for (const d26::Triangle& t : decimated.triangles()) {
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
    for (const std::uint32_t v : t) {
      const auto& p = mesh.positions[v];
      mesh.corners.push_back({v, normals.at({p.x, p.y, p.z})});
    }
  }
  return scene;
}

// ---- the outline ----

using Mask = Image<std::uint8_t>;

Mask silhouette(const Scene& scene) {
  RenderSettings settings;
  settings.want_distance = true;
  const Framebuffer drawn = render_tiled(scene, view_of_teapot(), settings, {.threads = 1}).buffers;
  Mask mask(kWidth, kHeight, 0);
  std::ranges::transform(drawn.distance.pixels, mask.pixels.begin(),
                         [](float z) { return std::uint8_t(std::isfinite(z)); });
  return mask;
}

// The length of an outline in px. A curve of length l that runs in all directions crosses 4 l/pi
// pairs of neighbouring pixels (Cauchy and Crofton).
double outline_px(const Mask& mask) {
  int crossings = 0;
  for (int y = 1; y < mask.height; ++y) {
    for (int x = 1; x < mask.width; ++x) {
      crossings += mask.at(x, y) != mask.at(x - 1, y);
      crossings += mask.at(x, y) != mask.at(x, y - 1);
    }
  }
  return crossings * kPi / 4;
}

// The area between the outline of `mask` and the exact one, per pixel of the outline's length.
double outline_shift_px(const Mask& mask) {
  static const Mask right = silhouette(make_teapot(kFineLevel));
  static const double length = outline_px(right);
  int changed = 0;
  for (std::size_t i = 0; i < mask.pixels.size(); ++i) changed += mask.pixels[i] != right.pixels[i];
  return changed / length;
}

// ---- the theory ----

// A side of a triangle is a chord of length h = 1 / level in the parameters. It misses the middle
// of its arc by h^2/8 times the second derivative (the next term of the Taylor series is of the
// order h^4). Sides run along u, along v and along the diagonal.
double predict_px(int level) {
  static const double largest_at_level_1 = [] {
    const Magnification magnification;
    double largest = 0;
    constexpr int kGrid = 64;
    for (std::size_t patch = 0; patch < kTeapotPatches.size(); ++patch) {
      const Surface surface(patch);
      for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
          const SurfacePoint p = surface.at(double(i) / kGrid, double(j) / kGrid);
          const glm::dvec3 normal = p.normal();
          const double length = std::sqrt(glm::dot(normal, normal));
          if (length < 1e-6) continue;
          const glm::dvec3 both = p.duu + 2.0 * p.duv + p.dvv;
          const double bend =
              std::max({std::abs(glm::dot(p.duu, normal)), std::abs(glm::dot(p.dvv, normal)),
                        std::abs(glm::dot(both, normal))});
          largest = std::max(largest, bend / length / 8 * magnification.at(p.at));
        }
      }
    }
    return largest;
  }();
  return largest_at_level_1 / (double(level) * level);
}

// Visits the surface at the cell centres of a grid on each patch, except at poles: the point, its
// unit normal, and the cell's fraction of the patch's parameters.
template <class Visit>
void for_each_place(const Visit& visit) {
  constexpr int kGrid = 64;
  for (std::size_t patch = 0; patch < kTeapotPatches.size(); ++patch) {
    const Surface surface(patch);
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        const SurfacePoint p = surface.at((i + 0.5) / kGrid, (j + 0.5) / kGrid);
        const glm::dvec3 normal = p.normal();
        const double length = glm::length(normal);
        if (length > 1e-6) visit(p, normal / length, 1.0 / (kGrid * kGrid));
      }
    }
  }
}

// Triangles with their corners on a surface have a largest distance from it of at least 2/(3 sqrt
// 3) times the integral of sqrt|K| over the surface, divided by the number of triangles (K: the
// Gaussian curvature). The best triangles are all equilateral if lengths are measured by the
// curvature (D'Azevedo and Simpson 1989). In the parameters, sqrt|K| dA is sqrt|L N - M^2| du dv,
// with the second fundamental form L, M, N.
double predict_least_px(std::size_t triangles) {
  static const double integral = [] {
    const Magnification magnification;
    double sum = 0;
    for_each_place([&](const SurfacePoint& p, const glm::dvec3& normal, double share) {
      const double l = glm::dot(p.duu, normal), m = glm::dot(p.duv, normal),
                   n = glm::dot(p.dvv, normal);
      sum += std::sqrt(std::abs(l * n - m * m)) * share * magnification.at(p.at);
    });
    return sum;
  }();
  return 2 / (3 * std::sqrt(3.0)) * integral / double(triangles);
}

// An outline runs along sides of triangles. Their midpoints have an error of h^2/8 times the second
// derivative along the side (h: the length of a side), and the mean over a side is 2/3 of that. The
// outline runs between corners next to the line where the surface is seen edge-on, up to h/2 away
// from it, which adds an error of h^2/24 times the second derivative across. If both derivatives
// have the same mean (taken along u and v where the surface is edge-on), the sum is h^2/8 times
// this mean.
double predict_outline_px(int level) {
  static const double mean_at_level_1 = [] {
    const Magnification magnification;
    const Transform<Eye, World> eye_from_world = view_of_teapot().eye_from_world;
    const auto in_eye = [&](const glm::dvec3& p) {
      return to_glm(eye_from_world * Point<World, double>(p));
    };
    double sum = 0, count = 0;
    for_each_place([&](const SurfacePoint& p, const glm::dvec3& normal, double) {
      const glm::dvec3 at = in_eye(p.at), turned = in_eye(p.at + normal) - at;
      if (std::abs(glm::dot(glm::normalize(at), turned)) > 0.05) return;
      const double bend =
          (std::abs(glm::dot(p.duu, normal)) + std::abs(glm::dot(p.dvv, normal))) / 2;
      sum += bend / 8 * magnification.at(p.at), count += 1;
    });
    return sum / count;
  }();
  return mean_at_level_1 / (double(level) * level);
}

// The least error of an outline, of equilateral triangles: their error at the midpoints of the
// sides is 3/4 of that at the centre.
double predict_least_outline_px(std::size_t triangles) {
  return predict_least_px(triangles) * 3 / 4;
}

// ---- the table ----

using MakeScene = std::function<Scene()>;

std::function<void(int)> frame_of(MakeScene make) {
  struct Bench {
    BenchScene scene;
    std::optional<GlassboxPeer> peer;
    int threads = 0;
  };
  return [make = std::move(make), bench = std::shared_ptr<Bench>()](int threads) mutable {
    if (!bench) {
      bench = std::make_shared<Bench>();
      bench->scene = make_bench_scene("teapot", make(), view_of_teapot());
    }
    if (bench->threads != threads) {
      bench->threads = threads;
      bench->peer.emplace(bench->scene, EngineOptions{.tile = {.threads = threads}});
    }
    bench->peer->frame_ms();
  };
}

// Collapsing the cheapest edge first does not give the best set of triangles.
const Finding kGreedy{
    "edges are collapsed one by one, chosen by the mean square of the distance and not by the "
    "largest distance",
    2, 8};

// The largest deviation and the outline error of one mesh, at its number of triangles.
struct Expected {
  double deviation_px = 0, outline_px = 0;
  std::optional<Finding> finding = {};  // explains the deviation
};
void add_mesh(const std::string& series, std::size_t triangles, const MakeScene& make,
              const std::function<double()>& deviation_px, const Expected& expected,
              std::vector<Configuration>& all) {
  all.push_back({.series = series,
                 .parameter = double(triangles),
                 .measure = kDeviation,
                 .error = deviation_px,
                 .predicted_error = expected.deviation_px,
                 .finding = expected.finding,
                 .work = frame_of(make)});
  all.push_back({.series = series,
                 .parameter = double(triangles),
                 .measure = kOutline,
                 .error = [=] { return outline_shift_px(silhouette(make())); },
                 .predicted_error = expected.outline_px});
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> levels{2, 4, 8, 16, 32};
  if (effort == Effort::kFull) levels.insert(levels.end(), {64, 128});
  std::vector<Configuration> all;
  for (const int level : levels) {
    all.push_back({.series = kPatches,
                   .parameter = double(level),
                   .error = [level] { return largest_deviation_px(level); },
                   .predicted_error = predict_px(level),
                   .work = frame_of([level] { return make_teapot(level); })});
  }
  const int source = source_level(effort);
  for (const int level : {2, 4, 8}) {
    const std::size_t triangles = tessellate_teapot(level).faces.size();
    add_mesh(
        kPatches, triangles, [level] { return make_teapot(level); },
        [level] { return largest_deviation_px(level); },
        {predict_px(level), predict_outline_px(level)}, all);
    const auto mesh = memoize([=] { return decimated(source, triangles); });
    add_mesh(
        "decimated by quadrics", triangles, [=] { return scene_of(mesh(), source); },
        [=] { return largest_deviation_px(mesh()); },
        {predict_least_px(triangles), predict_least_outline_px(triangles), kGreedy}, all);
  }
  return all;
}

}  // namespace d26

Experiment d26_tessellation() {
  using namespace d26;
  return {
      .id = "D-26",
      .name = "Tessellation: how many triangles are needed",
      .question =
          "How far are the triangles from the curved surface in the picture, and what does a finer "
          "mesh cost?",
      .axis = "cells along each side of a patch",
      .error =
          "largest distance between triangle and surface along its normal, in a picture of 1280 x "
          "720 px",
      .error_unit = "px",
      .reference = "the Bezier patches in double",
      .theory =
          "A chord of length h is h^2/8 times the second derivative across the surface away from "
          "its arc. The largest such distance over the teapot is divided by level^2, so error "
          "times number of triangles stays the same. For a decimated mesh, the formula is the "
          "lower limit of all meshes with corners on the surface: 2/(3 sqrt 3) times the integral "
          "of sqrt|K|, divided by the number of triangles (D'Azevedo and Simpson 1989). An outline "
          "along chords is wrong by h^2/12 times the curvature along it and, because corners are "
          "beside it, by h^2/24 times the curvature across it",
      .item = "frame",
      .threaded = true,
      .axis_is_chosen = true,
      .measures = {{kDeviation,
                    "largest distance between triangles and surface; for decimated meshes, "
                    "measured at the corners of a fine mesh",
                    "px", "triangles"},
                   {kOutline,
                    "area between the outline and the outline of a mesh of level 64, per pixel of "
                    "its length",
                    "px", "triangles"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
