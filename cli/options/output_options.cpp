#include "cli/options/output_options.h"

#include <CLI/CLI.hpp>

namespace glassbox {

CLI::Option* add_json_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& what) {
  return command.add_option("--json", target, what + " as JSON; - is standard output")
      ->type_name("FILE|-");
}

CLI::Option* add_html_output(CLI::App& command, std::optional<std::string>& target,
                             const std::string& help) {
  return command.add_option("--html", target, help)->type_name("FILE");
}

CLI::Option* add_max_megabytes(CLI::App& command, std::uint32_t& target, const std::string& of) {
  return command
      .add_option("--max-mb", target,
                  "do not write more than this number of megabytes" + of + " [" +
                      std::to_string(target) + "]")
      ->type_name("N")
      ->group("Limits");
}

}  // namespace glassbox
