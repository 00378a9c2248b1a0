#include <glassbox/compare/pixels/tolerance.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include <glassbox/base/printable.h>
#include <glassbox/base/trimmed.h>

namespace glassbox {
namespace {

constexpr std::string_view kMaxDifference = "maxDifference";
constexpr std::string_view kTotalPixels = "totalPixels";

bool read_count(std::string_view text, std::uint64_t& count) {
  text = trimmed(text);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  return error == std::errc{} && stop == end;
}

// Reads "3" or "0-3".
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

struct NamedRange {
  std::string_view name;  // empty: identified by its position
  CountRange range;
};

// Reads "name=range" or "range".
bool read_named_range(std::string_view text, NamedRange& named) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) return read_range(text, named.range);
  named.name = trimmed(text.substr(0, equals));
  const bool known = named.name == kMaxDifference || named.name == kTotalPixels;
  return known && read_range(text.substr(equals + 1), named.range);
}

std::string to_string(const CountRange& range) {
  if (range.lowest == range.highest) return std::to_string(range.lowest);
  return std::to_string(range.lowest) + "-" + std::to_string(range.highest);
}

}  // namespace

Result<Fuzzy> parse_fuzzy(const std::string& text) {
  const std::string_view whole = text;
  const auto semicolon = std::min(whole.find(';'), whole.size());
  NamedRange first, second;
  const bool good = semicolon < whole.size() &&
                    read_named_range(whole.substr(0, semicolon), first) &&
                    read_named_range(whole.substr(semicolon + 1), second) &&
                    (first.name.empty() || first.name != second.name);
  if (!good) {
    return fail("", "not a tolerance: " + in_quotes(text),
                "write maxDifference=0-1;totalPixels=0-4 (ranges inclusive; a single number means "
                "exactly that number)");
  }
  // Named parts may be in either order.
  const bool swapped = first.name == kTotalPixels || second.name == kMaxDifference;
  if (swapped) std::swap(first, second);
  return Fuzzy{first.range, second.range};
}

Result<std::uint32_t> parse_max_ulp(const std::string& text) {
  std::uint64_t ulps = 0;
  if (!read_count(text, ulps) || ulps >= kUnbounded) {
    return fail("", "not a number of ulps: " + in_quotes(text), "write a whole number, as in 4");
  }
  return std::uint32_t(ulps);
}

std::string to_string(const Fuzzy& fuzzy) {
  return "maxDifference=" + to_string(fuzzy.max_difference) +
         ";totalPixels=" + to_string(fuzzy.total_pixels);
}

bool allows(const Fuzzy& fuzzy, const Differences& differences) {
  const bool none_is_fine = fuzzy.max_difference.lowest == 0 || fuzzy.total_pixels.lowest == 0;
  if (differences.differing == 0) return none_is_fine;
  return differences.largest != kUnbounded && fuzzy.max_difference.has(differences.largest) &&
         fuzzy.total_pixels.has(differences.differing);
}

Fuzzy tightest_fuzzy(const Differences& differences) {
  return {{differences.largest, differences.largest},
          {differences.differing, differences.differing}};
}

}  // namespace glassbox
