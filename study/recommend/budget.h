// How much error is acceptable, of what.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::study {

enum class Quantity { kPosition, kDepth, kColour };

std::string_view name_of(Quantity quantity);  // "position"
std::string_view unit_of(Quantity quantity);  // "px", empty for shares

struct Budget {
  Quantity quantity = Quantity::kPosition;
  double limit = 0;  // errors are to be below it
};

// "position<0.05px, depth<1e-4, colour<1/255": each quantity once at most, limits above 0, fractions welcome.
Result<std::vector<Budget>> parse_budgets(const std::string& text);

}  // namespace glassbox::study
