#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "cli/report/shell_line.h"
#include "cli/report/text_layout.h"
#include "labs/commands/report.h"
#include "labs/framework/divergence_text.h"
#include "labs/framework/run_check.h"
#include "labs/framework/slips.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::labs {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Output of a student's code or of the compiler, indented, without the control characters that
// would change the terminal.
std::string quoted_lines(const std::string& indent, const std::string& text, std::size_t most) {
  const auto lines = lines_of(text);
  std::string quoted;
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i)
    quoted += indent + printable(lines[i], 400) + "\n";
  if (lines.size() > most)
    quoted += fmt::format("{}... and {}\n", indent, counted(lines.size() - most, "more line"));
  return quoted;
}

std::string divergence_text(const Divergence& found) {
  std::string text = fmt::format("    {}{}{}: {}\n", found.field, found.element.empty() ? "" : ", ",
                                 found.element, labs::kind_name(found.kind));
  const bool has_expected = found.kind != Divergence::Kind::kExtra || !std::isnan(found.expected);
  const bool has_actual = found.kind != Divergence::Kind::kMissing || !std::isnan(found.actual);
  if (has_expected) text += fmt::format("      expected  {}\n", labs::expected_text(found));
  if (has_actual) text += fmt::format("      actual    {}\n", labs::actual_text(found));
  if (has_expected && has_actual)
    text += fmt::format("      distance  {}\n", labs::distance_text(found));
  if (!found.explanation.empty()) text += wrapped("      ", found.explanation);
  return text;
}

std::string failure_text(const LabReport& report, const CheckResult& check) {
  const FirstFailure& first = *check.first;
  std::string text = fmt::format("  case {}", first.index);
  if (!first.where.empty()) text += ", " + first.where;
  text += fmt::format(": {}\n", outcome_text(report, check));
  if (first.verdict == Verdict::kUntouched) return text;
  if (!first.text.empty()) text += wrapped("    ", printable(first.text, 600));
  if (first.divergence) text += divergence_text(*first.divergence);
  if (first.comparison && !first.comparison->map.empty()) {
    for (const std::string& line : lines_of(first.comparison->map)) text += "    " + line + "\n";
  }
  const Restated restated = restated_lines(first.restated);
  for (const std::string& fact : restated.facts) text += "    " + fact + "\n";
  for (const std::string& slip : check.slips)
    text += fmt::format("    likely mistake ({}): {}\n", slip, labs::slip_text(slip));
  for (const std::string& command : restated.commands)
    text += fmt::format("    look at it: {}\n", command);
  const std::string debugger = debugger_command(report, check);
  if (!debugger.empty()) text += fmt::format("    debug it: {}\n", debugger);
  return text;
}

std::string printed_text(const CheckResult& check) {
  if (check.printed.empty()) return {};
  return "    your code printed:\n" + quoted_lines("      ", check.printed, 12);
}

std::string check_text(const LabReport& report, const CheckResult& check) {
  std::string text =
      fmt::format("\n{} (task {}, stage {}{}): {} of {} right{}\n", check.name, check.task,
                  check.stage, check.hidden ? ", hidden" : "", check.right,
                  counted(check.cases.size(), "case"), all_or_nothing_note(check));
  if (check.first) text += failure_text(report, check);
  return text + printed_text(check);
}

}  // namespace

std::string points_text(double score, double max_score) {
  // Points are shown to a hundredth, but a score below full marks is never rounded up to them.
  const auto shown = [](double points) {
    return fmt::format("{:g}", std::round(points * 100) / 100);
  };
  const bool full = score == max_score;
  const double seen = full ? score : std::min(score, std::floor((max_score - 1e-9) * 100) / 100);
  return shown(seen) + " of " + shown(max_score);
}

std::string outcome_text(const LabReport& report, const CheckResult& check) {
  const auto at = std::size_t(&check - report.result.checks.data());
  return at < report.names.size() ? report.names[at] : labs::verdict_name(check.verdict);
}

Restated restated_lines(const std::string& restated) {
  static const std::string kCommand = "glassbox ";
  Restated found;
  for (const std::string& line : lines_of(restated)) {
    if (line.rfind(kCommand, 0) == 0) {
      found.commands.push_back(program_name() + " " + line.substr(kCommand.size()));
    } else if (!line.empty()) {
      found.facts.push_back(line);
    }
  }
  return found;
}

std::string debugger_command(const LabReport& report, const CheckResult& check) {
  if (report.runner.empty() || !check.first) return {};
  const auto runner = shell_quoted(report.runner), name = shell_quoted(check.name);
  if (!runner || !name) return {};
  const auto& choices = check.first->choices;
  return fmt::format("gdb --args {} --check {} --case {}{}", *runner, *name, check.first->index,
                     choices ? fmt::format(" --choices '{}'", choices_text({*choices})) : "");
}

std::string lab_report_text(const LabReport& report) {
  const labs::LabResult& result = report.result;
  std::string text = fmt::format("Lab {}: {}\n\n", result.number, result.title);
  std::size_t width = 5;
  for (const labs::TaskResult& task : result.tasks) width = std::max(width, task.title.size());
  for (const labs::TaskResult& task : result.tasks) {
    if (task.max_score == 0) continue;
    text += fmt::format("  {:<4} {:<{}}  {}\n", task.id, task.title, width,
                        points_text(task.score, task.max_score));
  }
  text += fmt::format("  {:<4} {:<{}}  {}\n", "", "total", width,
                      points_text(result.score, result.max_score));
  if (result.hidden_points > 0)
    text += fmt::format("  Hidden checks can give {:g} points more.\n",
                        std::round(result.hidden_points * 100) / 100);
  if (!result.not_built.empty()) {
    return text + fmt::format("\n{} does not compile:\n", report.student) +
           quoted_lines("  ", result.not_built, 60);
  }
  if (!result.warnings.empty()) text += "\nWarnings:\n";
  for (const std::string& warning : result.warnings) text += quoted_lines("  ", warning, 30);
  for (const CheckResult& check : result.checks) {
    if (check.first || !check.printed.empty()) text += check_text(report, check);
  }
  return text;
}

}  // namespace glassbox::labs
