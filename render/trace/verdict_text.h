// A verdict in words.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/verdict.h>

namespace glassbox {

// "turned away"
const char* words_for(End end);

// "face 12 of mesh 'teapot' (instance 0)"
std::string place_of(const Scene& scene, std::uint32_t instance, std::uint32_t face);

// What decided, with its numbers: one paragraph after the other, without line breaks.
std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict);

// What is wrong with the view itself; empty where its matrices agree.
std::vector<std::string> explain(const ViewConventions& conventions);

// What an end means, for a scene whose triangles end there: "every w is 0 or less: ...".
const char* meaning_of(End end);

}  // namespace glassbox
