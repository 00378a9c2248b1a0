#include "cli/options/list_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"

namespace glassbox {

void ListCommand::add_to(CLI::App& parent, int& exit_code) {
  CLI::App& command = *parent.add_subcommand("list", help_);
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int ListCommand::run() const {
  if (json_output_) {
    if (const auto written = write_json(*json_output_, json_()); !written)
      return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", text_());
  return kSuccess;
}

}  // namespace glassbox
