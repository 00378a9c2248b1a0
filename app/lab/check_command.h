// glassbox lab check: builds a student's folder, runs its checks and says what is right. glassbox lab watch: again after every
// save.
#pragma once

#include <optional>
#include <string>

#include "app/lab/find_lab.h"
#include "app/options/cli_fwd.h"

namespace glassbox::app {

class LabCheckCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string folder_;
  std::optional<std::string> json_output_, html_output_;
  bool hidden_ = false;
  double seconds_ = 10;
};

class LabWatchCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string folder_;
  std::optional<std::string> html_output_;
};

}  // namespace glassbox::app
