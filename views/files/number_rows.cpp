#include "views/files/number_rows.h"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/printable.h>
#include <glassbox/base/trimmed.h>

namespace glassbox::views {

namespace {

constexpr std::string_view kSeparators = " \t,;";

// Removes the next word from the front of the line and returns it; empty at the line's end.
std::string_view next_word(std::string_view& line) {
  const std::size_t first = std::min(line.find_first_not_of(kSeparators), line.size());
  const std::size_t last = std::min(line.find_first_of(kSeparators, first), line.size());
  const std::string_view word = line.substr(first, last - first);
  line.remove_prefix(last);
  return word;
}

Result<NumberRow> row_of(std::string_view line, std::uint64_t number) {
  NumberRow row{number, {}, {}};
  bool is_first = true;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    if (const auto value = number_of(word)) {
      row.numbers.push_back(*value);
    } else if (is_first) {
      row.name = word;
    } else {
      return fail(fmt::format("line {}", number), in_quotes(word) + " is not a finite number",
                  "write decimal numbers");
    }
    is_first = false;
  }
  return row;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) return {};
  if (!std::isfinite(value)) return {};
  return value;
}

Result<std::vector<NumberRow>> number_rows(std::string_view text) {
  std::vector<NumberRow> rows;
  for (std::uint64_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    auto row = row_of(line, number);
    if (!row) return tl::unexpected(row.error());
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace glassbox::views
