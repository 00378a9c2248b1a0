#include <glassbox/render/trace/line_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/vertex_bounds.h>

namespace glassbox {
namespace {

// What the line has at its ends before it is clipped, by weights of three corners.
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
  if (line_kind(source) == LineKind::kPoint) {
    add_corner(stage, draw, mesh.points[source.number], 0, corners);
    return corners;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    add_corner(stage, draw, mesh.lines[source.number][k], k, corners);
  }
  return corners;
}

// Attributes are those of the side that is seen first.
Corners corners_of_triangle(const CornerStage& stage, const BoundsOfRun::Known& known,
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
    corners.varyings[k] = corner_of_face(stage, mesh.faces[triangle.face],
                                         mesh.corners[triangle.corners[k].corner], front);
  }
  corners.ends = {edge, (edge + 1) % 3};
  return corners;
}

// Plane by plane, as clip_segment does it.
void clip(std::span<const ClipPlane> planes, std::array<ClipVertex, 2>& ends,
          std::array<ClipVertexBound, 2>& bounds) {
  for (const ClipPlane& plane : planes) {
    const double d0 = signed_distance(plane, ends[0].position);
    const double d1 = signed_distance(plane, ends[1].position);
    if ((d0 >= 0) == (d1 >= 0)) continue;
    const auto cut = clip_segment(ends, {&plane, 1});
    if (!cut) continue;
    const std::size_t outside = d0 < 0 ? 0 : 1;
    const ClipVertex& crossing = (*cut)[outside];
    bounds[outside] =
        crossing_bound(plane, ends[0], bounds[0], d0, ends[1], bounds[1], d1, crossing);
    ends[outside] = crossing;
  }
}

double pixels(std::int32_t subpixels) {
  return double(subpixels) / kSubpixels;
}

}  // namespace

LineBounds::LineBounds(const CornerStage& stage, const Trace& trace, const TracedDraw& draw,
                       const FragmentSource& source, const BoundsOfRun::Known* triangle)
    : is_point_(line_kind(source) == LineKind::kPoint), stage_(stage) {
  const Corners corners = triangle != nullptr
                              ? corners_of_triangle(stage, *triangle, edge_of(source))
                              : corners_of_mesh(stage, draw, source);
  const auto [a, b] = is_point_ ? std::array<std::size_t, 2>{0, 0} : corners.ends;
  std::array<ClipVertex, 2> ends{corners.clip[a], corners.clip[b]};
  std::array<ClipVertexBound, 2> bounds{corners.bounds[a], corners.bounds[b]};
  if (!is_point_) clip(trace.planes, ends, bounds);
  for (std::size_t k = 0; k < 2; ++k) {
    TracedVertex& vertex = ends_[k].vertex;
    vertex.clip = ends[k];
    vertex.ndc = divide(ends[k]);
    vertex.screen = to_screen(vertex.ndc, trace.view.viewport);
    vertex.snapped = snap(vertex.screen);
    ends_[k].bounds = vertex_bounds(trace, vertex, bounds[k]);
    vertices_[k + 1] = at_vertex(corners.varyings, ends[k], bounds[k]);
  }
  vertices_[0] = vertices_[1];
  const auto& [begin, end] = ends_;
  const bool begin_is_nearer = begin.vertex.screen.position.z < end.vertex.screen.position.z;
  const End& nearer = begin_is_nearer ? begin : end;
  const float wa = begin.vertex.screen.inverse_w, wb = end.vertex.screen.inverse_w;
  setup_.inverse_w = {wa, wa, wb};
  setup_.depth = {nearer.vertex.screen.position.z, begin.vertex.screen.position.z,
                  end.vertex.screen.position.z};
  setup_.affine = wa == wb;
  setup_bounds_.depth = {nearer.bounds.screen.z, begin.bounds.screen.z, end.bounds.screen.z};
  setup_bounds_.inverse_w = {begin.bounds.ndc.inverse_w, begin.bounds.ndc.inverse_w,
                             end.bounds.ndc.inverse_w};
}

FragmentBounds LineBounds::of(const Fragment& fragment) const {
  if (!is_point_) return fragment_bounds(setup_, fragment, setup_bounds_);
  FragmentBounds bounds;
  bounds.depth = setup_bounds_.depth[0];
  bounds.inverse_w = setup_bounds_.inverse_w[0];
  return bounds;
}

ColorBounds LineBounds::colors(const TracedFragment& fragment, const FragmentBounds& bounds) const {
  return PieceColors(stage_.draw, stage_.lighting, stage_.settings, setup_, setup_bounds_,
                     vertices_)
      .at(fragment, bounds);
}

bool LineBounds::may_miss(const Fragment& fragment, double moved) const {
  const std::array<SnappedVertex, 2> ends{ends_[0].vertex.snapped, ends_[1].vertex.snapped};
  if (!is_point_) return line_may_miss(ends, fragment, moved);
  const double x = fragment.x + 0.5, y = fragment.y + 0.5;
  return 0.5 - std::max(std::abs(pixels(ends[0].x) - x), std::abs(pixels(ends[0].y) - y)) <= moved;
}

bool line_may_miss(const std::array<SnappedVertex, 2>& ends, const Fragment& fragment,
                   double moved) {
  const double x = fragment.x + 0.5, y = fragment.y + 0.5;
  const std::array<double, 2> a{pixels(ends[0].x), pixels(ends[0].y)},
      b{pixels(ends[1].x), pixels(ends[1].y)};
  // An end decides by whether it lies in the pixel's diamond, and on which side of its centre.
  const bool x_major = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]);
  for (const auto& end : {a, b}) {
    const double dx = std::abs(end[0] - x), dy = std::abs(end[1] - y);
    if (std::abs(dx + dy - 0.5) <= 2 * moved || (x_major ? dx : dy) <= moved) return true;
  }
  // Between them the line passes the pixel's centre less than half a pixel beside it. Its slope is at most 1, so that it moves by no
  // more than both coordinates of an end; and which axis is the longer one must not change.
  const double run = x_major ? b[0] - a[0] : b[1] - a[1];
  const double rise = x_major ? b[1] - a[1] : b[0] - a[0];
  if (std::abs(run) - std::abs(rise) <= 4 * moved) return true;
  const double along = x_major ? x - a[0] : y - a[1];
  const double beside = (x_major ? a[1] - y : a[0] - x) + along * rise / run;
  return 0.5 - std::abs(beside) <= 2 * moved;
}

}  // namespace glassbox
