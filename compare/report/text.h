// Comparisons in words, for people at a terminal.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// "same", "within tolerance", "different", "new", "missing", "not compared".
std::string verdict_name(Verdict verdict);

// One line: the picture, the verdict, and for what does not pass the reason.
std::string one_line(const Comparison& comparison);

// What else is worth knowing, one indented line each: further reasons, hints, notes, metrics, the command that inspects
// the first differing pixel. Empty for pictures that pass and have nothing to tell.
std::string details(const Comparison& comparison);

// "57 pictures: 55 same, 1 within tolerance, 1 different".
std::string summary_line(std::span<const Comparison> comparisons);

}  // namespace glassbox
