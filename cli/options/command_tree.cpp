#include "cli/options/command_tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"

#include <glassbox/base/printable.h>

namespace glassbox {

namespace {

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  for (const std::string& name : option.get_snames()) facts.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
  if (facts.names.empty()) {
    facts.positional = option.get_name();
    facts.repeats = option.get_expected_max() > 1;
  } else if (option.get_expected_max() > 0) {
    const std::string type = option.get_type_name();
    // without the description of validators that CLI11 appends
    facts.value = type.substr(0, type.find(':'));
  }
  facts.help = option.get_description();
  facts.group = option.get_group();
  facts.required = option.get_required();
  return facts;
}

// Whether the word is typed literally, unlike the placeholders "FILE" and "WxH".
bool is_literal(const std::string& word) {
  const auto is_one_of_them = [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-' || c == '_';
  };
  return !word.empty() && word != "-" && std::ranges::all_of(word, is_one_of_them);
}

// Removes leading zeros: 012 becomes 12. Returns an error text if the number has another base, else
// "".
std::string without_leading_zeros(std::string& word) {
  const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
  const std::size_t digits = word.find_first_not_of('0', sign);
  if (digits == sign) return "";
  if (digits == word.npos) {
    if (word.size() > sign) word.erase(sign + 1);
    return "";
  }
  const auto next = static_cast<unsigned char>(word[digits]);
  if (std::isdigit(next) != 0) word.erase(sign, digits - sign);
  const bool is_other_base = std::isalpha(next) != 0 && std::tolower(next) != 'e';
  return is_other_base ? "needs a whole number, not " + in_quotes(word) : "";
}

}  // namespace

CommandFacts command_tree(const CLI::App& app) {
  CommandFacts facts{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) facts.options.push_back(facts_of(*option));
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) facts.commands.push_back(command_tree(*command));
  }
  return facts;
}

ValueKinds kinds_of(const OptionFacts& option) {
  ValueKinds kinds;
  const std::string& word = option.is_positional() ? option.positional : option.value;
  for (const std::string& part : split(word, '|')) {
    if (part == "SCENE") {
      kinds.scenes = kinds.files = true;
    } else if (part == "COMMAND") {
      kinds.commands = true;
    } else if (part == "SHELL") {
      kinds.choices = {"bash", "zsh", "fish"};
    } else if (part.starts_with("FILE")) {
      kinds.files = true;
    } else if (part.starts_with("DIR") || part.starts_with("FOLDER")) {
      kinds.directories = true;
    } else if (is_literal(part)) {
      kinds.choices.push_back(part);
    } else if (option.is_positional() && part != "LAB" && part != "ID" && part != "CASE") {
      kinds.files = true;  // such as the arguments REFERENCE and TEST of diff
    }
  }
  return kinds;
}

void refuse_empty_names(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const ValueKinds kinds = kinds_of(facts_of(*option));
    if (option->get_positional() || !(kinds.files || kinds.directories)) continue;
    option->check([](const std::string& word) { return word.empty() ? "the name is empty" : ""; });
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    refuse_empty_names(*command);
  }
}

bool takes_whole_number(const OptionFacts& option) {
  constexpr std::array<std::string_view, 5> kTypes{"N", "K", "LEVEL", "INT", "UINT"};
  return std::ranges::find(kTypes, option.value) != kTypes.end();
}

void read_as_decimal(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (takes_whole_number(facts_of(*option)))
      option->transform(CLI::Validator(without_leading_zeros, ""));
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    read_as_decimal(*command);
}

}  // namespace glassbox
