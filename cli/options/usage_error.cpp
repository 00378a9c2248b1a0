#include "cli/options/usage_error.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/command_tree.h"

#include <glassbox/base/closest_word.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/builtin/scenes.h>

namespace glassbox {

namespace {

bool is_option(std::string_view word) {
  return word.size() > 1 && word[0] == '-';
}

// The innermost subcommand on the command line, and its full name as typed.
struct ReachedCommand {
  const CLI::App* app;
  std::string name;
};

ReachedCommand reached_command(const CLI::App& program) {
  ReachedCommand reached{&program, program.get_name()};
  while (true) {
    const std::vector<CLI::App*> chosen = reached.app->get_subcommands();
    // If a command finds a word that it does not know, the words after it do not belong to its
    // subcommand.
    if (chosen.empty() || !reached.app->remaining().empty()) return reached;
    reached = {chosen.front(), reached.name + " " + chosen.front()->get_name()};
  }
}

// The word that caused the error: the first unknown word if a subcommand is expected, else the
// first unknown option (its value is then unknown too).
std::optional<std::string> unknown_word(const CLI::App& app, const CommandFacts& command) {
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) return std::nullopt;
  const auto option = std::ranges::find_if(words, is_option);
  const bool first = option == words.end() || !command.commands.empty();
  return first ? words.front() : *option;
}

std::string without_dashes(std::string_view word) {
  const std::size_t start = word.find_first_not_of('-');
  return start == std::string_view::npos ? "" : std::string(word.substr(start));
}

bool has_option(const CommandFacts& command, const std::string& name) {
  return std::ranges::any_of(command.options, [&](const OptionFacts& option) {
    return std::ranges::find(option.names, name) != option.names.end();
  });
}

// The subcommand that has the option, if the option was given before the subcommand.
std::optional<std::string> command_with(const CommandFacts& program, const std::string& name) {
  const auto found = std::ranges::find_if(
      program.commands, [&](const CommandFacts& one) { return has_option(one, name); });
  return found == program.commands.end() ? std::nullopt : std::optional(found->name);
}

std::string unknown_option(const CommandFacts& command, const std::string& typed) {
  std::vector<std::string> names;
  for (const OptionFacts& option : command.options) {
    for (const std::string& name : option.names) {
      if (name.starts_with("--")) names.push_back(without_dashes(name));
    }
  }
  const std::string word = typed.substr(0, typed.find('='));
  const std::string what = "there is no option " + in_quotes(word);
  if (const auto near = closest_word(without_dashes(word), names)) {
    return what + ", did you mean --" + *near + "?";
  }
  const auto other = command_with(command, word);
  return other ? what + " here, did you mean " + command.name + " " + *other + " " + word + "?"
               : what;
}

bool is_scene(const std::string& word) {
  std::error_code ignored;
  return find_builtin(word) != nullptr || std::filesystem::is_regular_file(word, ignored);
}

std::string list_of(const std::vector<CommandFacts>& commands) {
  std::string list = "the subcommands are ";
  for (const CommandFacts& one : commands) {
    const bool first = &one == &commands.front(), last = &one == &commands.back();
    list += (first ? "" : last ? " and " : ", ") + one.name;
  }
  return list;
}

std::string unknown_command(const CommandFacts& command, const ReachedCommand& reached,
                            const std::string& typed) {
  std::vector<std::string> names;
  for (const CommandFacts& one : command.commands) names.push_back(one.name);
  const std::string what = "there is no subcommand " + in_quotes(typed);
  if (const auto near = closest_word(typed, names)) return what + ", did you mean " + *near + "?";
  if (reached.app->get_parent() == nullptr && is_scene(typed)) {
    return what + ", did you mean " + reached.name + " render " + printable(typed) + "?";
  }
  return what + "; " + list_of(command.commands);
}

std::string problem_with(const CommandFacts& command, const ReachedCommand& reached,
                         const std::string& word) {
  if (is_option(word)) return unknown_option(command, word);
  if (!command.commands.empty()) return unknown_command(command, reached, word);
  return "the argument " + in_quotes(word) + " is not expected";
}

// CLI11's error, in plain words where CLI11's own words are hard to understand.
std::string in_plain_words(const CommandFacts& command, const CLI::ParseError& error) {
  const std::string what = printable(error.what(), 2000);  // contains the word that is wrong
  if (what == "A subcommand is required") {
    return "a subcommand is missing; " + list_of(command.commands);
  }
  const std::string one = ": 1 required ", missing = " missing";
  const std::size_t at = what.find(one);
  if (at != std::string::npos && what.ends_with(missing)) {
    const std::size_t start = at + one.size();
    const std::string value = what.substr(start, what.size() - missing.size() - start);
    return what.substr(0, at) + ": its value, " + value + ", is missing";
  }
  const std::string unread = "Could not convert: ", is = " = ";
  if (const std::size_t equals = what.find(is); what.starts_with(unread) && equals != what.npos) {
    const std::string name = what.substr(unread.size(), equals - unread.size());
    const bool is_whole = std::ranges::any_of(command.options, [&](const OptionFacts& option) {
      return takes_whole_number(option) && std::ranges::count(option.names, name) > 0;
    });
    return name + (is_whole ? ": needs a whole number, not " : ": cannot use the value ") +
           in_quotes(what.substr(equals + is.size()));
  }
  const std::size_t twice = what.find(": At Most 1 required but received ");
  return twice == std::string::npos ? what : what.substr(0, twice) + ": is given more than once";
}

}  // namespace

std::string usage_error_message(const CLI::App& program, const CLI::ParseError& error) {
  const ReachedCommand reached = reached_command(program);
  // If a required word is missing, the reason may be an unknown word.
  const bool of_words = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                        dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const CommandFacts command = command_tree(*reached.app);
  const auto word = of_words ? unknown_word(*reached.app, command) : std::nullopt;
  const std::string what =
      word ? problem_with(command, reached, *word) : in_plain_words(command, error);
  return fmt::format("{}{} {} --help shows what there is", what, what.ends_with('?') ? "" : ";",
                     reached.name);
}

}  // namespace glassbox
