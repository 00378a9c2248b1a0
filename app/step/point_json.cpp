// The result for points as JSON: the matrices, the findings, and each point's coordinates in every
// space.
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/step/number_text.h"
#include "app/step/point_step.h"
#include "app/step/point_summary.h"
#include "cli/report/number_json.h"

#include <glassbox/base/trig.h>
#include <glassbox/matrices/projection_factors.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// Names in the order of the enumerators of MatrixShape, Severity and VertexVerdict.
constexpr const char* kShapes[] = {"not-finite", "identity",  "translation",           "rigid",
                                   "similarity", "scaled",    "scaled-after-rotation", "sheared",
                                   "flat",       "projective"};
constexpr const char* kSeverities[] = {"note", "hint", "alarm"};
constexpr const char* kFates[] = {"visible", "not-finite", "in-eye-plane", "behind-eye", "outside"};

// ---- matrices ----

Json affine_json(const GivenMatrix& given) {
  Json json{{"given", given.given}, {"origin", given.origin}, {"rows", rows_json(given.m)}};
  const MatrixFacts facts = matrix_facts(given.m);
  json["shape"] = kShapes[std::size_t(facts.shape)];
  json["affine"] = facts.affine;
  json["rank"] = facts.rank;
  json["determinant3"] = facts.determinant;
  json["mirror"] = facts.mirror();
  json["orthogonality_error"] = facts.orthogonality;
  json["scale"] = numbers_json(facts.scale);
  json["translation"] = numbers_json(facts.translation);
  if (facts.rotation) {
    json["rotation"] = {{"axis", numbers_json(facts.rotation->axis)},
                        {"degrees", degrees_from_radians(facts.rotation->radians)}};
  }
  return json;
}

Json view_json(const GivenMatrix& view) {
  Json json = affine_json(view);
  const auto eye = matrix_facts(view.m).affine ? eyepoint_of(view) : std::nullopt;
  if (!eye) return json;
  json["eye"] = {{"position", numbers_json(eye->position)},
                 {"right", numbers_json(eye->right)},
                 {"up", numbers_json(eye->up)},
                 {"back", numbers_json(eye->back)}};
  return json;
}

Json reading_json(const DepthReading& r) {
  if (!r.possible) return nullptr;
  Json json{{"near", r.near}, {"reversed", r.reversed}};
  json["far"] = std::isfinite(r.far) ? Json(r.far) : Json("infinity");
  return json;
}

Json projection_json(const GivenMatrix& given, const ApiDialect& dialect) {
  Json json{{"given", given.given}, {"origin", given.origin}, {"rows", rows_json(given.m)}};
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
  json["centre"] = numbers_json(p.centre);
  json["depth_lost"] = p.depth_lost;
  json["depth_0_1"] = reading_json(p.zero_to_one);
  json["depth_minus1_1"] = reading_json(p.minus_one_to_one);
  return json;
}

// ---- findings ----

Json findings_json(const std::vector<Finding>& findings) {
  Json json = Json::array();
  for (const Finding& finding : findings) {
    json.push_back({{"severity", kSeverities[std::size_t(finding.severity)]},
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
    if (a.window) one["window"] = numbers_json(*a.window);
    json.push_back(std::move(one));
  }
  return json;
}

// ---- the walks ----

template <class Vector>
Json bits_json(const Vector& v) {
  Json json = Json::array();
  for (int i = 0; i < v.length(); ++i) json.push_back(bits_text(v[i]));
  return json;
}

Json step_json(const char* space, const TransformStep& step) {
  return {{"space", space},
          {"matrix", rows_json(step.matrix)},
          {"position", numbers_json(step.after)},
          {"bits", bits_json(step.after)},
          {"bound", numbers_json(step.bound)}};
}

Json planes_json(const VertexChain& chain) {
  Json json = Json::array();
  if (chain.verdict == VertexVerdict::kNotFinite) return json;
  for (const auto& [plane, distance, bound] : chain.planes) {
    json.push_back({{"name", plane.name},
                    {"coefficients", {plane.a, plane.b, plane.c, plane.d}},
                    {"distance", distance},
                    {"bound", bound}});
  }
  return json;
}

Json ndc_json(const DivideStep& d) {
  const glm::vec3 position = to_glm(d.ndc.position);
  return {{"position", numbers_json(position)},
          {"bits", bits_json(position)},
          {"bound", numbers_json(d.bound.position)},
          {"condition", numbers_json(d.condition)},
          {"inverse_w", d.ndc.inverse_w}};
}

Json window_json(const ScreenStep& s, const PointStep::Walk& walk, const PointStep& step) {
  const glm::vec2 position(to_glm(s.screen.position));
  return {{"position", numbers_json(position)},
          {"bits", bits_json(position)},
          {"bound", numbers_json(glm::dvec2(s.bound))},
          {"y_up", step.setup.dialect.window_y_up},
          {"depth", s.depth},
          {"snapped", {s.snap_x.snapped, s.snap_y.snapped}},
          {"snap_stable", {s.snap_x.stable, s.snap_y.stable}},
          {"open_by_digits", walk.digits_uncertainty_px}};
}

Json round_trip_json(const RoundTrip& trip) {
  return {{"object", numbers_json(trip.object)},
          {"error", numbers_json(trip.error)},
          {"bound", numbers_json(trip.bound)}};
}

Json walk_json(const PointStep::Walk& walk, const PointStep& step) {
  const VertexChain& chain = walk.chain;
  Json json{{"object", numbers_json(chain.object)}};
  json["steps"] = {step_json("world", chain.to_world), step_json("eye", chain.to_eye)};
  if (!step.setup.projection.given) return json;
  json["steps"].push_back(step_json("clip", chain.to_clip));
  json["clip_at_once"] = numbers_json(chain.clip_by_composed_matrix);
  json["fate"] = kFates[std::size_t(chain.verdict)];
  json["outside"] = Json::array();
  if (chain.verdict != VertexVerdict::kNotFinite) {
    for (const PlaneStep& at : chain.planes) {
      if (at.is_outside()) json["outside"].push_back(at.plane.name);
    }
  }
  json["planes"] = planes_json(chain);
  json["deciding_plane"] = nullptr;
  if (chain.deciding_plane >= 0) {
    json["deciding_plane"] = chain.planes[std::size_t(chain.deciding_plane)].plane.name;
  }
  if (chain.divide) json["ndc"] = ndc_json(*chain.divide);
  if (chain.screen) json["window"] = window_json(*chain.screen, walk, step);
  if (chain.round_trip) json["round_trip"] = round_trip_json(*chain.round_trip);
  return json;
}

}  // namespace

Json point_step_json(const PointStep& step) {
  const MatrixSetup& setup = step.setup;
  Json json{{"schema", "glassbox-step-point-1"},
            {"dialect", setup.dialect.name},
            {"dialect_reason", step.dialect_reason},
            {"viewport", step.window},
            {"summary", summary_json(summarize(step))},
            {"matrices",
             {{"model", affine_json(setup.model)},
              {"view", view_json(setup.view)},
              {"projection", projection_json(setup.projection, setup.dialect)}}},
            {"points", Json::array()}};
  for (const PointStep::Walk& walk : step.walks) json["points"].push_back(walk_json(walk, step));
  json["findings"] = findings_json(step.findings);
  if (step.clip) json["clip_comparison"] = clip_comparison_json(*step.clip);
  if (!setup.projection.given) return json;
  json["visible"] = step.conventions.visible;
  json["behind_eye"] = step.conventions.behind_eye;
  json["alternatives"] = alternatives_json(step.conventions);
  json["spoiling_alternatives"] = step.conventions.spoiling;
  return json;
}

}  // namespace glassbox::app
