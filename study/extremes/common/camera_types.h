// Short names for types that cases about cameras and matrices often use.
#pragma once

#include <cmath>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>

#include "exact/matrix.h"
#include "exact/number.h"
#include "study/extremes/common/outcome.h"

namespace glassbox::study {

using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;
using EyeFromWorld = Transform<Eye, World>;
using WorldMap = Transform<World, World>;

using LookAt = Result<EyeFromWorld> (*)(const WorldPoint&, const WorldPoint&, const WorldVector&);
// Transforms a point of an object to eye space.
using ToEye = Point<Eye> (*)(const Transform<Eye, World>&, const Transform<World, Object>&,
                             const Point<Object>&);

// The pipeline's way to transform a point to eye space: composed in double, rounded once.
inline Point<Eye> composed_in_double(const Transform<Eye, World>& view,
                                     const Transform<World, Object>& model,
                                     const Point<Object>& p) {
  return round_to_float(view * model) * p;
}

// Compares the first three rows of a matrix with those of an exact one, entry by entry.
template <class Target, class Source>
void add_entry_errors(WorstError& worst, const Transform<Target, Source>& found,
                      const exact::Matrix4<exact::Decimal>& exact, int columns, double bound,
                      const std::string& where, std::optional<double> condition = std::nullopt) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto& right = exact.at[std::size_t(row)][std::size_t(column)];
      worst.add(exact::error_of(found.at(row, column), right), bound, where, condition);
    }
  }
}

template <class Space>
double length(const Vector<Space, double>& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace glassbox::study
