// glassbox study extremes: draws the cases that break pipelines, and measures how errors grow
// (sweeps).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "study/commands/extremes/report.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyExtremesCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<std::vector<const study::ExtremeCase*>> chosen_cases() const;
  Result<std::vector<const study::Sweep*>> chosen_sweeps() const;
  Result<void> write_outputs(const ExtremesReport& report) const;
  Result<void> write_pictures(const ExtremesReport& report) const;
  std::string command() const;

  std::vector<std::string> cases_;
  std::optional<std::string> one_case_, sweep_, json_output_, html_output_, picture_directory_;
};

}  // namespace glassbox::study
