#include <glassbox/compare/report/markdown.h>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/compare/report/text.h>
#include <glassbox/html/escaped_html.h>

namespace glassbox {
namespace {

// Bytes of the rows and what is above them: the last line has less than the rest of 65,536.
constexpr std::size_t kLongestTable = 60'000;

// A character that means itself in Markdown, which may contain HTML. A dollar sign begins a formula
// on GitHub, also behind a backslash (GitHub: Writing mathematical expressions).
std::string in_markdown(char c) {
  constexpr std::string_view kMarkup = "\\`*_{}[]()#+-.!|~", kHtml = "<>&";
  if (c == '$') return "<span>$</span>";
  if (kHtml.find(c) != std::string_view::npos) return escaped_html(std::string(1, c));
  return (kMarkup.find(c) != std::string_view::npos ? "\\" : "") + std::string(1, c);
}

std::string in_markdown(const std::string& text) {
  std::string out;
  for (const char c : printable(text, 400)) out += in_markdown(c);
  return out;
}

std::string number_of_pixels(const Comparison& comparison) {
  if (!comparison.differences) return "";
  const Differences& found = *comparison.differences;
  return fmt::format("{} of {}", found.differing, found.compared);
}

std::string row(const Comparison& comparison) {
  return fmt::format("| {} | {} | {} | {} |\n", in_markdown(comparison.name),
                     verdict_name(comparison.verdict), number_of_pixels(comparison),
                     in_markdown(comparison_reason(comparison)));
}

}  // namespace

std::string markdown_report(const std::string& title, std::span<const Comparison> comparisons) {
  std::string text =
      fmt::format("### {}\n\n{}\n", in_markdown(title), in_markdown(summary_line(comparisons)));
  bool has_table = false;
  std::size_t left_out = 0;
  for (const Comparison& one : comparisons) {
    if (passes(one.verdict)) continue;
    if (!has_table) {
      text += "\n| picture | verdict | pixels that differ | why |\n| --- | --- | --- | --- |\n";
      has_table = true;
    }
    const std::string next = row(one);
    if (left_out > 0 || text.size() + next.size() > kLongestTable) {
      ++left_out;
    } else {
      text += next;
    }
  }
  if (left_out > 0) {
    text += fmt::format("\nand {} that do not pass\n", counted(left_out, "more picture"));
  }
  return text;
}

}  // namespace glassbox
