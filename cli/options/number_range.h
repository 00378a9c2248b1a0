// Options whose value is a number between two limits.
#pragma once

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace glassbox {

// Like CLI::Range(least, most), but refuses "nan", which CLI::Range accepts because it is neither
// below nor above.
inline CLI::Validator number_between(double least, double most) {
  const std::string range = fmt::format("[{:g} - {:g}]", least, most);
  const auto refuse = [=](std::string& text) -> std::string {
    double value = 0;
    const bool legal = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
    return legal ? std::string() : "Value " + text + " not in range " + range;
  };
  return {refuse, "FLOAT in " + range, ""};
}

}  // namespace glassbox
