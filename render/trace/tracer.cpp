#include <glassbox/render/trace/tracer.h>

#include <algorithm>
#include <span>
#include <unordered_set>
#include <utility>

#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/trace/coverage_miss.h>

namespace glassbox {
namespace {

// Records the draws of a run, and knows which triangles and fragments the filter selects.
class DrawTracer : public Observer {
public:
  DrawTracer(const Scene& scene, const TraceFilter& filter, TraceSink& sink)
      : filter_(filter), sink_(sink), scene_(scene) {}

  bool complete() const { return complete_; }

  void draw(const Draw& draw) override {
    draw_ = &draw;
    traced_draw_ = record_of(draw, scene_);
    sink_.draw(traced_draw_);
    draw_wanted_ = !filter_.instance || *filter_.instance == draw.instance;
  }

protected:
  bool is_wanted(std::uint32_t number) const {
    return draw_wanted_ && (!filter_.triangle || *filter_.triangle == number);
  }

  bool has_wanted_vertex(const Triangle& triangle) const {
    return !filter_.position ||
           std::any_of(triangle.corners.begin(), triangle.corners.end(), [this](std::uint32_t k) {
             return draw_->mesh->corners[k].position == *filter_.position;
           });
  }

  bool is_wanted(const FragmentSource& source, const Fragment& fragment) const {
    if (!filter_.fragments || !draw_wanted_) return false;
    if (filter_.triangle && !(source.is_triangle && source.number == *filter_.triangle)) {
      return false;
    }
    if (filter_.position && !(source.is_triangle && with_wanted_vertex_.contains(source.number))) {
      return false;
    }
    return !filter_.pixels || contains(*filter_.pixels, fragment.x, fragment.y);
  }

  bool has_room(std::uint64_t bytes) {
    if (bytes_ + bytes > filter_.max_bytes) complete_ = false;
    if (!complete_) return false;
    bytes_ += bytes;
    return true;
  }

  const TraceFilter& filter_;
  TraceSink& sink_;
  const Draw* draw_ = nullptr;
  TracedDraw traced_draw_;
  // The numbers of the triangles that have the wanted vertex; only for filters by position.
  std::unordered_set<std::uint32_t> with_wanted_vertex_;

private:
  const Scene& scene_;
  bool draw_wanted_ = true;
  std::uint64_t bytes_ = 0;
  bool complete_ = true;
};

// Records the draws of a run, and also the triangles.
class TriangleTracer : public DrawTracer {
public:
  TriangleTracer(const Scene& scene, const View& view, const TraceFilter& filter, TraceSink& sink)
      : DrawTracer(scene, filter, sink), view_(view), planes_(render_planes(view)) {}

  void clipped(const PrimitiveStage&, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override {
    const std::uint32_t number = draw_->first_number + triangle.number;
    const bool wanted = is_wanted(number) && has_wanted_vertex(triangle);
    if (wanted && filter_.position) with_wanted_vertex_.insert(number);
    watching_ = wanted && filter_.triangles;
    if (!watching_) return;
    was_cut_ = polygon.count != 3 || polygon.vertices[0].position != corners[0].position ||
               polygon.vertices[1].position != corners[1].position ||
               polygon.vertices[2].position != corners[2].position;
    polygon_count_ = polygon.count;
    current_.number = number;
    current_.instance = draw_->instance;
    current_.face = triangle.face;
    for (std::size_t k = 0; k < 3; ++k) {
      current_.corners[k].corner = triangle.corners[k];
      current_.corners[k].clip = corners[k].position;
    }
    current_.clipping.clear();
    current_.polygon.clear();
    current_.pieces.clear();
  }

  // This is called for the vertices of the clipped polygon first; in wireframe pictures, the ends
  // of edges follow.
  void divided(const ClipVertex& clip, NdcVertex& ndc) override {
    of_polygon_ = watching_ && int(current_.polygon.size()) < polygon_count_;
    if (of_polygon_)
      current_.polygon.push_back({.clip = clip, .ndc = ndc, .screen = {}, .snapped = {}});
  }

  void mapped_to_screen(const NdcVertex&, ScreenVertex& screen) override {
    if (of_polygon_) current_.polygon.back().screen = screen;
  }

  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override {
    if (watching_) current_.pieces.push_back({{}, vertices, setup});
  }

  void facing_tested(const TriangleSetup&, bool front, bool& culled) override {
    if (!watching_) return;
    current_.pieces.back().front = front;
    current_.pieces.back().culled = culled;
  }

  void triangle_finished(const Triangle&) override {
    if (!watching_ || !reaches_wanted_pixels()) return;
    watching_ = false;
    complete_current();
    const std::uint64_t bytes = sizeof(TracedTriangle) +
                                current_.clipping.size() * sizeof(ClipStep) +
                                current_.polygon.size() * sizeof(TracedVertex) +
                                current_.pieces.size() * sizeof(TracedPiece);
    if (has_room(bytes)) sink_.triangle(current_);
  }

private:
  bool reaches_wanted_pixels() const {
    if (!filter_.pixels) return true;
    const bool reaches = std::any_of(
        current_.pieces.begin(), current_.pieces.end(), [this](const TracedPiece& piece) {
          return !intersect(pixels_touched(piece.vertices), *filter_.pixels).empty();
        });
    return reaches ||
           (was_cut_ && would_reach(clip_vertices(current_), view_.viewport, *filter_.pixels));
  }

  // Computes what the run itself does not compute or does not pass to observers.
  void complete_current() {
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k) {
      place(current_.corners[k]);
      codes[k] = current_.corners[k].outcode;
    }
    if (trivial_verdict(codes) == ClipVerdict::kClip) {
      clip_triangle(clip_vertices(current_), planes_, &current_.clipping);
    }
    std::array<SnappedVertex, kMaxClipVertices> snapped;
    for (std::size_t i = 0; i < current_.polygon.size(); ++i) {
      snapped[i] = snap(current_.polygon[i].screen);
      current_.polygon[i].snapped = snapped[i];
    }
    const int count = int(current_.polygon.size());
    const int apex = fan_apex(std::span(snapped).first(std::size_t(count)));
    for (std::size_t i = 0; i < current_.pieces.size(); ++i) {
      current_.pieces[i].polygon = fan_vertices(count > 3 ? apex : 0, count, int(i));
    }
  }

  // Computes the corner in the spaces that the run does not use: world and eye space.
  void place(TracedCorner& corner) const {
    corner.position = draw_->mesh->corners[corner.corner].position;
    corner.object = draw_->mesh->positions[corner.position];
    const Point<Object, double> object{corner.object.x, corner.object.y, corner.object.z};
    corner.world = traced_draw_.world_from_object * object;
    corner.eye = view_.eye_from_world * corner.world;
    corner.outcode = outcode(corner.clip, planes_);
  }

  const View& view_;
  const std::array<ClipPlane, kMaxClipPlanes> planes_;
  bool watching_ = false;  // whether the current triangle is recorded
  bool was_cut_ = false;   // whether clipping changed the current triangle
  // The current triangle. Its memory is reused, so that triangles that are not kept cost no
  // allocation.
  TracedTriangle current_;
  int polygon_count_ = 0;    // vertices that clipping left of the current triangle
  bool of_polygon_ = false;  // the vertex divided last belongs to the clipped polygon
};

// Records the draws and triangles of a run, and also the fragments.
class Tracer : public TriangleTracer {
public:
  using TriangleTracer::TriangleTracer;

  void interpolated(const FragmentSource&, const Coverage& coverage, Fragment&) override {
    coverage_ = coverage;
  }

  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool&) override {
    tracing_ = is_wanted(source, fragment) && has_room(sizeof(TracedFragment));
    if (!tracing_) return;
    fragment_ = {};
    fragment_.source = source;
    fragment_.instance = draw_->instance;
    if (source.is_triangle) fragment_.coverage = coverage_;
    fragment_.fragment = fragment;
    fragment_.code = code;
    fragment_.stored = stored;
  }

  void textured(const Varyings& at, Rgba& surface) override {
    if (!tracing_ || !filter_.colors) return;
    fragment_.at = at;
    fragment_.surface = surface;
  }

  void emitted(const Varyings&, std::array<float, 3>& emission) override {
    if (tracing_ && filter_.colors) fragment_.emission = emission;
  }

  void lit(const Varyings&, const Rgba&, Rgba& color) override {
    if (tracing_ && filter_.colors) fragment_.light = color;
  }

  void encoded(const Fragment&, const Rgba8& before, Rgba8& after) override {
    if (!tracing_ || !filter_.colors) return;
    fragment_.before = before;
    fragment_.after = after;
  }

  void fragment_finished(const FragmentSource&, const Fragment&, FragmentResult result) override {
    if (!tracing_) return;
    fragment_.result = result;
    sink_.fragment(fragment_);
  }

private:
  bool tracing_ = false;  // whether the current fragment is recorded
  TracedFragment fragment_;
  Coverage coverage_;
};

class Collector : public TraceSink {
public:
  explicit Collector(Trace& trace) : trace_(trace) {}
  void draw(const TracedDraw& draw) override { trace_.draws.push_back(draw); }
  void triangle(const TracedTriangle& triangle) override { trace_.triangles.push_back(triangle); }
  void fragment(const TracedFragment& fragment) override { trace_.fragments.push_back(fragment); }

private:
  Trace& trace_;
};

}  // namespace

TracedDraw record_of(const Draw& draw, const Scene& scene) {
  return {.instance = draw.instance,
          .first_number = draw.first_number,
          .world_from_object = scene.nodes[scene.instances[draw.instance].node].world_from_node,
          .anchor = draw.anchor,
          .clip_from_anchored = draw.clip_from_anchored,
          .eye_from_anchored = draw.eye_from_anchored,
          .mirrored = draw.mirrored};
}

StreamedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                  const TraceFilter& filter, TraceSink& sink) {
  Tracer tracer(scene, view, filter, sink);
  Rendering rendering = render_staged(scene, view, with_one_sample(settings), &tracer);
  return {std::move(rendering), tracer.complete()};
}

TracedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                const TraceFilter& filter) {
  TracedRun run;
  run.trace.view = view;
  run.trace.settings = with_one_sample(settings);
  run.trace.planes = render_planes(view);
  Collector collector(run.trace);
  StreamedRun sunk = trace(scene, view, settings, filter, collector);
  run.rendering = std::move(sunk.rendering);
  run.trace.complete = sunk.complete;
  return run;
}

}  // namespace glassbox
