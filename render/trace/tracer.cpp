#include <glassbox/render/trace/tracer.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/primitives.h>

namespace glassbox {
namespace {

bool overlap(const PixelRect& a, const PixelRect& b) {
  return !intersect(a, b).empty();
}

bool contains(const PixelRect& rect, int x, int y) {
  return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
}

// The pixels that the box of a piece reaches into, whether or not it covers their centres.
PixelRect pixels_touched(const std::array<ScreenVertex, 3>& vertices) {
  const auto [left, right] =
      std::minmax({vertices[0].position.x, vertices[1].position.x, vertices[2].position.x});
  const auto [top, bottom] =
      std::minmax({vertices[0].position.y, vertices[1].position.y, vertices[2].position.y});
  // The guard band keeps positions well inside of int.
  return {int(std::floor(left)), int(std::floor(top)), int(std::floor(right)) + 1,
          int(std::floor(bottom)) + 1};
}

class Tracer : public Observer {
public:
  Tracer(const Scene& scene, const View& view, const TraceFilter& filter)
      : scene_(scene), view_(view), filter_(filter) {
    const auto planes = render_planes(view);
    trace_.planes.assign(planes.begin(), planes.end());
  }

  Trace take() { return std::move(trace_); }

  void draw(const Draw& draw) override {
    draw_ = &draw;
    trace_.draws.push_back({draw.instance, draw.first_number, draw.anchor, draw.clip_from_anchored,
                            draw.eye_from_anchored, draw.mirrored});
    draw_wanted_ = !filter_.instance || *filter_.instance == draw.instance;
  }

  // ---- triangles ----

  void clipped(const PrimitiveStage&, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon&) override {
    const std::uint32_t number = draw_->first_number + triangle.number;
    watching_ = filter_.triangles && is_wanted(number);
    if (!watching_) return;
    current_.number = number;
    current_.instance = draw_->instance;
    current_.face = triangle.face;
    for (std::size_t k = 0; k < 3; ++k) {
      current_.corners[k].corner = triangle.corners[k];
      current_.corners[k].clip = corners[k].position;
    }
    current_.polygon.clear();
    current_.pieces.clear();
  }

  void divided(const ClipVertex& clip, NdcVertex& ndc) override {
    if (watching_) current_.polygon.push_back({clip, ndc, {}});
  }

  void placed(const NdcVertex&, ScreenVertex& screen) override {
    if (watching_) current_.polygon.back().screen = screen;
  }

  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override {
    if (watching_) current_.pieces.push_back({vertices, setup});
  }

  void faced(const TriangleSetup&, bool front, bool& culled) override {
    if (!watching_) return;
    current_.pieces.back().front = front;
    current_.pieces.back().culled = culled;
  }

  void prepared(const Triangle&) override {
    if (!watching_ || !reaches_wanted_pixels()) return;
    watching_ = false;
    const std::uint64_t bytes = sizeof(TracedTriangle) +
                                current_.polygon.size() * sizeof(TracedVertex) +
                                current_.pieces.size() * sizeof(TracedPiece);
    if (!has_room(bytes)) return;
    for (TracedCorner& corner : current_.corners) place(corner);
    trace_.triangles.push_back(current_);
  }

  // ---- fragments ----

  void interpolated(const FragmentSource&, const Coverage& coverage, Fragment&) override {
    coverage_ = coverage;
  }

  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool&) override {
    tracing_ = is_wanted(source, fragment) && has_room(sizeof(TracedFragment));
    if (!tracing_) return;
    TracedFragment& traced = trace_.fragments.emplace_back();
    traced.source = source;
    traced.instance = draw_->instance;
    if (source.is_triangle) traced.coverage = coverage_;
    traced.fragment = fragment;
    traced.code = code;
    traced.stored = stored;
  }

  void textured(const Varyings& at, Rgba& surface) override {
    if (!tracing_) return;
    trace_.fragments.back().at = at;
    trace_.fragments.back().surface = surface;
  }

  void lit(const Varyings&, const Rgba&, Rgba& color) override {
    if (tracing_) trace_.fragments.back().light = color;
  }

  void encoded(const Fragment&, const Rgba8& before, Rgba8& after) override {
    if (!tracing_) return;
    trace_.fragments.back().before = before;
    trace_.fragments.back().after = after;
  }

  void ended(const FragmentSource&, const Fragment&, Fate fate) override {
    if (tracing_) trace_.fragments.back().fate = fate;
  }

private:
  bool is_wanted(std::uint32_t number) const {
    return draw_wanted_ && (!filter_.triangle || *filter_.triangle == number);
  }

  bool is_wanted(const FragmentSource& source, const Fragment& fragment) const {
    if (!filter_.fragments || !draw_wanted_) return false;
    if (filter_.triangle && !(source.is_triangle && source.number == *filter_.triangle)) {
      return false;
    }
    return !filter_.pixels || contains(*filter_.pixels, fragment.x, fragment.y);
  }

  bool reaches_wanted_pixels() const {
    if (!filter_.pixels) return true;
    if (current_.pieces.empty()) return filter_.triangle.has_value();
    return std::any_of(current_.pieces.begin(), current_.pieces.end(),
                       [this](const TracedPiece& piece) {
                         return overlap(pixels_touched(piece.vertices), *filter_.pixels);
                       });
  }

  bool has_room(std::uint64_t bytes) {
    if (bytes_ + bytes > filter_.max_bytes) trace_.complete = false;
    if (!trace_.complete) return false;
    bytes_ += bytes;
    return true;
  }

  // Where the corner is in the spaces that the run does not visit.
  void place(TracedCorner& corner) const {
    corner.position = draw_->mesh->corners[corner.corner].position;
    corner.object = draw_->mesh->positions[corner.position];
    const Instance& instance = scene_.instances[draw_->instance];
    const Point<Object, double> object{corner.object.x, corner.object.y, corner.object.z};
    corner.world = scene_.nodes[instance.node].world_from_node * object;
    corner.eye = view_.eye_from_world * corner.world;
    corner.outcode = outcode(corner.clip, trace_.planes);
  }

  const Scene& scene_;
  const View& view_;
  const TraceFilter& filter_;
  Trace trace_;
  std::uint64_t bytes_ = 0;
  const Draw* draw_ = nullptr;
  bool draw_wanted_ = true;
  bool watching_ = false;   // the current triangle
  TracedTriangle current_;  // reused, so that what is not kept costs no allocation
  bool tracing_ = false;    // the current fragment
  Coverage coverage_;
};

}  // namespace

TracedRun trace(const Scene& scene, const View& view, const RenderSettings& settings,
                const TraceFilter& filter) {
  Tracer tracer(scene, view, filter);
  TracedRun run;
  run.rendering = render_staged(scene, view, settings, &tracer);
  run.trace = tracer.take();
  return run;
}

}  // namespace glassbox
