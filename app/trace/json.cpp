#include "app/trace/json.h"

#include <map>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include <glassbox/render/engine/names.h>

namespace glassbox {
namespace {

using Json = nlohmann::ordered_json;

// ---- spaces ----

Json rows(const glm::dmat4& m) {
  Json json = Json::array();
  for (int row = 0; row < 4; ++row) json.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  return json;
}

template <int N, class T>
Json components(const glm::vec<N, T>& v) {
  Json json = Json::array();
  for (int i = 0; i < N; ++i) json.push_back(v[i]);
  return json;
}

template <class V>
Json components_of(const V& v) {
  return components(to_glm(v));
}

Json json_of(const Rgba8& c) {
  return {c.r, c.g, c.b, c.a};
}

Json json_of(const Rgba& c) {
  return {c.r, c.g, c.b, c.a};
}

// ---- settings ----

Json json_of(const RenderSettings& s) {
  return {{"shading", name_of(s.shading)},
          {"show", name_of(s.show)},
          {"cull", name_of(s.cull)},
          {"wireframe", s.wireframe},
          {"depth", name_of(s.depth)},
          {"transfer", name_of(s.transfer)},
          {"background", json_of(s.background)},
          {"mask", {s.mask.r, s.mask.g, s.mask.b, s.mask.a}}};
}

Json json_of(const ClipPlane& plane) {
  return {{"name", plane.name}, {"coefficients", {plane.a, plane.b, plane.c, plane.d, plane.e}}};
}

Json json_of(const Scene& scene, const TracedDraw& draw, const DrawBounds& bounds) {
  const Mesh& mesh = scene.meshes[scene.instances[draw.instance].mesh];
  return {{"instance", draw.instance},
          {"mesh", mesh.name},
          {"material", scene.materials[mesh.material].name},
          {"first_number", draw.first_number},
          {"mirrored", draw.mirrored},
          {"world_from_object", rows(draw.world_from_object.columns)},
          {"anchor", components_of(draw.anchor)},
          {"clip_from_anchored", rows(glm::dmat4(draw.clip_from_anchored.columns))},
          {"clip_from_anchored_bound", rows(bounds.clip_from_anchored)},
          {"eye_from_anchored", rows(glm::dmat4(draw.eye_from_anchored.columns))},
          {"eye_from_anchored_bound", rows(bounds.eye_from_anchored)}};
}

// ---- triangles ----

Json json_of(const std::optional<RoundTrip>& trip) {
  if (!trip) return {};
  return {{"screen", {trip->screen.x, trip->screen.y, trip->screen.z}},
          {"object", components_of(trip->object)},
          {"error", components(trip->error)},
          {"bound", components(trip->bound)}};
}

Json json_of(const Trace& trace, const TracedCorner& corner, const CornerBounds& bounds) {
  Json planes = Json::array();
  const auto distances = plane_distances(trace, corner, bounds);
  for (std::size_t i = 0; i < trace.planes.size(); ++i) {
    planes.push_back({{"plane", trace.planes[i].name},
                      {"distance", distances[i].distance},
                      {"bound", distances[i].bound},
                      {"outside", (corner.outcode >> i & 1) != 0}});
  }
  return {{"corner", corner.corner},
          {"position", corner.position},
          {"object", components_of(corner.object)},
          {"world", components_of(corner.world)},
          {"world_bound", components(bounds.world)},
          {"eye", components_of(corner.eye)},
          {"eye_bound", components(bounds.eye)},
          {"clip", components_of(corner.clip)},
          {"clip_bound", components(bounds.clip)},
          {"finite", (corner.outcode & kNotFinite) == 0},
          {"planes", planes},
          {"round_trip", json_of(bounds.round_trip)}};
}

const char* verdict_of(const TracedTriangle& triangle) {
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = triangle.corners[k].outcode;
  switch (trivial_verdict(codes)) {
    case ClipVerdict::kAccept:
      return "accept";
    case ClipVerdict::kReject:
      return "reject";
    case ClipVerdict::kClip:
      break;
  }
  return "clip";
}

Json json_of(const ClipPlane& plane, const ClipStep& step, int count_before) {
  Json distances = Json::array(), polygon = Json::array();
  for (int i = 0; i < count_before; ++i) distances.push_back(step.distances[std::size_t(i)]);
  for (int i = 0; i < step.after.count; ++i) {
    const ClipVertex& vertex = step.after.vertices[std::size_t(i)];
    polygon.push_back({{"clip", components_of(vertex.position)},
                       {"weights", vertex.weights},
                       {"from", step.sources[std::size_t(i)]}});
  }
  return {{"plane", plane.name}, {"distances", distances}, {"polygon", polygon}};
}

Json json_of(const TracedVertex& vertex, const VertexBounds& bounds) {
  return {
      {"clip", components_of(vertex.clip.position)},
      {"clip_bound", components(bounds.clip.position)},
      {"weights", vertex.clip.weights},
      {"weights_bound", components(bounds.clip.weights)},
      {"ndc", components_of(vertex.ndc.position)},
      {"ndc_bound", components(bounds.ndc.position)},
      {"ndc_condition", bounds.condition == glm::dvec3(0) ? Json() : components(bounds.condition)},
      {"inverse_w", vertex.ndc.inverse_w},
      {"inverse_w_bound", bounds.ndc.inverse_w},
      {"screen", {vertex.screen.position.x, vertex.screen.position.y}},
      {"screen_bound", {bounds.screen.x, bounds.screen.y}},
      {"snapped", {vertex.snapped.x, vertex.snapped.y}},
      {"snap_stable", {bounds.snap_x.stable, bounds.snap_y.stable}}};
}

Json json_of(const EdgeFunction& edge) {
  return {{"a", edge.a}, {"b", edge.b}, {"c", edge.c}, {"owns_zero", edge.owns_zero}};
}

Json json_of(const PixelRect& rect) {
  return {rect.x0, rect.y0, rect.x1, rect.y1};
}

Json json_of(const TracedPiece& piece, double area_bound) {
  Json json{{"polygon", piece.polygon}};
  if (!piece.setup) {
    json["double_area"] = 0;
    json["double_area_px2_bound"] = area_bound;
    return json;
  }
  const TriangleSetup& setup = *piece.setup;
  json["double_area"] = setup.double_area;
  json["double_area_px2_bound"] = area_bound;
  json["clockwise"] = setup.clockwise;
  json["front"] = piece.front;
  json["culled"] = piece.culled;
  json["order"] = setup.order;
  json["edges"] = {json_of(setup.edges[0]), json_of(setup.edges[1]), json_of(setup.edges[2])};
  json["depth"] = setup.depth;
  json["inverse_w"] = setup.inverse_w;
  json["inverse_area"] = setup.inverse_area;
  json["affine"] = setup.affine;
  json["bounds"] = json_of(setup.bounds);
  return json;
}

Json json_of(const std::optional<BackFaceTest>& test) {
  if (!test) return {};
  const char* facing = test->facing == Facing::kBack    ? "back"
                       : test->facing == Facing::kFront ? "front"
                                                        : "edge-on";
  return {{"facing", facing},
          {"value", test->value},
          {"bound", test->bound},
          {"viewer_error_bound", test->viewer_error_bound},
          {"used_exact", test->used_exact}};
}

// ---- fragments ----

Json json_of(const Varyings& at) {
  return {{"normal", at.normal},     {"position", at.position}, {"diffuse", at.diffuse},
          {"specular", at.specular}, {"color", at.color},       {"texcoord", at.texcoord}};
}

// What the trace keeps of each draw and triangle besides its records.
class Known {
public:
  explicit Known(const Trace& trace) : trace_(trace) {
    for (const TracedDraw& draw : trace.draws) {
      draws_[draw.instance] = {&draw, bounds_of(draw, trace.view)};
    }
    for (const TracedTriangle& triangle : trace.triangles) triangles_[triangle.number] = &triangle;
  }

  TriangleBounds bounds(const TracedTriangle& triangle) const {
    const auto& [draw, draw_bounds] = draws_.at(triangle.instance);
    return bounds_of(trace_, triangle, *draw, draw_bounds);
  }

  const TracedTriangle* triangle(const FragmentSource& source) const {
    if (!source.is_triangle) return nullptr;
    const auto found = triangles_.find(source.number);
    return found == triangles_.end() ? nullptr : found->second;
  }

private:
  const Trace& trace_;
  std::map<std::uint32_t, std::pair<const TracedDraw*, DrawBounds>> draws_;
  std::map<std::uint32_t, const TracedTriangle*> triangles_;
};

}  // namespace

const char* name_of(Fate fate) {
  constexpr const char* kNames[] = {"hidden", "discarded", "written", "blended"};
  return kNames[std::size_t(fate)];
}

Json to_json(const View& view) {
  const Viewport& v = view.viewport;
  return {
      {"eye_from_world", rows(view.eye_from_world.columns)},
      {"clip_from_eye", rows(view.clip_from_eye.columns)},
      {"viewport", {{"left", v.left}, {"right", v.right}, {"bottom", v.bottom}, {"top", v.top}}},
      {"depth_range", view.depth_range == DepthRange::kReversed ? "reversed" : "standard"},
      {"perspective", view.perspective},
      {"near", view.near},
      {"far", view.far}};
}

Json to_json(const Trace& trace, const TracedTriangle& triangle, const TriangleBounds& bounds) {
  Json corners = Json::array(), clipping = Json::array(), polygon = Json::array(),
       pieces = Json::array();
  for (std::size_t k = 0; k < 3; ++k) {
    corners.push_back(json_of(trace, triangle.corners[k], bounds.corners[k]));
  }
  int count = 3;
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    clipping.push_back(json_of(trace.planes[i], triangle.clipping[i], count));
    count = triangle.clipping[i].after.count;
  }
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    polygon.push_back(json_of(triangle.polygon[i], bounds.polygon[i]));
  }
  for (std::size_t i = 0; i < triangle.pieces.size(); ++i) {
    pieces.push_back(json_of(triangle.pieces[i], bounds.double_area[i]));
  }
  return {{"number", triangle.number},
          {"instance", triangle.instance},
          {"face", triangle.face},
          {"corners", corners},
          {"verdict", verdict_of(triangle)},
          {"clipping", clipping},
          {"polygon", polygon},
          {"pieces", pieces},
          {"back_face", json_of(bounds.back_face)}};
}

Json to_json(const Trace& trace, const TracedFragment& traced, const TracedTriangle* triangle,
             const TriangleBounds* bounds) {
  const Fragment& fragment = traced.fragment;
  Json json;
  json["triangle"] = traced.source.is_triangle ? Json(traced.source.number) : Json();
  json["piece"] = traced.source.piece;
  json["instance"] = traced.instance;
  json["pixel"] = {fragment.x, fragment.y};
  if (traced.source.is_triangle) json["edges"] = traced.coverage.edges;
  json["lambda"] = fragment.lambda;
  json["weights"] = fragment.weights;
  json["depth"] = fragment.depth;
  json["inverse_w"] = fragment.inverse_w;
  if (triangle != nullptr && bounds != nullptr) {
    const TracedPiece& piece = triangle->pieces[traced.source.piece];
    const FragmentBounds bound =
        fragment_bounds(*piece.setup, fragment, setup_bounds(piece, *bounds));
    json["bounds"] = {{"lambda", bound.lambda},
                      {"weights", bound.weights},
                      {"depth", bound.depth},
                      {"inverse_w", bound.inverse_w},
                      {"distance", bound.distance}};
  }
  json["depth_test"] = {{"op", "less"}, {"incoming", traced.code}, {"stored", traced.stored}};
  json["fate"] = name_of(traced.fate);
  if (traced.fate == Fate::kHidden) return json;
  json["attributes"] = json_of(traced.at);
  json["surface"] = json_of(traced.surface);
  if (traced.fate == Fate::kDiscarded) return json;
  if (trace.settings.show == Show::kColor) {
    json["emission"] = traced.emission;
    json["light"] = json_of(traced.light);
  }
  json["before"] = json_of(traced.before);
  json["after"] = json_of(traced.after);
  return json;
}

Json to_json(const RoundTrips& trips) {
  return {{"corners", trips.corners},
          {"unbounded", trips.unbounded},
          {"largest_error", trips.largest_error},
          {"bound", trips.bound},
          {"triangle", trips.place.triangle},
          {"corner", trips.place.corner},
          {"axis", trips.place.axis},
          {"largest_ratio", trips.largest_ratio}};
}

Json head_json(const Scene& scene, const Trace& trace) {
  Json planes = Json::array(), draws = Json::array();
  for (const ClipPlane& plane : trace.planes) planes.push_back(json_of(plane));
  for (const TracedDraw& draw : trace.draws) {
    draws.push_back(json_of(scene, draw, bounds_of(draw, trace.view)));
  }
  return {{"schema", kTraceSchema},
          {"complete", trace.complete},
          {"view", to_json(trace.view)},
          {"settings", json_of(trace.settings)},
          {"planes", planes},
          {"draws", draws}};
}

Json to_json(const Scene& scene, const Trace& trace) {
  const Known known(trace);
  Json json = head_json(scene, trace), triangles = Json::array(), fragments = Json::array();
  RoundTrips trips;
  for (const TracedTriangle& triangle : trace.triangles) {
    const TriangleBounds bounds = known.bounds(triangle);
    trips.see(triangle, bounds);
    triangles.push_back(to_json(trace, triangle, bounds));
  }
  const TracedTriangle* triangle = nullptr;
  std::optional<TriangleBounds> bounds;  // of the triangle: fragments of one follow each other
  for (const TracedFragment& fragment : trace.fragments) {
    const TracedTriangle* its_triangle = known.triangle(fragment.source);
    if (its_triangle != nullptr && its_triangle != triangle) bounds = known.bounds(*its_triangle);
    triangle = its_triangle;
    fragments.push_back(to_json(trace, fragment, triangle, bounds ? &*bounds : nullptr));
  }
  json["triangles"] = std::move(triangles);
  json["fragments"] = std::move(fragments);
  json["round_trip"] = to_json(trips);
  return json;
}

}  // namespace glassbox
