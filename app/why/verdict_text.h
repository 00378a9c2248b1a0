// A verdict as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/scene_verdict.h>

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

// Two triangles that fight, their distances, and what separates them. Sentences.
std::string fight_text(const Scene& scene, const View& view, DepthFormat format,
                       const DepthFight& fight);

// What is wrong with the sides of the scene's surfaces, a sentence each: normals that point to the
// backs or were transformed like positions, closed surfaces whose fronts are inside, and nodes that
// mirror. A surface with its fronts inside is right if the eye is inside, too.
std::vector<std::string> surface_findings(const Scene& scene,
                                          const std::optional<Point<World, double>>& eye);

// What is wrong with the matrices of the view itself; empty if they are consistent.
std::vector<std::string> explain(const ViewConventions& conventions);

// The reasons for a triangle that is removed before it has a fragment.
std::vector<std::string> explain_geometry(const View& view, const TriangleVerdict& verdict);

// What it means for a scene if this happened to its triangles: "every w is 0 or less: ...".
const char* result_meaning(TriangleResult result);

// One cause of an empty picture: what is wrong, with its evidence in numbers, and what mends it. A
// sentence each, without a full stop.
struct CauseText {
  std::string why, mend;
};
CauseText explain(const Scene& scene, const View& view, const SceneVerdict& verdict,
                  const SceneCause& cause);

// A verdict as JSON: one field per member, left out if it does not apply.
nlohmann::ordered_json to_json(const TriangleVerdict& verdict);
nlohmann::ordered_json to_json(const SceneVerdict& verdict);
nlohmann::ordered_json to_json(const CentreMiss& miss);
nlohmann::ordered_json to_json(const DepthFight& fight);

}  // namespace glassbox
