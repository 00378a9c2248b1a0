// glassbox study report: writes the results as a page, and as pictures for papers and slides.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "study/commands/measuring.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

class StudyReportCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;
  Result<void> check_options() const;
  Result<study::StudyResults> results() const;
  std::string command() const;

  MeasuringOptions measuring_;
  std::optional<std::string> from_, page_, svg_directory_;
};

}  // namespace glassbox::study
