// glassbox study agree ONE OTHER: checks whether two runs agree on which configurations are faster
// than which.
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "cli/report/text_layout.h"
#include "study/commands/commands.h"
#include "study/experiment/agreement.h"
#include "study/experiment/result_file.h"

#include <glassbox/base/counted.h>

namespace glassbox::study {

class StudyAgreeCommand {
public:
  void add_to(CLI::App& study, int& exit_code);

private:
  int run() const;

  std::string one_, other_;
};

void StudyAgreeCommand::add_to(CLI::App& study, int& exit_code) {
  CLI::App& command = *study.add_subcommand(
      "agree", "compares two runs: checks whether they find the same configurations faster");
  command.footer(
      "Examples:\n"
      "  glassbox study run --quick --json one.json\n"
      "  glassbox study run --quick --json other.json\n"
      "  glassbox study agree one.json other.json\n\n"
      "A run says that one configuration is faster than another if the middle three quarters of "
      "their\n"
      "times do not overlap. The exit code is 1 if the two runs say the opposite of a pair.");
  command.add_option("ONE", one_, "the JSON file of a study run")->required();
  command.add_option("OTHER", other_, "the JSON file of another run")->required();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int StudyAgreeCommand::run() const {
  const auto one = study::read_results(one_), other = study::read_results(other_);
  for (const auto* results : {&one, &other}) {
    if (!*results) return refuse(results->error());
  }
  const auto found = study::find_agreement(*one, *other);
  if (!found) return refuse(found.error());
  fmt::print(
      "{} of configurations compared: both runs say which one is faster for {}, and they "
      "contradict each other for {} of them; only one run says it for {}\n",
      counted(found->compared, "pair"), counted(found->by_both, "pair"),
      found->contradictions.size(), found->by_one);
  for (const std::string& each : found->contradictions) fmt::print("{}", wrapped("  ", each));
  return found->contradictions.empty() ? kSuccess : kFailure;
}

void add_agree_command(CLI::App& study, int& exit_code) {
  add_command<StudyAgreeCommand>(study, exit_code);
}

}  // namespace glassbox::study
