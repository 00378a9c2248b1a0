#include "labs/grading/roster.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "labs/framework/sources.h"

#include <glassbox/base/ascii_case.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/utf8.h>

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

struct Line {
  std::size_t number = 0;  // from 1, of its first line in the file
  std::vector<std::string> cells;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

// The character between cells: the one of the three that is most frequent in the first line,
// outside of quotes.
char separator_of(std::string_view text) {
  std::map<char, int> counts;
  bool quoted = false;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '"') quoted = !quoted;
    if (!quoted) ++counts[c];
  }
  char best = ',';
  for (const char each : {';', '\t'}) {
    if (counts[each] > counts[best]) best = each;
  }
  return best;
}

// Splits a CSV file into cells without the blanks around them. `unclosed` is the number of a line
// in which quotes begin that do not end; 0 if there is none.
std::vector<Line> lines_of(std::string_view text, std::size_t& unclosed) {
  const char separator = separator_of(text);
  std::vector<Line> lines;
  std::size_t number = 1, opened = 0;
  Line line{number, {""}};
  bool quoted = false;
  const auto end_line = [&] {
    for (std::string& cell : line.cells) cell = trimmed(cell);
    if (std::any_of(line.cells.begin(), line.cells.end(),
                    [](const std::string& cell) { return !cell.empty(); }))
      lines.push_back(line);
    line = {number, {""}};
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++number;
    if (quoted) {
      if (c != '"') {
        line.cells.back() += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        line.cells.back() += text[++i];
      } else {
        quoted = false;
      }
    } else if (c == '"' && trimmed(line.cells.back()).empty()) {
      quoted = true;
      opened = number;
      line.cells.back().clear();
    } else if (c == separator) {
      line.cells.emplace_back();
    } else if (c == '\n') {
      end_line();
    } else {
      line.cells.back() += c;
    }
  }
  unclosed = quoted ? opened : 0;
  end_line();
  return lines;
}

// Whether a text has characters alone: UTF-8 without control characters but tabs and line ends.
bool is_plain_text(std::string_view text) {
  return is_utf8(text) && std::none_of(text.begin(), text.end(), [](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
         });
}

// Whether a first line without the column "submission" looks like the names of columns.
bool looks_like_names(const std::vector<std::string>& cells) {
  static constexpr std::string_view kUsual[] = {"name",  "id",       "student", "email",
                                                "login", "username", "user",    "full name",
                                                "group", "section"};
  return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return std::find(std::begin(kUsual), std::end(kUsual), lower_case(cell)) != std::end(kUsual);
  });
}

tl::unexpected<Error> wrong_line(const std::string& name, std::size_t number,
                                 const std::string& cause, const std::string& remedy) {
  return tl::unexpected(Error{name, fmt::format("line {}", number), cause, remedy});
}

}  // namespace

Result<Roster> parse_roster(const std::string& text, const std::string& name) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";  // some programs begin UTF-8 with it
  std::string_view rest = text;
  if (rest.starts_with(kMark)) rest.remove_prefix(kMark.size());
  if (!is_plain_text(rest))
    return fail(name, "is not a text in UTF-8", "export the roster as a CSV file in UTF-8");
  std::size_t unclosed = 0;
  std::vector<Line> lines = lines_of(rest, unclosed);
  if (unclosed > 0)
    return wrong_line(name, unclosed, "begins a cell in quotes that does not end",
                      "write \"\" for a quote in a cell, and a quote at its end");
  if (lines.empty())
    return fail(name, "names nobody",
                "write a line for each student that begins with the name of the submission");
  const std::vector<std::string> first = lines.front().cells;
  const std::size_t width = first.size();
  const auto is_column = [](const std::string& cell) { return lower_case(cell) == "submission"; };
  const auto found = std::find_if(first.begin(), first.end(), is_column);
  const bool has_names = found != first.end();
  if (has_names && std::count_if(first.begin(), first.end(), is_column) > 1)
    return wrong_line(name, lines.front().number, "has two columns \"submission\"",
                      "give the other column another name");
  if (!has_names && looks_like_names(first))
    return wrong_line(name, lines.front().number,
                      "seems to name columns, but none of them is called \"submission\"",
                      "call the column with the names of the submissions \"submission\", or remove "
                      "this line");
  const auto column = has_names ? static_cast<std::size_t>(found - first.begin()) : 0;
  Roster roster;
  for (std::size_t i = 0; i < width; ++i) {
    if (i != column)
      roster.columns.push_back(has_names ? first[i] : fmt::format("column {}", i + 1));
  }
  std::map<std::string, std::size_t> seen;  // the line of each name
  for (std::size_t i = has_names ? 1 : 0; i < lines.size(); ++i) {
    std::vector<std::string> cells = lines[i].cells;
    while (cells.size() > width && cells.back().empty()) cells.pop_back();
    if (cells.size() > width)
      return wrong_line(name, lines[i].number,
                        fmt::format("has {} cells, and the first line has {}", cells.size(), width),
                        "put a cell that contains the separator in quotes");
    cells.resize(width);
    const std::string student = cells[column];
    if (student.empty())
      return wrong_line(name, lines[i].number, "has no name of a submission",
                        "write the name of the student's submission, or remove the line");
    const auto [before, is_new] = seen.emplace(student, lines[i].number);
    if (!is_new)
      return wrong_line(
          name, lines[i].number,
          fmt::format("names {}, as line {} does", in_quotes(student), before->second),
          "remove one of the two lines");
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(column));
    roster.students.push_back({student, std::move(cells)});
  }
  if (roster.students.empty())
    return fail(name, "names nobody",
                "write a line for each student below the names of the columns");
  return roster;
}

Result<Roster> read_roster(const fs::path& file) {
  constexpr std::uintmax_t kLargest = std::uintmax_t(16) << 20;  // far above any university's
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size > kLargest)
    return fail(file.string(), "is larger than 16 MiB", "name the CSV file of one course");
  const auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  return parse_roster(*text, file.string());
}

}  // namespace glassbox::labs::grading
