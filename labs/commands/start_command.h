// glassbox lab start: makes a folder to do a lab in. glassbox lab export: writes the same as an
// archive, for a class.
#pragma once

#include <string>

#include "cli/options/cli_fwd.h"

namespace glassbox::labs {

class LabStartCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_, folder_, lab_dir_;
};

class LabExportCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_, output_, for_ = "students";
};

}  // namespace glassbox::labs
