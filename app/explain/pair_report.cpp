#include "app/explain/pair_report.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/explain/tile_report_text.h"
#include "cli/report/stage_report.h"

namespace glassbox::app {

namespace {

struct ReportedEye {
  const char* key;
  const char* heading;
  const Statistics& statistics;
};

std::vector<ReportedEye> eyes_of(const StereoRendering& both) {
  if (both.passes == 1) return {{"both", "both eyes", both.left_statistics}};
  return {{"left", "the left eye", both.left_statistics},
          {"right", "the right eye", both.right_statistics}};
}

std::string plans_text(const std::vector<ReportedEye>& eyes,
                       const std::vector<std::string>& plans) {
  const bool same = std::ranges::all_of(plans, [&](const auto& p) { return p == plans.front(); });
  if (same) return "both eyes\n\n" + plans.front() + "\n";
  std::string text;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    text += eyes[i].heading + std::string("\n\n") + plans[i] + "\n";
  }
  return text;
}

}  // namespace

std::string pair_text(const PairReport& pair) {
  const std::vector<ReportedEye> eyes = eyes_of(pair.both);
  std::string text;
  if (pair.is_planned()) text += plans_text(eyes, pair.planned.texts);
  if (!pair.counted) return text;
  const EngineKind engine = pair.is_planned() ? EngineKind::kTile : EngineKind::kStaged;
  for (const ReportedEye& eye : eyes) {
    text += eye.heading + std::string("\n") + stage_table(eye.statistics, engine) + "\n";
  }
  // Work shared by both eyes is counted and timed with the first eye.
  const Statistics& first = eyes.front().statistics;
  return text + (pair.is_planned() ? tile_text(first, pair.planned.report) : time_table(first));
}

nlohmann::ordered_json pair_json(const PairReport& pair) {
  const std::vector<ReportedEye> eyes = eyes_of(pair.both);
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    nlohmann::ordered_json& of_eye = json[eyes[i].key];
    if (pair.is_planned()) of_eye["plan"] = pair.planned.json[i];
    if (pair.counted) of_eye.update(to_json(eyes[i].statistics));
  }
  if (pair.counted && pair.is_planned()) {
    json["tile"] = to_json(eyes.front().statistics, pair.planned.report);
  }
  return json;
}

}  // namespace glassbox::app
