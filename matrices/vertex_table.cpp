#include <glassbox/matrices/vertex_table.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/elementary.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/utf8.h>

namespace glassbox {

namespace {

using Cells = std::vector<std::string_view>;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return lower;
}

// Without blanks and quotation marks at its ends.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\"";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Splits at semicolons, tabs, commas or blanks: at the first of these that the line has.
Cells cells_of(std::string_view line) {
  char separator = ' ';
  for (const char mark : {',', '\t', ';'}) {
    if (line.find(mark) != std::string_view::npos) separator = mark;
  }
  Cells cells;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(separator), line.size());
    const std::string_view cell = trimmed(line.substr(0, end));
    if (separator != ' ' || !cell.empty()) cells.push_back(cell);
    line.remove_prefix(std::min(line.size(), end + 1));
  }
  return cells;
}

struct Number {
  double value = 0, uncertainty = 0;
};

// The digit that ends the number's text has half a unit of uncertainty. Short numbers were typed,
// and count as exact up to a float's rounding, as those of a printed matrix do.
double uncertainty_of(std::string_view text, double value) {
  const std::size_t point = text.find('.');
  const bool has_exponent = text.find_first_of("eE") != std::string_view::npos;
  const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  const double own = double(unit_roundoff<float>) * std::abs(value);
  if (point == std::string_view::npos || has_exponent || digits <= 4) return own;
  const auto decimals = int(text.size() - point - 1);
  return std::max(own, 0.5 * power_of_ten(-decimals));
}

std::optional<Number> number_of(std::string_view text) {
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  if (digits.ends_with('f') && digits.size() > 1) digits.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || digits.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    value = std::strtod(std::string(digits).c_str(), nullptr);
  return Number{value, std::isfinite(value) ? uncertainty_of(digits, value) : 0};
}

// ---- which columns ----

struct Columns {
  std::array<std::size_t, 4> index{0, 1, 2, 3};
  bool has_w = false;
  std::string text;
};

// How well the name of columns fits what is wanted; 0 if it does not.
int fitness(const std::string& name, VertexColumns wanted) {
  const bool shader_output = name.find("sv_position") != std::string::npos ||
                             name.find("gl_position") != std::string::npos;
  if (shader_output) return wanted == VertexColumns::kClip ? 4 : 1;
  if (name.find("position") != std::string::npos) return 3;
  if (name.find("pos") != std::string::npos || name.find("vert") != std::string::npos) return 2;
  return name.empty() ? 3 : 1;  // "x" alone, and any other attribute
}

std::optional<std::size_t> find_cell(const std::vector<std::string>& names,
                                     const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return std::size_t(found - names.begin());
}

// The columns PREFIX.x, PREFIX.y, PREFIX.z and perhaps PREFIX.w whose prefix fits best.
std::optional<Columns> columns_of(const Cells& header, VertexColumns wanted) {
  std::vector<std::string> names;
  for (const std::string_view cell : header) names.push_back(lower_case(cell));
  std::optional<Columns> best;
  int best_fitness = 0;
  for (const std::string& x : names) {
    if (x != "x" && !x.ends_with(".x")) continue;
    const std::string prefix = x.substr(0, x.size() - 1);
    const auto y = find_cell(names, prefix + "y"), z = find_cell(names, prefix + "z");
    const auto w = find_cell(names, prefix + "w");
    const int fits = fitness(prefix, wanted);
    if (!y || !z || (wanted == VertexColumns::kClip && !w) || fits <= best_fitness) continue;
    const std::size_t first = *find_cell(names, x);
    best_fitness = fits;
    best = Columns{{first, *y, *z, w.value_or(0)}, w.has_value(), {}};
    best->text = fmt::format("{}, {}, {}{}", header[first], header[*y], header[*z],
                             w ? ", " + std::string(header[*w]) : "");
  }
  return best;
}

// ---- rows ----

class TableReader {
public:
  TableReader(const std::string& name, VertexColumns wanted) : name_(name), wanted_(wanted) {}

  Result<void> read_line(std::string_view line) {
    ++line_;
    line = trimmed(line);
    if (line.empty() || line.starts_with('#') || line.starts_with("//")) return {};
    Cells cells = cells_of(line);
    if (cells.empty()) return {};
    if (is_obj_line(cells)) return {};
    if (obj_) cells.erase(cells.begin());
    if (!columns_) {
      const bool is_header = !number_of(cells.front());
      columns_ = is_header ? columns_of(cells, wanted_) : columns_without_names(cells);
      if (!columns_) return refuse_columns(is_header);
      if (is_header) return {};
    }
    return read_row(cells);
  }

  Result<VertexTable> table() {
    if (!table_.vertices.empty()) {
      table_.columns = columns_->text;
      return std::move(table_);
    }
    return tl::unexpected(
        Error{name_, "", "there is no row of numbers", "give a line x, y, z for each vertex"});
  }

private:
  // Whether this is a line of an OBJ file that has no position.
  bool is_obj_line(const Cells& cells) {
    constexpr std::array kOthers{"vt", "vn", "vp", "f",      "l",     "p",
                                 "o",  "g",  "s",  "usemtl", "mtllib"};
    if (cells.front() == "v" && cells.size() >= 4) obj_ = true;
    const bool other = std::ranges::find(kOthers, cells.front()) != kOthers.end();
    return other || (obj_ && cells.front() != "v");
  }

  std::optional<Columns> columns_without_names(const Cells& cells) const {
    const bool clip = wanted_ == VertexColumns::kClip;
    // An OBJ file may have a colour behind each position.
    if (cells.size() < (clip ? 4U : 3U) || (cells.size() > 4 && !obj_)) return std::nullopt;
    Columns columns;
    columns.has_w = cells.size() == 4;
    columns.text = columns.has_w ? "x, y, z, w" : "x, y, z";
    return columns;
  }

  Result<void> refuse_columns(bool is_header) const {
    const bool clip = wanted_ == VertexColumns::kClip;
    if (!is_header) {
      return refuse(clip ? "a clip position has four numbers: x, y, z, w"
                         : "a position has three numbers, or four with w",
                    "leave only these, or name the columns in a first line");
    }
    return refuse(clip ? "no columns end in .x, .y, .z and .w" : "no columns end in .x, .y and .z",
                  clip ? "name the columns Position.x, Position.y, Position.z, Position.w"
                       : "name the columns Position.x, Position.y, Position.z");
  }

  Result<void> read_row(const Cells& cells) {
    if (table_.vertices.size() == kMaxTableVertices) {
      return refuse(fmt::format("there are more than {} vertices", kMaxTableVertices),
                    "give a part of the table");
    }
    TableVertex vertex;
    vertex.line = line_;
    for (int i = 0; i < (columns_->has_w ? 4 : 3); ++i) {
      const std::size_t column = columns_->index[std::size_t(i)];
      if (column >= cells.size()) {
        return refuse(fmt::format("there is no column {}", column + 1),
                      "give a number for each coordinate");
      }
      const std::optional<Number> number = number_of(cells[column]);
      if (!number) {
        return refuse(in_quotes(printable(std::string(cells[column]), 30)) + " is not a number",
                      cells[column].find(',') != std::string_view::npos
                          ? "write a point before decimals"
                          : "give a number for each coordinate");
      }
      if (!(std::abs(number->value) <= double(std::numeric_limits<float>::max()))) {
        return refuse("a coordinate is not finite, or too large for a float",
                      "give numbers up to 3.4e38");
      }
      vertex.position[i] = number->value;
      vertex.uncertainty[i] = number->uncertainty;
    }
    table_.vertices.push_back(vertex);
    return {};
  }

  Result<void> refuse(const std::string& what, const std::string& remedy) const {
    return tl::unexpected(Error{name_, fmt::format("line {}", line_), what, remedy});
  }

  const std::string& name_;
  VertexColumns wanted_;
  std::optional<Columns> columns_;
  bool obj_ = false;
  int line_ = 0;
  VertexTable table_;
};

}  // namespace

Result<VertexTable> parse_vertex_table(std::string_view text, const std::string& name,
                                       VertexColumns wanted) {
  std::string converted;
  if (const auto order = utf16_byte_order(text)) text = converted = utf8_of_utf16(text, *order);
  text = without_byte_order_mark(text);
  TableReader reader(name, wanted);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const auto read = reader.read_line(text.substr(0, end)); !read) {
      return tl::unexpected(read.error());
    }
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return reader.table();
}

}  // namespace glassbox
