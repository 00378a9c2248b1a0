#include "study/commands/list.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/text_layout.h"
#include "study/experiment/experiment.h"

namespace glassbox::study {

nlohmann::ordered_json experiments_json() {
  auto json = nlohmann::ordered_json::array();
  for (const study::Experiment& each : study::experiments()) {
    auto measures = nlohmann::ordered_json::array();
    for (const study::Measure& measure : each.measures) {
      measures.push_back({{"name", measure.name},
                          {"error", measure.error},
                          {"error_unit", measure.error_unit},
                          {"axis", measure.axis.empty() ? each.axis : measure.axis}});
    }
    json.push_back({{"id", each.id},
                    {"name", each.name},
                    {"question", each.question},
                    {"axis", each.axis},
                    {"error", each.error},
                    {"error_unit", each.error_unit},
                    {"reference", each.reference},
                    {"measures", std::move(measures)},
                    {"theory", each.theory},
                    {"item", each.item},
                    {"threaded", each.threaded}});
  }
  return json;
}

std::string experiments_text() {
  std::string text;
  for (const study::Experiment& each : study::experiments()) {
    text += fmt::format("{:<6}{}\n", each.id, each.name);
    text += wrapped("      ", each.question);
  }
  return text + "\nglassbox study run ID measures one of them, glassbox study run all.\n";
}

}  // namespace glassbox::study
