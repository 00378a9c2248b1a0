#include <glassbox/render/trace/arrays.h>

#include <algorithm>
#include <limits>

namespace glassbox {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// ---- what each table has: a call for each number of a record ----

void fill_run(Table& table, const View& view) {
  const Viewport& v = view.viewport;
  table("eye_from_world", view.eye_from_world.columns);
  table("clip_from_eye", view.clip_from_eye.columns);
  table("viewport", std::array{v.left, v.top, v.right, v.bottom});
  table("near", view.near);
  table("far", view.far);
}

void fill_plane(Table& table, const ClipPlane& plane) {
  table("coefficients", std::array{double(plane.a), double(plane.b), double(plane.c),
                                   double(plane.d), double(plane.e)});
}

void fill_draw(Table& table, const TracedDraw& draw, const DrawBounds& bounds) {
  table("instance", draw.instance);
  table("first_number", draw.first_number);
  table("mirrored", draw.mirrored);
  table("world_from_object", draw.world_from_object.columns);
  table("anchor", to_glm(draw.anchor));
  table("clip_from_anchored", draw.clip_from_anchored.columns);
  table("clip_from_anchored_bound", bounds.clip_from_anchored);
  table("eye_from_anchored", draw.eye_from_anchored.columns);
  table("eye_from_anchored_bound", bounds.eye_from_anchored);
}

std::int8_t sign_of(Facing facing) {
  return facing == Facing::kFront ? 1 : facing == Facing::kBack ? -1 : 0;
}

// Where a triangle's rows begin in the tables that have several.
struct Beginnings {
  std::size_t cut = 0, vertex = 0, piece = 0;
};

void fill_triangle(Table& table, const TracedTriangle& triangle, const TriangleBounds& bounds,
                   const Beginnings& first) {
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = triangle.corners[k].outcode;
  table("number", triangle.number);
  table("instance", triangle.instance);
  table("face", triangle.face);
  table("verdict", std::uint8_t(trivial_verdict(codes)));
  table("first_cut", std::uint64_t(first.cut));
  table("cut_count", std::uint8_t(triangle.clipping.size()));
  table("first_vertex", std::uint64_t(first.vertex));
  table("vertex_count", std::uint8_t(triangle.polygon.size()));
  table("first_piece", std::uint64_t(first.piece));
  table("piece_count", std::uint8_t(triangle.pieces.size()));
  const auto& test = bounds.back_face;
  table("facing", test ? sign_of(test->facing) : std::int8_t(0));
  table("facing_value", test ? test->value : kNone);
  table("facing_bound", test ? test->bound + test->viewer_error_bound : kNone);
}

void fill_corner(Table& table, const Trace& trace, const TracedCorner& corner,
                 const CornerBounds& bounds) {
  table("corner", corner.corner);
  table("position", corner.position);
  table("object", to_glm(corner.object));
  table("world", to_glm(corner.world));
  table("world_bound", bounds.world);
  table("eye", to_glm(corner.eye));
  table("eye_bound", bounds.eye);
  table("clip", to_glm(corner.clip));
  table("clip_bound", bounds.clip);
  table("outcode", corner.outcode);
  std::array<double, kMaxClipPlanes> distances{}, distance_bounds{};
  const auto found = plane_distances(trace, corner, bounds);
  for (std::size_t i = 0; i < found.size(); ++i) {
    distances[i] = found[i].distance;
    distance_bounds[i] = found[i].bound;
  }
  table("distance", distances);
  table("distance_bound", distance_bounds);
  const auto& trip = bounds.round_trip;
  table("round_trip", trip ? to_glm(trip->object) : glm::dvec3(kNone));
  table("round_trip_error", trip ? trip->error : glm::dvec3(kNone));
  table("round_trip_bound", trip ? trip->bound : glm::dvec3(kNone));
}

void fill_cut(Table& table, std::size_t triangle, std::size_t plane, std::size_t first_vertex,
              int count) {
  table("triangle", std::uint64_t(triangle));
  table("plane", std::uint8_t(plane));
  table("first_vertex", std::uint64_t(first_vertex));
  table("vertex_count", std::uint8_t(count));
}

void fill_cut_vertex(Table& table, const ClipVertex& vertex, const std::array<int, 2>& from) {
  table("clip", to_glm(vertex.position));
  table("weights", vertex.weights);
  table("from", std::array{std::uint8_t(from[0]), std::uint8_t(from[1])});
}

void fill_vertex(Table& table, const TracedVertex& vertex, const VertexBounds& bounds) {
  table("clip", to_glm(vertex.clip.position));
  table("clip_bound", bounds.clip.position);
  table("weights", vertex.clip.weights);
  table("weights_bound", bounds.clip.weights);
  table("ndc", to_glm(vertex.ndc.position));
  table("ndc_bound", bounds.ndc.position);
  table("ndc_condition", bounds.condition == glm::dvec3(0) ? glm::dvec3(kNone) : bounds.condition);
  table("inverse_w", vertex.ndc.inverse_w);
  table("inverse_w_bound", bounds.ndc.inverse_w);
  table("screen", std::array{vertex.screen.position.x, vertex.screen.position.y});
  table("screen_bound", std::array{bounds.screen.x, bounds.screen.y});
  table("snapped", std::array{vertex.snapped.x, vertex.snapped.y});
  table("snap_stable", std::array{bounds.snap_x.stable, bounds.snap_y.stable});
}

void fill_piece(Table& table, std::size_t triangle, const TracedPiece& piece, double area_bound) {
  const TriangleSetup setup = piece.setup.value_or(TriangleSetup{});
  std::array<std::array<std::int64_t, 3>, 3> edges{};
  std::array<bool, 3> owns_zero{};
  std::array<std::uint8_t, 3> polygon{}, order{};
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& edge = setup.edges[k];
    edges[k] = {edge.a, edge.b, edge.c};
    owns_zero[k] = edge.owns_zero;
    polygon[k] = std::uint8_t(piece.polygon[k]);
    order[k] = std::uint8_t(setup.order[k]);
  }
  table("triangle", std::uint64_t(triangle));
  table("polygon", polygon);
  table("set_up", piece.setup.has_value());
  table("double_area", setup.double_area);
  table("double_area_px2_bound", area_bound);
  table("clockwise", setup.clockwise);
  table("front", piece.front);
  table("culled", piece.culled);
  table("order", order);
  table("edges", edges);
  table("owns_zero", owns_zero);
  table("depth", setup.depth);
  table("inverse_w", setup.inverse_w);
  table("inverse_area", setup.inverse_area);
  table("affine", setup.affine);
  table("bounds", std::array{setup.bounds.x0, setup.bounds.y0, setup.bounds.x1, setup.bounds.y1});
}

std::array<float, 4> numbers_of(const Rgba& c) {
  return {c.r, c.g, c.b, c.a};
}

std::array<std::uint8_t, 4> numbers_of(const Rgba8& c) {
  return {c.r, c.g, c.b, c.a};
}

void fill_fragment(Table& table, const TracedFragment& traced, const FragmentBounds& bounds) {
  const Fragment& fragment = traced.fragment;
  const FragmentSource& source = traced.source;
  table("triangle", source.is_triangle ? std::int64_t(source.number) : std::int64_t(-1));
  table("piece", std::uint8_t(source.is_triangle ? source.piece : 0));
  table("instance", traced.instance);
  table("pixel", std::array{std::uint16_t(fragment.x), std::uint16_t(fragment.y)});
  table("edges", traced.coverage.edges);
  table("lambda", fragment.lambda);
  table("lambda_bound", bounds.lambda);
  table("weights", fragment.weights);
  table("weights_bound", bounds.weights);
  table("depth", fragment.depth);
  table("depth_bound", bounds.depth);
  table("inverse_w", fragment.inverse_w);
  table("inverse_w_bound", bounds.inverse_w);
  table("distance_bound", bounds.distance);
  table("incoming", traced.code);
  table("stored", traced.stored);
  table("fate", std::uint8_t(traced.fate));
  table("normal", traced.at.normal);
  table("position", traced.at.position);
  table("diffuse", traced.at.diffuse);
  table("specular", traced.at.specular);
  table("color", traced.at.color);
  table("texcoord", traced.at.texcoord);
  table("surface", numbers_of(traced.surface));
  table("emission", traced.emission);
  table("light", numbers_of(traced.light));
  table("before", numbers_of(traced.before));
  table("after", numbers_of(traced.after));
}

void fill_round_trips(Table& table, const RoundTrips& trips) {
  table("corners", trips.corners);
  table("unbounded", trips.unbounded);
  table("largest_error", trips.largest_error);
  table("bound", trips.bound);
  table("triangle", trips.place.triangle);
  table("corner", trips.place.corner);
  table("axis", trips.place.axis);
  table("largest_ratio", trips.largest_ratio);
}

FragmentBounds no_bounds() {
  FragmentBounds none{};
  none.lambda.fill(kNone);
  none.weights.fill(kNone);
  none.depth = none.inverse_w = none.distance = kNone;
  return none;
}

}  // namespace

// ---- counting ----

void TraceCounter::draw(const TracedDraw& draw) {
  ++counts_.draws;
  draws_.push_back(draw);
}

void TraceCounter::triangle(const TracedTriangle& triangle) {
  ++counts_.triangles;
  counts_.cuts += triangle.clipping.size();
  for (const ClipStep& step : triangle.clipping)
    counts_.cut_vertices += std::uint64_t(step.after.count);
  counts_.vertices += triangle.polygon.size();
  counts_.pieces += triangle.pieces.size();
}

void TraceCounter::fragment(const TracedFragment&) {
  ++counts_.fragments;
}

// ---- the arrays ----

TraceArrays::TraceArrays(const View& view, const std::vector<std::string>& wanted) : bounds_(view) {
  run_.declare([&](Table& t) { fill_run(t, view); });
  plane_.declare([](Table& t) { fill_plane(t, {}); });
  draw_.declare([](Table& t) { fill_draw(t, {}, {}); });
  triangle_.declare([](Table& t) { fill_triangle(t, {}, {}, {}); });
  corner_.declare([&](Table& t) { fill_corner(t, bounds_.trace(), {}, {}); });
  cut_.declare([](Table& t) { fill_cut(t, 0, 0, 0, 0); });
  cut_vertex_.declare([](Table& t) { fill_cut_vertex(t, {}, {}); });
  vertex_.declare([](Table& t) { fill_vertex(t, {}, {}); });
  piece_.declare([](Table& t) { fill_piece(t, 0, {}, 0); });
  fragment_.declare([](Table& t) { fill_fragment(t, {}, no_bounds()); });
  round_trip_.declare([](Table& t) { fill_round_trips(t, {}); });
  for (const std::string& name : wanted) {
    bool found = false;
    for (const Table* table : std::as_const(*this).tables()) found |= table->names(name);
    if (!found) unknown_.push_back(name);
  }
  for (Table* table : tables()) {
    if (!wanted.empty()) table->choose(wanted);
  }
  run_.add_row([&](Table& t) { fill_run(t, view); });
  for (const ClipPlane& plane : bounds_.trace().planes) {
    plane_.add_row([&](Table& t) { fill_plane(t, plane); });
  }
}

std::array<const Table*, 11> TraceArrays::tables() const {
  return {&run_,        &plane_,  &draw_,  &triangle_, &corner_,    &cut_,
          &cut_vertex_, &vertex_, &piece_, &fragment_, &round_trip_};
}

std::array<Table*, 11> TraceArrays::tables() {
  return {&run_,        &plane_,  &draw_,  &triangle_, &corner_,    &cut_,
          &cut_vertex_, &vertex_, &piece_, &fragment_, &round_trip_};
}

std::array<std::uint64_t, 11> TraceArrays::rows_for(const TraceCounts& c) const {
  return {1,      plane_.rows(),  c.draws,    c.triangles, 3 * c.triangles,
          c.cuts, c.cut_vertices, c.vertices, c.pieces,    c.fragments,
          1};
}

std::uint64_t TraceArrays::bytes_for(const TraceCounts& counts) const {
  const auto rows = rows_for(counts);
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) bytes += rows[i] * tables()[i]->row_bytes();
  return bytes;
}

void TraceArrays::reserve(const TraceCounts& counts) {
  const auto rows = rows_for(counts);
  for (std::size_t i = 0; i < rows.size(); ++i) tables()[i]->reserve(rows[i]);
}

void TraceArrays::draw(const TracedDraw& draw) {
  const DrawBounds& bounds = bounds_.draw(draw);
  draw_.add_row([&](Table& t) { fill_draw(t, draw, bounds); });
}

void TraceArrays::triangle(const TracedTriangle& triangle) {
  const TriangleBounds& bounds = bounds_.triangle(triangle).bounds;
  round_trips_.see(triangle, bounds);
  const std::size_t row = triangle_.rows();
  const Beginnings first{cut_.rows(), vertex_.rows(), piece_.rows()};
  triangle_.add_row([&](Table& t) { fill_triangle(t, triangle, bounds, first); });
  for (std::size_t k = 0; k < 3; ++k) {
    corner_.add_row(
        [&](Table& t) { fill_corner(t, bounds_.trace(), triangle.corners[k], bounds.corners[k]); });
  }
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    const ClipStep& step = triangle.clipping[i];
    cut_.add_row([&](Table& t) { fill_cut(t, row, i, cut_vertex_.rows(), step.after.count); });
    for (std::size_t j = 0; j < std::size_t(step.after.count); ++j) {
      cut_vertex_.add_row(
          [&](Table& t) { fill_cut_vertex(t, step.after.vertices[j], step.sources[j]); });
    }
  }
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    vertex_.add_row([&](Table& t) { fill_vertex(t, triangle.polygon[i], bounds.polygon[i]); });
  }
  for (std::size_t i = 0; i < triangle.pieces.size(); ++i) {
    piece_.add_row(
        [&](Table& t) { fill_piece(t, row, triangle.pieces[i], bounds.double_area[i]); });
  }
}

void TraceArrays::fragment(const TracedFragment& fragment) {
  const BoundsOfRun::Known* known = bounds_.of(fragment);
  const FragmentBounds bounds = known == nullptr ? no_bounds() : bounds_of(*known, fragment);
  fragment_.add_row([&](Table& t) { fill_fragment(t, fragment, bounds); });
}

void TraceArrays::finish() {
  round_trip_.add_row([&](Table& t) { fill_round_trips(t, round_trips_); });
}

}  // namespace glassbox
