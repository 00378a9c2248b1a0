#include <glassbox/compare/pixels/tolerance.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>

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

constexpr std::size_t kShareDecimals = 6;
constexpr std::uint64_t kOnePercent = 1'000'000;  // in the unit of a share

// Reads a percentage without its sign: "0.1" is 100000 millionths.
bool read_share(std::string_view text, std::uint64_t& share) {
  text = trimmed(text);
  const auto point = std::min(text.find('.'), text.size());
  std::string decimals(point < text.size() ? text.substr(point + 1) : "");
  if (point + 1 == text.size() || decimals.size() > kShareDecimals) return false;
  if (text.find_first_not_of("0123456789.") != text.npos) return false;
  decimals.resize(kShareDecimals, '0');
  std::uint64_t whole = 0, part = 0;
  if (!read_count(text.substr(0, point), whole) || !read_count(decimals, part)) return false;
  if (whole > 100) return false;
  share = whole * kOnePercent + part;
  return share <= 100 * kOnePercent;
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

Fuzzy lasting_fuzzy(const Differences& differences) {
  return {{0, differences.largest}, {0, differences.differing}};
}

Result<MaxDiffering> parse_max_differing(const std::string& text) {
  std::string_view number = trimmed(text);
  MaxDiffering most;
  const bool percent = number.ends_with('%');
  if (percent) number.remove_suffix(1);
  std::uint64_t share = 0;
  const bool good = percent ? read_share(number, share) : read_count(number, most.pixels);
  if (!good) {
    return fail("", "not a number of pixels, nor a share up to 100%: " + in_quotes(text),
                "write a whole number, as in 12, or a percentage, as in 0.1%");
  }
  if (percent) most.share = share;
  return most;
}

std::string to_string(const MaxDiffering& most) {
  if (!most.share) return std::to_string(most.pixels);
  std::string text = fmt::format("{}.{:06}", *most.share / kOnePercent, *most.share % kOnePercent);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text + "%";
}

bool allows(const MaxDiffering& most, const Differences& differences) {
  if (differences.largest == kUnbounded) return false;
  if (!most.share) return differences.differing <= most.pixels;
  // Both products stay below 2^60: at most 2^28 pixels are compared.
  return differences.differing * 100 * kOnePercent <= *most.share * differences.compared;
}

MaxDiffering tightest_like(const MaxDiffering& most, const Differences& differences) {
  if (!most.share) return {differences.differing, {}};
  const std::uint64_t parts = differences.differing * 100 * kOnePercent;
  return {0, (parts + differences.compared - 1) / differences.compared};
}

Result<double> parse_threshold(const std::string& text) {
  const std::string_view number = trimmed(text);
  double threshold = 0;
  const char* end = number.data() + number.size();
  const auto [stop, error] =
      std::from_chars(number.data(), end, threshold, std::chars_format::fixed);
  if (error != std::errc{} || stop != end || !(threshold >= 0 && threshold <= 1)) {
    return fail("", "not a threshold: " + in_quotes(text), "write a number from 0 to 1, as in 0.1");
  }
  return threshold;
}

}  // namespace glassbox
