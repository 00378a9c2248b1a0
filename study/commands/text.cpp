#include "study/commands/report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "cli/report/text_layout.h"
#include "study/commands/bench/report.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"
#include "study/experiment/theory.h"
#include "study/experiment/timing.h"

#include <glassbox/base/counted.h>

namespace glassbox::study {

namespace {

bool is_disturbed(const ConfigurationResult& result) {
  return std::ranges::any_of(result.timings,
                             [](const Timing& timing) { return timing.disturbed > 0; });
}

std::string mark_of(const ConfigurationResult& result, Standing standing) {
  const auto check = study::check_theory(result);
  const bool finding = check && check->finding;
  std::string mark = standing == Standing::kFront       ? "front"
                     : standing == Standing::kDominated ? "dominated"
                                                        : "";
  if (finding) mark += mark.empty() ? "finding" : ", finding";
  if (is_disturbed(result)) mark += ", disturbed";
  return mark;
}

Row row_of(const ConfigurationResult& result, Standing standing, const std::vector<int>& counts,
           const TimeUnit& unit) {
  const auto check = study::check_theory(result);
  Row row{result.series,
          result.scene,
          fmt::format("{:.6g}", result.parameter),
          fmt::format("{:.3g}", result.error),
          check ? fmt::format("{:.3g}", *result.predicted_error) : "",
          check ? fmt::format("{:.2f}", check->ratio) : ""};
  for (const int count : counts) {
    const Timing* timing = study::timing_of(result, count);
    row.push_back(timing != nullptr ? three_digits(timing->ns.median / unit.ns) : "");
    row.push_back(timing != nullptr
                      ? fmt::format("{} .. {}", three_digits(timing->ns.lower / unit.ns),
                                    three_digits(timing->ns.upper / unit.ns))
                      : "");
  }
  row.push_back(mark_of(result, standing));
  return row;
}

std::string table_of(const ExperimentResult& result) {
  const std::vector<int> counts = study::thread_counts(result);
  const TimeUnit unit = time_unit(result);
  const bool scenes = std::ranges::any_of(
      result.configurations, [](const ConfigurationResult& each) { return !each.scene.empty(); });
  Row head{"",
           scenes ? "scene" : "",
           result.axis_unit.empty() ? "axis" : result.axis_unit,
           "error",
           "theory",
           "ratio"};
  for (const int count : counts) {
    head.push_back(fmt::format("{}/{}, {} thr.", unit.name, result.item, count));
    head.push_back("quartiles");
  }
  head.push_back("");
  std::vector<Row> rows{head};
  const std::vector<Standing> all = study::standings(result);
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.push_back(row_of(result.configurations[i], all[i], counts, unit));
  return table(rows, 2);
}

// The known reason why an error differs from the theory, with the ratios (measured to predicted)
// that it explains; a statement if there is no reason for this ratio.
std::string explanation_of(const study::ConfigurationResult& result) {
  std::string known;
  if (const auto& e = result.explanation) {
    known = fmt::format("{} (for ratios from {:g} to {:g})", e->why, e->least, e->greatest);
  }
  if (!study::is_unexplained(result)) return known;
  return "NOT explained: the error differs from the theory" +
         (known.empty() ? "" : ", by another ratio than the known reason explains: " + known);
}

// All explanations, each one once with the number of configurations that it explains.
std::string findings_of(const ExperimentResult& result) {
  std::vector<std::pair<std::string, int>> told;
  for (const ConfigurationResult& each : result.configurations) {
    const auto check = study::check_theory(each);
    if (!check || !check->finding) continue;
    const std::string what = explanation_of(each);
    const auto same = std::ranges::find(told, what, &std::pair<std::string, int>::first);
    if (same == told.end()) {
      told.emplace_back(what, 1);
    } else {
      ++same->second;
    }
  }
  std::string text;
  for (const auto& [what, count] : told) {
    text += wrapped(count == 1 ? "  Finding: " : fmt::format("  {} findings: ", count), what);
  }
  return text;
}

// The machine's state as far as it is known: "load 1.2, 2300 MHz".
std::string state_text(const study::MachineState& state) {
  std::string text;
  if (std::isfinite(state.load)) text = fmt::format("load {:.1f}", state.load);
  if (std::isfinite(state.mhz) && state.mhz > 0)
    text += fmt::format("{}{:.0f} MHz", text.empty() ? "" : ", ", state.mhz);
  return text;
}

std::string experiment_text(const ExperimentResult& result) {
  std::string text = fmt::format("{}  {}\n", result.id, result.name);
  text += wrapped("  ", result.question);
  text += wrapped("  Reference: ", result.reference);
  if (!result.theory.empty()) text += wrapped("  Theory: ", result.theory);
  if (const std::string state = state_text(result.machine); !state.empty())
    text += wrapped("  Machine: ", state);
  for (const ExperimentResult& part : study::by_measure(result)) {
    text += "\n" + wrapped("  Axis: ", with_unit(part.axis, part.axis_unit));
    text += wrapped("  Error: ", with_unit(part.error, part.error_unit) +
                                     (part.more_is_better ? "; more is better" : ""));
    text += "\n" + table_of(part);
  }
  if (std::ranges::any_of(result.configurations, is_disturbed))
    text += "\n" + wrapped("  ", kDisturbedMeaning);
  text += "\n";
  return text + findings_of(result);
}

}  // namespace

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

TimeUnit time_unit(const ExperimentResult& result) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const ConfigurationResult& each : result.configurations) {
    for (const Timing& timing : each.timings) shortest = std::min(shortest, timing.ns.median);
  }
  return glassbox::time_unit(shortest);
}

std::string origin_text(const study::Origin& origin) {
  const std::string caches = origin.caches.empty() ? "unknown" : origin.caches;
  return fmt::format("{}; {}; caches {}; {} {}; glassbox {}; {} run, up to {}", origin.machine,
                     origin.target, caches, origin.compiler, origin.flags, origin.version,
                     origin.effort == study::Effort::kQuick ? "quick" : "full",
                     counted(origin.threads, "thread"));
}

std::string study_text(const study::StudyResults& results) {
  std::string text = wrapped("", origin_text(results.origin));
  int findings = 0, unexplained = 0;
  for (const ExperimentResult& each : results.experiments) {
    text += "\n" + experiment_text(each);
    findings += study::count_findings(each);
    unexplained += study::count_unexplained(each);
  }
  return text + fmt::format("\n{}, {}, {} of them not explained\n",
                            counted(results.experiments.size(), "experiment"),
                            counted(findings, "finding"), unexplained);
}

}  // namespace glassbox::study
