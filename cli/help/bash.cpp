#include <fmt/format.h>

#include "cli/help/completion.h"

namespace glassbox {

namespace {

constexpr const char* kHead =
    R"(# Completion of glassbox for bash, written by `glassbox completion bash`.
_glassbox() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev='' path='' words='' files='' i
  ((COMP_CWORD > 0)) && prev=${COMP_WORDS[COMP_CWORD-1]}
  # --size=640x480 comes as three words.
  if [[ $cur == = ]]; then
    cur=''
  elif [[ $prev == = && COMP_CWORD -gt 1 ]]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$path${path:+ }${COMP_WORDS[i]}" in
)";

constexpr const char* kTail = R"(  if [[ $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
  else
    COMPREPLY=()
  fi
  if [[ $files ]]; then
    local found
    mapfile -t found < <(compgen "$files" -- "$cur")
    COMPREPLY+=("${found[@]}")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _glassbox glassbox
)";

// The values that can be completed, as shell assignments: "words='a b' files=-f".
std::string offer(const ValueKinds& kinds, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = more;
  words.insert(words.end(), kinds.choices.begin(), kinds.choices.end());
  if (kinds.scenes) {
    const auto scenes = scene_names();
    words.insert(words.end(), scenes.begin(), scenes.end());
  }
  const char* files = kinds.files ? "-f" : kinds.directories ? "-d" : "''";
  return fmt::format("words={} files={}", single_quoted(joined(words, " ")), files);
}

// One line of the script's case statement per option: "      'render --size' | 'render -s')
// words='' files='' ;;"
std::string value_cases(const CommandFacts& command, const std::string& path) {
  std::string text;
  for (const OptionFacts& option : command.options) {
    if (option.is_positional() || option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      patterns.push_back(single_quoted(path + " " + name));
    }
    text += fmt::format("    {}) {} ;;\n", joined(patterns, " | "), offer(kinds_of(option)));
  }
  return text;
}

std::vector<std::string> option_names(const CommandFacts& command) {
  std::vector<std::string> names;
  for (const OptionFacts& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// The kinds of values of all positional arguments together: the words that any of them accepts are
// offered at every position.
ValueKinds positional_kinds(const CommandFacts& command, const CommandFacts& program) {
  ValueKinds all;
  for (const OptionFacts& option : command.options) {
    if (!option.is_positional()) continue;
    const ValueKinds kinds = kinds_of(option);
    all.scenes |= kinds.scenes;
    all.files |= kinds.files;
    all.directories |= kinds.directories;
    all.choices.insert(all.choices.end(), kinds.choices.begin(), kinds.choices.end());
    const auto names = names_of(program.commands);
    if (kinds.commands) all.choices.insert(all.choices.end(), names.begin(), names.end());
  }
  return all;
}

}  // namespace

std::string bash_completion(const CommandFacts& program) {
  std::string paths, values, rest;
  for_each_command(program, "", [&](const CommandFacts& command, const std::string& path) {
    if (!path.empty()) {
      paths += fmt::format("      {}) path={} ;;\n", single_quoted(path), single_quoted(path));
    }
    values += value_cases(command, path);
    rest += fmt::format("      {}) {} ;;\n", single_quoted(path + " -"),
                        offer({}, option_names(command)));
    rest += fmt::format("      {}) {} ;;\n", single_quoted(path + " "),
                        offer(positional_kinds(command, program), names_of(command.commands)));
  });
  return kHead + paths + "    esac\n  done\n  case \"$path $prev\" in\n" + values +
         "    *)\n      local kind=''\n      [[ $cur == -* ]] && kind=-\n"
         "      case \"$path $kind\" in\n" +
         rest + "      esac\n      ;;\n  esac\n" + kTail;
}

}  // namespace glassbox
