// glassbox lab package: writes a copy of this glassbox without the parts that students must not
// see.
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "labs/commands/commands.h"
#include "labs/framework/sources.h"
#include "labs/grading/package.h"

#include <glassbox/images/atomic_file.h>

namespace glassbox::labs {

class LabPackageCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string output_;
  bool students_ = false;
};

void LabPackageCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "package",
      "makes an archive of glassbox's sources for students, without solutions and grading");
  command.footer(
      "Example:\n"
      "  glassbox lab package --students -o glassbox-students.zip\n\n"
      "The archive has the sources without solutions, hidden checks, planted faults, tests and "
      "grading.\n"
      "In the unpacked folder, ./glassbox builds them as it does in a clone.");
  command.add_flag("--students", students_, "make the archive for students")->required();
  command.add_option("-o,--output", output_, "the archive: a .zip file")
      ->type_name("FILE")
      ->required();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabPackageCommand::run() const {
  if (const auto good = check_extension(output_, ".zip"); !good) return refuse(good.error());
  const auto sources = labs::find_sources();
  if (!sources) return refuse(sources.error());
  const auto entries = labs::grading::students_files(sources->labs.parent_path());
  if (!entries) return refuse(entries.error());
  const auto bytes = labs::make_zip(*entries);
  if (!bytes) return refuse(bytes.error());
  if (const auto written = write_file(output_, *bytes); !written) return refuse(written.error());
  fmt::print("{}: {} files, {} KiB, without solutions and hidden checks\n", output_,
             entries->size(), bytes->size() >> 10);
  return kSuccess;
}

void add_package_command(CLI::App& lab, int& exit_code) {
  add_command<LabPackageCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
