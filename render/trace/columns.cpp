#include <glassbox/render/trace/columns.h>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/trace/coverage_miss.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {
namespace {

class ColumnRecorder : public Observer {
public:
  ColumnRecorder(const Scene& scene, const View& view, const RenderSettings& settings,
                 const ColumnFilter& filter, ColumnRun& run)
      : scene_(scene), settings_(settings), filter_(filter), window_(view.viewport), run_(run) {
    run_.planes = render_planes(view);
  }

  void draw(const Draw& draw) override {
    draw_ = &draw;
    run_.draws.push_back(record_of(draw, scene_));
    run_.triangles_of_draw.push_back(0);
  }

  // ---- triangles ----

  void clipped(const PrimitiveStage& stage, const Triangle&,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override {
    std::array<Outcode, 3> codes;
    for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(corners[k].position, stage.planes);
    const ClipVerdict verdict = trivial_verdict(codes);
    marks_ = is_left_whole(corners, polygon) && verdict == ClipVerdict::kAccept ? 0
             : polygon.count > 0                                                ? kMarkCut
             : verdict == ClipVerdict::kReject                                  ? kMarkRejected
                                                                                : kMarkClippedAway;
    polygon_ = &polygon;
    reaches_ = !filter_.pixels || (marks_ != 0 && would_reach(corners, window_, *filter_.pixels));
  }

  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override {
    if (!setup) marks_ |= kMarkZeroArea;
    reaches_ = reaches_ || !intersect(pixels_touched(vertices), *filter_.pixels).empty();
  }

  void facing_tested(const TriangleSetup&, bool, bool& culled) override {
    marks_ |= culled ? kMarkCulled : kMarkSetUp;
  }

  void triangle_finished(const Triangle& triangle) override {
    if (!reaches_ || ++run_.triangle_count > filter_.max_triangles) return;
    TriangleColumns& columns = run_.triangles;
    const std::uint32_t number = draw_->first_number + triangle.number;
    columns.number.push_back(number);
    columns.face.push_back(triangle.face);
    for (std::size_t k = 0; k < 3; ++k) {
      columns.position[k].push_back(draw_->mesh->corners[triangle.corners[k]].position);
    }
    columns.marks.push_back(marks_);
    ++run_.triangles_of_draw.back();
    if (marks_ & kMarkCut) run_.cut.push_back({number, *polygon_});
  }

  // ---- fragments ----

  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t, bool&) override {
    recording_ = (!filter_.pixels || contains(*filter_.pixels, fragment.x, fragment.y)) &&
                 ++run_.fragment_count <= filter_.max_fragments;
    if (!recording_) return;
    FragmentColumns& columns = run_.fragments;
    columns.triangle.push_back(source.is_triangle ? source.number : kNoTriangle);
    columns.piece.push_back(std::uint8_t(source.piece));  // at most kMaxClipVertices - 3
    columns.x.push_back(std::uint16_t(fragment.x));       // below kMaxImageSide
    columns.y.push_back(std::uint16_t(fragment.y));
    if (!source.is_triangle) columns.code.push_back(code);
  }

  void encoded(const Fragment&, const Rgba8& before, Rgba8& after) override {
    if (!recording_) return;
    Rgba8 pixel = before;
    write_masked(settings_.mask, after, pixel);
    auto& [r, g, b, a] = run_.fragments.written;
    r.push_back(pixel.r);
    g.push_back(pixel.g);
    b.push_back(pixel.b);
    a.push_back(pixel.a);
  }

  void fragment_finished(const FragmentSource&, const Fragment&, FragmentResult result) override {
    if (recording_) run_.fragments.result.push_back(std::uint8_t(result));
  }

private:
  // Whether clipping left the triangle as it was. An observer that changes the run may have cut a
  // triangle that no plane cuts.
  static bool is_left_whole(const std::array<ClipVertex, 3>& corners, const ClipPolygon& polygon) {
    return polygon.count == 3 && polygon.vertices[0].position == corners[0].position &&
           polygon.vertices[1].position == corners[1].position &&
           polygon.vertices[2].position == corners[2].position;
  }

  const Scene& scene_;
  const RenderSettings& settings_;
  const ColumnFilter& filter_;
  const Viewport window_;
  ColumnRun& run_;
  const Draw* draw_ = nullptr;
  const ClipPolygon* polygon_ = nullptr;  // of the current triangle, until triangle_finished()
  std::uint8_t marks_ = 0;
  bool reaches_ = true;
  bool recording_ = false;
};

}  // namespace

ColumnRun record_columns(const Scene& scene, const View& view, const RenderSettings& settings,
                         const ColumnFilter& filter, Observer* stages) {
  ColumnRun run;
  ColumnRecorder recorder(scene, view, settings, filter, run);
  run.rendering = render_staged(scene, view, with_one_sample(settings), {stages, &recorder});
  return run;
}

}  // namespace glassbox
