// Where the commands of a prompt come from: any stream, or a terminal with line editing and history (libedit).
#pragma once

#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glassbox::app {

class LineReader {
public:
  virtual ~LineReader() = default;
  // Shows the prompt and waits for a line, which comes without its end; nothing at the end of the input.
  virtual std::optional<std::string> read(const std::string& prompt) = 0;
};

std::unique_ptr<LineReader> lines_of(std::istream& in);

// All words that may stand where `words.back()` does, which is empty or half a word; those before it are complete.
using Candidates = std::function<std::vector<std::string>(const std::vector<std::string>& words)>;

// Standard input and output as a terminal: the arrow keys go through the line and through the lines before, Control-R searches
// them, and the tabulator completes words. Where the terminal cannot do that (TERM unset or dumb), as lines_of.
std::unique_ptr<LineReader> terminal_lines(Candidates candidates);

}  // namespace glassbox::app
