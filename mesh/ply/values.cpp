#include <glassbox/mesh/ply/values.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <glassbox/base/little_endian.h>
#include <glassbox/mesh/input/text.h>

namespace glassbox::ply {
namespace {

constexpr const char* kEnd = "the file ends where a number is expected";

template <class T>
double from_bytes(std::string_view bytes, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data(), sizeof(T));
  if (swapped) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

// Calls `use` with a value of the C++ type that belongs to `type`.
template <class Use>
auto with_type(Type type, Use use) {
  switch (type) {
    case Type::kInt8:
      return use(std::int8_t());
    case Type::kUint8:
      return use(std::uint8_t());
    case Type::kInt16:
      return use(std::int16_t());
    case Type::kUint16:
      return use(std::uint16_t());
    case Type::kInt32:
      return use(std::int32_t());
    case Type::kUint32:
      return use(std::uint32_t());
    case Type::kFloat64:
      return use(double());
    case Type::kFloat32:
      break;
  }
  return use(float());
}

// Parses a double. Numbers that round to infinity are infinite, numbers that round to zero are
// zero. "nan" and "inf" have their own values.
bool parse_double(std::string_view word, double& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, number);
  if (parsed.ptr != end || parsed.ec == std::errc::invalid_argument) return false;
  if (parsed.ec == std::errc()) return true;
  // from_chars does not say whether the number is too large or too small; the test for floats is
  // right here, too: a number outside the range of double is outside that of float, at the same
  // end.
  const bool tiny = obj::parse_number(word).kind == obj::Number::Kind::kFinite;
  number = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  if (word.starts_with('-')) number = -number;
  return true;
}

bool parse_float(std::string_view word, double& number) {
  const obj::Number parsed = obj::parse_number(word);
  if (parsed.kind == obj::Number::Kind::kFinite) {
    number = double(parsed.value);
    return true;
  }
  return parsed.kind == obj::Number::Kind::kNotFinite && parse_double(word, number);
}

template <class Integer>
bool parse_integer(std::string_view word, double& number) {
  const auto parsed = obj::parse_integer(word);
  if (!parsed || !std::in_range<Integer>(*parsed)) return false;
  number = double(*parsed);
  return true;
}

}  // namespace

std::string Values::position_text() const {
  if (format_ == Format::kAscii) return "line " + std::to_string(line_);
  return "byte " + std::to_string(size_ - rest_.size());
}

bool Values::next(Type type, double& number) {
  return format_ == Format::kAscii ? next_text(type, number) : next_binary(type, number);
}

bool Values::next_binary(Type type, double& number) {
  const std::size_t bytes = bytes_of(type);
  if (rest_.size() < bytes) return refuse(kEnd);
  number = with_type(type, [&](auto value) {
    return from_bytes<decltype(value)>(rest_, format_ == Format::kBigEndian);
  });
  rest_.remove_prefix(bytes);
  return true;
}

bool Values::next_text(Type type, double& number) {
  constexpr std::string_view kBlanks = " \t\v\f\r\n";
  std::size_t begin = 0;
  for (; begin < rest_.size() && kBlanks.find(rest_[begin]) != std::string_view::npos; ++begin) {
    const bool second_half = rest_[begin] == '\n' && begin > 0 && rest_[begin - 1] == '\r';
    line_ += (rest_[begin] == '\r' || rest_[begin] == '\n') && !second_half;
  }
  rest_.remove_prefix(begin);
  if (rest_.empty()) return refuse(kEnd);
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  const bool good = with_type(type, [&](auto value) {
    using T = decltype(value);
    if constexpr (std::is_integral_v<T>) {
      return parse_integer<T>(word, number);
    } else if constexpr (std::is_same_v<T, float>) {
      return parse_float(word, number);
    } else {
      return parse_double(word, number);
    }
  });
  return good || refuse(in_quotes(word) + " is not a number of the type that the header names");
}

}  // namespace glassbox::ply
