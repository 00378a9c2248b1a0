#include <glassbox/images/compare/tolerance.h>

#include <charconv>
#include <string_view>

namespace glassbox {
namespace {

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool read_count(std::string_view text, std::uint64_t& count) {
  text = trim(text);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  return error == std::errc{} && stop == end;
}

// "3" or "0-3".
bool read_range(std::string_view text, CountRange& range) {
  const auto dash = text.find('-');
  if (dash == std::string_view::npos) {
    if (!read_count(text, range.lowest)) return false;
    range.highest = range.lowest;
    return true;
  }
  return read_count(text.substr(0, dash), range.lowest) &&
         read_count(text.substr(dash + 1), range.highest) && range.lowest <= range.highest;
}

// Takes "name =" off the front, if it is there.
bool take_name(std::string_view& text, std::string_view name) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || trim(text.substr(0, equals)) != name) return false;
  text.remove_prefix(equals + 1);
  return true;
}

std::string to_string(const CountRange& range) {
  if (range.lowest == range.highest) return std::to_string(range.lowest);
  return std::to_string(range.lowest) + "-" + std::to_string(range.highest);
}

}  // namespace

Result<Fuzzy> parse_fuzzy(const std::string& text) {
  const std::string_view whole = text;
  const auto semicolon = whole.find(';');
  std::string_view first = whole.substr(0, semicolon);
  std::string_view second =
      semicolon == std::string_view::npos ? std::string_view{} : whole.substr(semicolon + 1);
  // The two may change places where they are named.
  if (take_name(first, "totalPixels")) {
    std::swap(first, second);
    if (!take_name(first, "maxDifference")) first = {};
  } else if (take_name(first, "maxDifference") && !take_name(second, "totalPixels")) {
    second = {};
  }
  Fuzzy fuzzy;
  if (!read_range(first, fuzzy.max_difference) || !read_range(second, fuzzy.total_pixels)) {
    return fail("", "not a tolerance: '" + text + "'",
                "write maxDifference=0-1;totalPixels=0-4 (ranges inclusive; a single number means "
                "exactly that number)");
  }
  return fuzzy;
}

std::string to_string(const Fuzzy& fuzzy) {
  return "maxDifference=" + to_string(fuzzy.max_difference) +
         ";totalPixels=" + to_string(fuzzy.total_pixels);
}

bool allows(const Fuzzy& fuzzy, const Differences& differences) {
  const bool none_is_fine = fuzzy.max_difference.lowest == 0 || fuzzy.total_pixels.lowest == 0;
  if (differences.differing == 0) return none_is_fine;
  return fuzzy.max_difference.has(differences.largest) &&
         fuzzy.total_pixels.has(differences.differing);
}

Fuzzy tightest(const Differences& differences) {
  return {{differences.largest, differences.largest},
          {differences.differing, differences.differing}};
}

}  // namespace glassbox
