// Scripts that make a shell complete the program's command lines, made from the same tables as the
// help text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/options/command_tree.h"

#include <glassbox/mesh/builtin/scenes.h>

namespace glassbox {

// Each of these functions returns the script for one shell.
std::string bash_completion(const CommandFacts& program);
std::string zsh_completion(const CommandFacts& program);
std::string fish_completion(const CommandFacts& program);

// ---- used for all three shells ----

// Calls `visit` for every command with the words that lead to it: "" for the program itself, "study
// run" for a nested command.
inline void for_each_command(
    const CommandFacts& command, const std::string& path,
    const std::function<void(const CommandFacts&, const std::string&)>& visit) {
  visit(command, path);
  for (const CommandFacts& one : command.commands) {
    for_each_command(one, path + (path.empty() ? "" : " ") + one.name, visit);
  }
}

inline std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

inline std::vector<std::string> names_of(const std::vector<CommandFacts>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CommandFacts& command : commands) names.push_back(command.name);
  return names;
}

inline std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.emplace_back(scene.name);
  return names;
}

// Puts the text in single quotes, as POSIX shells and zsh read them.
inline std::string single_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace glassbox
