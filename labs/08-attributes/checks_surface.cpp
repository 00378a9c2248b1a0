// The expected answers of tasks 8.5 and 8.6, on curved surfaces: Bezier patches in exact rational
// numbers.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/number.h"
#include "labs/08-attributes/cases.h"
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

ExactPoint patch_point(const Rows& rows, int i, int j, int level) {
  const Rational u = Rational(i) / Rational(level), v = Rational(j) / Rational(level);
  return bezier_point({bezier_point(rows[0], u), bezier_point(rows[1], u), bezier_point(rows[2], u),
                       bezier_point(rows[3], u)},
                      v);
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

Case expect_patch(const PatchCase& input) {
  const int n = input.level;
  const Rows rows = exact_rows(input.patch);
  std::vector<double> positions, exchanged, triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      add(patch_point(rows, i, j, n), positions);
      add(patch_point(rows, j, i, n), exchanged);
    }
  }
  const bool pole =
      rows[0][0] == rows[0][1] && rows[0][1] == rows[0][2] && rows[0][2] == rows[0][3];
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = j * (n + 1) + i, d = a + n + 1;
      if (!(pole && j == 0)) triangles.insert(triangles.end(), {a, a + 1, d + 1});
      triangles.insert(triangles.end(), {a, d + 1, d});
    }
  }
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

Case expect_level(const LevelCase& input) {
  const Rows rows = exact_rows(input.patch);
  const Decimal uu = longest(rows, {{0, 0, 6}, {1, 0, -12}, {2, 0, 6}});
  const Decimal vv = longest(rows, {{0, 0, 6}, {0, 1, -12}, {0, 2, 6}});
  const Decimal uv = longest(rows, {{0, 0, 9}, {1, 0, -9}, {0, 1, -9}, {1, 1, 9}});
  const Decimal at_level_1 = (uu + Decimal(2) * uv + vv) * Decimal(input.px_per_unit) / Decimal(8);
  int level = 1;
  while (level < 256 && Decimal(input.tolerance_px) * Decimal(level * level) < at_level_1) ++level;
  return {input.what,
          fmt::format("{}\n{} px to a unit, at most {} px; Muu {:.6g}, Muv {:.6g}, Mvv {:.6g}\n"
                      "glassbox study run D-26",
                      patch_text(input.patch), input.px_per_unit, input.tolerance_px, double(uu),
                      double(uv), double(vv)),
          {numbers("level", {double(level)})}};
}

}  // namespace

std::vector<Check> surface_checks() {
  return {check("a patch in cells", "8.5", "world", patches, expect_patch),
          check("patches meet", "8.5", "world", seams, expect_seam),
          hidden_check("other patches in cells", "8.5", "world", hidden_patches, expect_patch),
          hidden_check("other patches meet", "8.5", "world", hidden_seams, expect_seam),
          check("the level of a patch", "8.6", "world", levels, expect_level),
          hidden_check("the level of other patches", "8.6", "world", hidden_levels, expect_level)};
}

}  // namespace glassbox::labs
