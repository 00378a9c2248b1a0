#include "app/step/chain_text.h"

#include <nlohmann/json.hpp>
#include "app/step/numbers_text.h"
#include "app/step/round_trip_text.h"

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

Json homogeneous_json(const glm::vec4& v) {
  return {v.x, v.y, v.z, v.w};
}

Json bits_json(const glm::vec4& v) {
  return {bits_text(v.x), bits_text(v.y), bits_text(v.z), bits_text(v.w)};
}

Json step_json(const char* space, const TransformStep& step) {
  return {{"space", space},
          {"matrix", matrix_json(glm::dmat4(step.matrix))},
          {"position", homogeneous_json(step.after)},
          {"bits", bits_json(step.after)},
          {"bound", {step.bound.x, step.bound.y, step.bound.z, step.bound.w}}};
}

const char* fate_id(VertexFate fate) {
  switch (fate) {
    case VertexFate::kVisible:
      return "visible";
    case VertexFate::kNotFinite:
      return "not-finite";
    case VertexFate::kInEyePlane:
      return "in-eye-plane";
    case VertexFate::kBehindEye:
      return "behind-eye";
    case VertexFate::kOutside:
      return "outside";
  }
  return "";
}

}  // namespace

Json matrix_json(const glm::dmat4& m) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  }
  return rows;
}

Json chain_json(const VertexChain& chain, const ChainSetting& setting) {
  Json json{{"object", homogeneous_json(chain.object)}};
  json["steps"] = {step_json("world", chain.to_world), step_json("eye", chain.to_eye),
                   step_json("clip", chain.to_clip)};
  if (!setting.projected) {
    json["steps"].erase(2);
    return json;
  }
  json["clip_at_once"] = {chain.at_once.x, chain.at_once.y, chain.at_once.z, chain.at_once.w};
  json["fate"] = fate_id(chain.fate);
  json["outside"] = Json::array();
  json["planes"] = Json::array();
  if (chain.fate != VertexFate::kNotFinite) {
    for (const PlaneStep& step : chain.planes) {
      json["planes"].push_back(
          {{"name", step.plane.name},
           {"coefficients", {step.plane.a, step.plane.b, step.plane.c, step.plane.d}},
           {"distance", step.distance},
           {"bound", step.bound}});
      if (step.outside()) json["outside"].push_back(step.plane.name);
    }
  }
  json["deciding_plane"] = chain.deciding_plane < 0
                               ? Json(nullptr)
                               : Json(chain.planes[std::size_t(chain.deciding_plane)].plane.name);
  if (chain.divide) {
    const DivideStep& d = *chain.divide;
    const Point<Ndc>& p = d.ndc.position;
    json["ndc"] = {{"position", {p.x, p.y, p.z}},
                   {"bits", {bits_text(p.x), bits_text(p.y), bits_text(p.z)}},
                   {"bound", {d.bound.position.x, d.bound.position.y, d.bound.position.z}},
                   {"condition", {d.condition.x, d.condition.y, d.condition.z}},
                   {"inverse_w", d.ndc.inverse_w}};
  }
  if (chain.screen) {
    const ScreenStep& s = *chain.screen;
    const Point<Screen>& p = s.screen.position;
    json["window"] = {{"position", {p.x, p.y}},
                      {"bits", {bits_text(p.x), bits_text(p.y)}},
                      {"bound", {s.bound.x, s.bound.y}},
                      {"y_up", setting.dialect.window_y_up},
                      {"depth", s.depth},
                      {"snapped", {s.snap_x.snapped, s.snap_y.snapped}},
                      {"snap_stable", {s.snap_x.stable, s.snap_y.stable}}};
    if (setting.open_px) json["window"]["open_by_digits"] = *setting.open_px;
  }
  if (chain.round_trip) json["round_trip"] = round_trip_json(*chain.round_trip);
  return json;
}

}  // namespace glassbox::app
