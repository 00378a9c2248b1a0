#include <glassbox/matrices/printed_matrix.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include <glassbox/base/ascii_case.h>
#include <glassbox/base/printable.h>

namespace glassbox {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

class Lexer {
public:
  Lexer(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<std::vector<MatrixToken>> run() {
    while (skip_to_token(), at_ < text_.size()) {
      const Result<void> taken = take();
      if (!taken) return tl::unexpected(taken.error());
    }
    return std::move(tokens_);
  }

private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool starts_with(std::string_view word) const { return text_.substr(at_).starts_with(word); }

  void advance(std::size_t count = 1) {
    for (; count > 0 && at_ < text_.size(); --count, ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        column_ = 1;
      } else if ((static_cast<unsigned char>(text_[at_]) & 0xc0) != 0x80) {
        // a column is a character: bytes that continue a UTF-8 character are not counted
        ++column_;
      }
    }
  }
  void advance_past(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    advance((found == std::string_view::npos ? text_.size() : found + end.size()) - at_);
  }

  // Skips blanks, comments, and the characters by which some programs draw large brackets.
  void skip_to_token() {
    for (;;) {
      const char c = peek();
      if (at_ == text_.size()) return;
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v') {
        advance();
      } else if (c == '#' || starts_with("//")) {
        advance_past("\n");
      } else if (starts_with("/*")) {
        advance(2);
        advance_past("*/");
      } else if (const std::size_t drawn = drawn_separator()) {
        advance(drawn);
      } else {
        return;
      }
    }
  }

  // The length in bytes of a no-break space, a byte order mark, a box-drawing character or a part
  // of a tall bracket; 0 for anything else.
  std::size_t drawn_separator() const {
    if (starts_with("\u00a0")) return 2;
    if (starts_with("\ufeff")) return 3;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(peek(i)); };
    const bool box = byte(0) == 0xe2 && (byte(1) == 0x94 || byte(1) == 0x95);    // U+2500 .. U+257F
    const bool bracket = byte(0) == 0xe2 && byte(1) == 0x8e && byte(2) >= 0x9b;  // U+239B ..
    return box || bracket ? 3 : 0;
  }

  // The minus sign U+2212, which typesetting and some libraries write, counts as '-'.
  std::size_t sign_length() const {
    if (peek() == '+' || peek() == '-') return 1;
    return starts_with("\u2212") ? 3 : 0;
  }

  Result<void> take() {
    const std::size_t sign = sign_length();
    const char first = peek(sign);
    if (is_digit(first) || (first == '.' && is_digit(peek(sign + 1)))) return take_number(sign);
    if (is_letter(first)) return take_name(sign);
    if (sign == 0 && take_quoted_name()) return {};
    if (sign == 0 && std::string_view("()[]{}<>,;:=|&'\"").find(first) != std::string_view::npos &&
        first != '\0') {
      push(MatrixToken::Kind::kMark, 1);
      return {};
    }
    if (first == '*' && sign == 0) {
      return refuse(1, "looks like a factor for the whole matrix",
                    "print the numbers without one (MATLAB: format long g)");
    }
    return refuse(word_length(), "is neither a number nor a separator",
                  "leave only the sixteen numbers, with blanks or commas between them");
  }

  // Reads a name in quotes. 'view matrix 3' and "cuda:0" are names, but "0.5" and "NaN" are numbers
  // in quotes.
  bool take_quoted_name() {
    const char quote = peek();
    if (quote != '"' && quote != '\'') return false;
    const std::string_view rest = text_.substr(at_ + 1);
    const std::size_t end = rest.find_first_of(std::string{quote, '\n'});
    if (end == std::string_view::npos || end == 0 || rest[end] != quote) return false;
    const std::string_view inside = rest.substr(0, end);
    if (!is_letter(inside[0]) || is_nan(inside) || is_infinite(inside)) return false;
    push(MatrixToken::Kind::kName, end + 2).text = inside;
    return true;
  }

  // JavaScript writes NaN as null in JSON.
  static bool is_nan(std::string_view word) {
    return equal_ignoring_case(word, "nan") || word == "null";
  }
  static bool is_infinite(std::string_view word) {
    return equal_ignoring_case(word, "inf") || equal_ignoring_case(word, "infinity");
  }

  // Reads a name. nan and inf are numbers; other names are kept as labels.
  Result<void> take_name(std::size_t sign) {
    std::size_t length = sign;
    while (is_letter(peek(length)) || is_digit(peek(length)) || peek(length) == '.') ++length;
    const std::string_view word = text_.substr(at_ + sign, length - sign);
    const bool nan = is_nan(word);
    if (nan || is_infinite(word)) {
      // NaN can be followed by details: "nan(ind)", "nan(0x400000)"
      if (nan && peek(length) == '(') {
        const std::size_t end = text_.find(')', at_ + length);
        if (end != std::string_view::npos) length = end + 1 - at_;
      }
      const double magnitude =
          nan ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
      push(MatrixToken::Kind::kNumber, length).value = negative(sign) ? -magnitude : magnitude;
      return {};
    }
    if (sign > 0) {
      return refuse(word_length(), "is an expression, not a number", "print its value instead");
    }
    push(MatrixToken::Kind::kName, length);
    return {};
  }

  bool negative(std::size_t sign) const { return sign == 3 || (sign == 1 && peek() == '-'); }

  // Reads digits with a point and an exponent (e, or d in Fortran), then perhaps a suffix as in C.
  Result<void> take_number(std::size_t sign) {
    const char before = at_ > 0 ? text_[at_ - 1] : ' ';
    if (sign > 0 && (before == ')' || before == ']' || is_letter(before))) {
      return refuse(word_length(), "continues an expression", "print its value instead");
    }
    if (sign == 0 && is_size()) {
      push(MatrixToken::Kind::kName, 3);
      return {};
    }
    std::string plain = negative(sign) ? "-" : "";  // the number in the notation of from_chars
    std::size_t length = sign;
    int point = -1, digits = 0, decimals = 0;
    bool leading = true;
    for (; is_digit(peek(length)) || (peek(length) == '.' && point < 0); ++length) {
      const char c = peek(length);
      plain += c;
      if (c == '.') {
        point = int(length);
        continue;
      }
      decimals += point >= 0;
      leading = leading && c == '0';
      digits += !leading;
    }
    for (const char* special : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
      if (starts_with_at(length, special)) return take_old_special(sign, length);
    }
    const bool has_exponent = exponent_at(length);
    if (has_exponent) {
      plain += 'e';
      ++length;
      if (peek(length) == '-') plain += '-';
      if (peek(length) == '-' || peek(length) == '+') ++length;
      for (; is_digit(peek(length)); ++length) plain += peek(length);
    }
    if (peek(length) == 'f' || peek(length) == 'F' || peek(length) == 'l' || peek(length) == 'L') {
      ++length;
    }
    if (!ends_at(length)) {
      return refuse(word_length(), "is not a number",
                    peek(length) == 'j' || peek(length) == 'i'
                        ? "print the real part alone"
                        : "separate numbers by blanks or commas, with a point before decimals");
    }
    double value = 0;
    const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (error == std::errc::result_out_of_range) {
      // from_chars does not say whether the number is too large or too small for a double; strtod
      // returns infinity or a number near 0.
      value = std::strtod(plain.c_str(), nullptr);
    }
    if (std::isinf(float(value))) {  // because the stages compute in float
      return refuse(word_length(), "is too large for a float", "numbers go up to 3.4e38");
    }
    MatrixToken& token = push(MatrixToken::Kind::kNumber, length);
    token.value = value;
    token.digits = digits;
    token.decimals = point >= 0 && !has_exponent ? decimals : -1;
    return {};
  }

  // Whether this is a size such as "4x4", with which Blender's matrices begin.
  bool is_size() const {
    return peek() >= '1' && peek() <= '9' && peek(1) == 'x' && is_digit(peek(2)) && ends_at(3);
  }

  bool starts_with_at(std::size_t offset, std::string_view word) const {
    return text_.substr(std::min(text_.size(), at_ + offset)).starts_with(word);
  }

  // Reads "1.#INF", "-1.#IND" or "1.#QNAN0", which old C libraries of Windows print.
  Result<void> take_old_special(std::size_t sign, std::size_t length) {
    const bool infinite = starts_with_at(length, "#INF");
    const double magnitude = infinite ? std::numeric_limits<double>::infinity()
                                      : std::numeric_limits<double>::quiet_NaN();
    const double value = negative(sign) ? -magnitude : magnitude;
    ++length;
    while (is_letter(peek(length)) || is_digit(peek(length))) ++length;
    push(MatrixToken::Kind::kNumber, length).value = value;
    return {};
  }

  bool exponent_at(std::size_t length) const {
    const char c = peek(length);
    if (c != 'e' && c != 'E' && c != 'd' && c != 'D') return false;
    const char next = peek(length + 1);
    return is_digit(next) || ((next == '+' || next == '-') && is_digit(peek(length + 2)));
  }

  // Whether the text of a number can end after `length` bytes. A following '*' is refused: the
  // number would be a factor for the whole matrix, or part of an expression.
  bool ends_at(std::size_t length) const {
    const char c = peek(length);
    if (starts_with_at(length, "//") || starts_with_at(length, "/*")) return true;
    return !is_letter(c) && !is_digit(c) && !starts_with_at(length, "\u2212") &&
           (c == '\0' || std::string_view(".+-*/^%").find(c) == std::string_view::npos);
  }

  std::size_t word_length() const {
    std::size_t length = 0;
    while (at_ + length < text_.size() && length < 40) {
      const char c = peek(length);
      if (length > 0 && std::string_view(" \t\r\n,;()[]{}").find(c) != std::string_view::npos)
        break;
      ++length;
    }
    return length;
  }

  MatrixToken& push(MatrixToken::Kind kind, std::size_t length) {
    tokens_.push_back({kind, text_.substr(at_, length), line_, column_});
    advance(length);
    return tokens_.back();
  }

  Result<void> refuse(std::size_t length, const std::string& why, const std::string& remedy) const {
    return tl::unexpected(Error{name_, fmt::format("line {}, column {}", line_, column_),
                                in_quotes(std::string(text_.substr(at_, length))) + " " + why,
                                remedy});
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  std::vector<MatrixToken> tokens_;
};

}  // namespace

Result<std::vector<MatrixToken>> matrix_tokens(std::string_view text, const std::string& name) {
  return Lexer(text, name).run();
}

}  // namespace glassbox
