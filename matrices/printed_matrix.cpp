#include <glassbox/matrices/printed_matrix.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/elementary.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/rounding.h>
#include <glassbox/base/utf8.h>

namespace glassbox {

namespace {

using Kind = MatrixToken::Kind;
using Tokens = std::vector<MatrixToken>;

constexpr std::size_t kMaxBytes = 1 << 16;

// A number with the name before it: "x" in "x = 1" and "x: 1", the constructor's name in "mat4(1".
struct Labelled {
  MatrixToken token;
  std::string_view label;
};

bool is_mark(const Tokens& tokens, std::size_t i, std::string_view marks) {
  return i < tokens.size() && tokens[i].kind == Kind::kMark &&
         marks.find(tokens[i].text[0]) != std::string_view::npos;
}

bool is_count(const Tokens& tokens, std::size_t i) {
  if (i >= tokens.size() || tokens[i].kind != Kind::kNumber) return false;
  const std::string_view text = tokens[i].text;
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Whether "[3]" is a subscript or a size and not an element: after a name ("m[16]", "m[4][4]"), or
// before '=' ("[0] = 1").
bool is_subscript(const Tokens& tokens, std::size_t i, bool after_name) {
  if (!is_mark(tokens, i, "[") || !is_count(tokens, i + 1) || !is_mark(tokens, i + 2, "]")) {
    return false;
  }
  return after_name || is_mark(tokens, i + 3, "=");
}

// Whether this is the length in "Float32Array(16) [1, 0, ...]".
bool is_length(const Tokens& tokens, std::size_t i) {
  return is_mark(tokens, i, "(") && is_count(tokens, i + 1) && is_mark(tokens, i + 2, ")") &&
         is_mark(tokens, i + 3, "[{");
}

// Whether this is a key: the 0 in "row 0: 1 0 0 0", or one in {"0": 1, "1": 0, ...}, which is how
// JavaScript writes typed arrays.
bool is_key(const Tokens& tokens, std::size_t i) {
  return is_count(tokens, i) && (is_mark(tokens, i + 1, ":") ||
                                 (is_mark(tokens, i + 1, "\"'") && is_mark(tokens, i + 2, ":")));
}

Error count_error(const std::string& name, std::size_t count) {
  std::string remedy = "give one matrix of four rows and four columns";
  if (count == 32)
    remedy = "give two matrices separately; print decimal points, not decimal commas";
  if (count == 48) remedy = "give three matrices separately, each as its own file or text";
  if (count == 12) remedy = "if the last row is missing, add 0 0 0 1";
  if (count == 9) remedy = "extend a 3x3 matrix by a column 0 0 0 and a row 0 0 0 1";
  return {name, "",
          fmt::format("has {}{}", count > 64 ? "more than " : "",
                      counted(std::min<std::size_t>(count, 64), "number")) +
              ", but a matrix has 16",
          remedy};
}

// The number of repetitions in gdb's "0 <repeats 15 times>"; nothing if there is something else.
std::optional<double> repeats_at(const Tokens& tokens, std::size_t i) {
  const bool is_one = is_mark(tokens, i, "<") && i + 4 < tokens.size() &&
                      tokens[i + 1].text == "repeats" && is_count(tokens, i + 2) &&
                      tokens[i + 3].text == "times" && is_mark(tokens, i + 4, ">");
  if (!is_one) return std::nullopt;
  return tokens[i + 2].value;
}

Result<std::vector<Labelled>> numbers_of(const Tokens& tokens, const std::string& name) {
  std::vector<Labelled> numbers;
  std::string_view label;
  bool after_name = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const MatrixToken& token = tokens[i];
    if (is_subscript(tokens, i, after_name) || is_length(tokens, i)) {
      i += 2;  // after_name stays true, for the second subscript of m[4][4]
      continue;
    }
    if (const auto repeats = repeats_at(tokens, i)) {
      if (numbers.empty() || tokens[i - 1].kind != Kind::kNumber) {
        return tl::unexpected(Error{name,
                                    fmt::format("line {}, column {}", token.line, token.column),
                                    "there is no number before <repeats ... times>",
                                    "print the matrix again after `set print repeats 0` in gdb"});
      }
      const Labelled last = numbers.back();
      for (double k = 1; k < *repeats && numbers.size() <= 64; ++k) numbers.push_back(last);
      i += 4;
      continue;
    }
    after_name = token.kind == Kind::kName;
    if (token.kind == Kind::kName) label = token.text;
    if (is_mark(tokens, i, ",;)]}")) label = {};
    if (token.kind != Kind::kNumber || is_key(tokens, i)) continue;
    if (numbers.size() <= 64) numbers.push_back({token, label});
    label = {};
  }
  return numbers;
}

// gdb shows each member of GLM's unions under all its names, such as x = r = s. Keeps the number
// once.
void drop_second_names(std::vector<Labelled>& numbers) {
  const auto is = [](const Labelled& n, std::string_view names) {
    return n.label.size() == 1 && names.find(n.label[0]) != std::string_view::npos;
  };
  const bool named_by_axis =
      std::any_of(numbers.begin(), numbers.end(), [&](const Labelled& n) { return is(n, "x"); });
  if (!named_by_axis || numbers.size() != 48) return;
  std::erase_if(numbers, [&](const Labelled& n) { return is(n, "rgbastpq"); });
}

// Whether this is "15": 1, the last entry of a typed array that JavaScript writes as JSON.
bool is_last_key(const Tokens& tokens, std::size_t i) {
  return tokens[i].text == "15" && is_mark(tokens, i + 1, "\"") && is_key(tokens, i);
}

// The name of the layout if it always writes matrices by columns, recognised by a constructor or a
// member's name; nullptr for others.
const char* known_by_columns(const Tokens& tokens, std::size_t i) {
  if (is_last_key(tokens, i)) return "a typed array of JavaScript";
  if (tokens[i].kind != Kind::kName) return nullptr;
  std::string word(tokens[i].text);
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  const bool called = is_mark(tokens, i + 1, "(");
  if (called && (word == "mat4" || word == "dmat4" || word.ends_with("mat4x4"))) {
    return "a matrix of GLM or GLSL";
  }
  if (called && word == "matrix3d") return "a matrix of CSS";
  if (word == "float32array" || word == "float64array") return "a typed array of JavaScript";
  if (word == "elements") return "a matrix of three.js";
  if (word == "x_axis") return "a matrix of glam";
  if (word == "value" && is_mark(tokens, i + 1, "=") && is_mark(tokens, i + 2, "{")) {
    return "GLM in a debugger";
  }
  if (word == "m11" && is_mark(tokens, i + 1, ":")) {
    return "a matrix of System.Numerics, for row vectors";
  }
  if (word == "_11" && is_mark(tokens, i + 1, "=:")) {
    return "an XMFLOAT4X4 of DirectXMath, for row vectors";
  }
  return nullptr;
}

// Whether this is Unreal's FMatrix, "[1 0 0 0] [0 1 0 0] [0 0 1 0] [0 0 0 1]" in one line: four
// brackets without commas and without a bracket around them.
bool is_unreal(const Tokens& tokens) {
  if (tokens.size() != 24 || tokens.front().line != tokens.back().line) return false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::size_t place = i % 6;
    if (place == 0 && !is_mark(tokens, i, "[")) return false;
    if (place == 5 && !is_mark(tokens, i, "]")) return false;
    if (place != 0 && place != 5 && tokens[i].kind != Kind::kNumber) return false;
  }
  return true;
}

// Whether this is Godot's Transform3D, "[X: (1, 0, 0), Y: (0, 1, 0), Z: (0, 0, 1), O: (0, 0, 0)]":
// its axes and its origin, twelve numbers.
bool is_godot(const Tokens& tokens) {
  std::string names;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != Kind::kName) continue;
    if (tokens[i].text.size() != 1 || !is_mark(tokens, i + 1, ":")) return false;
    names += tokens[i].text;
  }
  return names == "XYZO";
}

// Adds the last row, 0 0 0 1, to twelve numbers that are listed by columns.
void add_last_row(std::vector<Labelled>& numbers) {
  for (std::size_t column = 0; column < 4; ++column) {
    Labelled entry = numbers[4 * column];
    entry.token.value = column == 3 ? 1 : 0;
    entry.token.digits = 1;
    numbers.insert(numbers.begin() + std::ptrdiff_t(4 * column + 3), entry);
  }
}

void recognise(const Tokens& tokens, MatrixText& matrix) {
  const char* whole = is_unreal(tokens)  ? "an FMatrix of Unreal, for row vectors"
                      : is_godot(tokens) ? "a Transform3D of Godot"
                                         : nullptr;
  if (whole != nullptr) {
    matrix.order = NumberOrder::kColumns;
    matrix.recognised = whole;
    return;
  }
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (const char* by = known_by_columns(tokens, i)) {
      matrix.order = NumberOrder::kColumns;
      matrix.recognised = by;
      return;
    }
  }
}

// The uncertainty of each number is half a unit of its last digit. In fixed notation the last digit
// follows from the number of decimals. Otherwise it follows from the significant digits of the
// longest number, because programs drop trailing zeros. Numbers with four digits or fewer were
// probably typed and count as exact. The uncertainty is never less than float's own rounding.
void estimate_uncertainty(const std::vector<Labelled>& numbers, MatrixText& matrix) {
  const int decimals = numbers.front().token.decimals;
  bool fixed = decimals > 0;
  int digits = 0;
  for (const Labelled& n : numbers) {
    fixed = fixed && n.token.decimals == decimals;
    digits = std::max(digits, n.token.digits);
  }
  matrix.digits = digits;
  for (std::size_t i = 0; i < 16; ++i) {
    const double size = std::abs(matrix.numbers[i]);
    double open = 0;
    if (fixed && decimals > 4) {
      open = 0.5 * power_of_ten(-decimals);
    } else if (!fixed && digits > 4 && size > 0 && std::isfinite(size)) {
      open = 0.5 * power_of_ten(int(std::floor(logarithm_10(size))) + 1 - digits);
    }
    matrix.uncertainty[i] = std::max(open, double(unit_roundoff<float>) * size);
  }
}

}  // namespace

Result<MatrixText> parse_matrix_text(std::string_view text, const std::string& name) {
  const auto tokens = matrix_tokens(text, name);
  if (!tokens) return tl::unexpected(tokens.error());
  auto numbers = numbers_of(*tokens, name);
  if (!numbers) return tl::unexpected(numbers.error());
  drop_second_names(*numbers);
  if (numbers->size() == 12 && is_godot(*tokens)) add_last_row(*numbers);
  if (numbers->size() != 16) return tl::unexpected(count_error(name, numbers->size()));
  MatrixText matrix;
  for (std::size_t i = 0; i < 16; ++i) matrix.numbers[i] = (*numbers)[i].token.value;
  recognise(*tokens, matrix);
  estimate_uncertainty(*numbers, matrix);
  return matrix;
}

NumberOrder order_of(const MatrixText& text, std::optional<NumberOrder> asked) {
  return asked.value_or(text.order.value_or(NumberOrder::kRows));
}

GivenMatrix to_matrix(const MatrixText& text, NumberOrder order) {
  GivenMatrix matrix;
  matrix.given = true;
  for (int i = 0; i < 16; ++i) {
    const int row = order == NumberOrder::kRows ? i / 4 : i % 4;
    const int column = order == NumberOrder::kRows ? i % 4 : i / 4;
    matrix.m[column][row] = text.numbers[std::size_t(i)];
    matrix.uncertainty[column][row] = text.uncertainty[std::size_t(i)];
  }
  return matrix;
}

Result<NamedText> read_matrix_source(const std::string& source) {
  namespace fs = std::filesystem;
  const auto contents = [](std::istream& in) {
    std::string text(kMaxBytes + 1, '\0');
    in.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(in.gcount()));
    return text;
  };
  const auto checked = [](NamedText read) -> Result<NamedText> {
    if (read.text.size() <= kMaxBytes) {
      if (const auto order = utf16_byte_order(read.text)) {
        read.text = utf8_of_utf16(read.text, *order);
      }
      return read;
    }
    return tl::unexpected(Error{read.name, "", fmt::format("is longer than {} bytes", kMaxBytes),
                                "give the matrix alone"});
  };
  if (source == "-") return checked({"standard input", contents(std::cin)});
  std::error_code ignored;
  const bool is_text = source.find_first_of(" ,\n\t") != std::string::npos;
  if (is_text && (source.size() > 4096 || !fs::exists(source, ignored))) {
    std::string name = source.substr(0, 31);
    std::replace(name.begin(), name.end(), '\n', ' ');
    return checked({in_quotes(printable(name, 30)), source});
  }
  if (fs::is_directory(source, ignored)) {
    return tl::unexpected(Error{source, "", "is a directory", "name a file with a matrix"});
  }
  std::ifstream in(source, std::ios::binary);
  if (!in) {
    return tl::unexpected(Error{source, "",
                                fs::exists(source, ignored) ? "cannot be read" : "no such file",
                                "name a file, - for standard input, or give the sixteen numbers"});
  }
  return checked({source, contents(in)});
}

Result<GivenMatrix> read_given_matrix(const char* option, const std::string& source,
                                      std::optional<NumberOrder> asked) {
  const auto located = [&](Error error) {
    error.place = error.place.empty() ? option : std::string(option) + ", " + error.place;
    return tl::unexpected(std::move(error));
  };
  const auto read = read_matrix_source(source);
  if (!read) return located(read.error());
  const auto parsed = parse_matrix_text(read->text, read->name);
  if (!parsed) return located(parsed.error());
  const NumberOrder order = order_of(*parsed, asked);
  GivenMatrix matrix = to_matrix(*parsed, order);
  matrix.origin = fmt::format("{}, read by {}", printable(read->name),
                              order == NumberOrder::kRows ? "rows" : "columns");
  if (!parsed->recognised.empty()) matrix.origin += fmt::format(" ({})", parsed->recognised);
  return matrix;
}

}  // namespace glassbox
