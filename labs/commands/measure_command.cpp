// glassbox lab measure: runs an experiment with a student's functions as one more series.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "cli/report/table.h"
#include "cli/report/text_layout.h"
#include "labs/commands/commands.h"
#include "labs/commands/find_lab.h"
#include "labs/commands/student_stages.h"
#include "labs/framework/digest.h"
#include "labs/framework/lab.h"
#include "labs/grading/submission.h"
#include "labs/measuring/claim.h"
#include "labs/measuring/measuring.h"
#include "study/commands/bench/report.h"
#include "study/commands/report.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"
#include "study/experiment/results.h"
#include "study/experiment/runner.h"
#include "study/experiment/timing.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/read.h>

namespace glassbox::labs {

// The report of `glassbox lab measure` on an experiment that includes a student's series.

namespace {

using study::ConfigurationResult;
using study::ExperimentResult;
using study::Timing;

bool is_theirs(const ConfigurationResult& each, const std::vector<std::string>& series) {
  return std::find(series.begin(), series.end(), each.series) != series.end();
}

// The fastest configuration that is at least as exact as `mine` and certainly faster: its upper
// quartile of times is below the lower quartile of `mine`. Null if there is none.
const ConfigurationResult* better_than(const ConfigurationResult& mine, const Timing& time,
                                       const ExperimentResult& result) {
  const ConfigurationResult* best = nullptr;
  for (const ConfigurationResult& each : result.configurations) {
    const Timing* const theirs = study::timing_of(each, 1);
    if (&each == &mine || theirs == nullptr || !study::are_competitors(result, mine, each))
      continue;
    const bool as_exact = each.error <= mine.error || mine.error != mine.error;
    if (!as_exact || theirs->ns.upper >= time.ns.lower) continue;
    if (best == nullptr || theirs->ns.median < study::timing_of(*best, 1)->ns.median) best = &each;
  }
  return best;
}

// The place of a point in the chart of error against time: "front" (the Pareto front), or "behind
// X" if the series X is at least as exact and certainly faster; empty if the point is not timed.
std::string standing_of(const ConfigurationResult& mine, const ExperimentResult& result) {
  const Timing* const time = study::timing_of(mine, 1);
  if (time == nullptr) return {};
  const ConfigurationResult* const better = better_than(mine, *time, result);
  const std::string word = better == nullptr ? "front" : "behind " + better->series;
  return time->disturbed > 0 ? word + ", disturbed" : word;
}

glassbox::Row row_of(const ConfigurationResult& mine, const ExperimentResult& result,
                     const TimeUnit& unit) {
  glassbox::Row row{mine.series, mine.scene, standing_of(mine, result),
                    fmt::format("{:.6g}", mine.parameter), fmt::format("{:.3g}", mine.error)};
  const Timing* const time = study::timing_of(mine, 1);
  row.push_back(time == nullptr ? "" : study::three_digits(time->ns.median / unit.ns));
  row.push_back(time == nullptr
                    ? ""
                    : fmt::format("{} .. {}", study::three_digits(time->ns.lower / unit.ns),
                                  study::three_digits(time->ns.upper / unit.ns)));
  return row;
}

std::string table_of(const ExperimentResult& part, const std::vector<std::string>& series) {
  const TimeUnit unit = time_unit(part);
  const auto scened = [](const ConfigurationResult& each) { return !each.scene.empty(); };
  const bool scenes = std::any_of(part.configurations.begin(), part.configurations.end(), scened);
  std::vector<glassbox::Row> rows{{"", scenes ? "scene" : "", "",
                                   part.axis_unit.empty() ? "axis" : part.axis_unit, "error",
                                   fmt::format("{}/{}", unit.name, part.item), "quartiles"}};
  for (const ConfigurationResult& each : part.configurations) {
    if (is_theirs(each, series)) rows.push_back(row_of(each, part, unit));
  }
  return rows.size() == 1 ? "" : table(rows, 3);
}

}  // namespace

// The text in place of the table if the student's functions give no point at all.
std::string unwritten_text(const labs::Lab& lab, const labs::LabMeasure& measured) {
  return fmt::format("Lab {} in {}\n", lab.number, measured.experiment) +
         wrapped("  Not written yet: ", measured.functions +
                                            "; they give the same answers as the starter's "
                                            "functions, so nothing was measured.");
}

// A table of the student's points, which also says for each whether one of the experiment's own
// configurations is better. `untouched` are the series whose functions the student has not written.
std::string measure_text(const labs::Lab& lab, const labs::LabMeasure& measured,
                         const ExperimentResult& result, const std::vector<std::string>& series,
                         const std::vector<std::string>& untouched) {
  std::string text =
      fmt::format("Lab {} in {}, {}\n", lab.number, result.id, result.name) +
      wrapped("  Measured: ", measured.functions + "; times are processor time of one thread");
  for (const ExperimentResult& part : study::by_measure(result)) {
    const std::string rows = table_of(part, series);
    if (rows.empty()) continue;
    text += "\n" + wrapped("  Axis: ", study::with_unit(part.axis, part.axis_unit)) +
            wrapped("  Error: ", study::with_unit(part.error, part.error_unit)) + "\n" + rows;
  }
  if (!untouched.empty())
    text += "\n" + wrapped("  Not written yet, and not measured: ",
                           fmt::format("{}", fmt::join(untouched, "; ")));
  text +=
      "\nfront: no other point of the chart is at least as exact and clearly faster; behind X: "
      "X is at least\nas exact and clearly faster.\n";
  const auto is_disturbed = [&](const ConfigurationResult& each) {
    const Timing* const time = study::timing_of(each, 1);
    return is_theirs(each, series) && time != nullptr && time->disturbed > 0;
  };
  return std::ranges::any_of(result.configurations, is_disturbed)
             ? text + wrapped("", study::kDisturbedMeaning)
             : text;
}

class LabMeasureCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  LabSelection selection_;
  std::optional<std::string> json_output_, html_output_, against_;
  double seconds_ = 60;
};

namespace {

using study::ExperimentResult;

std::vector<std::string> series_of(const std::vector<study::ConfigurationResult>& yours) {
  std::vector<std::string> series;
  for (const auto& each : yours) {
    if (std::find(series.begin(), series.end(), each.series) == series.end())
      series.push_back(each.series);
  }
  return series;
}

Result<labs::Claim> claim_in(const std::string& path) {
  // A file of one or two thousand points is smaller.
  constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 20;
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return labs::read_claim(path,
                          std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
}

// The measurement without the series whose functions the student has not written yet.
labs::LabMeasure without(const labs::LabMeasure& whole, const std::vector<std::string>& untouched) {
  labs::LabMeasure rest = whole;
  rest.points = [points = whole.points(), untouched] {
    auto written = points;
    std::erase_if(written, [&](const labs::MeasuredPoint& each) {
      return std::find(untouched.begin(), untouched.end(), each.series) != untouched.end();
    });
    return written;
  };
  return rest;
}

// Compares the claimed results with the measured ones. Prints to `out` where they differ. Returns
// the exit code.
int judge(const std::string& path, const labs::Claim& claimed, const labs::Claim& measured,
          std::FILE* out) {
  fmt::print(out, "{}: the times of {}\n", printable(path), printable(labs::owner_text(claimed)));
  fmt::print(out, "measured here: the times of {}\n", printable(labs::owner_text(measured)));
  const auto found = labs::contradictions(claimed, measured);
  if (found.empty()) {
    fmt::print(out,
               "{} agrees with this measurement: it has the same {}, and no two times are in the "
               "opposite order\n",
               printable(path), counted(measured.points.size(), "error"));
    return kSuccess;
  }
  for (const std::string& each : found)
    fmt::print(out, "{}: {}\n", printable(path), printable(each));
  return kFailure;
}

}  // namespace

void LabMeasureCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "measure", "measures error and time of your functions, as points in an experiment's chart");
  command.footer(
      "Examples:\n"
      "  glassbox lab measure ~/lab6 --html chart.html\n"
      "  glassbox lab measure ~/lab6 --json measured.json       # to be handed in\n"
      "  glassbox lab measure class/ann --lab 6 --against class/ann/measured.json\n\n"
      "The experiment that the handout names is run as by study run --quick, and your functions "
      "run in\n"
      "a process of their own. The exit code is 1 if no function is written yet, if the code does "
      "not\n"
      "compile or does not end, or if the file of --against differs from what was measured.");
  command
      .add_option("FOLDER", selection_.folder,
                  "a folder made by glassbox lab start, or another one with a student.cpp")
      ->required();
  add_lab_name(command, selection_.lab);
  add_json_output(command, json_output_, "your points, to be handed in");
  add_html_output(command, html_output_, "the experiment's charts, with your points");
  command.add_option("--against", against_, "compare with this file, which was handed in")
      ->type_name("FILE");
  command
      .add_option("--time-limit", seconds_,
                  "time limit of a process that runs your functions, in seconds")
      ->check(number_between(0.1, 3600))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabMeasureCommand::run() const {
  if (const auto good = check_report_outputs(html_output_, json_output_); !good)
    return refuse(good.error());
  const auto folder = open_lab_folder(selection_);
  if (!folder) return refuse(folder.error());
  const auto measured = labs::measure_of(folder->lab->number);
  if (!measured)
    return refuse({selection_.folder, "",
                   fmt::format("no function of lab {} is measured", folder->lab->number),
                   "run the experiments that its handout names under \"Error against time\""});
  std::optional<labs::Claim> claimed;
  if (against_) {
    auto claim = claim_in(*against_);
    if (!claim) return refuse(claim.error());
    claimed = std::move(*claim);
  }
  const auto sources = labs::find_sources();
  if (!sources) return refuse(sources.error());
  Progress progress;
  StudentStages stages;
  if (const auto built = stages.build(*sources, *folder, progress, true); !built)
    return refuse(built.error());
  if (stages.program().program.empty()) {
    progress.done();
    fmt::print("{}", stages.program().messages);
    return kFailure;
  }
  const auto starter = stages.build_starter(*sources, *folder, true);
  if (!starter) return refuse(starter.error());
  labs::StudentAnswers student(stages.sandbox(), stages.program().program, seconds_),
      untouched(stages.sandbox(), starter->program, seconds_);
  const auto tell = [&](const std::string& what) { progress.phase(what); };
  // Reports an error of the student's code, or what prevented the code from being run.
  const auto broken = [&](const Error& error) {
    if (!student.failure()) return refuse(error);
    progress.done();
    fmt::print("{}: {}\n", folder->student.string(), *student.failure());
    return kFailure;
  };
  const auto not_written = labs::untouched_series(*measured, student, untouched, tell);
  if (!not_written) return broken(not_written.error());
  const labs::LabMeasure written = without(*measured, *not_written);
  if (written.points().empty()) {
    progress.done();
    fmt::print("{}", unwritten_text(*folder->lab, *measured));
    return kFailure;
  }
  const auto yours = labs::measure_points(written, student, study::kMinRepetitions, tell);
  if (!yours) return broken(yours.error());

  study::RunOptions options;
  options.phase = tell;
  ExperimentResult result = study::run_experiment(
      *study::find_experiment(study::experiments(), measured->experiment), options);
  result.configurations.insert(result.configurations.end(), yours->begin(), yours->end());
  progress.done();
  const study::Origin origin =
      study::current_origin(study::version_and_build(), study::Effort::kQuick, 1);
  const std::vector<std::string> series = series_of(*yours);
  const auto text = labs::grading::read_source(folder->student);
  if (!text) return refuse(text.error());
  const labs::Claim claim =
      labs::claim_of(folder->lab->folder, labs::grading::submission_name(selection_.folder),
                     labs::Digest().add(*text).text(), origin, result, series);
  if (json_output_) {
    if (const auto made = write_json(*json_output_, labs::claim_json(claim)); !made)
      return refuse(made.error());
  }
  if (html_output_) {
    const std::string command =
        shell_line({{"lab", "measure", selection_.folder, "--html", *html_output_}});
    const auto made = write_text(*html_output_, study::study_page({origin, {result}}, command));
    if (!made) return refuse(made.error());
  }
  if (json_output_ != "-")
    fmt::print("{}", measure_text(*folder->lab, *measured, result, series, *not_written));
  // If JSON goes to standard output, nothing else may be written there.
  return claimed ? judge(*against_, *claimed, claim, json_output_ == "-" ? stderr : stdout)
                 : kSuccess;
}

void add_measure_command(CLI::App& lab, int& exit_code) {
  add_command<LabMeasureCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
