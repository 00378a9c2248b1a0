#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/table.h"
#include "cli/report/text_layout.h"
#include "study/commands/bench/report.h"
#include "study/commands/recommendation.h"
#include "study/experiment/results_json.h"

namespace glassbox::study {

namespace {

std::string table_of(const BudgetResult& judged) {
  const Comparison& comparison = judged.comparison;
  double fastest = std::numeric_limits<double>::infinity();
  for (const Candidate& each : comparison.candidates) {
    if (each.ns) fastest = std::min(fastest, each.ns->median);
  }
  const TimeUnit unit = glassbox::time_unit(fastest);
  std::vector<Row> rows{
      {"", "error", comparison.item.empty() ? "" : fmt::format("{}/{}", unit.name, comparison.item),
       comparison.item.empty() ? "" : "quartiles", ""}};
  for (std::size_t i = 0; i < comparison.candidates.size(); ++i) {
    const Candidate& each = comparison.candidates[i];
    const auto time = [&](double ns) { return three_digits(ns / unit.ns); };
    rows.push_back({each.name, fmt::format("{:.3g}", each.error),
                    each.ns ? time(each.ns->median) : "",
                    each.ns ? time(each.ns->lower) + " .. " + time(each.ns->upper) : "",
                    judged.chosen == i                 ? "recommended"
                    : each.error < judged.budget.limit ? "fits"
                                                       : "fails"});
  }
  return table(rows, 1);
}

// The recommendation in one sentence.
std::string verdict(const BudgetResult& judged) {
  const auto& candidates = judged.comparison.candidates;
  if (!judged.chosen) {
    const auto best = std::ranges::min_element(candidates, {}, &Candidate::error);
    return fmt::format(
        "No candidate is accurate enough: the most accurate one, {}, has an error of {:.3g}.",
        best->name, best->error);
  }
  const Candidate& chosen = candidates[*judged.chosen];
  if (!chosen.in_render)
    return chosen.name + " is accurate enough, but glassbox render has no option for it.";
  if (chosen.options.empty())
    return chosen.name + " is accurate enough; glassbox render does this without options.";
  return chosen.name + " is accurate enough.";
}

std::string combined_text(const CombinedOptions& combined) {
  const TimeUnit unit = glassbox::time_unit(combined.ns.median);
  const auto time = [&](double ns) { return three_digits(ns / unit.ns); };
  std::string text = fmt::format(
      "measured with these options: {} {} a frame with one thread ({} .. {})",
      time(combined.ns.median), unit.name, time(combined.ns.lower), time(combined.ns.upper));
  if (combined.color_error) text += fmt::format(", error of colour {:.3g}", *combined.color_error);
  return text;
}

}  // namespace

std::string recommendation_text(const Recommendation& recommendation) {
  std::string text = wrapped(
      "", fmt::format("{}, {} x {}; {}; {}; times are those of one thread", recommendation.scene,
                      recommendation.size.width, recommendation.size.height, recommendation.machine,
                      recommendation.compiler));
  for (const BudgetResult& each : recommendation.budget_results) {
    const std::string limit =
        fmt::format("{} below {:.4g}{}", name_of(each.budget.quantity), each.budget.limit,
                    unit_of(each.budget.quantity).empty() ? "" : " px");
    text += "\n" + wrapped("", fmt::format("{}: {}, compared with {}", limit, each.comparison.error,
                                           each.comparison.reference));
    text += table_of(each) + wrapped("  ", verdict(each));
  }
  text +=
      recommendation.meets_all() ? "\n" : "\nNot every budget can be met. This comes nearest:\n";
  return text + "  " + recommendation.command + "\n" +
         wrapped("  ", combined_text(recommendation.combined));
}

nlohmann::ordered_json recommendation_json(const Recommendation& recommendation) {
  using Json = nlohmann::ordered_json;
  Json json{{"scene", recommendation.scene},        {"width", recommendation.size.width},
            {"height", recommendation.size.height}, {"machine", recommendation.machine},
            {"compiler", recommendation.compiler},  {"meets_all", recommendation.meets_all()},
            {"command", recommendation.command},    {"budgets", Json::array()}};
  const CombinedOptions& combined = recommendation.combined;
  json["together"] = {{"options", combined.options},
                      {"ns", combined.ns.median},
                      {"ns_quartiles", {combined.ns.lower, combined.ns.upper}},
                      {"colour_error", nullptr}};
  if (combined.color_error) json["together"]["colour_error"] = *combined.color_error;
  for (const BudgetResult& each : recommendation.budget_results) {
    Json budget{{"quantity", name_of(each.budget.quantity)},
                {"limit", each.budget.limit},
                {"unit", unit_of(each.budget.quantity)},
                {"error", each.comparison.error},
                {"reference", each.comparison.reference},
                {"item", each.comparison.item},
                {"recommended", nullptr},
                {"candidates", Json::array()}};
    if (each.chosen) budget["recommended"] = each.comparison.candidates[*each.chosen].name;
    for (const Candidate& candidate : each.comparison.candidates) {
      Json entry{{"name", candidate.name},
                 {"options", candidate.options},
                 {"in_render", candidate.in_render},
                 {"error", study::number_json(candidate.error)},
                 {"fits", candidate.error < each.budget.limit},
                 {"ns", nullptr},
                 {"ns_quartiles", nullptr}};
      if (candidate.ns) {
        entry["ns"] = candidate.ns->median;
        entry["ns_quartiles"] = {candidate.ns->lower, candidate.ns->upper};
      }
      budget["candidates"].push_back(std::move(entry));
    }
    json["budgets"].push_back(std::move(budget));
  }
  return json;
}

}  // namespace glassbox::study
