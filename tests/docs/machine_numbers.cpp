#include "tests/docs/machine_numbers.h"

#include <set>

#include "tests/docs/tokens.h"

namespace glassbox::test {

namespace {

bool is_of_the_c_library(const std::string& name) {
  static const std::set<std::string> kNames{
      "acos", "acosh", "asin",  "asinh", "atan", "atan2", "atanh", "cbrt",   "cos",
      "cosh", "erf",   "erfc",  "exp",   "exp2", "expm1", "hypot", "lgamma", "log",
      "log2", "log10", "log1p", "pow",   "sin",  "sinh",  "tan",   "tanh",   "tgamma"};
  return kNames.count(name) > 0;
}

bool is_eigens_rotation(const std::string& name) {
  return name.starts_with("AngleAxis") || name.starts_with("Rotation2D");
}

}  // namespace

std::vector<MachineNumber> machine_numbers(std::string_view source) {
  const Tokens tokens = tokens_of(source);
  std::vector<MachineNumber> found;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& text = tokens[i].text;
    const auto before = [&](std::size_t back) { return back > i ? "" : tokens[i - back].text; };
    const bool is_called = i + 1 < tokens.size() && tokens[i + 1].text == "(";
    const bool is_std = before(1) == "::" && before(2) == "std";
    if (is_std && is_called && is_of_the_c_library(text)) found.push_back({tokens[i].line, text});
    if (text == "double" && before(1) == "long") found.push_back({tokens[i].line, "long double"});
    if (is_eigens_rotation(text)) found.push_back({tokens[i].line, text});
  }
  return found;
}

}  // namespace glassbox::test
