// How `glassbox step` writes numbers: with what is known about them (value, bound, bits), as points, and as matrices.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include <glassbox/pipeline/round_trip.h>

namespace glassbox::app {

inline constexpr const char* kAxes[] = {"x", "y", "z", "w"};

// Lines below the heading of a stage begin with this; a sentence is broken into such lines.
inline constexpr const char* kIndent = "     ";
std::string sentence(const std::string& text);

std::string bound_text(double bound);  // "+- 1.2e-08", "exact", "+- unknown"
std::string bits_text(float value);    // "3f800000"
std::string bits_text(double value);   // "3ff0000000000000"

// "x   0.123456789  +- 1.2e-08  3dfcd6e9": floats with nine digits, doubles with seventeen.
std::string number_line(const char* name, float value, double bound, bool bits);
std::string number_line(const char* name, double value, double bound, bool bits);

// "a b c d" of each row, the entries as wide as their columns.
std::array<std::string, 4> entry_rows(const glm::dmat4& m, int digits);
// Four lines "[ a b c d ]".
std::string matrix_rows(const glm::dmat4& m, const std::string& indent, int digits = 6);

// The way back from the screen to object space, a line for each coordinate: where it came back to, its bound, and how far that
// is from where it was. One line where the bounds are infinite.
std::vector<std::string> round_trip_lines(const RoundTrip& trip, bool bits);

}  // namespace glassbox::app
