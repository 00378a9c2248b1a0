#include <glassbox/render/trace/arrays.h>

#include <algorithm>
#include <limits>
#include <optional>

#include <glassbox/render/trace/fields.h>

namespace glassbox {
namespace {

// ---- the columns of each table: one call for each number of a record ----

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
  each_field(draw, bounds, table);
}

// Where a triangle's rows begin in the tables that have several rows for a triangle.
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
  std::int8_t facing = 0;
  std::optional<double> value, bound;
  if (const auto& test = bounds.back_face) {
    facing = test->facing == Facing::kFront ? 1 : test->facing == Facing::kBack ? -1 : 0;
    value = test->value;
    bound = test->bound + test->viewer_error_bound;
  }
  table("facing", facing);
  table("facing_value", value);
  table("facing_bound", bound);
}

void fill_corner(Table& table, const Trace& trace, const TracedCorner& corner,
                 const CornerBounds& bounds) {
  each_field(corner, bounds, table);
  table("outcode", corner.outcode);
  std::array<double, kMaxClipPlanes> distances{}, distance_bounds{};
  const auto found = plane_distances(trace, corner, bounds);
  for (std::size_t i = 0; i < found.size(); ++i) {
    distances[i] = found[i].distance;
    distance_bounds[i] = found[i].bound;
  }
  table("distance", distances);
  table("distance_bound", distance_bounds);
  std::optional<glm::dvec3> object, error, bound;
  if (const auto& trip = bounds.round_trip) {
    object = to_glm(trip->object);
    error = trip->error;
    bound = trip->bound;
  }
  table("round_trip", object);
  table("round_trip_error", error);
  table("round_trip_bound", bound);
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

void fill_fragment(Table& table, const TracedFragment& traced, const FragmentBounds& bounds) {
  const Fragment& fragment = traced.fragment;
  const FragmentSource& source = traced.source;
  table("triangle", source.is_triangle ? std::int64_t(source.number) : std::int64_t(-1));
  table("piece", std::uint8_t(source.piece));
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
  table("fate", std::uint8_t(traced.result));
  each_field(traced.at, table);
  table("surface", numbers_of(traced.surface));
  table("emission", traced.emission);
  table("light", numbers_of(traced.light));
  table("before", numbers_of(traced.before));
  table("after", numbers_of(traced.after));
}

FragmentBounds no_bounds() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
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
  const auto declare = [&](Kind kind, const auto& fill) { tables_[kind].declare(fill); };
  declare(kRun, [&](Table& t) { fill_run(t, view); });
  declare(kPlane, [](Table& t) { fill_plane(t, {}); });
  declare(kDraw, [](Table& t) { fill_draw(t, {}, {}); });
  declare(kTriangle, [](Table& t) { fill_triangle(t, {}, {}, {}); });
  declare(kCorner, [&](Table& t) { fill_corner(t, bounds_.trace(), {}, {}); });
  declare(kCut, [](Table& t) { fill_cut(t, 0, 0, 0, 0); });
  declare(kCutVertex, [](Table& t) { fill_cut_vertex(t, {}, {}); });
  declare(kVertex, [](Table& t) { each_field(TracedVertex{}, VertexBounds{}, t); });
  declare(kPiece, [](Table& t) { fill_piece(t, 0, {}, 0); });
  declare(kFragment, [](Table& t) { fill_fragment(t, {}, no_bounds()); });
  declare(kRoundTrip, [](Table& t) { each_field(RoundTrips{}, t); });
  for (const std::string& name : wanted) {
    const bool found =
        std::ranges::any_of(tables_, [&](const Table& table) { return table.names(name); });
    if (!found) unknown_.push_back(name);
  }
  for (Table& table : tables_) {
    if (!wanted.empty()) table.choose(wanted);
  }
  tables_[kRun].add_row([&](Table& t) { fill_run(t, view); });
  for (const ClipPlane& plane : bounds_.trace().planes) {
    tables_[kPlane].add_row([&](Table& t) { fill_plane(t, plane); });
  }
}

std::array<std::uint64_t, TraceArrays::kKinds> TraceArrays::rows_for(const TraceCounts& c) const {
  std::array<std::uint64_t, kKinds> rows{};
  rows[kRun] = rows[kRoundTrip] = 1;
  rows[kPlane] = tables_[kPlane].rows();
  rows[kDraw] = c.draws;
  rows[kTriangle] = c.triangles;
  rows[kCorner] = 3 * c.triangles;
  rows[kCut] = c.cuts;
  rows[kCutVertex] = c.cut_vertices;
  rows[kVertex] = c.vertices;
  rows[kPiece] = c.pieces;
  rows[kFragment] = c.fragments;
  return rows;
}

std::uint64_t TraceArrays::bytes_for(const TraceCounts& counts) const {
  const auto rows = rows_for(counts);
  std::uint64_t bytes = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) bytes += rows[kind] * tables_[kind].row_bytes();
  return bytes;
}

void TraceArrays::reserve(const TraceCounts& counts) {
  const auto rows = rows_for(counts);
  for (std::size_t kind = 0; kind < kKinds; ++kind) tables_[kind].reserve(rows[kind]);
}

void TraceArrays::draw(const TracedDraw& draw) {
  const DrawBounds& bounds = bounds_.draw(draw);
  tables_[kDraw].add_row([&](Table& t) { fill_draw(t, draw, bounds); });
}

void TraceArrays::triangle(const TracedTriangle& triangle) {
  const TriangleBounds& bounds = bounds_.triangle(triangle).bounds;
  round_trips_.add(triangle, bounds);
  const std::size_t row = tables_[kTriangle].rows();
  const Beginnings first{tables_[kCut].rows(), tables_[kVertex].rows(), tables_[kPiece].rows()};
  tables_[kTriangle].add_row([&](Table& t) { fill_triangle(t, triangle, bounds, first); });
  for (std::size_t k = 0; k < 3; ++k) {
    tables_[kCorner].add_row(
        [&](Table& t) { fill_corner(t, bounds_.trace(), triangle.corners[k], bounds.corners[k]); });
  }
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    const ClipStep& step = triangle.clipping[i];
    const std::size_t first_vertex = tables_[kCutVertex].rows();
    tables_[kCut].add_row([&](Table& t) { fill_cut(t, row, i, first_vertex, step.after.count); });
    for (std::size_t j = 0; j < std::size_t(step.after.count); ++j) {
      tables_[kCutVertex].add_row(
          [&](Table& t) { fill_cut_vertex(t, step.after.vertices[j], step.sources[j]); });
    }
  }
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    tables_[kVertex].add_row(
        [&](Table& t) { each_field(triangle.polygon[i], bounds.polygon[i], t); });
  }
  for (std::size_t i = 0; i < triangle.pieces.size(); ++i) {
    tables_[kPiece].add_row(
        [&](Table& t) { fill_piece(t, row, triangle.pieces[i], bounds.double_area[i]); });
  }
}

void TraceArrays::fragment(const TracedFragment& fragment) {
  const BoundsOfRun::KnownTriangle* known = bounds_.of_fragment(fragment);
  const FragmentBounds bounds = known == nullptr ? no_bounds() : bounds_of(*known, fragment);
  tables_[kFragment].add_row([&](Table& t) { fill_fragment(t, fragment, bounds); });
}

void TraceArrays::finish() {
  tables_[kRoundTrip].add_row([&](Table& t) { each_field(round_trips_, t); });
}

}  // namespace glassbox
