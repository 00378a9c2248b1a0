#include <glassbox/compare/report/github.h>

#include <string_view>

#include <fmt/format.h>

#include <glassbox/compare/report/text.h>

namespace glassbox {
namespace {

// Writes the characters that end a command or a property as their codes, after %.
std::string in_command(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    out += special.find(c) == std::string_view::npos ? std::string(1, c)
                                                     : fmt::format("%{:02X}", int(c));
  }
  return out;
}

std::string in_property(std::string_view text) {
  return in_command(text, "%\r\n:,");
}

std::string in_message(std::string_view text) {
  return in_command(text, "%\r\n");
}

std::string annotation(const Comparison& comparison) {
  std::string message = comparison_line(comparison) + "\n" + comparison_details(comparison);
  message.pop_back();  // the line feed at the end, of the details or of the first line
  return fmt::format("::error file={},title={}::{}\n", in_property(comparison.reference.path),
                     in_property("picture " + verdict_name(comparison.verdict)),
                     in_message(message));
}

}  // namespace

std::string github_annotations(std::span<const Comparison> comparisons) {
  std::string text;
  for (const Comparison& one : comparisons) {
    if (!passes(one.verdict)) text += annotation(one);
  }
  return text;
}

}  // namespace glassbox
