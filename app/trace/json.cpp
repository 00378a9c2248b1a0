#include "app/trace/json.h"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"

#include <glassbox/render/engine/setting_names.h>
#include <glassbox/render/trace/fields.h>

namespace glassbox {
namespace {

using Json = nlohmann::ordered_json;

// Adds each number to `json` as a field with its name.
struct JsonFields {
  Json& json;

  template <class T>
  void operator()(const char* name, const T& value) {
    json[name] = value;
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    json[name] = value ? numbers_json(*value) : Json();
  }
  template <int N, class T>
  void operator()(const char* name, const glm::vec<N, T>& value) {
    json[name] = numbers_json(value);
  }
  template <class T>
  void operator()(const char* name, const glm::mat<4, 4, T>& value) {
    json[name] = rows_json(value);
  }
};

template <class... Records>
void add_fields(Json& json, const Records&... records) {
  JsonFields fields{json};
  each_field(records..., fields);
}

// ---- settings ----

Json json_of(const RenderSettings& s) {
  return {{"shading", name_of(s.shading)},
          {"show", name_of(s.show)},
          {"cull", name_of(s.cull)},
          {"wireframe", s.wireframe},
          {"depth", name_of(s.depth)},
          {"transfer", name_of(s.transfer)},
          {"background", numbers_json(s.background)},
          {"mask", numbers_json(s.mask)}};
}

Json json_of(const ClipPlane& plane) {
  return {{"name", plane.name}, {"coefficients", {plane.a, plane.b, plane.c, plane.d, plane.e}}};
}

Json json_of(const Scene& scene, const TracedDraw& draw, const DrawBounds& bounds) {
  const Mesh& mesh = scene.meshes[scene.instances[draw.instance].mesh];
  Json json{{"instance", draw.instance},
            {"mesh", mesh.name},
            {"material", scene.materials[mesh.material].name}};
  add_fields(json, draw, bounds);
  return json;
}

// ---- triangles ----

Json json_of(const std::optional<RoundTrip>& trip) {
  if (!trip) return {};
  return {{"screen", numbers_json(trip->screen)},
          {"object", numbers_json(trip->object)},
          {"error", numbers_json(trip->error)},
          {"bound", numbers_json(trip->bound)}};
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
  Json json;
  add_fields(json, corner, bounds);
  json["finite"] = (corner.outcode & kNotFinite) == 0;
  json["planes"] = planes;
  json["round_trip"] = json_of(bounds.round_trip);
  return json;
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
    polygon.push_back({{"clip", numbers_json(vertex.position)},
                       {"weights", vertex.weights},
                       {"from", step.sources[std::size_t(i)]}});
  }
  return {{"plane", plane.name}, {"distances", distances}, {"polygon", polygon}};
}

Json json_of(const TracedVertex& vertex, const VertexBounds& bounds) {
  Json json;
  add_fields(json, vertex, bounds);
  return json;
}

Json json_of(const EdgeFunction& edge) {
  return {{"a", edge.a}, {"b", edge.b}, {"c", edge.c}, {"owns_zero", edge.owns_zero}};
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
  json["bounds"] = numbers_json(setup.bounds);
  return json;
}

}  // namespace

const char* name_of(FragmentResult result) {
  constexpr const char* kNames[] = {"hidden", "discarded", "written", "blended"};
  return kNames[std::size_t(result)];
}

Json to_json(const BackFaceTest& test) {
  constexpr const char* kFacings[] = {"front", "edge-on", "back"};
  return {{"facing", kFacings[std::size_t(test.facing)]},
          {"value", test.value},
          {"bound", test.bound},
          {"viewer_error_bound", test.viewer_error_bound},
          {"used_exact", test.used_exact}};
}

Json to_json(const View& view) {
  const Viewport& v = view.viewport;
  return {
      {"eye_from_world", rows_json(view.eye_from_world.columns)},
      {"clip_from_eye", rows_json(view.clip_from_eye.columns)},
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
          {"back_face", bounds.back_face ? to_json(*bounds.back_face) : Json()}};
}

Json to_json(const Trace& trace, const TracedFragment& traced,
             const BoundsOfRun::KnownTriangle* known) {
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
  if (known != nullptr) {
    const FragmentBounds bound = bounds_of(*known, traced);
    json["bounds"] = {{"lambda", bound.lambda},
                      {"weights", bound.weights},
                      {"depth", bound.depth},
                      {"inverse_w", bound.inverse_w},
                      {"distance", bound.distance}};
  }
  json["depth_test"] = {{"op", "less"}, {"incoming", traced.code}, {"stored", traced.stored}};
  json["fate"] = name_of(traced.result);
  if (traced.result == FragmentResult::kHidden) return json;
  add_fields(json["attributes"], traced.at);
  json["surface"] = numbers_json(traced.surface);
  if (traced.result == FragmentResult::kDiscarded) return json;
  if (trace.settings.show == Show::kColor) {
    json["emission"] = traced.emission;
    json["light"] = numbers_json(traced.light);
  }
  json["before"] = numbers_json(traced.before);
  json["after"] = numbers_json(traced.after);
  return json;
}

Json to_json(const RoundTrips& trips) {
  Json json;
  add_fields(json, trips);
  return json;
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
  const auto known = bounds_of_all(trace);
  Json json = head_json(scene, trace), triangles = Json::array(), fragments = Json::array();
  RoundTrips trips;
  for (const TracedTriangle& triangle : trace.triangles) {
    const TriangleBounds& bounds = known.at(triangle.number).bounds;
    trips.add(triangle, bounds);
    triangles.push_back(to_json(trace, triangle, bounds));
  }
  for (const TracedFragment& fragment : trace.fragments) {
    const auto found = known.find(fragment.source.number);
    const bool is_known = fragment.source.is_triangle && found != known.end();
    fragments.push_back(to_json(trace, fragment, is_known ? &found->second : nullptr));
  }
  json["triangles"] = std::move(triangles);
  json["fragments"] = std::move(fragments);
  json["round_trip"] = to_json(trips);
  return json;
}

}  // namespace glassbox
