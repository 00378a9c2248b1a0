// How much a picture may differ from its reference: not at all by default; otherwise within limits
// that must all hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// A range of numbers that includes its first and its last number.
struct CountRange {
  std::uint64_t lowest = 0;
  std::uint64_t highest = 0;
  bool has(std::uint64_t count) const { return lowest <= count && count <= highest; }
  friend bool operator==(const CountRange&, const CountRange&) = default;
};

// The fuzzy annotation of the web-platform-tests: the largest difference of a channel, in steps,
// and the number of pixels that differ
// (https://web-platform-tests.org/writing-tests/reftests.html).
struct Fuzzy {
  CountRange max_difference;  // steps
  CountRange total_pixels;
  friend bool operator==(const Fuzzy&, const Fuzzy&) = default;
};

// Parses "maxDifference=0-1;totalPixels=0-4". The names may be left out ("0-1;0-4"), and parts with
// names may be in either order. A single number means exactly that number.
Result<Fuzzy> parse_fuzzy(const std::string& text);
std::string to_string(const Fuzzy& fuzzy);

// Whether the largest difference and the number of differing pixels are within their ranges.
// Pictures that do not differ at all pass if a range starts at 0; no range allows kUnbounded.
bool allows(const Fuzzy& fuzzy, const Differences& differences);

// The annotation that allows exactly these differences.
Fuzzy tightest_fuzzy(const Differences& differences);

// The annotation that allows these differences and everything smaller.
Fuzzy lasting_fuzzy(const Differences& differences);

// How many pixels may differ: a number, or a share of the pixels that are compared.
struct MaxDiffering {
  std::uint64_t pixels = 0;  // valid unless there is a share
  // In millionths of a percent, so that shares are exact: at most 10^8.
  std::optional<std::uint64_t> share = {};
  friend bool operator==(const MaxDiffering&, const MaxDiffering&) = default;
};

// Parses a whole number ("12") or a percentage with at most six decimals ("0.1%").
Result<MaxDiffering> parse_max_differing(const std::string& text);
std::string to_string(const MaxDiffering& most);

// Whether no more pixels differ. A difference of kUnbounded is never allowed.
bool allows(const MaxDiffering& most, const Differences& differences);

// The smallest number or share, whichever `most` is, that allows these differences; a share is
// rounded up to a millionth of a percent.
MaxDiffering tightest_like(const MaxDiffering& most, const Differences& differences);

// Parses a number from 0 to 1: a distance of perceived_distance.h.
Result<double> parse_threshold(const std::string& text);

struct Tolerance {
  std::optional<Fuzzy> fuzzy;
  // The largest allowed distance of two samples; for pictures of floats only.
  std::optional<std::uint32_t> max_ulp;
  std::optional<MaxDiffering> max_differing;
  // What is not counted as a difference. No pixel may lie above a threshold, unless `fuzzy` or
  // `max_differing` allow some.
  SetAside set_aside;
  bool empty() const { return !fuzzy && !max_ulp && !max_differing && set_aside.empty(); }
};

// Parses a whole number of ulps below kUnbounded.
Result<std::uint32_t> parse_max_ulp(const std::string& text);

}  // namespace glassbox
