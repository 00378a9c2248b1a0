#include <glassbox/render/staged.h>

#include <algorithm>
#include <chrono>
#include <span>

#include <glassbox/render/draw_list.h>
#include <glassbox/render/fragments.h>
#include <glassbox/render/primitives.h>
#include <glassbox/render/show.h>
#include <glassbox/render/vertex_stage.h>

namespace glassbox {

namespace {

// Triangles are carried through the stages in batches, so that each stage can be timed and memory stays small.
constexpr std::size_t kBatch = 1024;

// Adds the wall-clock time of its own life to a statistic.
class Stopwatch {
public:
  explicit Stopwatch(double& total_ms) : total_ms_(total_ms), start_(Clock::now()) {}
  ~Stopwatch() {
    total_ms_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double& total_ms_;
  Clock::time_point start_;
};

template <class Primitive>
void rasterise_all(const FragmentStage& stage, std::vector<Primitive>& primitives) {
  const Stopwatch watch(stage.statistics.fragment_ms);
  for (const Primitive& primitive : primitives) rasterise(stage, primitive);
  primitives.clear();
}

void render_draw(const Draw& draw, const View& view, const RenderSettings& settings,
                 const Lighting& lighting, Framebuffer& target, Statistics& statistics,
                 Observer* observer) {
  if (observer != nullptr) observer->draw(draw);
  VertexTables tables;
  {
    const Stopwatch watch(statistics.vertex_ms);
    tables = transform_vertices(draw, settings, observer);
  }
  const PrimitiveStage primitives =
      make_primitive_stage(draw, tables, view, settings, lighting, statistics, observer);
  const FragmentStage fragments{draw, view, settings, lighting, target, statistics, observer};

  std::vector<ReadyTriangle> triangles;
  std::vector<ReadyLine> lines;
  std::vector<ReadyPoint> points;
  const std::span<const Triangle> all(draw.triangulation->triangles);
  for (std::size_t first = 0; first < all.size(); first += kBatch) {
    {
      const Stopwatch watch(statistics.triangle_ms);
      for (const Triangle& triangle : all.subspan(first, std::min(kBatch, all.size() - first))) {
        ready_triangle(primitives, triangle, triangles, lines);
      }
    }
    rasterise_all(fragments, triangles);
    rasterise_all(fragments, lines);
  }
  for (const auto& line : draw.mesh->lines) ready_line(primitives, line, lines);
  rasterise_all(fragments, lines);
  for (const Corner& point : draw.mesh->points) ready_point(primitives, point, points);
  rasterise_all(fragments, points);
}

void count_input(const Draw& draw, Statistics& statistics) {
  ++statistics.instances;
  statistics.vertices += draw.mesh->positions.size();
  statistics.triangles += draw.triangulation->numbered;
  statistics.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
  statistics.lines += draw.mesh->lines.size();
  statistics.points += draw.mesh->points.size();
}

}  // namespace

Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        Observer* observer) {
  Rendering rendering;
  Statistics& statistics = rendering.statistics;
  DrawList list;
  {
    const Stopwatch watch(statistics.prepare_ms);
    list = make_draw_list(scene, view, settings);
    rendering.buffers =
        cleared_framebuffer(int(view.viewport.width()), int(view.viewport.height()), settings);
  }
  for (const Draw& draw : list.draws) {
    count_input(draw, statistics);
    render_draw(draw, view, settings, list.lighting, rendering.buffers, statistics, observer);
  }
  show(settings.show, rendering.buffers);
  return rendering;
}

}  // namespace glassbox
