// glassbox lab gradescope: writes the archive from which Gradescope builds an autograder.
#include <filesystem>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/options/choices.h"
#include "cli/report/exit_codes.h"
#include "labs/commands/commands.h"
#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/autograder.h"

#include <glassbox/images/atomic_file.h>

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
  bool vary_ = false;
};

void LabGradescopeCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command =
      *lab.add_subcommand("gradescope", "makes the archive for Gradescope's autograder");
  command.footer(
      "Example:\n"
      "  glassbox lab gradescope 5 -o autograder.zip\n\n"
      "Upload the archive without unpacking it. docs/grading.md says what Gradescope does with "
      "it.");
  command.add_option("LAB", lab_, "the number of the lab")->required();
  command.add_option("-o,--output", output_, "the archive; by default autograder.zip")
      ->type_name("FILE");
  command
      .add_option("--time-limit", seconds_, "time limit of each check, in seconds; by default 10")
      ->check(number_between(0.1, 3600));
  command
      .add_option("--memory-limit", memory_mib_,
                  "memory limit of each check, in MiB; by default 512")
      ->check(CLI::Range(std::size_t(64), std::size_t(1) << 20));
  command.add_flag("--vary", vary_,
                   "give each submission its own inputs for the hidden checks, computed from those "
                   "who handed it in");
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabGradescopeCommand::run() const {
  const auto sources = find_sources_();
  if (!sources) return refuse(sources.error());
  for (const labs::Lab& lab : labs_()) {
    if (lab.number != lab_) continue;
    const auto entries = labs::grading::autograder_files(
        lab, sources->labs.parent_path(),
        {fmt::format("--time-limit {}", seconds_), fmt::format("--memory-limit {}", memory_mib_)},
        vary_);
    if (!entries) return refuse(entries.error());
    const auto bytes = labs::make_zip(*entries);
    if (!bytes) return refuse(bytes.error());
    if (const auto written = write_file(output_, *bytes); !written) return refuse(written.error());
    fmt::print("{}: {} files, {} KiB; upload this archive to Gradescope without unpacking it\n",
               output_, entries->size(), bytes->size() >> 10);
    return kSuccess;
  }
  return refuse(
      {"", "LAB", fmt::format("there is no lab {}", lab_), "`glassbox lab list` names the labs"});
}

void add_gradescope_command(CLI::App& lab, int& exit_code) {
  add_command<LabGradescopeCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
