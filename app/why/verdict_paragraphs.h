// The paragraphs of which a verdict's text is made, by what decided. verdict_text.h is the way in.
#pragma once

#include <string>
#include <vector>

#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/verdict.h>

namespace glassbox {

// For triangles that end before they have a fragment.
std::vector<std::string> explain_geometry(const View& view, const TriangleVerdict& verdict);

// For those that have fragments: one paragraph for each fate that some of them met.
std::vector<std::string> explain_fragments(const TriangleVerdict& verdict);

// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts);

}  // namespace glassbox
