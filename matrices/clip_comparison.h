// Compares the clip positions that a program computed, such as a vertex shader's output, with the
// ones that follow from the given matrices, and finds which matrix explains a difference.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include <glassbox/matrices/matrix_setup.h>
#include <glassbox/matrices/vertex_table.h>

namespace glassbox {

// One vertex whose clip positions differ by more than their uncertainties.
struct ClipDifference {
  std::size_t vertex = 0;         // index, counted from 0
  glm::dvec4 ours{0}, theirs{0};  // clip positions
  glm::dvec4 tolerance{0};        // how much may differ: rounding in float, and printed digits
};

struct ClipExplanation {
  const char* id = "";  // "no-model"; does not change between versions
  std::string text;     // what the program does: "it leaves out the model matrix"
};

struct ClipComparison {
  std::size_t compared = 0, different = 0;
  std::optional<ClipDifference> first;
  // All ways of using these matrices that give the program's positions at every vertex.
  std::vector<ClipExplanation> explanations;
  // The matrix that gives the program's positions, by least squares. It is there only if nothing
  // explains them, if there are at least five vertices that are not in one plane, and if it gives
  // all positions.
  std::optional<glm::dmat4> clip_from_object;
};

// Compares the vertices with the same index. `object` and `theirs` have the same size, which is not
// 0. Both sides are computed in float: each coordinate may differ by the rounding errors of four
// products and three sums for each matrix (gamma(13)) of the sum of the absolute terms, on both
// sides, and by the uncertainties of the printed numbers.
ClipComparison compare_clip_positions(const MatrixSetup& setup, std::span<const TableVertex> object,
                                      std::span<const TableVertex> theirs);

}  // namespace glassbox
