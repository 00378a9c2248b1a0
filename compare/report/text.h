// Comparisons as text, for people at a terminal.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// Returns "same", "within tolerance", "different", "new", "missing" or "not compared".
std::string verdict_name(Verdict verdict);

// One line: the picture, the verdict, and the reason if it does not pass.
std::string comparison_line(const Comparison& comparison);

// The reason why the pictures are not the same, or were not compared; empty if they are the same.
std::string comparison_reason(const Comparison& comparison);

// Returns further lines, each indented: more reasons, hints, notes, metrics, suggestions, and the
// command that inspects the first differing pixel. Empty for pictures that pass without any of
// these.
std::string comparison_details(const Comparison& comparison);

// A sentence that says how many pictures have an opaque alpha channel that their partner does not
// have; empty if there are none.
std::string opaque_alpha_text(std::span<const Comparison> comparisons);

// A line such as "57 pictures: 55 same, 1 within tolerance, 1 different".
std::string summary_line(std::span<const Comparison> comparisons);

}  // namespace glassbox
