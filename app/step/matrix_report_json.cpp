#include <cmath>

#include <nlohmann/json.hpp>

#include "app/step/chain_text.h"
#include "app/step/matrices/projection_factors.h"
#include "app/step/matrix_report.h"

#include <glassbox/base/trig.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

const char* shape_id(Shape shape) {
  switch (shape) {
    case Shape::kNotFinite:
      return "not-finite";
    case Shape::kIdentity:
      return "identity";
    case Shape::kTranslation:
      return "translation";
    case Shape::kRigid:
      return "rigid";
    case Shape::kSimilarity:
      return "similarity";
    case Shape::kScaled:
      return "scaled";
    case Shape::kScaledAfter:
      return "scaled-after-rotation";
    case Shape::kSheared:
      return "sheared";
    case Shape::kFlat:
      return "flat";
    case Shape::kProjective:
      return "projective";
  }
  return "";
}

const char* severity_id(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kHint:
      return "hint";
    case Severity::kAlarm:
      return "alarm";
  }
  return "";
}

Json affine_json(const GivenMatrix& given, const std::string& origin) {
  Json json{{"given", given.given}, {"origin", origin}, {"rows", matrix_json(given.m)}};
  const MatrixFacts facts = facts_of(given.m);
  json["shape"] = shape_id(facts.shape);
  json["affine"] = facts.affine;
  json["rank"] = facts.rank;
  json["determinant3"] = facts.determinant;
  json["mirror"] = facts.mirror();
  json["orthogonality_error"] = facts.orthogonality;
  json["scale"] = {facts.scale.x, facts.scale.y, facts.scale.z};
  json["translation"] = {facts.translation.x, facts.translation.y, facts.translation.z};
  if (facts.rotation) {
    const glm::dvec3& axis = facts.rotation->axis;
    json["rotation"] = {{"axis", {axis.x, axis.y, axis.z}},
                        {"degrees", degrees_from_radians(facts.rotation->radians)}};
  }
  return json;
}

Json view_json(const GivenMatrix& view, const std::string& origin) {
  Json json = affine_json(view, origin);
  const auto eye = facts_of(view.m).affine ? eyepoint_of(view) : std::nullopt;
  if (!eye) return json;
  const auto vector = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
  json["eye"] = {{"position", vector(eye->position)},
                 {"right", vector(eye->right)},
                 {"up", vector(eye->up)},
                 {"back", vector(eye->back)}};
  return json;
}

Json reading_json(const DepthReading& r) {
  if (!r.possible) return nullptr;
  Json json{{"near", r.near}, {"reversed", r.reversed}};
  json["far"] = std::isfinite(r.far) ? Json(r.far) : Json("infinity");
  return json;
}

Json projection_json(const GivenMatrix& given, const ApiDialect& dialect,
                     const std::string& origin) {
  Json json{{"given", given.given}, {"origin", origin}, {"rows", matrix_json(given.m)}};
  json["rank"] = first_not_finite(given.m) ? 0 : rank_of(given.m);
  const GivenMatrix part = projection_part(given);
  const ProjectionFacts p = projection_facts(part, dialect.depth);
  if (p.kind == ProjectionKind::kNone) {
    json["kind"] = nullptr;
    return json;
  }
  const bool perspective = p.kind == ProjectionKind::kPerspective;
  json["kind"] = perspective ? "perspective" : "parallel";
  json["contains_view"] = part.m != given.m;
  json["looks_down"] = p.looks_down_minus_z ? "-z" : "+z";
  if (perspective) json["fovy_degrees"] = p.fovy_degrees;
  json["aspect"] = p.aspect;
  json["centre"] = {p.centre.x, p.centre.y};
  json["depth_lost"] = p.depth_lost;
  json["depth_0_1"] = reading_json(p.zero_to_one);
  json["depth_minus1_1"] = reading_json(p.minus_one_to_one);
  return json;
}

}  // namespace

Json matrices_json(const MatrixSetup& setup, const MatrixOrigins& origins) {
  return {{"model", affine_json(setup.model, origins.model)},
          {"view", view_json(setup.view, origins.view)},
          {"projection", projection_json(setup.projection, setup.dialect, origins.projection)}};
}

Json findings_json(const std::vector<Finding>& findings) {
  Json json = Json::array();
  for (const Finding& finding : findings) {
    json.push_back({{"severity", severity_id(finding.severity)},
                    {"id", finding.id},
                    {"matrix", finding.matrix},
                    {"cause", finding.cause},
                    {"remedy", finding.remedy}});
  }
  return json;
}

Json alternatives_json(const ConventionsReport& report) {
  Json json = Json::array();
  for (const Alternative& a : report.alternatives) {
    Json one{{"ids", Json::array({a.id})}, {"what", a.what},       {"remedy", a.remedy},
             {"points", a.points},         {"reasons", a.reasons}, {"score", a.score}};
    if (a.second) one["ids"].push_back(a.second_id);
    if (a.window) one["window"] = {a.window->x, a.window->y};
    json.push_back(std::move(one));
  }
  return json;
}

}  // namespace glassbox::app
