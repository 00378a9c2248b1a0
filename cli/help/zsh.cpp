#include <algorithm>

#include <fmt/format.h>

#include "cli/help/completion.h"

namespace glassbox {

namespace {

// Escapes a text that is inside the brackets of an _arguments specification, or a message after its
// colon.
std::string specified(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string function_of(const std::string& path) {
  std::string name = "_glassbox";
  if (!path.empty()) name += "_" + path;
  std::ranges::replace(name, ' ', '_');
  return name;
}

// The action that shows the name of a value but offers no words for it.
constexpr const char* kNoWords = " ";

// The action of _arguments for a value.
std::string action(const ValueKinds& kinds, const CommandFacts& program) {
  if (kinds.scenes) return "_glassbox_scenes";
  if (kinds.files) return "_files";
  if (kinds.directories) return "_files -/";
  if (kinds.commands) return "(" + joined(names_of(program.commands), " ") + ")";
  if (!kinds.choices.empty()) return "(" + joined(kinds.choices, " ") + ")";
  return kNoWords;
}

// The specification of an option: "'(-o --output)'{-o,--output}'[image file]:FILE:_files'"
std::string option_spec(const OptionFacts& option, const CommandFacts& program) {
  std::string rest = "[" + specified(option.help) + "]";
  if (!option.value.empty()) {
    rest += ":" + specified(option.value) + ":" + action(kinds_of(option), program);
  }
  if (option.names.size() == 1) return single_quoted(option.names[0] + rest);
  return single_quoted("(" + joined(option.names, " ") + ")") + "{" + joined(option.names, ",") +
         "}" + single_quoted(rest);
}

std::string positional_spec(const OptionFacts& option, const CommandFacts& program) {
  const char* start = option.repeats ? "*:" : option.required ? ":" : "::";
  const std::string offered = action(kinds_of(option), program);
  // Options are offered at the same position. A message alone would stop zsh from completing them,
  // so "()" is used.
  return single_quoted(start + specified(option.positional) + ":" +
                       (offered == kNoWords ? "()" : offered));
}

std::string specs(const CommandFacts& command, const CommandFacts& program) {
  std::string text;
  for (const OptionFacts& option : command.options) {
    text += " \\\n    " + (option.is_positional() ? positional_spec(option, program)
                                                  : option_spec(option, program));
  }
  return text;
}

std::string leaf(const CommandFacts& command, const std::string& path,
                 const CommandFacts& program) {
  return fmt::format("{}() {{\n  _arguments -S{}\n}}\n\n", function_of(path),
                     specs(command, program));
}

std::string branch(const CommandFacts& command, const std::string& path,
                   const CommandFacts& program) {
  std::string list;
  for (const CommandFacts& one : command.commands) {
    list += "        " + single_quoted(specified(one.name) + ":" + one.help) + "\n";
  }
  return fmt::format(
      "{0}() {{\n"
      "  local curcontext=$curcontext state line ret=1\n"
      "  local -a commands\n"
      "  _arguments -C{1} \\\n"
      "    '1:subcommand:->command' \\\n"
      "    '*::word:->words' && ret=0\n"
      "  case $state in\n"
      "    command)\n"
      "      commands=(\n{2}      )\n"
      "      _describe -t commands subcommand commands && ret=0\n"
      "      ;;\n"
      "    words)\n"
      "      (( $+functions[{0}_$line[1]] )) && {0}_$line[1] && ret=0\n"
      "      ;;\n"
      "  esac\n"
      "  return ret\n"
      "}}\n\n",
      function_of(path), specs(command, program), list);
}

}  // namespace

std::string zsh_completion(const CommandFacts& program) {
  std::string text =
      "#compdef glassbox\n"
      "# Completion of glassbox for zsh, written by `glassbox completion zsh`.\n\n"
      "_glassbox_scenes() {\n"
      "  _alternative 'scenes:built-in scene:(" +
      joined(scene_names(), " ") +
      ")' 'files:file:_files'\n"
      "}\n\n";
  for_each_command(program, "", [&](const CommandFacts& command, const std::string& path) {
    text +=
        command.commands.empty() ? leaf(command, path, program) : branch(command, path, program);
  });
  // The script works both when it is sourced and when the completion system loads it at first use.
  return text +
         "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n"
         "  _glassbox \"$@\"\n"
         "else\n"
         "  compdef _glassbox glassbox\n"
         "fi\n";
}

}  // namespace glassbox
