#include <glassbox/compare/report/text.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/compare/report/json.h>

namespace glassbox {
namespace {

constexpr std::size_t kLongestName = 400;

std::string line(const std::string& label, const std::string& text) {
  return fmt::format("  {}: {}\n", label, printable(text, 2000));
}

std::string value_text(const MetricValue& metric) {
  return metric.value ? fmt::format("{:.6g}", *metric.value) : "not defined: " + metric.why_not;
}

}  // namespace

std::string verdict_name(Verdict verdict) {
  if (verdict == Verdict::kUncompared) return "not compared";
  return verdict == Verdict::kWithinTolerance ? "within tolerance" : verdict_word(verdict);
}

std::string comparison_reason(const Comparison& comparison) {
  if (comparison.error) return comparison.error->message();
  return comparison.reasons.empty() ? "" : comparison.reasons.front();
}

std::string comparison_line(const Comparison& comparison) {
  std::string text =
      printable(comparison.name, kLongestName) + ": " + verdict_name(comparison.verdict);
  const std::string why = comparison_reason(comparison);
  if (!why.empty()) text += ": " + printable(why, 1000);
  return text;
}

std::string comparison_details(const Comparison& comparison) {
  std::string text;
  for (std::size_t i = 1; i < comparison.reasons.size(); ++i) {
    text += line("and", comparison.reasons[i]);
  }
  if (!comparison.tolerance.empty()) text += line("tolerance", comparison.tolerance);
  if (!comparison.tolerance_reason.empty()) text += line("because", comparison.tolerance_reason);
  for (const MetricValue& metric : comparison.metrics)
    text += line(metric.name, value_text(metric));
  for (const std::string& hint : comparison.hints) text += line("likely", hint);
  for (const std::string& note : comparison.notes) text += line("note", note);
  for (const std::string& suggestion : comparison.suggestions) text += "  " + suggestion + "\n";
  // The command is not shortened: a command that is cut off would be a different command.
  if (!comparison.inspect_command.empty()) {
    text += fmt::format("  inspect: {}\n", comparison.inspect_command);
  }
  return text;
}

std::string opaque_alpha_text(std::span<const Comparison> comparisons) {
  const auto has = [](const Comparison& one) { return one.opaque_alpha != OpaqueAlpha::kNone; };
  const auto count = std::count_if(comparisons.begin(), comparisons.end(), has);
  if (count == 0) return {};
  const Comparison& first = *std::find_if(comparisons.begin(), comparisons.end(), has);
  const bool is_test = first.opaque_alpha == OpaqueAlpha::kTest;
  const std::string who =
      comparisons.size() == 1
          ? fmt::format("the {}", is_test ? "test" : "reference")
          : fmt::format("in {}, one picture", counted(std::size_t(count), "pair"));
  return fmt::format(
      "{} has an alpha channel that is opaque everywhere, and the other picture has none: this is "
      "no difference (--alpha strict makes it one)",
      who);
}

std::string summary_line(std::span<const Comparison> comparisons) {
  constexpr std::array kVerdicts{Verdict::kSame,      Verdict::kWithinTolerance,
                                 Verdict::kDifferent, Verdict::kMissing,
                                 Verdict::kNew,       Verdict::kUncompared};
  std::string text = counted(comparisons.size(), "picture");
  const char* separator = ": ";
  for (const Verdict verdict : kVerdicts) {
    const auto count =
        std::count_if(comparisons.begin(), comparisons.end(),
                      [verdict](const Comparison& one) { return one.verdict == verdict; });
    if (count == 0) continue;
    text += fmt::format("{}{} {}", separator, count, verdict_name(verdict));
    separator = ", ";
  }
  return text;
}

}  // namespace glassbox
