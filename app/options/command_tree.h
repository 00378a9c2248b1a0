// The program's subcommands and options as data: what help, completion and the manual are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace glassbox::app {

struct OptionFacts {
  std::vector<std::string> names;  // "-o", "--output"; none where the place on the line says it
  std::string positional;          // "SCENE"
  std::string value;               // "WxH", "back|front|none"; empty for a flag and a positional
  std::string help;
  std::string group;
  bool required = false;
  bool repeats = false;  // a positional that takes any number of words

  bool is_positional() const { return names.empty(); }
};

struct CommandFacts {
  std::string name;
  std::string help;
  std::string footer;
  std::vector<OptionFacts> options;  // in the order of the help text
  std::vector<CommandFacts> commands;
};

// What is hidden from the help text is not in it.
CommandFacts command_tree(const CLI::App& app);

// ---- what may stand where a value is expected ----

struct ValueKinds {
  std::vector<std::string> choices;  // "back", "front", "none"; "auto" of "S|auto"
  bool scenes = false;               // names of the built-in scenes
  bool files = false;
  bool directories = false;  // and nothing else
  bool commands = false;     // names of subcommands
};

ValueKinds kinds_of(const OptionFacts& option);

// Makes an empty word an error of usage wherever an option takes the name of a file or directory.
void refuse_empty_names(CLI::App& app);

// Whether an option takes a whole number, as its type says.
bool takes_whole_number(const OptionFacts& option);

// Whole numbers are decimal wherever an option takes one: CLI11 reads 012 as octal and 0x10 as hexadecimal.
void read_as_decimal(CLI::App& app);

}  // namespace glassbox::app
