#include "study/recommend/vertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "exact/matrix.h"
#include "exact/number.h"

namespace glassbox::study {

namespace {

using exact::Decimal;

// ---- the right answer ----

Transform<World, Object> world_from_object(const Scene& scene, const Draw& draw) {
  return scene.nodes[scene.instances[draw.instance].node].world_from_node;
}

// The product of the three matrices in exact arithmetic; their entries are the doubles from which
// the pipeline starts.
exact::Matrix4<Decimal> exact_clip_from_object(const Scene& scene, const View& view,
                                               const Draw& draw) {
  return exact::exactly<Decimal>(view.clip_from_eye) *
         (exact::exactly<Decimal>(view.eye_from_world) *
          exact::exactly<Decimal>(world_from_object(scene, draw)));
}

enum class VertexRegion { kInside, kBeside, kNotBetweenPlanes };

VertexRegion region_of(const exact::Vector4<Decimal>& clip) {
  if (clip[3] <= 0 || clip[2] < 0 || clip[2] > clip[3]) return VertexRegion::kNotBetweenPlanes;
  return abs(clip[0]) <= clip[3] && abs(clip[1]) <= clip[3] ? VertexRegion::kInside
                                                            : VertexRegion::kBeside;
}

// The eye-space distance of a point in clip space. It needs only z and w, because the rows of a
// projection for z and w use nothing but z and w of eye space.
double distance_of(const View& view, const exact::Vector4<Decimal>& clip) {
  if (view.perspective) return double(clip[3]);
  return double((Decimal(view.clip_from_eye.at(2, 3)) - clip[2]) /
                Decimal(view.clip_from_eye.at(2, 2)));
}

ExactVertexPlace place_of(const View& view, const exact::Vector4<Decimal>& clip, std::size_t draw,
                          std::uint32_t vertex) {
  const auto half = [](float a, float b) {
    return (Decimal(double(a)) + Decimal(double(b))) / Decimal(2);
  };
  const Viewport& v = view.viewport;
  const Decimal x = clip[0] / clip[3] * half(v.right, -v.left) + half(v.right, v.left);
  const Decimal y = clip[1] / clip[3] * half(v.top, -v.bottom) + half(v.top, v.bottom);
  return {draw, vertex, double(x), double(y), distance_of(view, clip)};
}

// ---- methods to compute the positions ----

// The chosen vertices, one array per coordinate, grouped into runs of the same draw: a loop over
// them can be vectorized.
struct VertexColumns {
  struct Run {
    std::size_t draw = 0, first = 0, end = 0;
  };
  std::vector<Run> runs;
  std::vector<float> x, y, z;  // object space
};

// Positions on the screen after snapping.
struct ScreenColumns {
  std::vector<double> x, y;
};

// Computes the positions of all vertices and snaps them to `steps` steps per pixel.
using PlaceAll = std::function<void(const VertexColumns&, double steps, ScreenColumns&)>;

template <class T>
struct Screen {
  T x, y;
};

template <class T>
Screen<T> to_screen_of(const Point<Clip, T>& clip, const Viewport& v) {
  return {
      clip.x / clip.w * ((T(v.right) - T(v.left)) * T(0.5)) + (T(v.right) + T(v.left)) * T(0.5),
      clip.y / clip.w * ((T(v.top) - T(v.bottom)) * T(0.5)) + (T(v.top) + T(v.bottom)) * T(0.5)};
}

template <class T, class Target, class Source>
Transform<Target, Source, T> as(const Transform<Target, Source>& m) {
  return Transform<Target, Source, T>(glm::mat<4, 4, T>(m.columns));
}

// Rounds to a multiple of 1/`steps` px; `steps` is a power of two.
double snapped(double px, double steps) {
  return std::floor(px * steps + 0.5) * (1 / steps);
}

struct Arithmetic {
  std::string name;
  bool in_render;
  PlaceAll place_all;
};

// Runs one loop for each run of vertices; `make(draw)` returns the function that transforms a
// vertex of this draw to the screen.
template <class Make>
PlaceAll by_runs(Make make) {
  return [make](const VertexColumns& vertices, double steps, ScreenColumns& to) {
    for (const VertexColumns::Run& run : vertices.runs) {
      const auto carry = make(run.draw);
      for (std::size_t i = run.first; i < run.end; ++i) {
        const auto at = carry(vertices.x[i], vertices.y[i], vertices.z[i]);
        to.x[i] = snapped(double(at.x), steps);
        to.y[i] = snapped(double(at.y), steps);
      }
    }
  };
}

// Applies the three matrices one after the other, each rounded to the type T.
template <class T>
PlaceAll separately(const Scene& scene, const View& view, const std::vector<Draw>& draws) {
  return by_runs([&scene, &view, &draws](std::size_t draw) {
    return [world = as<T>(world_from_object(scene, draws[draw])), eye = as<T>(view.eye_from_world),
            clip = as<T>(view.clip_from_eye), viewport = view.viewport](float x, float y, float z) {
      return to_screen_of(clip * (eye * (world * Point<Object, T>(T(x), T(y), T(z)))), viewport);
    };
  });
}

// Uses the pipeline's own functions; the anchor (a point near the object) is subtracted as in
// project_vertex().
PlaceAll as_render_does(const View& view, const std::vector<Draw>& draws) {
  return by_runs([&view, &draws](std::size_t draw) {
    return [matrix = draws[draw].clip_from_anchored, anchor = draws[draw].anchor,
            viewport = view.viewport](float x, float y, float z) {
      const Point<Object> anchored(x - anchor.x, y - anchor.y, z - anchor.z);
      return to_screen(divide(matrix * anchored), viewport).position;
    };
  });
}

VertexColumns columns_of(const std::vector<Draw>& draws,
                         const std::vector<ExactVertexPlace>& places) {
  VertexColumns all;
  for (const ExactVertexPlace& place : places) {
    const auto& p = draws[place.draw].mesh->positions[place.vertex];
    if (all.runs.empty() || all.runs.back().draw != place.draw) {
      all.runs.push_back({place.draw, all.x.size(), all.x.size()});
    }
    all.x.push_back(p.x);
    all.y.push_back(p.y);
    all.z.push_back(p.z);
    all.runs.back().end = all.x.size();
  }
  return all;
}

// The largest distance between a computed and an exact position, in pixels.
double largest_distance(const ScreenColumns& found, const std::vector<ExactVertexPlace>& places) {
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double off = std::hypot(found.x[i] - places[i].x, found.y[i] - places[i].y);
    largest = off <= largest ? largest : off;  // a NaN is kept
  }
  return largest;
}

// ---- depth ----

// The depth that a code of this format represents, in [0, 1].
double depth_of(DepthFormat format, std::uint32_t code) {
  switch (format) {
    case DepthFormat::kFloat32:
      return std::bit_cast<float>(code);
    case DepthFormat::kFloat32Reversed:
      return std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) - code);
    case DepthFormat::kUnorm24:
      return double(code) / double((1u << 24) - 1);
    case DepthFormat::kUnorm16:
      return double(code) / double((1u << 16) - 1);
  }
  return std::nan("");
}

// Computes the distance from a depth. Inverts depth = -a + b/w for perspective (w is the distance)
// and depth = a z + b for parallel projection (the distance is -z); a and b are the entries of the
// matrix row for clip z.
double distance_at(const View& view, double depth) {
  const double a = view.clip_from_eye.at(2, 2), b = view.clip_from_eye.at(2, 3);
  if (!view.perspective) return (b - depth) / a;
  return b / (depth + a);
}

}  // namespace

SceneVertices::SceneVertices(const Scene& scene, const View& view)
    : scene_(&scene),
      view_(view),
      prepared_(prepare_scene(scene, Transfer::kSrgb)),
      list_(make_draw_list(scene, prepared_, view)) {}

Result<SceneVertices> SceneVertices::sample(const Scene& scene, const View& view,
                                            std::size_t most) {
  SceneVertices vertices(scene, view);
  std::size_t all = 0;
  for (const Draw& draw : vertices.list_.draws) all += draw.mesh->positions.size();
  // Examines ten times as many vertices as needed, because most of a scene may be out of sight.
  const std::size_t step = std::max<std::size_t>(1, all / (10 * most));
  std::vector<ExactVertexPlace> inside, beside;
  std::size_t number = 0;
  for (std::size_t d = 0; d < vertices.list_.draws.size(); ++d) {
    const Draw& draw = vertices.list_.draws[d];
    const auto matrix = exact_clip_from_object(scene, view, draw);
    for (std::uint32_t i = 0; i < draw.mesh->positions.size(); ++i) {
      if (number++ % step != 0) continue;
      const auto& p = draw.mesh->positions[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
      const auto clip = matrix * exact::exactly<Decimal>(p);
      if (const VertexRegion at = region_of(clip); at != VertexRegion::kNotBetweenPlanes)
        (at == VertexRegion::kInside ? inside : beside).push_back(place_of(view, clip, d, i));
    }
  }
  const std::vector<ExactVertexPlace>& usable = inside.empty() ? beside : inside;
  if (usable.empty()) {
    return fail("", "no vertex of the scene lies between the near and the far plane",
                "look at the scene from another place: --eye, --look-at, or --camera");
  }
  const std::size_t stride = (usable.size() + most - 1) / most;
  for (std::size_t i = 0; i < usable.size(); i += stride) vertices.places_.push_back(usable[i]);
  return vertices;
}

double SceneVertices::position_error() const {
  ScreenColumns found{std::vector<double>(count()), std::vector<double>(count())};
  as_render_does(view_, list_.draws)(columns_of(list_.draws, places_),
                                     std::ldexp(1.0, kSubpixelBits), found);
  return largest_distance(found, places_);
}

Comparison SceneVertices::positions() const {
  const std::vector<Draw>& draws = list_.draws;
  const Arithmetic ways[] = {
      {"float, composed in double, anchored", true, as_render_does(view_, draws)},
      {"float, one matrix after the other", false, separately<float>(*scene_, view_, draws)},
      {"double, one matrix after the other", false, separately<double>(*scene_, view_, draws)}};
  Comparison result;
  result.quantity = Quantity::kPosition;
  result.error =
      fmt::format("largest distance on the screen from the right place, over {} vertices", count());
  result.reference = "50 digits";
  const VertexColumns vertices = columns_of(draws, places_);
  ScreenColumns found{std::vector<double>(count()), std::vector<double>(count())};
  for (const Arithmetic& way : ways) {
    for (const int bits : {4, 6, 8, 10, 12}) {
      const double steps = std::ldexp(1.0, bits);
      Candidate candidate;
      candidate.name = fmt::format("{}; {} subpixel bits", way.name, bits);
      candidate.in_render = way.in_render && bits == kSubpixelBits;
      way.place_all(vertices, steps, found);
      candidate.error = largest_distance(found, places_);
      result.candidates.push_back(std::move(candidate));
    }
  }
  return result;
}

double SceneVertices::depth_error(DepthFormat format) const {
  double worst = 0;
  for (const ExactVertexPlace& right : places_) {
    const NdcVertex ndc = divide(project_vertex(list_.draws[right.draw], right.vertex));
    const double depth = depth_of(format, depth_code(format, ndc.position.z));
    const double scale =
        view_.perspective ? right.distance : std::abs(1 / view_.clip_from_eye.at(2, 2));
    const double found = distance_at(view_, depth);
    const double off = found > 0 || !view_.perspective ? std::abs(found - right.distance) / scale
                                                       : std::numeric_limits<double>::infinity();
    worst = off <= worst ? worst : off;
  }
  return worst;
}

}  // namespace glassbox::study
