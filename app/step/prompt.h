// A prompt at which the user steps through a triangle's stages: next, back, jump, other cameras or
// triangles, and what they change.
#pragma once

#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/step/stepped_triangle.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// What is examined: the words of the picture options, such as "--eye 1,2,3", and the triangle.
struct StepChoice {
  std::vector<std::string> words;
  StepTarget target;
};

// Reads commands until "quit" or the end of the input, and writes to standard output. If
// `terminal`, with line editing, history and completion; otherwise from any standard input.
void run_step_prompt(const Scene& scene, const StepChoice& choice, std::vector<StageText> stages,
                     bool bits, bool terminal);

// Reads the commands of a prompt from any stream, or from a terminal with line editing and history
// (libedit).
class LineReader {
public:
  virtual ~LineReader() = default;
  // Shows the prompt, waits for a line and returns it without its line break; nothing at the end of
  // the input.
  virtual std::optional<std::string> read(const std::string& prompt) = 0;
};

std::unique_ptr<LineReader> make_stream_reader(std::istream& in);

// Returns all words that can complete `words.back()`, which is empty or the beginning of a word.
// The words before it are complete.
using Candidates = std::function<std::vector<std::string>(const std::vector<std::string>& words)>;

// Reads from a terminal: the arrow keys move in the line and through earlier lines, Control-R
// searches earlier lines, and the tab key completes words. If the terminal cannot do that (TERM
// unset or dumb), behaves like make_stream_reader.
std::unique_ptr<LineReader> make_terminal_reader(Candidates candidates);

}  // namespace glassbox::app
