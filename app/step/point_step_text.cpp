#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/text_layout.h"
#include "app/step/chain_text.h"
#include "app/step/matrices/decimal.h"
#include "app/step/matrices/projection_facts.h"
#include "app/step/point_step.h"

#include <glassbox/base/counted.h>

namespace glassbox::app {

namespace {

ChainSetting chain_setting(const PointStep& step) {
  ChainSetting setting{step.setup.dialect, step.viewport, {}, true, step.bits, std::nullopt};
  setting.projected = step.setup.projection.given;
  const ProjectionFacts lens = projection_facts(step.setup.projection, step.setup.dialect.depth);
  if (setting.projected && !lens.looks_transposed) setting.projection = lens;
  return setting;
}

std::string heading_text(const PointStep& step) {
  if (!step.setup.projection.given) return {};
  const auto [x, y, width, height] = step.window;
  return wrapped("", fmt::format("{} ({}), window {}x{}{}", step.setup.dialect.title,
                                 step.dialect_reason, width, height,
                                 x == 0 && y == 0 ? "" : fmt::format(" at ({}, {})", x, y))) +
         "\n";
}

std::string point_text(const glm::vec4& p) {
  return p.w == 1 ? fmt::format("({}, {}, {})", p.x, p.y, p.z)
                  : fmt::format("({}, {}, {}, {})", p.x, p.y, p.z, p.w);
}

std::string where_text(const PointStep::Walk& walk, const ChainSetting& setting) {
  const VertexChain& chain = walk.chain;
  std::string line = point_text(chain.object) + " is ";
  if (setting.projected) {
    line += fate_text(chain, setting);
    if (walk.expected) {
      line += fmt::format(", expected at ({:.2f}, {:.2f})", walk.expected->x, walk.expected->y);
    }
  } else {
    line += fmt::format("at {} in the eye's space; without --proj nothing is projected",
                        brief_triple(glm::dvec3(chain.to_eye.after)));
  }
  if (chain.object.w == 0) line += "; w = 0 makes it a direction, which no translation moves";
  return wrapped("  ", line);
}

std::string behind_text(const ConventionsReport& report) {
  if (report.points < 2 || report.behind_eye == 0) return {};
  const bool all = report.behind_eye == report.points;
  return wrapped("  ", fmt::format("{} negative ({} of {} points): behind the eye",
                                   all ? "every w is" : "w is", report.behind_eye, report.points));
}

std::string no_change_text(const PointStep& step) {
  const bool alarmed =
      std::any_of(step.findings.begin(), step.findings.end(),
                  [](const Finding& finding) { return finding.severity == Severity::kAlarm; });
  return wrapped("  ", alarmed ? "No other change of convention brings it into the picture: mend "
                                 "what is wrong first"
                               : "No change of convention that is tried here brings it into the "
                                 "picture: look where it stands, and what the camera sees");
}

std::string changes_text(const PointStep& step) {
  const ConventionsReport& report = step.conventions;
  const bool expects = step.walks.front().expected.has_value();
  const bool pairs = report.alternatives.front().second.has_value();
  const std::string line = fmt::format(
      "If the {} ought to be {}, {} would do{}:", inflected(report.points, "point"),
      expects ? "where it is expected" : "in the picture",
      pairs ? "two changes together" : "one of these changes",
      report.alternatives.size() == 1 ? ""
                                      : " (the likeliest first; what was meant only you know)");
  return "\n" + wrapped("  ", line) + alternatives_text(report);
}

std::string verdict_text(const PointStep& step, const ChainSetting& setting) {
  std::string text = "VERDICT\n";
  for (const PointStep::Walk& walk : step.walks) text += where_text(walk, setting);
  const ConventionsReport& report = step.conventions;
  text += behind_text(report) + findings_text(step.findings);
  if (report.visible == report.points) return text;
  return text + (report.alternatives.empty() ? no_change_text(step) : changes_text(step));
}

}  // namespace

std::string point_step_text(const PointStep& step) {
  ChainSetting setting = chain_setting(step);
  std::string text = heading_text(step) + matrices_text(step.setup, step.origins);
  for (const PointStep::Walk& walk : step.walks) {
    setting.open_px = walk.open_px;
    text += "\nPOINT " + point_text(walk.chain.object) + "\n" + chain_text(walk.chain, setting);
  }
  return text + "\n" + verdict_text(step, setting);
}

nlohmann::ordered_json point_step_json(const PointStep& step) {
  const auto [x, y, width, height] = step.window;
  nlohmann::ordered_json json{{"schema", "glassbox-step-point-1"},
                              {"dialect", step.setup.dialect.name},
                              {"dialect_reason", step.dialect_reason},
                              {"viewport", {x, y, width, height}}};
  json["matrices"] = matrices_json(step.setup, step.origins);
  ChainSetting setting = chain_setting(step);
  json["points"] = nlohmann::ordered_json::array();
  for (const PointStep::Walk& walk : step.walks) {
    setting.open_px = walk.open_px;
    json["points"].push_back(chain_json(walk.chain, setting));
  }
  json["findings"] = findings_json(step.findings);
  if (!setting.projected) return json;
  json["visible"] = step.conventions.visible;
  json["behind_eye"] = step.conventions.behind_eye;
  json["alternatives"] = alternatives_json(step.conventions);
  json["spoiling_alternatives"] = step.conventions.spoiling;
  return json;
}

}  // namespace glassbox::app
