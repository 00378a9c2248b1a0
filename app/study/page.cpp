#include "app/study/page.h"

#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/program_name.h"
#include "study/experiment/results_json.h"
#include "study_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

std::string command_of(const study::ExperimentResult& experiment, const study::Origin& origin) {
  return fmt::format("{} study run {}{} --threads {}", program_name(), experiment.id,
                     origin.effort == study::Effort::kQuick ? " --quick" : "", origin.threads);
}

}  // namespace

std::string study_page(const study::StudyResults& results, const std::string& command) {
  nlohmann::ordered_json manifest = study::results_json(results);
  manifest["command"] = command;
  for (std::size_t i = 0; i < results.experiments.size(); ++i)
    manifest["experiments"][i]["command"] = command_of(results.experiments[i], results.origin);
  return assemble_page(kStudyPage, "glassbox study", json_block("manifest", manifest));
}

}  // namespace glassbox::app
