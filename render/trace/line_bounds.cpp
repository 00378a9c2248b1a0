#include <glassbox/render/trace/line_bounds.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/vertex_bounds.h>

namespace glassbox {
namespace {

// The ends of a line before clipping: two of three corners, with the bounds and attributes of the
// corners.
struct Corners {
  std::array<ClipVertex, 3> clip;
  std::array<ClipVertexBound, 3> bounds;
  std::array<BoundedVaryings, 3> varyings;
  std::array<std::size_t, 2> ends{0, 1};
};

void add_corner(const CornerStage& stage, const TracedDraw& draw, const Corner& corner,
                std::size_t k, Corners& corners) {
  const Point<Object>& object = stage.draw.mesh->positions[corner.position];
  corners.clip[k].position = project_vertex(stage.draw, corner.position);
  corners.clip[k].weights[k] = 1;
  corners.bounds[k].position = clip_bound(object, draw, stage.bounds);
  corners.varyings[k] = corner_of_line(stage, corner);
}

Corners corners_of_mesh(const CornerStage& stage, const TracedDraw& draw,
                        const FragmentSource& source) {
  Corners corners;
  const Mesh& mesh = *stage.draw.mesh;
  if (source.line == LineKind::kPoint) {
    add_corner(stage, draw, mesh.points[source.number], 0, corners);
    return corners;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    add_corner(stage, draw, mesh.lines[source.number][k], k, corners);
  }
  return corners;
}

// Returns the corners of the triangle that the edge belongs to. The attributes are those of the
// side that is seen: front or back, as for the first triangle of the fan that is not culled.
Corners corners_of_triangle(const CornerStage& stage, const BoundsOfRun::KnownTriangle& known,
                            std::size_t edge) {
  const TracedTriangle& triangle = *known.triangle;
  const auto seen = std::ranges::find_if(
      triangle.pieces, [](const TracedPiece& piece) { return piece.setup && !piece.culled; });
  const bool front = seen == triangle.pieces.end() || seen->front;
  Corners corners;
  corners.clip = clip_vertices(triangle);
  const Mesh& mesh = *stage.draw.mesh;
  for (std::size_t k = 0; k < 3; ++k) {
    corners.bounds[k].position = known.bounds.corners[k].clip;
    corners.varyings[k] = face_corner_attributes(stage, triangle.face,
                                                 mesh.corners[triangle.corners[k].corner], front);
  }
  corners.ends = {edge, (edge + 1) % 3};
  return corners;
}

// Clips a line plane by plane, as clip_segment does, and changes the bounds of its ends with it.
void clip(std::span<const ClipPlane> planes, std::array<ClipVertex, 2>& ends,
          std::array<ClipVertexBound, 2>& bounds) {
  for (const ClipPlane& plane : planes) {
    const double d0 = signed_distance(plane, ends[0].position);
    const double d1 = signed_distance(plane, ends[1].position);
    if ((d0 >= 0) == (d1 >= 0)) continue;
    const std::size_t outside = d0 < 0 ? 0 : 1;  // the other end is inside, so something is left
    const ClipVertex crossing = clip_segment(ends, {&plane, 1}).value()[outside];
    bounds[outside] =
        crossing_bound(plane, ends[0], bounds[0], d0, ends[1], bounds[1], d1, crossing);
    ends[outside] = crossing;
  }
}

std::int64_t centre_of(int pixel) {
  return std::int64_t(pixel) * kSubpixels + kPixelCentre;
}

// A factor that covers the rounding errors of a sum and a product of bounds.
constexpr double kRoundUp = 1 + 0x1p-40;

}  // namespace

LineBounds::LineBounds(const CornerStage& stage, const Trace& trace, const TracedDraw& draw,
                       const FragmentSource& source, const BoundsOfRun::KnownTriangle* triangle)
    : is_point_(source.line == LineKind::kPoint) {
  assert((source.line == LineKind::kEdge) == (triangle != nullptr));
  const Corners corners = triangle != nullptr ? corners_of_triangle(stage, *triangle, source.edge)
                                              : corners_of_mesh(stage, draw, source);
  const auto [a, b] = is_point_ ? std::array<std::size_t, 2>{0, 0} : corners.ends;
  std::array<ClipVertex, 2> ends{corners.clip[a], corners.clip[b]};
  std::array<ClipVertexBound, 2> bounds{corners.bounds[a], corners.bounds[b]};
  if (!is_point_) clip(trace.planes, ends, bounds);
  std::array<BoundedVaryings, 3> vertices;
  for (std::size_t k = 0; k < 2; ++k) {
    TracedVertex& vertex = ends_[k].vertex;
    vertex.clip = ends[k];
    vertex.ndc = divide(ends[k]);
    vertex.screen = to_screen(vertex.ndc, trace.view.viewport);
    vertex.snapped = snap(vertex.screen);
    ends_[k].bounds = vertex_bounds(trace, vertex, bounds[k]);
    moved_ = std::max(moved_, snapped_bound(vertex, ends_[k].bounds));
    vertices[k + 1] = at_vertex(corners.varyings, ends[k], bounds[k]);
  }
  vertices[0] = vertices[1];
  const auto& [begin, end] = ends_;
  const bool begin_is_nearer = begin.vertex.screen.position.z < end.vertex.screen.position.z;
  const LineEnd& nearer = begin_is_nearer ? begin : end;
  const float wa = begin.vertex.screen.inverse_w, wb = end.vertex.screen.inverse_w;
  setup_.inverse_w = {wa, wa, wb};
  setup_.depth = {nearer.vertex.screen.position.z, begin.vertex.screen.position.z,
                  end.vertex.screen.position.z};
  setup_.affine = wa == wb;
  setup_bounds_.depth = {nearer.bounds.screen.z, begin.bounds.screen.z, end.bounds.screen.z};
  setup_bounds_.inverse_w = {begin.bounds.ndc.inverse_w, begin.bounds.ndc.inverse_w,
                             end.bounds.ndc.inverse_w};
  colors_.emplace(stage.draw, stage.lighting, stage.settings, setup_, setup_bounds_, vertices);
}

FragmentBounds LineBounds::of_fragment(const Fragment& fragment) const {
  if (!is_point_) return fragment_bounds(setup_, fragment, setup_bounds_);
  FragmentBounds bounds;
  bounds.depth = setup_bounds_.depth[0];
  bounds.inverse_w = setup_bounds_.inverse_w[0];
  return bounds;
}

ColorBounds LineBounds::colors(const TracedFragment& fragment, const FragmentBounds& bounds) const {
  return colors_->at(fragment, bounds);
}

bool LineBounds::may_miss(const Fragment& fragment) const {
  const std::array<SnappedVertex, 2> ends{ends_[0].vertex.snapped, ends_[1].vertex.snapped};
  return is_point_ ? point_may_miss(ends[0], fragment, moved_)
                   : line_may_miss(ends, fragment, moved_);
}

// point_may_miss() and line_may_miss() compare integers of 1/256 pixel; only the bound itself is
// rounded. Coordinates are below 2^24 (SnappedVertex), products below 2^50. A comparison with a NaN
// bound is false, and then the answer is "may miss".

bool point_may_miss(const SnappedVertex& point, const Fragment& fragment, double moved) {
  const double by = moved * kSubpixels * kRoundUp;
  const std::int64_t dx = std::abs(point.x - centre_of(fragment.x));
  const std::int64_t dy = std::abs(point.y - centre_of(fragment.y));
  return !(double(kPixelCentre - std::max(dx, dy)) > by);
}

bool line_may_miss(const std::array<SnappedVertex, 2>& ends, const Fragment& fragment,
                   double moved) {
  const double by = moved * kSubpixels * kRoundUp;
  const LineSetup line = setup_line(ends[0], ends[1]);
  const std::int64_t x = centre_of(line.x_major ? fragment.x : fragment.y);
  const std::int64_t y = centre_of(line.x_major ? fragment.y : fragment.x);
  // What an end of the line decides depends on whether it is inside the pixel's diamond (|dx| +
  // |dy| below half a pixel), and on which side of the pixel's centre it is. The exact end must be
  // the same in both respects.
  for (const SnappedVertex& end : {line.low, line.high}) {
    const std::int64_t dx = std::abs(end.x - x), dy = std::abs(end.y - y);
    const std::int64_t from_border = std::abs(dx + dy - kPixelCentre);
    if (!(double(from_border) > 2 * by && double(dx) > by)) return true;
  }
  // Between the ends, the exact line must also pass the pixel's centre at less than half a pixel's
  // distance along the shorter axis. The slope is at most 1; so if an end moves by `by` along x and
  // along y, the line moves by at most 2 by. Also, the same axis must stay the longer one: run -
  // |rise| changes by at most 4 by.
  const std::int64_t run = line.high.x - line.low.x, rise = line.high.y - line.low.y;
  if (!(double(run - std::abs(rise)) > 4 * by)) return true;
  const std::int64_t beside_times_run = (line.low.y - y) * run + (x - line.low.x) * rise;
  return !(double(kPixelCentre * run - std::abs(beside_times_run)) > 2 * by * double(run));
}

}  // namespace glassbox
