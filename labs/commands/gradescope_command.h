// glassbox lab gradescope: writes the archive from which Gradescope builds an autograder.
#pragma once

#include <functional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"

namespace glassbox::labs {

class LabGradescopeCommand {
public:
  using FindSources = std::function<Result<labs::Sources>()>;
  explicit LabGradescopeCommand(const std::vector<labs::Lab>& (*labs)() = labs::all_labs,
                                FindSources find_sources = labs::find_sources)
      : labs_(labs), find_sources_(std::move(find_sources)) {}
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  const std::vector<labs::Lab>& (*labs_)();
  FindSources find_sources_;
  int lab_ = 0;
  std::string output_ = "autograder.zip";
  double seconds_ = 10;
  std::size_t memory_mib_ = 512;
};

}  // namespace glassbox::labs
