// glassbox completion SHELL: prints the script that makes a shell complete command lines.
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/help/completion.h"
#include "cli/help/help_command.h"
#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"

#include <glassbox/base/printable.h>

namespace glassbox {

class CompletionCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run(const CLI::App& program) const;

  std::string shell_;
};

void CompletionCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "completion", "print a script that lets a shell complete these commands and options");
  command.footer(
      "Examples:\n"
      "  source <(glassbox completion bash)            # in ~/.bashrc\n"
      "  source <(glassbox completion zsh)             # in ~/.zshrc, after compinit\n"
      "  glassbox completion fish | source             # in ~/.config/fish/config.fish\n\n"
      "cmake --install puts all three where the shells look for them.");
  command.add_option("SHELL", shell_, "bash, zsh or fish")->required();
  command.callback([this, &app, &exit_code] { exit_code = run(app); });
}

int CompletionCommand::run(const CLI::App& program) const {
  const CommandFacts facts = command_tree(program);
  if (shell_ == "bash") {
    fmt::print("{}", bash_completion(facts));
  } else if (shell_ == "zsh") {
    fmt::print("{}", zsh_completion(facts));
  } else if (shell_ == "fish") {
    fmt::print("{}", fish_completion(facts));
  } else {
    return refuse({"", "completion", "the shell " + in_quotes(shell_) + " is not known",
                   "name bash, zsh or fish"});
  }
  return kSuccess;
}

void add_completion_command(CLI::App& app, int& exit_code) {
  add_command<CompletionCommand>(app, exit_code);
}

}  // namespace glassbox
