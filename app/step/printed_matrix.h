// A 4x4 matrix as some program printed it.
//
// Sixteen numbers in any layout: brackets, commas, semicolons, names and line breaks only separate. It is understood from
//
//   1 0 0 0                           paper, Eigen, MATLAB, Fortran
//   [[1., 0., 0., 0.], ...]           numpy, JSON, Rust's nalgebra
//   mat4x4((1.000000, ...), ...)      GLM's to_string, GLSL: columns
//   float m[16] = {1.0f, 0, ...};     C; also m[0] = 1; m[1] = ...
//   {value = {{{x = 1, r = 1, s = 1}, gdb of a glm::mat4, "<repeats 3 times>" too: columns
//   x_axis: Vec4(1.0, ...)            Rust's glam: columns
//   Float32Array(16) [1, 0, ...]      JavaScript: columns; three.js's elements, {"0": 1, "1": 0, ...} and CSS's matrix3d(), too
//   {M11:1 M12:0 ...}                 System.Numerics, whose matrices are for row vectors: columns of ours
//
// Comments (#, //, /* */) are skipped. Everything else is refused by line, column and token: a number with letters in it, a
// scale factor ("1.0e+03 *"), and any count but sixteen.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <glassbox/base/error.h>

#include "app/step/matrices/matrix_facts.h"

namespace glassbox::app {

// Whether the first four numbers are the first row of p' = M p, or its first column.
enum class NumberOrder { kRows, kColumns };

struct MatrixText {
  std::array<double, 16> numbers{};      // in the order of the text
  std::array<double, 16> uncertainty{};  // of each, as the digits leave it
  int digits = 0;                        // significant ones of the longest number
  // The order that the layout implies, and what it was recognised by ("GLM's to_string").
  std::optional<NumberOrder> order;
  std::string recognised;
};

// `name`: what errors call the text.
Result<MatrixText> parse_matrix_text(std::string_view text, const std::string& name);

// Rows unless the text, or `asked`, says otherwise. `asked` wins.
NumberOrder order_of(const MatrixText& text, std::optional<NumberOrder> asked);
GivenMatrix to_matrix(const MatrixText& text, NumberOrder order);

// `source`: a file, "-" for standard input, or the matrix itself.
struct NamedText {
  std::string name, text;
};
Result<NamedText> read_matrix_source(const std::string& source);

}  // namespace glassbox::app
