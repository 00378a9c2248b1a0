#include "labs/framework/slip_variants.h"

#include <algorithm>
#include <cmath>

#include "labs/framework/compare.h"

namespace glassbox::labs {

namespace {

using Values = std::vector<double>;
using Candidates = std::vector<Values>;

bool is_vertex_list(const Expected& field) {
  return field.shape == Shape::kPolygon;
}

bool is_point(const Expected& field, const Values& values) {
  return field.shape == Shape::kPoint ||
         (field.shape == Shape::kNumbers && values.size() >= 2 && values.size() <= 4);
}

// Replaces coordinate `axis` of a point, or of each vertex of a polygon, by change(coordinate).
template <class Change>
Candidates change_coordinate(const Expected& field, const Values& values, std::size_t axis,
                             Change change) {
  std::size_t step = 0;
  if (is_point(field, values)) step = std::max<std::size_t>(values.size(), 1);
  if (is_vertex_list(field)) step = std::size_t(columns_of(field));
  if (step <= axis) return {};
  Values changed = values;
  for (std::size_t i = axis; i < changed.size(); i += step) changed[i] = change(changed[i]);
  return {changed};
}

Candidates negated_axis(const Expected& field, const Values& values, std::size_t axis) {
  return change_coordinate(field, values, axis, [](double x) { return -x; });
}

bool is_square(const Expected& field, const Values& values) {
  const auto side = std::size_t(std::max(0, columns_of(field)));
  return field.shape == Shape::kMatrix && side * side == values.size() && side > 1;
}

// Two matrices: one with the opposite signs in row `at`, the other in column `at`. None if the
// field is not a square matrix.
Candidates negated_line(const Expected& field, const Values& values, std::size_t at) {
  if (!is_square(field, values)) return {};
  const auto side = std::size_t(columns_of(field));
  if (at >= side) return {};
  Values row = values, column = values;
  for (std::size_t i = 0; i < side; ++i) {
    row[at * side + i] = -row[at * side + i];
    column[i * side + at] = -column[i * side + at];
  }
  return {row, column};
}

Candidates axis_or_line(const Expected& field, const Values& values, std::size_t axis) {
  Candidates all = negated_axis(field, values, axis);
  for (Values& each : negated_line(field, values, axis)) all.push_back(std::move(each));
  return all;
}

// Whether the field is a normal, or Newell's vector, which is a normal of any length.
bool is_normal_field(const Expected& field) {
  return field.field.find("normal") != std::string::npos || field.field == "newell";
}

// The numbers with the opposite signs, for a normal that points inwards or a signed area; nothing
// if there are not `size` numbers.
Candidates all_negated(const Expected& field, const Values& values, std::size_t size) {
  if (values.size() != size || (field.shape != Shape::kNumbers && field.shape != Shape::kPoint))
    return {};
  Values changed = values;
  for (double& each : changed) each = -each;
  return {changed};
}

Candidates flipped_rows(const Expected& field, const Values& values) {
  const auto width = std::size_t(std::max(1, columns_of(field)));
  if (field.shape != Shape::kCoverage || values.size() % width != 0) return {};
  Values changed;
  for (std::size_t row = values.size() / width; row-- > 0;) {
    const auto first = values.begin() + std::ptrdiff_t(row * width);
    changed.insert(changed.end(), first, first + std::ptrdiff_t(width));
  }
  return {changed};
}

Candidates transposed(const Expected& field, const Values& values) {
  const auto side = std::size_t(std::max(0, columns_of(field)));
  const bool grid = field.shape == Shape::kMatrix || field.shape == Shape::kCoverage;
  if (!grid || side < 2 || side * side != values.size()) return {};
  Values changed = values;
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) changed[i * side + j] = values[j * side + i];
  }
  return {changed};
}

// The polygon's vertices in reverse order: one result for each vertex that may come first.
Candidates reversed_polygon(const Expected& field, const Values& values) {
  const auto columns = std::size_t(std::max(1, columns_of(field)));
  const std::size_t count = values.size() / columns;
  // A clipped polygon has at most ten vertices. For a very long list the time, which grows with the
  // square of its length, would be too long.
  constexpr std::size_t kMost = 64;
  // a table of positions has an order, but no winding
  const bool table = field.field == "positions";
  if (!is_vertex_list(field) || table || values.size() % columns != 0 || count < 3 || count > kMost)
    return {};
  Candidates all;
  for (std::size_t start = 0; start < count; ++start) {
    Values changed;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t from = (start + count - k) % count;
      for (std::size_t i = 0; i < columns; ++i) changed.push_back(values[from * columns + i]);
    }
    all.push_back(std::move(changed));
  }
  return all;
}

bool all_are(const Values& values, bool (*what)(double)) {
  return !values.empty() && std::all_of(values.begin(), values.end(), what);
}

// The answers with 0 and 1 exchanged, as if back faces were taken for front faces.
Candidates inverted_answers(const Expected& field, const Values& values) {
  const auto is_bit = [](double x) { return x == 0 || x == 1; };
  // Whether a triangle owns an edge has nothing to do with its face: lab 6 has a slip for it.
  if (field.field == "owned") return {};
  if (field.shape != Shape::kNumbers || !all_are(field.values, is_bit) || !all_are(values, is_bit))
    return {};
  Values changed = values;
  for (double& each : changed) each = 1 - each;
  return {changed};
}

// Triangles, given as triples of indices, with the opposite winding.
Candidates reversed_triples(const Expected& field, const Values& values) {
  const auto is_index = [](double x) { return x >= 0 && x == std::floor(x); };
  if (field.shape != Shape::kNumbers || values.size() % 3 != 0 || !all_are(values, is_index))
    return {};
  for (std::size_t i = 0; i + 3 <= field.values.size(); i += 3) {
    const double a = field.values[i], b = field.values[i + 1], c = field.values[i + 2];
    if (a == b || b == c || c == a) return {};  // not a triangle
  }
  Values changed = values;
  for (std::size_t i = 0; i < changed.size(); i += 3) std::swap(changed[i + 1], changed[i + 2]);
  return {changed};
}

// Whether the field is a depth, or a distance along the direction of view.
bool is_depth_field(const Expected& field) {
  return field.field == "z" || field.field.find("depth") != std::string::npos ||
         field.field.find("distance") != std::string::npos || field.field.ends_with("_z") ||
         field.field.ends_with(" z");
}

}  // namespace

AnswerVariant flipped_y_variant(double height) {
  return {"y-direction", 2, [height](const Expected& field, const Values& values) {
            return change_coordinate(field, values, 1, [height](double y) { return height - y; });
          }};
}

std::vector<AnswerVariant> answer_variants() {
  std::vector<AnswerVariant> all;
  const auto add = [&](const char* slip, std::size_t evidence, auto undo) {
    all.push_back({slip, evidence, std::move(undo)});
  };
  add("z-sign", 1, [](const Expected& f, const Values& v) { return axis_or_line(f, v, 2); });
  add("z-sign", 2, [](const Expected& f, const Values& v) {
    return is_depth_field(f) ? all_negated(f, v, 1) : Candidates{};
  });
  add("y-direction", 1, [](const Expected& f, const Values& v) { return axis_or_line(f, v, 1); });
  add("y-direction", 1, flipped_rows);
  add("row-column-order", 1, transposed);
  add("handedness", 1, [](const Expected& f, const Values& v) { return axis_or_line(f, v, 0); });
  add("winding", 1, reversed_polygon);
  add("winding", 2, inverted_answers);
  add("winding", 2, reversed_triples);
  add("winding", 2, [](const Expected& f, const Values& v) {
    return f.field.find("area") != std::string::npos ? all_negated(f, v, 1) : Candidates{};
  });
  add("winding", 1, [](const Expected& f, const Values& v) {
    return is_normal_field(f) ? all_negated(f, v, 3) : Candidates{};
  });
  return all;
}

}  // namespace glassbox::labs
