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

constexpr std::size_t kMaxRows = 200;

// Text that means itself in Markdown, which may contain HTML.
std::string in_markdown(const std::string& text) {
  constexpr std::string_view kMarkup = "\\`*_{}[]()#+-.!|~", kHtml = "<>&";
  std::string out;
  for (const char c : printable(text, 400)) {
    if (kMarkup.find(c) != std::string_view::npos) out += '\\';
    out += kHtml.find(c) == std::string_view::npos ? std::string(1, c)
                                                   : escaped_html(std::string(1, c));
  }
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
  std::size_t rows = 0;
  for (const Comparison& one : comparisons) {
    if (passes(one.verdict) || ++rows > kMaxRows) continue;
    if (rows == 1) text += "\n| picture | | pixels that differ | |\n| --- | --- | --- | --- |\n";
    text += row(one);
  }
  if (rows > kMaxRows) {
    text += fmt::format("\nand {} that do not pass\n", counted(rows - kMaxRows, "more picture"));
  }
  return text;
}

}  // namespace glassbox
