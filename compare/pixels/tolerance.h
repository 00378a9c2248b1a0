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

struct Tolerance {
  std::optional<Fuzzy> fuzzy;
  // The largest allowed distance of two samples; for pictures of floats only.
  std::optional<std::uint32_t> max_ulp;
  bool empty() const { return !fuzzy && !max_ulp; }
};

// Parses a whole number of ulps below kUnbounded.
Result<std::uint32_t> parse_max_ulp(const std::string& text);

}  // namespace glassbox
