// D-26: into how many triangles a curved surface is cut.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include <glassbox/mesh/builtin/teapot.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/view.h>

#include "study/bench/glassbox_peer.h"
#include "study/experiment/experiment.h"
#include "study/experiments/d26_surface.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {
namespace {

constexpr int kWidth = 1280, kHeight = 720;

View view_of_teapot() {
  const Camera camera = *frame(make_teapot(), double(kWidth) / kHeight);
  return *make_view(camera, kWidth, kHeight);
}

// How many pixels a unit of length across the line of sight has there.
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

// A triangle and where its corners are on their patch.
struct Piece {
  std::size_t patch = 0;
  std::array<glm::dvec3, 3> corners;
  std::array<glm::dvec2, 3> uv;
};

// The faces come patch by patch; the last one of a patch is the only one with the corners (1, 1) and (1, 1 - 1/level).
template <class Visit>
void for_each_piece(const Mesh& mesh, int level, const Visit& visit) {
  Piece piece;
  for (const Face& face : mesh.faces) {
    bool at_corner = false, below_corner = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& corner = mesh.corners[face.first + k];
      const TexCoord& uv = mesh.texcoords[corner.texcoord];
      piece.corners[k] = glm::dvec3(to_glm(mesh.positions[corner.position]));
      // The place on the grid without the rounding of the texture coordinate.
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

// From the middles of a triangle's sides and its centre to the surface there, along the surface's normal: what moves an
// outline, from wherever it is seen. What lies along the surface moves nothing that can be seen.
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

// ---- the theory ----

// A chord of length h in the parameters misses the middle of its arc by h^2/8 of the second derivative (the next term of
// Taylor's series is that of h^4). Sides run along u, along v and along both.
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

// ---- the table ----

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> levels{2, 4, 8, 16, 32};
  if (effort == Effort::kFull) levels.insert(levels.end(), {64, 128});
  std::vector<Configuration> all;
  for (const int level : levels) {
    struct Bench {
      BenchScene scene;
      std::optional<GlassboxPeer> peer;
      int threads = 0;
    };
    const auto work = [level, bench = std::shared_ptr<Bench>()](int threads) mutable {
      if (!bench) {
        bench = std::make_shared<Bench>();
        bench->scene = make_bench_scene("teapot", make_teapot(level), view_of_teapot());
      }
      if (bench->threads != threads) {
        bench->threads = threads;
        bench->peer.emplace(bench->scene, EngineOptions{.tile = {.threads = threads}});
      }
      bench->peer->frame_ms();
    };
    all.push_back({.series = "teapot, 32 patches of level x level cells",
                   .parameter = double(level),
                   .error = [level] { return largest_deviation_px(level); },
                   .predicted_error = predict_px(level),
                   .work = work});
  }
  return all;
}

}  // namespace

Experiment d26_tessellation() {
  return {
      .id = "D-26",
      .name = "Tessellation: into how many triangles",
      .question =
          "How far are a curved surface's triangles from it in the picture, and what does a finer "
          "mesh cost?",
      .axis = "cells along each side of a patch",
      .error =
          "largest distance between triangle and surface along its normal, in a picture of 1280 x "
          "720 px",
      .error_unit = "px",
      .reference = "the Bezier patches in double",
      .theory =
          "a chord misses its arc by h^2/8 of the second derivative across the surface: the "
          "largest over the teapot, times 1/level^2, so that error times triangles stays the same",
      .item = "frame",
      .threaded = true,
      .axis_is_chosen = true,
      .configurations = configurations};
}

}  // namespace glassbox::study
