// Options whose value is one of some names.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace glassbox::app {

// An option that takes one of the names of `choices`, in either case.
template <class Enum>
using Choices = std::vector<std::pair<std::string, Enum>>;

template <class Enum>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Enum& value,
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

}  // namespace glassbox::app
