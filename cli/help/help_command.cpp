#include "cli/help/help_command.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"

#include <glassbox/base/closest_word.h>
#include <glassbox/base/printable.h>

namespace glassbox {

class HelpCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run(const CLI::App& program) const;

  std::vector<std::string> words_;
};

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : commands_of(app)) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

int refuse_word(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  if (names.empty()) {
    return refuse({"", "help", in_quotes(app.get_name()) + " has no subcommands",
                   "glassbox help " + app.get_name() + " shows its options"});
  }
  const auto near = closest_word(word, names);
  return refuse({"", "help", "there is no subcommand " + in_quotes(word),
                 near ? "did you mean " + *near + "?" : "glassbox help lists them"});
}

}  // namespace

void HelpCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("help", "print the options and examples of a subcommand");
  command.footer(
      "Examples:\n"
      "  glassbox help render\n"
      "  glassbox help study run");
  command.add_option("COMMAND", words_, "the subcommand whose help is printed [the program]")
      ->type_name("");
  command.callback([this, &app, &exit_code] { exit_code = run(app); });
}

int HelpCommand::run(const CLI::App& program) const {
  const CLI::App* asked = &program;
  std::string name = program.get_name();
  for (const std::string& word : words_) {
    const CLI::App* next = command_named(*asked, word);
    if (next == nullptr) return refuse_word(*asked, word);
    asked = next;
    name += " " + word;
  }
  fmt::print("{}", program.get_formatter()->make_help(asked, name, CLI::AppFormatMode::Normal));
  return kSuccess;
}

void add_help_commands(CLI::App& app, int& exit_code) {
  add_command<HelpCommand>(app, exit_code);
  add_completion_command(app, exit_code);
  add_man_command(app, exit_code);
}

}  // namespace glassbox
