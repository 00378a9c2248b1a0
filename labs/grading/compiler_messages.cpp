#include "labs/grading/compiler_messages.h"

#include <cctype>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "labs/grading/build_kit.h"

namespace glassbox::labs::grading {

namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The line number in "...student.cpp:24:3: ..."; 0 if there is none.
int line_in_source(const std::string& message) {
  const std::string mark = std::string(kSource) + ":";
  const std::size_t at = message.find(mark);
  if (at == std::string::npos ||
      !std::isdigit(static_cast<unsigned char>(message[at + mark.size()])))
    return 0;
  return std::atoi(message.c_str() + at + mark.size());
}

// For the message around line `at`, which is an error in another file: the nearest line of
// student.cpp that the messages name before it or after it.
int cause_of(const std::vector<std::string>& lines, std::size_t at) {
  for (std::size_t i = at; i-- > 0 && lines[i].find("error:") == std::string::npos;) {
    if (const int line = line_in_source(lines[i])) return line;
  }
  for (std::size_t i = at + 1; i < lines.size() && lines[i].find("error:") == std::string::npos;
       ++i) {
    if (const int line = line_in_source(lines[i])) return line;
  }
  return 0;
}

std::string trimmed_left(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string::npos ? "" : line.substr(first);
}

}  // namespace

std::string student_line_first(const std::string& messages, const std::string& source) {
  const std::vector<std::string> lines = split_lines(messages);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string missing = "undefined reference to `";
    if (const std::size_t at = lines[i].find(missing); at != std::string::npos) {
      const std::string name = lines[i].substr(at + missing.size());
      return fmt::format("{} does not define {}, which is called somewhere.\n{}", kSource,
                         name.substr(0, name.rfind('\'')), messages);
    }
    if (lines[i].find("error:") == std::string::npos) continue;
    if (lines[i].starts_with(kSource)) return messages;
    const int line = cause_of(lines, i);
    const std::vector<std::string> text = split_lines(source);
    if (line < 1 || static_cast<std::size_t>(line) > text.size()) return messages;
    return fmt::format("{}:{}: this line leads to the error below:\n    {}\n{}", kSource, line,
                       trimmed_left(text[static_cast<std::size_t>(line) - 1]), messages);
  }
  return messages;
}

}  // namespace glassbox::labs::grading
