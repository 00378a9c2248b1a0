#include "labs/framework/compare.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>

namespace glassbox::labs {

namespace {

const char* const kAxes[] = {"x", "y", "z", "w"};

// The distance between two numbers in ulps of float. It is computed from the doubles if their
// floats are equal or neighbours, so it may be a fraction.
double float_ulps(double expected, double actual) {
  if (std::isnan(expected) || std::isnan(actual))
    return std::isnan(expected) == std::isnan(actual) ? 0 : std::numeric_limits<double>::infinity();
  const auto e = static_cast<float>(expected), a = static_cast<float>(actual);
  const std::uint64_t between = ulp_distance(e, a);
  if (between > 1 || !std::isfinite(e)) return double(between);
  return std::abs(expected - actual) / double(ulp(e));
}

// Whether a distance is given in ulps of double. The type that a student's function returned is not
// known, but a number that is not a float was not returned as one, and a bound below half an ulp of
// float can only be met in double.
bool are_doubles(const Divergence& found) {
  if (!std::isfinite(found.actual) || !std::isfinite(found.expected)) return false;
  const float expected = float(found.expected);
  return double(float(found.actual)) != found.actual ||
         (found.bound > 0 && std::isfinite(expected) && found.bound < double(ulp(expected)) / 2);
}

// The distance between two numbers, in ulps of the larger one.
double double_ulps(double expected, double actual) {
  const double larger = std::max(std::abs(expected), std::abs(actual));
  if (!std::isfinite(larger)) return std::numeric_limits<double>::infinity();
  const double next = std::nextafter(larger, std::numeric_limits<double>::infinity());
  return std::abs(expected - actual) / (next - larger);
}

double bound_at(const Expected& expected, std::size_t index) {
  return index < expected.bounds.size() ? expected.bounds[index] : expected.bound;
}

Divergence divergence_at(const Expected& expected, std::size_t index, Divergence::Kind kind) {
  return {.kind = kind,
          .field = expected.field,
          .index = index,
          .element = element_name(expected, index),
          .bound = bound_at(expected, index),
          .unit = expected.unit};
}

// What is wrong with a number that is in the answer, but is not as expected.
Divergence::Kind kind_of(const Expected& expected, std::size_t index, double actual) {
  const double wanted = expected.values[index];
  if (std::isnan(actual) && !std::isnan(wanted)) return Divergence::Kind::kNotANumber;
  switch (expected.shape) {
    case Shape::kCoverage:
      if (actual < wanted) return Divergence::Kind::kMissing;
      return Divergence::Kind::kExtra;
    case Shape::kPoint:
      return Divergence::Kind::kPosition;
    case Shape::kPolygon:  // a vertex is x, y, z, w, then its attributes
      return int(index) % columns_of(expected) < 4 ? Divergence::Kind::kPosition
                                                   : Divergence::Kind::kData;
    case Shape::kNumbers:
    case Shape::kMatrix:
      break;
  }
  return Divergence::Kind::kData;
}

// The divergence of an answer that is too short or too long: the first number that is missing, or
// the first one that is superfluous.
Divergence wrong_length(const Expected& expected, const std::vector<double>& actual) {
  const std::size_t wanted = expected.values.size(), given = actual.size();
  const std::size_t at = std::min(wanted, given);
  Divergence found = divergence_at(
      expected, at, given < wanted ? Divergence::Kind::kMissing : Divergence::Kind::kExtra);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  found.expected = at < wanted ? expected.values[at] : kNone;
  found.actual = at < given ? actual[at] : kNone;
  found.distance = found.ulps = std::numeric_limits<double>::infinity();
  const auto columns = std::size_t(columns_of(expected));
  if (expected.shape == Shape::kPolygon && wanted % columns == 0 && given % columns == 0) {
    found.explanation = fmt::format("a polygon of {} vertices is expected, but it has {}",
                                    wanted / columns, given / columns);
  } else {
    found.explanation = fmt::format("{} numbers are expected, but there are {}", wanted, given);
  }
  return found;
}

bool is_within_bound(const Expected& expected, std::size_t index, double actual) {
  return distance_between(expected.values[index], actual) <= bound_at(expected, index);
}

CoverageCounts count_coverage(const Expected& expected, const std::vector<double>& actual) {
  CoverageCounts counts;
  for (std::size_t i = 0; i < std::min(expected.values.size(), actual.size()); ++i) {
    if (is_within_bound(expected, i, actual[i])) continue;
    if (actual[i] < expected.values[i]) {
      ++counts.gaps;
    } else if (expected.values[i] > 0) {
      ++counts.doubles;
    } else {
      ++counts.extra;
    }
  }
  return counts;
}

char map_letter(const Expected& expected, const std::vector<double>& actual, std::size_t i) {
  if (i >= actual.size()) return '?';
  if (is_within_bound(expected, i, actual[i])) return expected.values[i] > 0 ? '#' : '.';
  if (!(actual[i] >= expected.values[i])) return 'o';
  return expected.values[i] > 0 ? '2' : '+';
}

// The pixels around the first wrong pixel, drawn as text with their coordinates at the edges.
std::string coverage_map(const Expected& expected, const std::vector<double>& actual,
                         std::size_t centre) {
  constexpr int kAcross = 41, kDown = 17;
  const int width = columns_of(expected);
  const int height = int((expected.values.size() + std::size_t(width) - 1) / std::size_t(width));
  const int cx = int(centre) % width, cy = int(centre) / width;
  const int left = std::clamp(cx - kAcross / 2, 0, std::max(0, width - kAcross));
  const int top = std::clamp(cy - kDown / 2, 0, std::max(0, height - kDown));
  const int right = std::min(width, left + kAcross), bottom = std::min(height, top + kDown);
  std::string map = fmt::format("      x = {} to {}\n", left, right - 1);
  for (int y = top; y < bottom; ++y) {
    map += fmt::format("{:>4}  ", y);
    for (int x = left; x < right; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
      if (i < expected.values.size()) map += map_letter(expected, actual, i);
    }
    map += y == cy ? " <\n" : "\n";
  }
  return map + fmt::format("      {:>{}}\n", "^", cx - left + 1) +
         "      # right  . not covered  o missing  2 covered too often  + covered, but should not "
         "be\n";
}

}  // namespace

int columns_of(const Expected& expected) {
  const auto size = expected.values.size();
  switch (expected.shape) {
    case Shape::kMatrix: {
      const auto side = std::size_t(std::lround(std::sqrt(double(size))));
      if (expected.columns > 0) return expected.columns;
      return side > 0 && side * side == size ? int(side) : 4;
    }
    case Shape::kPolygon:
      return expected.columns > 0 ? expected.columns : 4;
    case Shape::kCoverage:
      return expected.columns > 0 ? expected.columns : std::max(1, int(size));
    case Shape::kNumbers:
    case Shape::kPoint:
      break;
  }
  return 0;
}

std::string element_name(const Expected& expected, std::size_t index) {
  const auto columns = std::size_t(std::max(1, columns_of(expected)));
  switch (expected.shape) {
    case Shape::kMatrix:
      return fmt::format("row {}, column {}", index / columns, index % columns);
    case Shape::kPolygon: {
      const std::size_t at = index % columns;
      const std::string part = at < 4 ? kAxes[at] : fmt::format("attribute {}", at - 4);
      return fmt::format("vertex {}, {}", index / columns, part);
    }
    case Shape::kCoverage:
      return fmt::format("pixel ({}, {})", index % columns, index / columns);
    case Shape::kPoint:
      return index < 4 ? kAxes[index] : fmt::format("number {}", index);
    case Shape::kNumbers:
      break;
  }
  return expected.values.size() == 1 && index == 0 ? "" : fmt::format("number {}", index);
}

double distance_between(double expected, double actual) {
  if (std::isnan(expected) && std::isnan(actual)) return 0;
  if (expected == actual) return 0;
  const double distance = std::abs(expected - actual);
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

Comparison compare(const Expected& expected, const std::vector<double>& actual) {
  Comparison result;
  const std::size_t both = std::min(expected.values.size(), actual.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (is_within_bound(expected, i, actual[i])) continue;
    ++result.differing;
    if (result.first) continue;
    Divergence found = divergence_at(expected, i, kind_of(expected, i, actual[i]));
    found.expected = expected.values[i];
    found.actual = actual[i];
    found.distance = distance_between(found.expected, found.actual);
    found.ulps_of_double = are_doubles(found);
    found.ulps = found.ulps_of_double ? double_ulps(found.expected, found.actual)
                                      : float_ulps(found.expected, found.actual);
    result.first = found;
  }
  if (actual.size() != expected.values.size()) {
    result.differing += std::max(expected.values.size(), actual.size()) - both;
    if (!result.first) {
      result.first = wrong_length(expected, actual);
    } else if (result.first->explanation.empty()) {
      result.first->explanation = wrong_length(expected, actual).explanation;
    }
  }
  if (expected.shape == Shape::kCoverage && result.first && !expected.values.empty()) {
    result.coverage = count_coverage(expected, actual);
    result.map =
        coverage_map(expected, actual, std::min(result.first->index, expected.values.size() - 1));
    if (result.first->explanation.empty()) {
      result.first->explanation = fmt::format(
          "{} missing, {} covered too often, {} covered, but should not be",
          counted(result.coverage.gaps, "pixel"), result.coverage.doubles, result.coverage.extra);
    }
  }
  return result;
}

Comparison compare(const Expected& expected, const Answer& answer) {
  if (const auto* actual = find_field(answer, expected.field)) return compare(expected, *actual);
  Comparison result;
  result.first = divergence_at(expected, 0, Divergence::Kind::kMissing);
  result.first->element.clear();
  result.first->expected = expected.values.empty() ? 0 : expected.values[0];
  result.first->actual = std::numeric_limits<double>::quiet_NaN();
  result.first->distance = result.first->ulps = std::numeric_limits<double>::infinity();
  result.first->explanation = "all numbers of this field are missing";
  result.differing = expected.values.size();
  return result;
}

std::optional<Divergence> judge_case(const Case& input, const Answer& answer) {
  if (input.judge) return input.judge(answer);
  for (const Expected& expected : input.expected) {
    if (auto found = compare(expected, answer).first) return found;
  }
  return std::nullopt;
}

// Whether there are as many numbers, each at most its bound away from the right one.
template <class BoundAt>
static bool are_near(const std::vector<double>* actual, const std::vector<double>& right,
                     BoundAt bound_at_index) {
  if (actual == nullptr || actual->size() != right.size()) return false;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (!(distance_between(right[i], (*actual)[i]) <= bound_at_index(i))) return false;
  }
  return true;
}

bool has_numbers(const Answer& answer, const std::string& field, const std::vector<double>& right,
                 double bound) {
  return are_near(find_field(answer, field), right, [bound](std::size_t) { return bound; });
}

bool has_field(const Answer& answer, const Expected& right) {
  return are_near(find_field(answer, right.field), right.values,
                  [&](std::size_t i) { return bound_at(right, i); });
}

bool has_fields(const Answer& answer, const std::vector<Expected>& right) {
  return std::all_of(right.begin(), right.end(),
                     [&](const Expected& each) { return has_field(answer, each); });
}

std::optional<bool> judge_nearly(const Expected& nearly, const std::vector<double>* actual) {
  if (actual == nullptr || actual->size() != nearly.values.size()) return false;
  std::optional<bool> right = true;
  for (std::size_t i = 0; i < actual->size(); ++i) {
    const double distance = distance_between(nearly.values[i], (*actual)[i]);
    const double bound = bound_at(nearly, i);
    if (distance > 2 * bound) return false;
    if (!(distance <= bound / 2)) right = std::nullopt;
  }
  return right;
}

const std::vector<double>* find_field(const Answer& answer, const std::string& name) {
  for (const Answer::Field& field : answer.fields()) {
    if (field.name == name) return &field.values;
  }
  return nullptr;
}

const char* kind_name(Divergence::Kind kind) {
  constexpr const char* kNames[] = {"missing", "extra", "wrong position", "wrong data",
                                    "not a number"};
  static_assert(std::size(kNames) == std::size_t(Divergence::Kind::kNotANumber) + 1);
  return kNames[int(kind)];
}

}  // namespace glassbox::labs
