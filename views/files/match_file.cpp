#include "views/files/match_file.h"

#include <fmt/format.h>

#include "views/files/number_rows.h"

namespace glassbox::views {

Result<Matches> parse_matches(std::string_view text) {
  // The words of a heading are not numbers; number_rows() accepts that only of the first word in a
  // line.
  const std::string_view first = text.substr(0, text.find('\n'));
  const bool has_heading = first.starts_with("x_left");
  const std::uint64_t skipped = has_heading ? 1 : 0;
  const auto rows =
      number_rows(has_heading ? text.substr(std::min(first.size() + 1, text.size())) : text);
  if (!rows) return tl::unexpected(rows.error());
  Matches matches;
  for (const NumberRow& row : *rows) {
    if (!row.name.empty() || row.numbers.size() != 4) {
      return fail(fmt::format("line {}", row.line + skipped),
                  fmt::format("a match needs 4 numbers, but there are {}{}", row.numbers.size(),
                              row.name.empty() ? "" : " after a word"),
                  "write x and y of the left picture, then of the right one");
    }
    matches.push_back({{row.numbers[0], row.numbers[1]}, {row.numbers[2], row.numbers[3]}});
  }
  return matches;
}

std::string matches_text(const Matches& matches) {
  std::string text = "x_left,y_left,x_right,y_right\n";
  for (const Match& match : matches) {
    text += fmt::format("{},{},{},{}\n", match.left.x(), match.left.y(), match.right.x(),
                        match.right.y());
  }
  return text;
}

}  // namespace glassbox::views
