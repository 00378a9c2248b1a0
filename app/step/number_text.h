// How `glassbox step` writes numbers (value, error bound, bits), points and matrices.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include <glassbox/pipeline/round_trip.h>

namespace glassbox::app {

inline constexpr const char* kAxes[] = {"x", "y", "z", "w"};

// The indentation of lines below the heading of a stage. `sentence` breaks a text into such lines.
inline constexpr const char* kIndent = "     ";
std::string sentence(const std::string& text);

std::string bound_text(double bound);  // "+- 1.2e-08", "exact", "+- unknown"
std::string bits_text(float value);    // "3f800000"
std::string bits_text(double value);   // "3ff0000000000000"

// A line for a number: "x   0.123456789  +- 1.2e-08  3dfcd6e9". Floats have nine digits, doubles
// seventeen.
std::string number_line(const char* name, float value, double bound, bool bits);
std::string number_line(const char* name, double value, double bound, bool bits);

// The four rows as text, "a b c d", with aligned columns.
std::array<std::string, 4> entry_rows(const glm::dmat4& m, int digits);
// Four lines "[ a b c d ]", one per row.
std::string matrix_rows(const glm::dmat4& m, const std::string& indent, int digits = 6);

// The point transformed back from the screen to object space, with a line per coordinate: the
// result, its bound, and its distance from the original value. One line only if the bounds are
// infinite.
std::vector<std::string> round_trip_lines(const RoundTrip& trip, bool bits);

}  // namespace glassbox::app
