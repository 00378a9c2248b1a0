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

// "mesh 'teapot'", or "mesh 3" of a mesh without a name.
std::string mesh_text(const Scene& scene, std::uint32_t instance);

// "face 12 of mesh 'teapot' (instance 0)"
std::string place_of(const Scene& scene, std::uint32_t instance, std::uint32_t face);

// How far a centre is missed: "3.25/256 px", and from a pixel on "1.5 px".
std::string subpixels_text(double subpixels);

// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts);

// What decided, with its numbers: one paragraph after the other, without line breaks.
std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict);

// What is wrong with the view itself; empty where its matrices agree.
std::vector<std::string> explain(const ViewConventions& conventions);

// The part of it for triangles that end before they have a fragment.
std::vector<std::string> explain_geometry(const View& view, const TriangleVerdict& verdict);

// What an end means, for a scene whose triangles end there: "every w is 0 or less: ...".
const char* meaning_of(End end);

}  // namespace glassbox
