// Newell's sums as they are computed by hand, with a row for each edge of the face (S4-16).
#pragma once

#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/mesh.h>

namespace glassbox {

// The row of the edge from corner i to the next corner j. The terms are (y_i - y_j)(z_i + z_j),
// (z_i - z_j)(x_i + x_j) and (x_i - x_j)(y_i + y_j), in square object units; the sums are those of
// all terms so far.
struct NewellRow {
  Vector<Object, double> terms{0, 0, 0}, sums{0, 0, 0};
};

// A row for each corner, in the order of the face; the last sums are twice the vector area. The
// coordinates are taken as they are, as on the slide (S4.33), and not from the first corner, as
// newell_vector() takes them; the exact results are the same. No number overflows, because
// coordinates are floats.
std::vector<NewellRow> newell_rows(const Mesh& mesh, const Face& face);

// The largest error that rounding can cause in each component of the last sums: gamma_(N + 2) times
// the sum of the absolute values of N exact terms, where gamma_k is about k units of rounding. (A
// term has three roundings, and N - 1 additions follow.) The computed terms are used in place of
// the exact ones, with one unit more, which is enough for N up to 2^40.
Vector<Object, double> newell_error_bound(const std::vector<NewellRow>& rows);

}  // namespace glassbox
