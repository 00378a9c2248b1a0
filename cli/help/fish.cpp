#include <fmt/format.h>

#include "cli/help/completion.h"

namespace glassbox {

namespace {

constexpr const char* kFunction = R"(
# Whether the words typed so far lead to this subcommand.
function __glassbox_at
    set -l path ''
    for word in (commandline -opc)[2..-1]
        set -l next (string trim -- "$path $word")
        contains -- $next $__glassbox_commands; and set path $next
    end
    test "$path" = "$argv[1]"
end

complete -c glassbox -f
)";

std::string fish_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::vector<std::string> words_of(const ValueKinds& kinds, const CommandFacts& program) {
  std::vector<std::string> words = kinds.choices;
  const auto add = [&words](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (kinds.scenes) add(scene_names());
  if (kinds.commands) add(names_of(program.commands));
  return words;
}

// The arguments of fish's `complete` for a value: whether file names are completed, and other
// words.
std::string offer(const ValueKinds& kinds, const CommandFacts& program) {
  std::string text;
  if (kinds.files) text += " -F";
  const std::vector<std::string> words = words_of(kinds, program);
  if (kinds.directories) text += " -a '(__fish_complete_directories (commandline -ct))'";
  if (!words.empty()) text += " -a " + fish_quoted(joined(words, " "));
  return text;
}

std::string option_line(const OptionFacts& option, const CommandFacts& program) {
  std::string text;
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.value.empty()) {
    const ValueKinds kinds = kinds_of(option);
    text += (kinds.files ? " -r" : " -x") + offer(kinds, program);
  }
  return text + " -d " + fish_quoted(option.help);
}

}  // namespace

std::string fish_completion(const CommandFacts& program) {
  std::string commands, lines;
  for_each_command(program, "", [&](const CommandFacts& command, const std::string& path) {
    if (!path.empty()) commands += " " + fish_quoted(path);
    const std::string start =
        "complete -c glassbox -n " + fish_quoted("__glassbox_at " + fish_quoted(path));
    for (const CommandFacts& one : command.commands) {
      lines += start + " -a " + one.name + " -d " + fish_quoted(one.help) + "\n";
    }
    for (const OptionFacts& option : command.options) {
      if (!option.is_positional()) {
        lines += start + option_line(option, program) + "\n";
        continue;
      }
      const std::string words = offer(kinds_of(option), program);
      if (!words.empty()) lines += start + words + "\n";
    }
  });
  return "# Completion of glassbox for fish, written by `glassbox completion fish`.\n"
         "set -g __glassbox_commands" +
         commands + "\n" + kFunction + lines;
}

}  // namespace glassbox
