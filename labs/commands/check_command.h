// glassbox lab check: builds a student's folder, runs its checks and reports what is right.
// glassbox lab watch: does so again after every save, or draws a scene again.
#pragma once

#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "labs/commands/checker.h"
#include "labs/commands/find_lab.h"

namespace glassbox::labs {

class LabCheckCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  AskedLab asked_;
  std::optional<std::string> json_output_, html_output_;
  CheckOptions options_;
};

class LabWatchCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  int watch_picture() const;

  AskedLab asked_;
  std::string scene_, output_;
  PictureOptions picture_;
  std::optional<std::string> html_output_;
  CheckOptions options_;
};

}  // namespace glassbox::labs
