// Reads a 4x4 matrix as some program printed it.
//
// The text has sixteen numbers in any layout. Brackets, commas, semicolons, names and line breaks
// only separate them. These layouts are examples; the word "columns" marks the ones that are read
// by columns:
//
//   1 0 0 0                           paper, Eigen, MATLAB, Fortran
//   [[1., 0., 0., 0.], ...]           numpy, JSON, Rust's nalgebra
//   mat4x4((1.000000, ...), ...)      GLM's to_string, GLSL: columns
//   float m[16] = {1.0f, 0, ...};     C; also m[0] = 1; m[1] = ...
//   {value = {{{x = 1, r = 1, s = 1}, gdb for a glm::mat4, also "<repeats 3 times>": columns
//   x_axis: Vec4(1.0, ...)            Rust's glam: columns
//   Float32Array(16) [1, 0, ...]      JavaScript: columns; also three.js's elements,
//                                     {"0": 1, "1": 0, ...} and CSS's matrix3d()
//   {M11:1 M12:0 ...}                 System.Numerics, with matrices for row vectors: columns here
//   {_11=1 _12=0 ...}                 DirectXMath's XMFLOAT4X4, likewise
//   [1 0 0 0] [0 1 0 0] [...] [...]   Unreal's FMatrix, in one line, likewise
//   [X: (1, 0, 0), Y: ..., O: ...]    Godot's Transform3D, twelve numbers: columns
//
// Comments (#, //, /* */) are skipped. Everything else is refused with an error that names line,
// column and token: a number with letters in it, a scale factor ("1.0e+03 *"), and any number of
// entries other than sixteen.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/matrices/matrix_facts.h>

namespace glassbox {

// Whether the first four numbers are the first row of p' = M p, or its first column.
enum class NumberOrder { kRows, kColumns };

struct MatrixText {
  std::array<double, 16> numbers{};      // in the order of the text
  std::array<double, 16> uncertainty{};  // of each number, from its digits
  int digits = 0;                        // significant digits of the longest number
  // The order that the layout implies, and the layout that it was recognised by ("GLM's
  // to_string").
  std::optional<NumberOrder> order;
  std::string recognised;
};

// Parses the text. Errors call it `name`.
Result<MatrixText> parse_matrix_text(std::string_view text, const std::string& name);

// Returns `asked` if it is given, else the order that the layout implies, else rows.
NumberOrder order_of(const MatrixText& text, std::optional<NumberOrder> asked);
GivenMatrix to_matrix(const MatrixText& text, NumberOrder order);

// Reads a matrix's text. `source` is a file, "-" for standard input, or the matrix itself.
struct NamedText {
  std::string name, text;
};
Result<NamedText> read_matrix_source(const std::string& source);

// Reads a matrix from its source for an option, which errors name. The matrix says where it comes
// from: "view.txt, read by rows (a matrix of GLM or GLSL)".
Result<GivenMatrix> read_given_matrix(const char* option, const std::string& source,
                                      std::optional<NumberOrder> asked);

// The tokens of a printed matrix: numbers, names, and the marks between them.
struct MatrixToken {
  enum class Kind { kNumber, kName, kMark };
  Kind kind;
  std::string_view text;
  int line = 1, column = 1;
  double value = 0;   // of a kNumber
  int digits = 0;     // significant digits as written; 0 for nan and inf
  int decimals = -1;  // after the point; -1 without a point, or with an exponent
};

// The tokens in the order of the text, without comments and blanks. Errors name the token and its
// place.
Result<std::vector<MatrixToken>> matrix_tokens(std::string_view text, const std::string& name);

}  // namespace glassbox
