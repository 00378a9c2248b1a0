// A verdict as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/verdict.h>

namespace glassbox {

// What happened to a triangle, in words such as "turned away".
const char* result_words(TriangleResult result);

// The name of an instance's mesh: "mesh 'teapot'", or "mesh 3" if it has no name.
std::string mesh_text(const Scene& scene, std::uint32_t instance);

// "face 12 of mesh 'teapot' (instance 0)"
std::string face_text(const Scene& scene, std::uint32_t instance, std::uint32_t face);

// A distance from a pixel's centre: "3.25/256 px" if it is less than a pixel, else "1.5 px".
std::string subpixels_text(double subpixels);

// A list in words: "a", "a and b", "a, b and c".
std::string list_in_words(const std::vector<std::string>& parts);

// The reasons for what happened to the triangle, with their numbers: one paragraph per element,
// without line breaks.
std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict);

// What is wrong with the matrices of the view itself; empty if they are consistent.
std::vector<std::string> explain(const ViewConventions& conventions);

// The reasons for a triangle that is removed before it has a fragment.
std::vector<std::string> explain_geometry(const View& view, const TriangleVerdict& verdict);

// What it means for a scene if this happened to its triangles: "every w is 0 or less: ...".
const char* result_meaning(TriangleResult result);

// A verdict as JSON: one field per member, left out if it does not apply.
nlohmann::ordered_json to_json(const TriangleVerdict& verdict);
nlohmann::ordered_json to_json(const SceneVerdict& verdict);
nlohmann::ordered_json to_json(const CentreMiss& miss);

}  // namespace glassbox
