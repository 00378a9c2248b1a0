#include <glassbox/mesh/input/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <glassbox/base/counted.h>
#include <glassbox/base/utf8.h>

namespace glassbox::obj {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Whether a decimal number outside the range of float is too large, and not too small: it is too
// large if, with the exponent applied, its first digit that is not zero is before the decimal
// point.
bool is_too_large(std::string_view number) {
  const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  // The decimal place of the first digit that is not zero: 0 for units, -1 for tenths.
  const std::int64_t place =
      first < point ? std::int64_t(point - first) - 1 : -std::int64_t(first - point);
  std::int64_t exponent = 0;
  if (mantissa_end < number.size()) {
    std::string_view digits = number.substr(mantissa_end + 1);
    const bool negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    // If the exponent does not fit in an int64, only its sign matters: no mantissa in memory has
    // enough digits to make up for it.
    if (parsed.ec == std::errc::result_out_of_range) return !negative;
    if (negative) exponent = -exponent;
  }
  return exponent >= -place;
}

}  // namespace

std::string_view without_comment(std::string_view text) {
  for (std::size_t hash = text.find('#'); hash != std::string_view::npos;
       hash = text.find('#', hash + 1)) {
    if (hash == 0 || kBlanks.find(text[hash - 1]) != std::string_view::npos) {
      return trimmed(text.substr(0, hash));
    }
  }
  return text;
}

Lines::Lines(std::string_view text) : rest_(without_byte_order_mark(text)) {
  if (const auto order = utf16_byte_order(text)) {
    converted_ = utf8_of_utf16(text, *order);
    rest_ = converted_;
  }
}

std::string_view Lines::take_physical_line() {
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
  if (!rest_.empty()) rest_.remove_prefix(1);
  ++lines_taken_;
  return line;
}

bool Lines::next() {
  while (!rest_.empty()) {
    std::string_view line = take_physical_line();
    first_line_ = lines_taken_;
    line_ = trimmed(line);
    if (line_.starts_with('#')) continue;
    if (line.ends_with('\\')) {
      joined_.clear();
      while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1));
        joined_ += ' ';
        line = take_physical_line();
      }
      joined_.append(line);
      line_ = trimmed(joined_);
    }
    if (!line_.empty()) return true;
  }
  return false;
}

std::string_view Words::next() {
  if (rest_.starts_with('#')) rest_ = {};
  const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  const std::size_t first = rest_.find_first_not_of(kBlanks);
  rest_.remove_prefix(std::min(first, rest_.size()));
  return word;
}

Number parse_number(std::string_view word) {
  // from_chars does not accept a plus sign.
  if (word.starts_with('+') && word.size() > 1 && (is_digit(word[1]) || word[1] == '.')) {
    word.remove_prefix(1);
  }
  Number number;
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, number.value);
  if (parsed.ec == std::errc::invalid_argument || parsed.ptr != end) return {};
  if (parsed.ec == std::errc::result_out_of_range) {
    // from_chars does not say whether the number is too large or too small, nor does it keep the
    // sign of a zero.
    if (is_too_large(word)) return {Number::Kind::kNotFinite, 0};
    return {Number::Kind::kFinite, word.starts_with('-') ? -0.0f : 0.0f};
  }
  if (!std::isfinite(number.value)) return {Number::Kind::kNotFinite, 0};
  number.kind = Number::Kind::kFinite;
  return number;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && is_digit(word[1])) word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, value);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

void Warnings::add(std::string text) {
  if (kept_.size() < kMaxKept) {
    kept_.push_back(std::move(text));
  } else {
    ++dropped_;
  }
}

std::vector<std::string> Warnings::take() {
  if (dropped_ > 0) kept_.push_back("and " + counted(dropped_, "more warning"));
  dropped_ = 0;
  return std::move(kept_);
}

void OccurrenceCount::report(std::string_view one, std::string_view many, Warnings& warnings,
                             const char* where) const {
  if (count_ == 0) return;
  warnings.add(counted(count_, one, many) + " (first" + where + " " + std::to_string(first_) + ")");
}

}  // namespace glassbox::obj
