#include <glassbox/render/trace/bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/vertex_bounds.h>

namespace glassbox {
namespace {

constexpr double kRoundUp = 1 + 0x1p-40;

bool is_power_of_two(double x) {
  int exponent = 0;
  return std::abs(std::frexp(x, &exponent)) == 0.5;
}

// Returns bound 1 of SPEC C (docs/references.md) for a matrix in double with last row 0 0 0 1. A
// row that has only one product, by a power of two, has no rounding error.
glm::dvec3 affine_bound(const glm::dmat4& m, const glm::dvec3& point,
                        const glm::dvec3& point_bound) {
  const glm::dvec4 x(point, 1);
  const glm::dvec4 size = magnitude(m, x), inherited = magnitude(m, glm::dvec4(point_bound, 0));
  glm::dvec3 bound;
  for (int row = 0; row < 3; ++row) {
    int products = 0, last = 0;
    for (int column = 0; column < 4; ++column) {
      if (m[column][row] == 0 || x[column] == 0) continue;
      ++products;
      last = column;
    }
    const bool exact = products == 0 || (products == 1 && is_power_of_two(m[last][row]));
    bound[row] = ((exact ? 0 : gamma<double>(products) * size[row]) + inherited[row]) * kRoundUp;
  }
  return bound;
}

glm::vec4 anchored(const Point<Object>& object, const TracedDraw& draw) {
  return {object.x - draw.anchor.x, object.y - draw.anchor.y, object.z - draw.anchor.z, 1.0f};
}

// Returns the rounding error of subtracting the anchor: zero for an anchor from anchor_for().
glm::dvec4 anchoring_bound(const Point<Object>& object, const TracedDraw& draw) {
  const glm::vec4 rounded = anchored(object, draw);
  return {std::abs(double(object.x) - double(draw.anchor.x) - double(rounded.x)),
          std::abs(double(object.y) - double(draw.anchor.y) - double(rounded.y)),
          std::abs(double(object.z) - double(draw.anchor.z) - double(rounded.z)), 0};
}

CornerBounds corner_bounds(const Trace& trace, const TracedCorner& corner, const TracedDraw& draw,
                           const DrawBounds& draw_bounds) {
  const glm::dmat4 world = draw.world_from_object.columns;
  const glm::dmat4 eye = trace.view.eye_from_world.columns;
  CornerBounds bounds;
  bounds.world = affine_bound(world, glm::dvec3(to_glm(corner.object)), glm::dvec3(0));
  bounds.eye = affine_bound(eye, to_glm(corner.world), bounds.world);
  const glm::mat4 clip = draw.clip_from_anchored.columns;
  const glm::vec4 x = anchored(corner.object, draw);
  bounds.clip = clip_bound(corner.object, draw, draw_bounds);
  bounds.clip_magnitude = magnitude(clip, x);
  bounds.round_trip = round_trip(corner.object, corner.clip, bounds.clip,
                                 draw_bounds.forward_transform, trace.view.viewport);
  return bounds;
}

// ---- the clipped polygon ----

std::vector<ClipVertexBound> corners_in_clip(const std::array<CornerBounds, 3>& corners) {
  std::vector<ClipVertexBound> bounds;
  for (const CornerBounds& corner : corners) bounds.push_back({corner.clip, glm::dvec3(0)});
  return bounds;
}

std::vector<ClipVertexBound> after_step(const ClipPlane& plane, const ClipPolygon& before,
                                        const std::vector<ClipVertexBound>& bounds,
                                        const ClipStep& step) {
  std::vector<ClipVertexBound> after;
  for (int i = 0; i < step.after.count; ++i) {
    const std::size_t from = std::size_t(step.sources[std::size_t(i)][0]);
    const std::size_t to = std::size_t(step.sources[std::size_t(i)][1]);
    after.push_back(from == to
                        ? bounds[from]
                        : crossing_bound(plane, before.vertices[from], bounds[from],
                                         step.distances[from], before.vertices[to], bounds[to],
                                         step.distances[to], step.after.vertices[std::size_t(i)]));
  }
  return after;
}

// Returns the bounds of the clipped polygon's vertices: they are the vertices of the last clipping
// step, in order, without repetitions.
std::vector<ClipVertexBound> without_repetitions(const std::vector<TracedVertex>& polygon,
                                                 const ClipPolygon& last,
                                                 const std::vector<ClipVertexBound>& bounds) {
  std::vector<ClipVertexBound> kept;
  int i = 0;
  for (const TracedVertex& vertex : polygon) {
    while (i < last.count && last.vertices[std::size_t(i)].position != vertex.clip.position) ++i;
    if (i == last.count) break;  // an observer has replaced the clipper
    kept.push_back(bounds[std::size_t(i++)]);
  }
  kept.resize(polygon.size());
  return kept;
}

std::vector<ClipVertexBound> polygon_in_clip(const Trace& trace, const TracedTriangle& triangle,
                                             const std::array<CornerBounds, 3>& corners) {
  std::vector<ClipVertexBound> bounds = corners_in_clip(corners);
  const std::array<ClipVertex, 3> whole = clip_vertices(triangle);
  ClipPolygon polygon{{whole[0], whole[1], whole[2]}, 3};
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    bounds = after_step(trace.planes[i], polygon, bounds, triangle.clipping[i]);
    polygon = triangle.clipping[i].after;
  }
  return without_repetitions(triangle.polygon, polygon, bounds);
}

// ---- bounds on the screen ----

double largest_displacement(const TracedPiece& piece, const std::vector<VertexBounds>& polygon) {
  constexpr double kSnap = 0.5 / kSubpixels;
  double largest = 0;
  for (const std::size_t k : piece.polygon) {
    largest = std::max({largest, polygon[k].screen.x, polygon[k].screen.y});
  }
  return largest + kSnap;
}

// Sets the condition number of the divide; it is known only for the triangle's own corners.
void add_conditions(const TracedTriangle& triangle, TriangleBounds& bounds) {
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.polygon[i].clip.weights[k] != 1) continue;
      bounds.polygon[i].condition =
          divide_condition(triangle.polygon[i].clip.position, bounds.corners[k].clip_magnitude);
    }
  }
}

}  // namespace

glm::dvec4 clip_bound(const Point<Object>& object, const TracedDraw& draw,
                      const DrawBounds& bounds) {
  return transform_bound(draw.clip_from_anchored.columns, anchored(object, draw),
                         anchoring_bound(object, draw), bounds.clip_from_anchored);
}

VertexBounds vertex_bounds(const Trace& trace, const TracedVertex& vertex,
                           const ClipVertexBound& clip) {
  VertexBounds bounds;
  bounds.clip = clip;
  bounds.ndc = divide_bound(vertex.clip.position, clip.position);
  bounds.screen = screen_bound(vertex.ndc.position, bounds.ndc.position, trace.view.viewport);
  bounds.snap_x = snap_stability(vertex.screen.position.x, bounds.screen.x);
  bounds.snap_y = snap_stability(vertex.screen.position.y, bounds.screen.y);
  return bounds;
}

double snapped_bound(const TracedVertex& vertex, const VertexBounds& bounds) {
  const auto off = [](std::int32_t snapped, float screen, double bound) {
    return (std::abs(double(snapped) / kSubpixels - double(screen)) + bound) * kRoundUp;
  };
  const double x = off(vertex.snapped.x, vertex.screen.position.x, bounds.screen.x);
  const double y = off(vertex.snapped.y, vertex.screen.position.y, bounds.screen.y);
  return x <= y || y <= x ? std::max(x, y) : std::numeric_limits<double>::infinity();
}

DrawBounds bounds_of(const TracedDraw& draw, const View& view) {
  // The same products as in place_draw (draw_list.cpp), in the same order.
  const Transform<Eye, Object> eye_from_object = view.eye_from_world * draw.world_from_object;
  const Vector<Object, double> anchor{draw.anchor.x, draw.anchor.y, draw.anchor.z};
  const glm::dmat4 from_anchored = translate<Object, Object>(anchor).columns;
  const glm::dmat4 eye = eye_from_object.columns * from_anchored;
  const glm::dmat4 clip = view.clip_from_eye.columns * eye;
  const glm::dmat4 eye_from_object_bound =
      product_bound(view.eye_from_world.columns, draw.world_from_object.columns);
  const glm::dmat4 eye_bound =
      product_bound(eye_from_object.columns, from_anchored, eye_from_object_bound);
  DrawBounds bounds;
  bounds.eye_from_anchored = eye_bound + rounding_bound(eye);
  bounds.clip_from_anchored =
      product_bound(view.clip_from_eye.columns, eye, glm::dmat4(0), eye_bound) +
      rounding_bound(clip);
  bounds.viewer = viewer_in_object_space(eye_from_object, view.perspective);
  bounds.forward_transform = {(view.clip_from_eye * eye_from_object).columns,
                              product_bound(view.clip_from_eye.columns, eye_from_object.columns,
                                            glm::dmat4(0), eye_from_object_bound)};
  return bounds;
}

TriangleBounds bounds_of(const Trace& trace, const TracedTriangle& triangle, const TracedDraw& draw,
                         const DrawBounds& draw_bounds) {
  TriangleBounds bounds;
  std::array<Point<Object>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    bounds.corners[k] = corner_bounds(trace, triangle.corners[k], draw, draw_bounds);
    corners[k] = triangle.corners[k].object;
  }
  const std::vector<ClipVertexBound> clip = polygon_in_clip(trace, triangle, bounds.corners);
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    bounds.polygon.push_back(vertex_bounds(trace, triangle.polygon[i], clip[i]));
  }
  add_conditions(triangle, bounds);
  for (const TracedPiece& piece : triangle.pieces) {
    bounds.double_area.push_back(
        area_bound(piece.vertices, largest_displacement(piece, bounds.polygon)));
  }
  if (draw_bounds.viewer) bounds.back_face = test_back_face(corners, *draw_bounds.viewer);
  return bounds;
}

std::array<PlaneDistance, kMaxClipPlanes> plane_distances(const Trace& trace,
                                                          const TracedCorner& corner,
                                                          const CornerBounds& bounds) {
  std::array<PlaneDistance, kMaxClipPlanes> distances;
  for (std::size_t i = 0; i < trace.planes.size(); ++i) {
    distances[i] = {signed_distance(trace.planes[i], corner.clip),
                    distance_bound(trace.planes[i], bounds.clip)};
  }
  return distances;
}

SetupBounds setup_bounds(const TracedPiece& piece, const TriangleBounds& bounds) {
  SetupBounds setup;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexBounds& vertex = bounds.polygon[piece.polygon[std::size_t(piece.setup->order[k])]];
    setup.depth[k] = vertex.screen.z;
    setup.inverse_w[k] = vertex.ndc.inverse_w;
  }
  return setup;
}

// ---- bounds of a whole run ----

BoundsOfRun::BoundsOfRun(const View& view) {
  trace_.view = view;
  trace_.planes = render_planes(view);
}

const DrawBounds& BoundsOfRun::draw(const TracedDraw& draw) {
  KnownDraw& known = draws_[draw.instance];
  known = {draw, bounds_of(draw, trace_.view)};
  return known.bounds;
}

const BoundsOfRun::KnownTriangle& BoundsOfRun::triangle(const TracedTriangle& triangle) {
  if (std::exchange(fragments_came_, false)) {
    latest_.clear();
    earlier_.clear();
  }
  // If many triangles come without fragments, this limits the memory.
  if (latest_.size() == kTriangleBatch) earlier_ = std::exchange(latest_, {});
  const auto& [draw, draw_bounds] = of_instance(triangle.instance);
  Kept& kept = latest_[triangle.number];
  kept.triangle = triangle;
  kept.known = {&kept.triangle, bounds_of(trace_, triangle, draw, draw_bounds)};
  return kept.known;
}

const BoundsOfRun::KnownTriangle* BoundsOfRun::of_fragment(const TracedFragment& fragment) {
  fragments_came_ = true;
  return fragment.source.is_triangle ? of_triangle(fragment.source.number) : nullptr;
}

const BoundsOfRun::KnownTriangle* BoundsOfRun::of_triangle(std::uint32_t number) {
  fragments_came_ = true;
  for (const auto* triangles : {&latest_, &earlier_}) {
    const auto found = triangles->find(number);
    if (found != triangles->end()) return &found->second.known;
  }
  return nullptr;
}

std::map<std::uint32_t, BoundsOfRun::KnownTriangle> bounds_of_all(const Trace& trace) {
  std::map<std::uint32_t, std::pair<const TracedDraw*, DrawBounds>> draws;
  for (const TracedDraw& draw : trace.draws) {
    draws[draw.instance] = {&draw, bounds_of(draw, trace.view)};
  }
  std::map<std::uint32_t, BoundsOfRun::KnownTriangle> known;
  for (const TracedTriangle& triangle : trace.triangles) {
    const auto& [draw, draw_bounds] = draws.at(triangle.instance);
    known[triangle.number] = {&triangle, bounds_of(trace, triangle, *draw, draw_bounds)};
  }
  return known;
}

FragmentBounds bounds_of(const BoundsOfRun::KnownTriangle& known, const TracedFragment& fragment) {
  const TracedPiece& piece = known.triangle->pieces[fragment.source.piece];
  return fragment_bounds(*piece.setup, fragment.fragment, setup_bounds(piece, known.bounds));
}

void RoundTrips::add(const TracedTriangle& triangle, const TriangleBounds& bounds) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::optional<RoundTrip>& trip = bounds.corners[k].round_trip;
    if (!trip) continue;
    ++corners;
    if (!trip->is_bounded()) {
      ++unbounded;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double error = trip->error[axis];
      largest_ratio = std::max(largest_ratio, error / trip->bound[axis]);
      if (error < largest_error || (error == largest_error && bound > 0)) continue;
      largest_error = error;
      bound = trip->bound[axis];
      place = {triangle.number, k, std::uint32_t(axis)};
    }
  }
}

}  // namespace glassbox
