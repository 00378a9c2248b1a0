// Options whose value is one of several names.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace glassbox {

// The names that an option accepts (upper or lower case), with their values.
template <class Enum>
using Choices = std::vector<std::pair<std::string, Enum>>;

// The choices for values that have a name_of.
template <class Enum>
Choices<Enum> choices_of(std::initializer_list<Enum> values) {
  Choices<Enum> choices;
  for (const Enum value : values) choices.emplace_back(name_of(value), value);
  return choices;
}

template <class Value, class Enum = Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& value,
                        const Choices<Enum>& choices, const std::string& help) {
  std::string names;
  for (const auto& [choice, unused] : choices) names += (names.empty() ? "" : "|") + choice;
  return app
      .add_option_function<std::string>(
          name,
          [&value, name, choices, names](const std::string& text) {
            for (const auto& [choice, meaning] : choices) {
              if (CLI::detail::to_lower(text) != choice) continue;
              value = meaning;
              return;
            }
            throw CLI::ValidationError(name, "needs one of " + names + ", not '" + text + "'");
          },
          help)
      ->type_name(names);
}

// Options whose value is a number between two limits.

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
