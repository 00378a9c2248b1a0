// Comparisons as a page in Markdown, for the summary of a job or a comment.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// A title, the numbers of pictures by verdict, and a table of the pictures that do not pass. It has
// at most 65,536 bytes, which is the most characters that a comment on GitHub may have (a summary:
// 1 MiB): rows that do not fit are counted in its last line.
std::string markdown_report(const std::string& title, std::span<const Comparison> comparisons);

}  // namespace glassbox
