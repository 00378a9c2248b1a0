#include "labs/commands/measure_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/report/table.h"
#include "cli/report/text_layout.h"
#include "study/commands/bench/text.h"
#include "study/commands/text.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"

#include <glassbox/base/counted.h>

namespace glassbox::labs {

namespace {

using study::ConfigurationResult;
using study::ExperimentResult;
using study::Timing;

bool is_theirs(const ConfigurationResult& each, const std::vector<std::string>& series) {
  return std::find(series.begin(), series.end(), each.series) != series.end();
}

// The fastest configuration that is at least as exact as `mine` and clearly faster (its upper
// quartile is below `mine`'s lower one); null if there is none.
const ConfigurationResult* better_than(const ConfigurationResult& mine, const Timing& time,
                                       const ExperimentResult& result) {
  const ConfigurationResult* best = nullptr;
  for (const ConfigurationResult& each : result.configurations) {
    const Timing* const theirs = study::timing_of(each, 1);
    if (&each == &mine || theirs == nullptr || !study::compete(result, mine, each)) continue;
    const bool as_exact = each.error <= mine.error || mine.error != mine.error;
    if (!as_exact || theirs->ns.upper >= time.ns.lower) continue;
    if (best == nullptr || theirs->ns.median < study::timing_of(*best, 1)->ns.median) best = &each;
  }
  return best;
}

// The standing in the chart: "front", or "behind X" if the series X is as exact and clearly faster;
// empty if it is not timed.
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

std::string unwritten_text(const labs::Lab& lab, const labs::LabMeasure& measured) {
  return fmt::format("Lab {} in {}\n", lab.number, measured.experiment) +
         wrapped("  Not written yet: ",
                 measured.functions + "; the answers are the starter's. Nothing was measured.");
}

std::string measure_text(const labs::Lab& lab, const labs::LabMeasure& measured,
                         const ExperimentResult& result, const std::vector<std::string>& series,
                         const std::vector<std::string>& untouched) {
  std::string text =
      fmt::format("Lab {} in {}, {}\n", lab.number, result.id, result.name) +
      wrapped("  Measured: ", measured.functions + "; the processor's time of one thread");
  for (const ExperimentResult& part : study::by_measure(result)) {
    const std::string rows = table_of(part, series);
    if (rows.empty()) continue;
    text += "\n" + wrapped("  Axis: ", study::with_unit(part.axis, part.axis_unit)) +
            wrapped("  Error: ", study::with_unit(part.error, part.error_unit)) + "\n" + rows;
  }
  if (!untouched.empty())
    text += "\n" + wrapped("  Not written yet, and not measured: ",
                           fmt::format("{}", fmt::join(untouched, "; ")));
  return text + "\nfront: nothing in the chart is as exact there and faster.\n";
}

}  // namespace glassbox::labs
