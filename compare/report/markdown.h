// Comparisons as a page in Markdown, for the summary of a job or a comment.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// A title, the numbers of pictures by verdict, and a table of the pictures that do not pass: 200
// rows at most, because GitHub refuses a summary above 1 MiB, and then how many more there are.
std::string markdown_report(const std::string& title, std::span<const Comparison> comparisons);

}  // namespace glassbox
