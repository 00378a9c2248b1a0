#include "app/matrix_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/chain_text.h"
#include "app/text_layout.h"

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/decimal.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// Coordinates that are rounding beside the largest are shown as 0.
std::string triple(const glm::dvec3& v, int digits = 6) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const auto shown = [&](double x) { return std::abs(x) < 1e-6 * largest ? 0 : x; };
  return brief_triple(shown(v.x), shown(v.y), shown(v.z), digits);
}

// A number that the digits of the text leave open by `uncertainty`, as round as that allows.
std::string rounded(double value, double uncertainty) {
  return brief(simplest_decimal(value, uncertainty).value);
}

// "2^-21.3"
std::string power_of_two(double error) {
  if (error == 0) return "0";
  return fmt::format("2^{:.1f}", std::log2(error));
}

std::string turn_text(const MatrixFacts& facts) {
  if (!facts.rotation || facts.rotation->radians < kSmall) return {};
  return fmt::format("a turn by {} degrees about {}",
                     brief(degrees_from_radians(facts.rotation->radians), 5),
                     triple(facts.rotation->axis, 4));
}

std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : ", then ") + part;
  }
  return text;
}

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

// How far from a rotation, in the units in which floats round.
std::string rigidity_text(const MatrixFacts& facts) {
  if (facts.orthogonality == 0) return "exactly";
  return fmt::format("to within {} ({} ulp of a float 1)", power_of_two(facts.orthogonality),
                     brief(facts.orthogonality / std::numeric_limits<float>::epsilon(), 2));
}

std::string heading(const char* name, const char* from_to, const std::string& origin) {
  return wrapped(fmt::format("{:<11} ", name),
                 from_to + (origin.empty() ? ": none given, the identity" : "; " + origin));
}

std::string sentence(const std::string& text) {
  return wrapped("  ", text);
}

std::string model_text(const GivenMatrix& model, const std::string& origin) {
  std::string text = heading("MODEL", "world from object", origin);
  if (!model.given) return text;
  return text + matrix_rows(model.m, "  ") + sentence(affine_sentence(facts_of(model.m)));
}

std::string view_sentences(const GivenMatrix& view) {
  const MatrixFacts facts = facts_of(view.m);
  std::string text = sentence(affine_sentence(facts));
  const auto eye = facts.affine ? eyepoint_of(view) : std::nullopt;
  if (!eye) return text;
  const auto at = [&](double x) { return simplest_decimal(x, eye->uncertainty).value; };
  text +=
      sentence(fmt::format("the eye stands at {}; right is {}, up {}",
                           triple({at(eye->position.x), at(eye->position.y), at(eye->position.z)}),
                           triple(eye->right, 4), triple(eye->up, 4)));
  return text + sentence(fmt::format("it looks along {} if its eye looks down -z, the other way if "
                                     "down +z: the projection decides",
                                     triple(-eye->back, 4)));
}

std::string view_text(const GivenMatrix& view, const std::string& origin) {
  std::string text = heading("VIEW", "eye from world", origin);
  if (!view.given) return text;
  return text + matrix_rows(view.m, "  ") + view_sentences(view);
}

// "depth 0 at near 0.1, 1 at far 100"
std::string reading_text(const DepthReading& r) {
  if (!r.possible) return "none";
  const char* low = r.from_minus_one ? "-1" : "0";
  return fmt::format("{} at the near plane {}, {} at the far plane {}", r.reversed ? "1" : low,
                     rounded(r.near, r.near_uncertainty), r.reversed ? low : "1",
                     rounded(r.far, r.far_uncertainty));
}

std::string depth_text(const ProjectionFacts& p, const ApiDialect& dialect) {
  if (p.depth_lost) return sentence("the depth is the same at all distances (rank 3)");
  if (p.oblique_depth) return sentence("depth depends on x and y: an oblique near plane");
  const DepthReading &ours = dialect.z_from_minus_w ? p.minus_one_to_one : p.zero_to_one,
                     &other = dialect.z_from_minus_w ? p.zero_to_one : p.minus_one_to_one;
  return sentence(fmt::format("depth read as {} has it: {}", dialect.title, reading_text(ours))) +
         sentence(fmt::format("read for {} instead, the same numbers mean {}",
                              other.from_minus_one ? "-1 .. 1" : "0 .. 1", reading_text(other)));
}

std::string lens_text(const ProjectionFacts& p, const ApiDialect& dialect) {
  std::string text;
  if (p.kind == ProjectionKind::kPerspective) {
    text += sentence(p.looks_down_minus_z
                         ? "perspective; w grows along -z: a right-handed eye, looking down -z"
                         : "perspective; w grows along +z: a left-handed eye, looking down +z");
    text +=
        sentence(fmt::format("vertical angle of view {} degrees, aspect ratio {}{}",
                             rounded(p.fovy_degrees, p.fovy_uncertainty), brief(p.aspect, 5),
                             p.off_centre() ? "; off-centre: the gaze meets the picture at NDC (" +
                                                  brief(p.centre.x) + ", " + brief(p.centre.y) + ")"
                                            : ""));
  } else {
    text += sentence("parallel: w is the same everywhere");
    const auto edge = [&](int axis, double side) {
      return brief((side - p.centre[axis]) / p.scale[axis]);
    };
    text += sentence(fmt::format("the window is x from {} to {}, y from {} to {}", edge(0, -1),
                                 edge(0, 1), edge(1, -1), edge(1, 1)));
    text += sentence(fmt::format("with depth as {} has it, the eye looks down {}z", dialect.title,
                                 p.looks_down_minus_z ? "-" : "+"));
  }
  return text + depth_text(p, dialect);
}

std::string projection_text(const GivenMatrix& given, const ApiDialect& dialect,
                            const std::string& origin) {
  std::string text = heading("PROJECTION", "clip from eye", origin);
  if (!given.given) return text;
  text += matrix_rows(given.m, "  ");
  const ProjectionFacts plain = projection_facts(given, dialect.depth);
  if (plain.kind != ProjectionKind::kNone && plain.w_offset == 0)
    return text + lens_text(plain, dialect);
  if (const auto parts = factor_projection(given); parts && plain.kind == ProjectionKind::kNone) {
    text += sentence("a projection with a view in it. The view's part:");
    text += view_sentences(parts->view);
    return text + sentence("The projection's part:") +
           lens_text(projection_facts(parts->projection, dialect.depth), dialect);
  }
  if (plain.kind != ProjectionKind::kNone) return text + lens_text(plain, dialect);
  const MatrixFacts facts = facts_of(given.m);
  return text + sentence(facts.affine
                             ? "as a matrix: " + affine_sentence(facts)
                             : fmt::format("no projection as it stands (rank {})", facts.rank));
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

std::string affine_sentence(const MatrixFacts& facts) {
  const std::string moved =
      facts.translation == glm::dvec3(0) ? "" : "a translation by " + triple(facts.translation);
  const std::string mirror =
      facts.mirror() ? fmt::format("; it mirrors (determinant {})", brief(facts.determinant, 4))
                     : "";
  switch (facts.shape) {
    case Shape::kNotFinite:
      return "not all of its entries are finite";
    case Shape::kIdentity:
      return "the identity";
    case Shape::kTranslation:
      return moved + ", and nothing else";
    case Shape::kRigid:
      return fmt::format("rigid {}: {}{}", rigidity_text(facts),
                         joined({facts.mirror() ? "a reflection" : turn_text(facts), moved}),
                         mirror);
    case Shape::kSimilarity:
      return joined({"a scale by " + brief(std::abs(facts.scale.x)), turn_text(facts), moved}) +
             mirror;
    case Shape::kScaled:
      return joined({"scales by " + triple(facts.scale) + " along the axes", turn_text(facts),
                     moved}) +
             mirror;
    case Shape::kScaledAfter:
      return joined({"a turn, then scales along fixed axes: a shear", moved}) + mirror;
    case Shape::kSheared:
      return joined({"affine, with a shear", moved}) + mirror;
    case Shape::kFlat:
      return fmt::format("affine, but flat: rank {}, determinant {}", facts.rank,
                         brief(facts.determinant, 3));
    case Shape::kProjective:
      return fmt::format("not affine: the last row is not 0 0 0 1 (rank {})", facts.rank);
  }
  return "";
}

std::string matrices_text(const MatrixSetup& setup, const MatrixOrigins& origins) {
  return model_text(setup.model, origins.model) + "\n" + view_text(setup.view, origins.view) +
         "\n" + projection_text(setup.projection, setup.dialect, origins.projection);
}

Json matrices_json(const MatrixSetup& setup, const MatrixOrigins& origins) {
  return {{"model", affine_json(setup.model, origins.model)},
          {"view", view_json(setup.view, origins.view)},
          {"projection", projection_json(setup.projection, setup.dialect, origins.projection)}};
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Severity severity : {Severity::kAlarm, Severity::kHint, Severity::kNote}) {
    for (const Finding& finding : findings) {
      if (finding.severity != severity) continue;
      const std::string place = *finding.matrix == '\0' ? "" : std::string(finding.matrix) + ": ";
      text += wrapped(
          fmt::format("  {:<6}", severity == Severity::kAlarm ? "WRONG" : severity_id(severity)),
          place + finding.cause);
      if (!finding.remedy.empty()) text += wrapped("        -> ", finding.remedy);
    }
  }
  return text;
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

std::string alternatives_text(const ConventionsReport& report) {
  std::string text;
  int number = 0;
  for (const Alternative& a : report.alternatives) {
    std::string line = a.what + ": ";
    if (report.points > 1)
      line += fmt::format("{} of {} points are where they should be", a.points, report.points);
    if (report.points > 1 && a.window) line += ", the first ";
    if (a.window) line += fmt::format("at ({:.2f}, {:.2f})", a.window->x, a.window->y);
    text += wrapped(fmt::format("  {}. ", ++number), line);
    for (const std::string& reason : a.reasons) text += wrapped("       because ", reason);
    text += wrapped("       -> ", a.remedy);
  }
  if (report.spoiling > 0) {
    text += wrapped("  ",
                    fmt::format("{} more would do, but spoil{} a matrix that is sound as it stands",
                                report.spoiling, report.spoiling == 1 ? "s" : ""));
  }
  return text;
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
