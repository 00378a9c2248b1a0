// Comparisons as annotations of GitHub Actions, which show them beside the files of a change.
#pragma once

#include <span>
#include <string>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// One line for each picture that does not pass: the workflow command "error" (GitHub: Workflow
// commands for GitHub Actions), with the path of the reference and the text of comparison_line and
// comparison_details. GitHub shows the first ten of a step. Empty if all pictures pass.
std::string github_annotations(std::span<const Comparison> comparisons);

}  // namespace glassbox
