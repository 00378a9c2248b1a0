// The error that a user accepts, for each quantity.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::study {

enum class Quantity { kPosition, kDepth, kColour };

std::string_view name_of(Quantity quantity);  // for example "position"
std::string_view unit_of(Quantity quantity);  // for example "px"; empty for fractions

struct Budget {
  Quantity quantity = Quantity::kPosition;
  double limit = 0;  // errors must be smaller than this
};

// Reads for example "position<0.05px, depth<1e-4, colour<1/255". Each quantity may appear once;
// limits must be greater than 0 and may be fractions.
Result<std::vector<Budget>> parse_budgets(const std::string& text);

}  // namespace glassbox::study
