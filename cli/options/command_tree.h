// The program's subcommands and options as data, from which help, completion and the manual are
// made.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace glassbox {

struct OptionFacts {
  std::vector<std::string> names;  // "-o", "--output"; empty for a positional argument
  std::string positional;          // "SCENE"
  std::string value;               // "WxH", "back|front|none"; empty for a flag and a positional
  std::string help;
  std::string group;
  bool required = false;
  bool repeats = false;  // a positional argument that takes any number of words

  bool is_positional() const { return names.empty(); }
};

struct CommandFacts {
  std::string name;
  std::string help;
  std::string footer;
  std::vector<OptionFacts> options;  // in the order of the help text
  std::vector<CommandFacts> commands;
};

// The tree of commands and options, without the commands and options that the help text hides.
CommandFacts command_tree(const CLI::App& app);

// ---- what a value can be ----

struct ValueKinds {
  std::vector<std::string> choices;  // "back", "front", "none"; "auto" of "S|auto"
  bool scenes = false;               // names of the built-in scenes
  bool files = false;
  bool directories = false;  // only directories
  bool commands = false;     // names of subcommands
};

ValueKinds kinds_of(const OptionFacts& option);

// Makes an empty word a usage error wherever an option takes the name of a file or directory.
void refuse_empty_names(CLI::App& app);

// Whether the option's type is a whole number.
bool takes_whole_number(const OptionFacts& option);

// Makes all whole-number options decimal: CLI11 would read 012 as octal and 0x10 as hexadecimal.
void read_as_decimal(CLI::App& app);

}  // namespace glassbox
