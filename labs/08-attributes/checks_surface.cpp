// The expected answers of tasks 8.5 and 8.6, on curved surfaces: Bezier patches in exact rational
// numbers.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/number.h"
#include "labs/08-attributes/generators_surface.h"
#include "labs/08-attributes/surface_checks.h"
#include "labs/framework/compare.h"

namespace glassbox::labs {

namespace {

using namespace lab_08;
using exact::Decimal;
using exact::decimal_from;
using exact::Rational;

// ---- positions ----

using ExactPoint = std::array<Rational, 3>;
using Rows = std::array<std::array<ExactPoint, 4>, 4>;

Rows exact_rows(const Patch& patch) {
  Rows rows;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& p = patch.rows[j][i];
      rows[j][i] = {Rational(p.x), Rational(p.y), Rational(p.z)};
    }
  }
  return rows;
}

ExactPoint between(const ExactPoint& a, const ExactPoint& b, const Rational& t) {
  ExactPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + (b[k] - a[k]) * t;
  return p;
}

// The point of a Bezier curve at the parameter t, by De Casteljau's construction.
ExactPoint bezier_point(std::array<ExactPoint, 4> p, const Rational& t) {
  for (std::size_t left = 3; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) p[i] = between(p[i], p[i + 1], t);
  }
  return p[0];
}

// The four points at the parameter i / level of the rows, which are the control points of the curve
// down the patch.
std::array<ExactPoint, 4> points_down(const Rows& rows, int i, int level) {
  const Rational u = Rational(i) / Rational(level);
  return {bezier_point(rows[0], u), bezier_point(rows[1], u), bezier_point(rows[2], u),
          bezier_point(rows[3], u)};
}

ExactPoint patch_point(const Rows& rows, int i, int j, int level) {
  return bezier_point(points_down(rows, i, level), Rational(j) / Rational(level));
}

void add(const ExactPoint& p, std::vector<double>& numbers) {
  for (const Rational& x : p) numbers.push_back(double(x));
}

// The bound is 64 u (u = 2^-53 is the unit roundoff) times the largest coordinate, more than twice
// the error of either method. De Casteljau's construction has six steps of three roundings, 18 u.
// Also, an error of u in a parameter moves the point by up to 3 * 2 u of the largest coordinate,
// for each of the two parameters: 30 u together. A sum with Bernstein polynomials, in powers of t,
// rounds 9 times for a weight and 3 times for the sum, and this twice, along u and along v: 24 u.
double position_bound(const Patch& patch) {
  double largest = 0;
  for (const auto& row : patch.rows) {
    for (const auto& p : row)
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return 64 * unit_roundoff<double> * largest;
}

std::string patch_text(const Patch& patch) {
  std::string text;
  for (std::size_t j = 0; j < 4; ++j) {
    text += fmt::format("{}rows[{}]", j > 0 ? "\n" : "", j);
    for (const auto& p : patch.rows[j]) text += fmt::format(" ({:g}, {:g}, {:g})", p.x, p.y, p.z);
  }
  return text;
}

bool is_pole(const Patch& patch) {
  const auto& row = patch.rows[0];
  return row[0] == row[1] && row[1] == row[2] && row[2] == row[3];
}

std::vector<double> triangles_of(const PatchCase& input) {
  const int n = input.level;
  const bool pole = is_pole(input.patch);
  std::vector<double> triangles;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = j * (n + 1) + i, d = a + n + 1;
      if (!(pole && j == 0)) triangles.insert(triangles.end(), {a, a + 1, d + 1});
      triangles.insert(triangles.end(), {a, d + 1, d});
    }
  }
  return triangles;
}

Case expect_patch(const PatchCase& input) {
  const int n = input.level;
  const auto count = std::size_t(n) + 1;
  const Rows rows = exact_rows(input.patch);
  std::vector<double> positions(3 * count * count), exchanged(positions.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<ExactPoint, 4> down = points_down(rows, int(i), n);
    for (std::size_t j = 0; j < count; ++j) {
      const ExactPoint p = bezier_point(down, Rational(std::int64_t(j)) / Rational(n));
      for (std::size_t k = 0; k < 3; ++k) {
        positions[3 * (j * count + i) + k] = double(p[k]);
        exchanged[3 * (i * count + j) + k] = double(p[k]);
      }
    }
  }
  const bool pole = is_pole(input.patch);
  const std::vector<double> triangles = triangles_of(input);
  const Expected indices = numbers("triangles", triangles);
  const auto places = [&](std::vector<double> values) {
    return polygon("positions", 3, std::move(values), position_bound(input.patch));
  };
  return {.where = input.what,
          .restated = fmt::format("{}\n{} x {} cells{}", patch_text(input.patch), n, n,
                                  pole ? ", rows[0] is a pole" : ""),
          .expected = {places(positions), indices},
          .slipped = {{"row-column-order", {places(exchanged), indices}}}};
}

// A curve at i / n in double, with Bernstein's weights from integers: products, two sums and a
// quotient, 4 u of the largest coordinate (u: the unit roundoff).
std::array<double, 3> nearly_on_curve(const std::array<std::array<double, 3>, 4>& p, int i, int n) {
  const double a = n - i, b = i, whole = double(n) * n * n;
  const double weights[4] = {a * a * a, 3 * a * a * b, 3 * a * b * b, b * b * b};
  std::array<double, 3> sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum[k] = ((p[0][k] * weights[0] + p[1][k] * weights[1]) +
              (p[2][k] * weights[2] + p[3][k] * weights[3])) /
             whole;
  return sum;
}

std::array<std::array<double, 3>, 4> nearly_down(const Patch& patch, int i, int n) {
  std::array<std::array<double, 3>, 4> down;
  for (std::size_t j = 0; j < 4; ++j) {
    std::array<std::array<double, 3>, 4> row;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& p = patch.rows[j][k];
      row[k] = {p.x, p.y, p.z};
    }
    down[j] = nearly_on_curve(row, i, n);
  }
  return down;
}

// Positions in double are off by 8 u, an eighth of the bound (judge_nearly() allows half of it).
bool right_patch(const PatchCase& input, const Answer& answer) {
  const auto count = std::size_t(input.level) + 1;
  if (!has_numbers(answer, "triangles", triangles_of(input))) return false;
  std::vector<double> nearly(3 * count * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto down = nearly_down(input.patch, int(i), input.level);
    for (std::size_t j = 0; j < count; ++j) {
      const std::array<double, 3> p = nearly_on_curve(down, int(j), input.level);
      for (std::size_t k = 0; k < 3; ++k) nearly[3 * (j * count + i) + k] = p[k];
    }
  }
  const auto judged =
      judge_nearly(nearly, position_bound(input.patch), find_field(answer, "positions"));
  return judged ? *judged : !judge_case(expect_patch(input), answer);
}

// ---- seams ----

// Checks that the borders of both patches are within the bound of the exact border, and that they
// are equal to each other to the last bit.
std::optional<Divergence> judge_seam(const SeamCase& input, const Answer& answer) {
  const Rows rows = exact_rows(input.a);
  std::vector<double> border;
  for (int i = 0; i <= input.level; ++i)
    add(patch_point(rows, i, input.level, input.level), border);
  const std::string names[2] = {"border of the first patch", "border of the second patch"};
  for (const std::string& name : names) {
    const Expected expected = polygon(name, 3, border, position_bound(input.a));
    if (auto found = compare(expected, answer).first) return found;
  }
  auto found = compare(polygon(names[1], 3, *find_field(answer, names[0]), 0), answer).first;
  if (found)
    found->explanation = "the first patch has a different position there, which leaves a crack";
  return found;
}

Case expect_seam(const SeamCase& input) {
  return {
      .where = input.what,
      .restated = fmt::format(
          "{}\n{} x {} cells; the last row is a border of the second patch in the opposite order",
          patch_text(input.a), input.level, input.level),
      .judge = [input](const Answer& answer) { return judge_seam(input, answer); }};
}

bool right_seam(const SeamCase& input, const Answer& answer) {
  const auto* first = find_field(answer, "border of the first patch");
  const auto* second = find_field(answer, "border of the second patch");
  if (first == nullptr || second == nullptr || *first != *second) return false;
  std::vector<double> nearly;
  for (int i = 0; i <= input.level; ++i) {
    const std::array<double, 3> p =
        nearly_on_curve(nearly_down(input.a, i, input.level), input.level, input.level);
    nearly.insert(nearly.end(), p.begin(), p.end());
  }
  const auto judged = judge_nearly(nearly, position_bound(input.a), first);
  return judged ? *judged : !judge_case(expect_seam(input), answer);
}

// ---- levels ----

// A term of a difference of control points: factor P[j + dj][i + di]. longest() adds up the terms
// for every i and j for which all these points exist, and returns the length of the longest sum.
struct Term {
  std::size_t di, dj;
  int factor;
};
Decimal longest(const Rows& rows, const std::vector<Term>& terms) {
  std::size_t across = 0, down = 0;
  for (const Term& t : terms) across = std::max(across, t.di), down = std::max(down, t.dj);
  Rational largest;
  for (std::size_t j = 0; j + down < 4; ++j) {
    for (std::size_t i = 0; i + across < 4; ++i) {
      Rational squares;
      for (std::size_t k = 0; k < 3; ++k) {
        Rational sum;
        for (const Term& t : terms) sum += Rational(t.factor) * rows[j + t.dj][i + t.di][k];
        squares += sum * sum;
      }
      if (largest < squares) largest = squares;
    }
  }
  return sqrt(decimal_from(largest));
}

// The lengths of task 8.6 in double, and their sum with px_per_unit / 8. It rounds by less than
// either_level(), and not at all where nothing_rounds().
double nearly_at_level_1(const LevelCase& input) {
  const auto& p = input.patch.rows;
  const auto combined = [&](std::size_t j, std::size_t i, std::array<std::size_t, 2> right,
                            std::array<std::size_t, 2> down, std::array<std::size_t, 2> last) {
    const Vector<Object, double> v = (p[j + last[0]][i + last[1]] - p[j + right[0]][i + right[1]]) -
                                     (p[j + down[0]][i + down[1]] - p[j][i]);
    return std::sqrt(dot(v, v));
  };
  double uu = 0, uv = 0, vv = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      uu = std::max(uu, combined(a, b, {0, 1}, {0, 1}, {0, 2}));
      vv = std::max(vv, combined(b, a, {1, 0}, {1, 0}, {2, 0}));
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) uv = std::max(uv, combined(j, i, {0, 1}, {1, 0}, {1, 1}));
  }
  return (6 * uu + 18 * uv + 6 * vv) * input.px_per_unit / 8;
}

// Whether no step of task 8.6 has to round (student.h). All terms of Muu, Muv and Mvv are whole
// numbers below 2^26 in size, times 6 or 9. Both sides, times 8 level^2 / px_per_unit, are whole
// numbers below 2^33. So they are equal in double, too, or differ by far more than a rounding.
bool nothing_rounds(const LevelCase& input) {
  int exponent = 0;
  if (std::frexp(input.px_per_unit, &exponent) != 0.5) return false;
  const double n = input.tolerance_px / input.px_per_unit * 8;
  if (!(n < 0x1p13) || n != std::floor(n)) return false;
  std::array<bool, 3> used{};
  for (const auto& row : input.patch.rows) {
    for (const auto& p : row) {
      const std::array<double, 3> coordinates{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) {
        used[k] = used[k] || coordinates[k] != 0;
        if (std::abs(coordinates[k]) >= 0x1p24 || coordinates[k] != std::floor(coordinates[k]))
          return false;
      }
    }
  }
  return std::count(used.begin(), used.end(), true) <= 1;
}

// How far the two sides of the formula of task 8.6 may be apart, times level^2, for either answer
// to be right: 512 u C px_per_unit (u: the unit roundoff, C: the largest coordinate of a control
// point in size). A difference of four control points of coordinates up to C rounds by 8 u C. Three
// coordinates, times 6 or 9, make a length of at most 42 C or 63 C (with a factor of sqrt 3), which
// rounds by 5 u more: 300 u C for Muu and Mvv, 440 u C for Muv. Muu + 2 Muv + Mvv is at most 210 C
// and rounds by 4 u with its factors: 2320 u C together, of which 1/8 is 290 u C. The right side
// rounds twice, which is 53 u C where both sides are equal.
double either_level(const LevelCase& input) {
  if (nothing_rounds(input)) return 0;
  double largest = 0;
  for (const auto& row : input.patch.rows) {
    for (const auto& p : row)
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return 512 * unit_roundoff<double> * largest * input.px_per_unit;
}

Case expect_level(const LevelCase& input) {
  const Rows rows = exact_rows(input.patch);
  const Decimal uu = longest(rows, {{0, 0, 6}, {1, 0, -12}, {2, 0, 6}});
  const Decimal vv = longest(rows, {{0, 0, 6}, {0, 1, -12}, {0, 2, 6}});
  const Decimal uv = longest(rows, {{0, 0, 9}, {1, 0, -9}, {0, 1, -9}, {1, 1, 9}});
  const Decimal at_level_1 =
      nothing_rounds(input)
          ? Decimal(nearly_at_level_1(input))  // a decimal root of a square may round
          : (uu + Decimal(2) * uv + vv) * Decimal(input.px_per_unit) / Decimal(8);
  const auto first_level = [&](const Decimal& left) {
    int level = 1;
    while (level < 256 && Decimal(input.tolerance_px) * Decimal(level * level) < left) ++level;
    return level;
  };
  const int level = first_level(at_level_1);
  Case made{input.what,
            fmt::format("{}\n{} px to a unit, at most {} px; Muu {:.6g}, Muv {:.6g}, Mvv {:.6g}\n"
                        "glassbox study run D-26",
                        patch_text(input.patch), input.px_per_unit, input.tolerance_px, double(uu),
                        double(uv), double(vv)),
            {numbers("level", {double(level)})}};
  const Decimal either(either_level(input));
  const int lowest = first_level(at_level_1 - either), highest = first_level(at_level_1 + either);
  if (lowest < highest)
    made.judge = [lowest, highest, expected = made.expected](const Answer& answer) {
      const auto* given = find_field(answer, "level");
      if (given != nullptr && given->size() == 1) {
        const double each = (*given)[0];
        if (each >= lowest && each <= highest && each == std::floor(each))
          return std::optional<Divergence>();
      }
      return judge_case({.where = "", .restated = "", .expected = expected}, answer);
    };
  return made;
}

// Judges in double where that is enough: both sides are further apart than twice the distance at
// which either answer is right.
bool right_level(const LevelCase& input, const Answer& answer) {
  const auto* given = find_field(answer, "level");
  if (given == nullptr || given->size() != 1) return false;
  const double level = (*given)[0], either = 2 * either_level(input);
  if (!(level >= 1 && level <= 256) || level != std::floor(level)) return false;
  const double left = nearly_at_level_1(input);
  const auto is_enough = [&](double cells) -> std::optional<bool> {
    const double apart = input.tolerance_px * cells * cells - left;
    if (either > 0 && std::abs(apart) <= either) return std::nullopt;
    return apart >= 0;
  };
  const std::optional<bool> enough = level == 256 ? true : is_enough(level);
  const std::optional<bool> too_much = level == 1 ? false : is_enough(level - 1);
  if (enough && too_much) return *enough && !*too_much;
  return !judge_case(expect_level(input), answer);
}

}  // namespace

std::vector<Check> surface_checks() {
  return {
      check("a patch in cells", "8.5", "world", patches, expect_patch),
      check("patches meet", "8.5", "world", seams, expect_seam),
      generated_check("any patch", "8.5", "world", generated_patches, expect_patch, right_patch),
      generated_check("any two patches that meet", "8.5", "world", generated_seams, expect_seam,
                      right_seam),
      hidden_check("other patches in cells", "8.5", "world", hidden_patches, expect_patch),
      hidden_check("other patches meet", "8.5", "world", hidden_seams, expect_seam),
      check("the level of a patch", "8.6", "world", levels, expect_level),
      generated_check("the level of any patch", "8.6", "world", generated_levels, expect_level,
                      right_level),
      hidden_check("the level of other patches", "8.6", "world", hidden_levels, expect_level)};
}

}  // namespace glassbox::labs
