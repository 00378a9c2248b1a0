#include "cli/run_program.h"

#include <exception>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/help/help_command.h"
#include "cli/options/command_tree.h"
#include "cli/options/usage_error.h"
#include "cli/report/begin_and_end_run.h"
#include "cli/report/exit_codes.h"

#include <glassbox/base/printable.h>

namespace glassbox {

namespace {

// Adds a command that is not compiled into this program. It is listed, and if it is run, it prints
// how to build a program that has it.
void add_name(const CommandName& absent, CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(absent.name);
  command.prefix_command();
  command.callback([name = absent.name, &exit_code] {
    exit_code =
        refuse({"", name, "this program was built without the subcommand " + in_quotes(name),
                "./glassbox " + std::string(name) + " builds it"});
  });
}

void add_subject(const Subject& subject, CLI::App& app, int& exit_code) {
  if (subject.add != nullptr) subject.add(app, exit_code);
  for (const CommandName& each : subject.commands) {
    if (subject.add == nullptr) add_name(each, app, exit_code);
    app.get_subcommand(each.name)->description(each.help);
  }
}

int run(std::span<const Subject> subjects, int (*without_arguments)(), int argc, char** argv) {
  CLI::App app{"Glassbox: a software rasterizer you can see through.", "glassbox"};
  app.set_version_flag("-V,--version", std::string("glassbox ") + GLASSBOX_VERSION);
  app.footer(
      "Without a subcommand the built-in teapot is rendered to teapot.png.\n"
      "glassbox SUBCOMMAND --help shows its options and examples, as does glassbox help "
      "SUBCOMMAND.");

  int exit_code = kSuccess;
  for (const Subject& subject : subjects) add_subject(subject, app, exit_code);
  add_help_commands(app, exit_code);
  app.require_subcommand(0, 1);
  refuse_empty_names(app);
  read_as_decimal(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors. Anything else is bad usage; CLI11's exit code is not used.
    if (error.get_exit_code() == 0) return app.exit(error), kSuccess;
    fmt::print(stderr, "glassbox: {}\n", usage_error_message(app, error));
    return kBadInput;
  }
  if (app.get_subcommands().empty()) return without_arguments();
  return exit_code;
}

}  // namespace

int run_program(std::span<const Subject> subjects, int (*without_arguments)(), int argc,
                char** argv) {
  begin_run();
  try {
    return end_run(run(subjects, without_arguments, argc, argv));
  } catch (const std::exception& error) {
    return report_exception(error);
  }
}

}  // namespace glassbox
