#include "labs/grading/sanitizer_report.h"

#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "labs/grading/build_kit.h"

namespace glassbox::labs::grading {

namespace {

// Reads a line of a stack trace, such as "    #1 0x55d0 in lab_05::f(int) student.cpp:24:3": the
// function without its arguments, the file's name, the line.
std::optional<std::string> place_of(const std::string& frame) {
  static const std::regex pattern(R"(^ *#\d+ 0x[0-9a-f]+ in (.*) (\S*?)([^/\s:]+):(\d+)(:\d+)?$)");
  std::smatch parts;
  if (!std::regex_match(frame, parts, pattern) || parts[3] != kSource) return std::nullopt;
  static const std::regex unnamed(R"(\(anonymous namespace\)::)");
  const std::string called = std::regex_replace(parts[1].str(), unnamed, "");
  const std::string function = called.substr(0, called.find('('));
  return fmt::format("{}:{}, in {}", kSource, parts[4].str(), function);
}

// The kind of error that the line reports; empty if it reports none.
std::string kind_of(const std::string& line) {
  for (const std::string& mark :
       {std::string("AddressSanitizer: "), std::string("runtime error: ")}) {
    const std::size_t at = line.find(mark);
    if (at == std::string::npos) continue;
    const std::string rest = line.substr(at + mark.size());
    return mark[0] == 'A' ? rest.substr(0, rest.find(' ')) : rest;
  }
  static const std::regex assertion("Assertion ('.*') failed");
  std::smatch found;
  if (std::regex_search(line, found, assertion))
    return fmt::format("the standard library's assertion {} failed", found[1].str());
  return line.find("rss limit exhausted") != std::string::npos
             ? "the program used more memory than is allowed"
             : "";
}

}  // namespace

std::optional<std::string> sanitizer_finding(const std::string& printed) {
  std::istringstream lines(printed);
  std::string kind;
  for (std::string line; std::getline(lines, line);) {
    if (kind.empty()) {
      kind = kind_of(line);
    } else if (const auto place = place_of(line)) {
      return kind + ", " + *place;
    }
  }
  if (kind.empty()) return std::nullopt;
  return kind;
}

}  // namespace glassbox::labs::grading
