// Options that are numbers between two limits.
#pragma once

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace glassbox::app {

// A check as CLI::Range(least, most), which takes "nan": it is neither below nor above.
inline CLI::Validator number_between(double least, double most) {
  const std::string range = fmt::format("[{:g} - {:g}]", least, most);
  const auto refuse = [=](std::string& text) -> std::string {
    double value = 0;
    const bool legal = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
    return legal ? std::string() : "Value " + text + " not in range " + range;
  };
  return {refuse, "FLOAT in " + range, ""};
}

}  // namespace glassbox::app
