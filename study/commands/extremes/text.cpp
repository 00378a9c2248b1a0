#include <algorithm>
#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "cli/report/text_layout.h"
#include "study/commands/extremes/report.h"

#include <glassbox/base/counted.h>

namespace glassbox::study {

namespace {

std::string number_text(double value) {
  if (std::isinf(value)) return "inf";
  return value == 0 ? "0" : fmt::format("{:.3g}", value);
}

std::string ratio(const Outcome& outcome) {
  return outcome.bound > 0 ? number_text(outcome.error / outcome.bound) : "";
}

std::string shortened(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most - 2) + "..";
}

const char* verdict(const CaseResult& result) {
  if (!result.ours_passes()) return "FAILS";
  if (!result.naive_fails()) return "NAIVE PASSES";
  if (result.mutants_caught() != int(result.mutants.size())) return "MUTANT LIVES";
  return result.holds() ? "pass" : "DRAWN WRONG";
}

// Whether the case is drawn right. The text is the same on every machine, even if processors
// support different targets.
std::string drawn(const CaseResult& r) {
  if (r.drawn.empty()) return "-";
  if (r.drawn_right() == int(r.drawn.size())) return "right";
  return fmt::format("{} of {}", r.drawn_right(), r.drawn.size());
}

std::string row(const CaseResult& r) {
  return fmt::format(
      "{:<5} {:<36} {:>9} {:>9} {:>9} {:>6} {:>9}  {:<8} {:<7} {:<12} {}\n", r.extreme_case.id,
      shortened(r.extreme_case.name, 36), number_text(r.naive.error), number_text(r.ours.error),
      number_text(r.ours.bound), ratio(r.ours),
      r.ours.condition ? number_text(*r.ours.condition) : "",
      r.mutants.empty() ? "-" : fmt::format("{} of {}", r.mutants_caught(), r.mutants.size()),
      drawn(r), verdict(r), r.extreme_case.unit);
}

std::string outcome_text(const char* kind, const std::string& name, const Outcome& outcome,
                         const std::string& unit) {
  std::string text =
      fmt::format("{:<8}{}\n        {} {} {} {}, {}\n", kind, name, number_text(outcome.error),
                  outcome.passes() ? "<=" : ">", number_text(outcome.bound), unit,
                  outcome.passes() ? "within the bound" : "above the bound");
  if (!outcome.summary.empty()) text += wrapped("        ", outcome.summary);
  return text;
}

// Whether a bound in the text is a multiple of the unit roundoff, as in "to 8 u" or "8 u of float".
bool names_unit_roundoff(const std::string& text) {
  static const std::regex kMultiple("[0-9)] u\\b");
  return std::regex_search(text, kMultiple);
}

std::string sweep_text(const SweepResult& result) {
  std::string text = fmt::format("\n{}: {}\n", result.sweep.name, result.sweep.title);
  text += wrapped("  ", result.sweep.question);
  text += wrapped("  bound  ", result.sweep.bound);
  text += wrapped("  fails at  ", result.sweep.tolerance);
  for (const SweepSeries& series : result.series) {
    const bool within = study::within_bounds(series);
    text +=
        fmt::format("\n  {}{}: {}{}\n", series.name, series.ours ? " (ours)" : "",
                    series.failure_parameter ? "fails at " + number_text(*series.failure_parameter)
                                             : "never fails",
                    within ? "" : "; ABOVE ITS BOUND");
    text += fmt::format("    {:>12} {:>12} {:>12}\n", "at", "error", "bound");
    for (const study::SweepPoint& point : series.points) {
      text += fmt::format("    {:>12.6g} {:>12} {:>12}\n", point.parameter,
                          number_text(point.error), point.bound ? number_text(*point.bound) : "-");
    }
  }
  return text;
}

}  // namespace

bool SweepResult::holds() const {
  return std::ranges::all_of(series, study::within_bounds);
}

bool ExtremesReport::holds() const {
  return std::ranges::all_of(cases, &CaseResult::holds) &&
         std::ranges::all_of(sweeps, &SweepResult::holds);
}

const char* oracle_name(study::Oracle oracle) {
  switch (oracle) {
    case study::Oracle::kRational:
      return "exact rationals";
    case study::Oracle::kInteger:
      return "exact integers";
    case study::Oracle::kExtended:
      return "extended precision";
    case study::Oracle::kAnalytic:
      return "a formula";
    case study::Oracle::kProperty:
      return "a property";
  }
  return "";
}

std::string extremes_text(const ExtremesReport& report) {
  std::string text;
  if (!report.cases.empty()) {
    text += fmt::format("{:<5} {:<36} {:>9} {:>9} {:>9} {:>6} {:>9}  {:<8} {:<7} {:<12} {}\n",
                        "case", "", "naive", "ours", "bound", "ratio", "condition", "mutants",
                        "drawn", "", "unit");
    for (const CaseResult& each : report.cases) text += row(each);
    const auto hold = std::ranges::count_if(report.cases, &CaseResult::holds);
    int mutants = 0, caught = 0, in_pictures = 0;
    for (const CaseResult& each : report.cases) {
      mutants += int(each.mutants.size());
      caught += each.mutants_caught();
      in_pictures += !each.drawn.empty();
    }
    text += fmt::format(
        "\n"
        "{} of {} {}: our code is within the bound, and naive code is above it.\n"
        "{} of {} {} caught. {} also drawn, by both engines and for every target.\n"
        "glassbox study extremes --case ID shows one case in full.\n",
        hold, counted(report.cases.size(), "case"), singular_or_plural(hold, "holds", "hold"),
        caught, counted(mutants, "mutant"), singular_or_plural(caught, "is", "are"),
        counted(in_pictures, "case is", "cases are"));
  }
  for (const SweepResult& each : report.sweeps) text += sweep_text(each);
  return text;
}

std::string case_text(const CaseResult& r) {
  std::string text = fmt::format("{} {}\n\n", r.extreme_case.id, r.extreme_case.name);
  text += wrapped("built   ", r.extreme_case.construction);
  text += wrapped("stage   ", r.extreme_case.stage);
  text += wrapped("right   ", r.extreme_case.right_answer);
  if (names_unit_roundoff(r.extreme_case.right_answer))
    text += "        u is the unit roundoff: 2^-24 in float, 2^-53 in double\n";
  text += wrapped("oracle  ", oracle_name(r.extreme_case.oracle));
  if (r.ours.condition)
    text += fmt::format("        condition number {}\n", number_text(*r.ours.condition));
  text += "\n" + outcome_text("ours", r.extreme_case.ours.name, r.ours, r.extreme_case.unit);
  text += outcome_text("naive", r.extreme_case.naive.name, r.naive, r.extreme_case.unit);
  for (std::size_t i = 0; i < r.mutants.size(); ++i) {
    text +=
        outcome_text("mutant", r.extreme_case.mutants[i].name, r.mutants[i], r.extreme_case.unit);
  }
  for (std::size_t i = 0; i < r.drawn.size(); ++i) {
    text +=
        wrapped("drawn   ", fmt::format("{}: {}{}", study::tested_engines()[i].name,
                                        r.drawn[i].passes() ? "" : "WRONG: ", r.drawn[i].summary));
  }
  if (!r.extreme_case.not_drawn.empty()) text += wrapped("no picture  ", r.extreme_case.not_drawn);
  return text + fmt::format("\n{}\n", verdict(r));
}

}  // namespace glassbox::study
