// The typical mistakes (slips) in an angle or in the order of a product: the numbers that they lead
// to.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "labs/framework/compare.h"
#include "labs/framework/slip_variants.h"

namespace glassbox::labs {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The answer that a typical mistake leads to: `values`, with a larger error bound than that of the
// right answer, because the mistake can also enlarge the rounding errors. An angle times
// 180/pi = 57.3 has 57.3 times the error, so the bound is 64 times that of the right answer. It is
// at least 1e-5 of the largest number (for a matrix: of at least 1), which is more than 100
// roundings of float but still far from any other angle.
Expected slipped(const Expected& field, std::vector<double> values) {
  Expected changed = field;
  double largest = field.shape == Shape::kMatrix ? 1 : 0;
  for (const double each : values) largest = std::max(largest, std::abs(each));
  changed.values = std::move(values);
  changed.bound = std::max(64 * field.bound, 1e-5 * largest);
  changed.bounds.clear();
  return changed;
}

using AngleSlip = double (*)(double radians);
double doubled(double a) {
  return 2 * a;
}
double halved(double a) {
  return a / 2;
}
double degrees_as_radians(double a) {
  return a / kDegree;
}
double radians_as_degrees(double a) {
  return a * kDegree;
}

struct Rotation {
  std::array<double, 3> axis;
  double angle;  // radians, in [0, pi)
};

// The rotation in the upper left 3 x 3 part of the matrix; nothing if that part is not a rotation,
// or one by 0 or pi, whose axis is not exact.
std::optional<Rotation> rotation_of(const std::vector<double>& m, std::size_t side) {
  const auto at = [&](std::size_t i, std::size_t j) { return m[i * side + j]; };
  constexpr double kTolerance = 1e-4;  // for the products of rows of a matrix of floats
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double dot = 0;
      for (std::size_t k = 0; k < 3; ++k) dot += at(i, k) * at(j, k);
      if (std::abs(dot - (i == j ? 1 : 0)) > kTolerance) return std::nullopt;
    }
  }
  const double x = at(2, 1) - at(1, 2), y = at(0, 2) - at(2, 0), z = at(1, 0) - at(0, 1);
  const double sine = std::sqrt(x * x + y * y + z * z) / 2;
  const double cosine = (at(0, 0) + at(1, 1) + at(2, 2) - 1) / 2;
  if (sine < 1e-3 || std::abs(sine * sine + cosine * cosine - 1) > kTolerance) return std::nullopt;
  return Rotation{{x / (2 * sine), y / (2 * sine), z / (2 * sine)}, std::atan2(sine, cosine)};
}

std::vector<double> rotated(const std::vector<double>& m, std::size_t side,
                            const std::array<double, 3>& n, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
  std::vector<double> changed = m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      changed[i * side + j] = (i == j ? c : 0) + (1 - c) * n[i] * n[j] + s * cross[i][j];
  }
  return changed;
}

bool is_projection(const std::vector<double>& m) {
  return m.size() == 16 && m[15] == 0 && std::abs(m[14]) > 0 && m[0] != 0 && m[5] != 0;
}

// The expected field with the mistake `slip` in its angle: a number in radians, the field of view
// of a projection, or the angle of a rotation. A rotation matrix does not show whether its angle is
// a, a - 2 pi or a + 2 pi, so all three are tried.
std::vector<Expected> slip_angle(const Expected& field, AngleSlip slip) {
  std::vector<Expected> all;
  const auto& values = field.values;
  if (field.shape == Shape::kNumbers && values.size() == 1 && field.unit == "radian")
    return {slipped(field, {slip(values[0])})};
  const auto side = std::size_t(std::max(0, columns_of(field)));
  if (field.shape != Shape::kMatrix || side * side != values.size() || side < 3) return all;
  if (is_projection(values)) {
    // values[5] is cot(fovy / 2), values[0] is values[5] divided by the aspect ratio.
    const double half = std::atan2(1, std::abs(values[5]));
    const double factor = 1 / std::tan(slip(2 * half) / 2) / std::abs(values[5]);
    std::vector<double> changed = values;
    changed[0] *= factor;
    changed[5] *= factor;
    return {slipped(field, std::move(changed))};
  }
  if (const auto rotation = rotation_of(values, side)) {
    for (const int turns : {0, -1, 1}) {
      const double angle = rotation->angle + 2 * std::numbers::pi * turns;
      all.push_back(slipped(field, rotated(values, side, rotation->axis, slip(angle))));
    }
  }
  return all;
}

// The matrix [L | t] is the product of the linear map L and a translation. If these two factors are
// in the wrong order, the last column is L t where the translation should act last, and L^-1 t
// where L should act last.
std::vector<Expected> multiplied_in_other_order(const Expected& field) {
  const auto side = std::size_t(std::max(0, columns_of(field)));
  const auto& m = field.values;
  if (field.shape != Shape::kMatrix || side * side != m.size() || (side != 3 && side != 4))
    return {};
  for (std::size_t j = 0; j < side; ++j) {
    if (m[(side - 1) * side + j] != (j + 1 == side ? 1 : 0)) return {};
  }
  const std::size_t n = side - 1;
  // The last column becomes L t in `after` and L^T t in `before`; L^T is L^-1, because the L of a
  // view matrix is a rotation.
  std::vector<double> after = m, before = m;
  for (std::size_t i = 0; i < n; ++i) {
    double a = 0, b = 0;
    for (std::size_t j = 0; j < n; ++j) {
      a += m[i * side + j] * m[j * side + n];
      b += m[j * side + i] * m[j * side + n];
    }
    after[i * side + n] = a;
    before[i * side + n] = b;
  }
  std::vector<Expected> all;
  for (std::vector<double>* values : {&after, &before}) {
    // If t is zero, or L does not change it, the order makes no difference.
    Expected made = slipped(field, std::move(*values));
    if (compare(made, m).first) all.push_back(std::move(made));
  }
  return all;
}

}  // namespace

std::vector<ExpectedVariant> expected_variants() {
  std::vector<ExpectedVariant> all;
  const auto angle = [&](const char* slip, AngleSlip change) {
    all.push_back({slip, [change](const Expected& field) { return slip_angle(field, change); }});
  };
  angle("half-angle", doubled);
  angle("half-angle", halved);
  angle("degrees-radians", degrees_as_radians);
  angle("degrees-radians", radians_as_degrees);
  all.push_back({"multiplication-order", multiplied_in_other_order});
  return all;
}

}  // namespace glassbox::labs
