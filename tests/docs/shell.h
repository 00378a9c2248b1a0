// Reads and runs the command lines of README and docs/ as they are written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/app/working_directory.h"
#include "tests/docs/tree.h"

namespace glassbox::test {

struct ShellLine {
  std::string text;  // the line as a reader would copy it
  // The text below a line that begins with "$ ", up to the next such line or the end of the block.
  std::string output;
  bool has_output = false;
  std::string section = {};  // the last heading before it that begins with "## "
};

// Returns the line without "$ " and indentation if it runs glassbox, or an empty text.
inline std::string command_in(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  line.remove_prefix(begin);
  if (line.starts_with("$ ")) line.remove_prefix(2);
  const bool is_command = line.starts_with("glassbox ") || line.starts_with("./glassbox");
  return std::string(is_command ? line : std::string_view());
}

// Returns the commands of all blocks between ```, and of blocks indented by four blanks.
inline std::vector<ShellLine> shell_lines(const std::string& page) {
  std::vector<ShellLine> found;
  bool in_block = false, in_output = false;
  std::string section;
  for (const std::string& line : lines_of(page)) {
    if (!in_block && line.starts_with("## ")) section = line;
    const bool fence = line.starts_with("```");
    if (fence) in_block = !in_block;
    if (fence || (!in_block && !line.starts_with("    "))) {
      in_output = false;
      continue;
    }
    if (in_output && !line.starts_with("$ ")) {
      found.back().output += line + "\n";
      continue;
    }
    std::string command = command_in(line);
    in_output = line.starts_with("$ ") && !command.empty();
    if (!command.empty()) found.push_back({std::move(command), {}, in_output, section});
  }
  return found;
}

// Those parts of a fresh clone that commands use, with the built program as ./glassbox and, through
// PATH, as glassbox. HOME is a directory of its own beside it.
class Clone {
public:
  Clone() {
    namespace fs = std::filesystem;
    const fs::path top(here_.path());
    fs::create_directories(top / "bin");
    fs::create_directories(top / "home");
    fs::create_directories(root());
    fs::create_symlink(GLASSBOX_PROGRAM, top / "bin/glassbox");
    fs::create_symlink(GLASSBOX_PROGRAM, fs::path(root()) / "glassbox");
    for (const char* folder : {"examples", "images/golden"}) {
      fs::create_directories(fs::path(root()) / folder);
      fs::copy(tree() / folder, fs::path(root()) / folder, fs::copy_options::recursive);
    }
  }
  std::string root() const { return here_.path() + "/clone"; }
  Outcome run(const std::string& line) const {
    const std::string environment = "HOME='" + here_.path() + "/home' PATH='" + here_.path() +
                                    "/bin':\"$PATH\"; export HOME PATH\n";
    return run_program("/bin/sh", {"-c", environment + line}, root());
  }
  void write(const std::string& name, const std::string& text) const {
    here_.write("clone/" + name, text);
  }
  // Returns the paths of all files that git would report as new or changed: those below the top
  // except out/.
  std::vector<std::string> files() const {
    namespace fs = std::filesystem;
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(root())) {
      const std::string name = entry.path().lexically_relative(root()).generic_string();
      if (!name.starts_with("out/") && name != "out") all.push_back(name);
    }
    std::ranges::sort(all);
    return all;
  }

private:
  WorkingDirectory here_;
};

}  // namespace glassbox::test
