#include "study/recommend/budget.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <glassbox/base/printable.h>

namespace glassbox::study {

namespace {

constexpr const char* kExample = "write it like 'position<0.05px, depth<1e-4, colour<1/255'";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Reads a number such as "0.05" or a fraction such as "1/255".
std::optional<double> share_of(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return number_of(text);
  const auto above = number_of(trimmed(text.substr(0, slash)));
  const auto below = number_of(trimmed(text.substr(slash + 1)));
  if (!above || !below) return std::nullopt;
  return *above / *below;
}

std::optional<Quantity> quantity_of(std::string_view name) {
  if (name == "color") return Quantity::kColour;
  for (const Quantity each : {Quantity::kPosition, Quantity::kDepth, Quantity::kColour}) {
    if (name == name_of(each)) return each;
  }
  return std::nullopt;
}

tl::unexpected<Error> refused(std::string_view part, const std::string& why) {
  return fail("--error-budget", "'" + printable(part, 100) + "' " + why, kExample);
}

Result<Budget> parse_budget(std::string_view part) {
  const auto sign = part.find('<');
  if (sign == std::string_view::npos) return refused(part, "has no <");
  const auto quantity = quantity_of(trimmed(part.substr(0, sign)));
  if (!quantity) return refused(part, "limits neither position nor depth nor colour");
  std::string_view value = trimmed(part.substr(sign + 1));
  const std::string_view unit = unit_of(*quantity);
  if (!unit.empty() && value.ends_with(unit))
    value = trimmed(value.substr(0, value.size() - unit.size()));
  const auto limit = share_of(value);
  if (!limit) {
    return refused(part, unit.empty() ? "has a limit that is not a number"
                                      : "has a limit that is not a number of " + std::string(unit));
  }
  if (!(*limit > 0 && std::isfinite(*limit)))
    return refused(part, "has a limit that is not above 0");
  return Budget{*quantity, *limit};
}

}  // namespace

std::string_view name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kPosition:
      return "position";
    case Quantity::kDepth:
      return "depth";
    case Quantity::kColour:
      break;
  }
  return "colour";
}

std::string_view unit_of(Quantity quantity) {
  return quantity == Quantity::kPosition ? "px" : "";
}

Result<std::vector<Budget>> parse_budgets(const std::string& text) {
  std::vector<Budget> budgets;
  std::string_view rest = text;
  while (true) {
    const auto comma = rest.find(',');
    const auto budget = parse_budget(trimmed(rest.substr(0, comma)));
    if (!budget) return tl::unexpected(budget.error());
    if (std::ranges::count(budgets, budget->quantity, &Budget::quantity) != 0)
      return refused(text, "has two limits for " + std::string(name_of(budget->quantity)));
    budgets.push_back(*budget);
    if (comma == std::string_view::npos) return budgets;
    rest = rest.substr(comma + 1);
  }
}

}  // namespace glassbox::study
