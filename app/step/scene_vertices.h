// Vertices of a scene by their numbers, for glassbox step SCENE --vertices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include <glassbox/base/error.h>
#include <glassbox/matrices/vertex_table.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// Vertices of one instance of a mesh, in object space.
struct SceneVertices {
  std::vector<TableVertex> vertices;
  glm::dmat4 world_from_object{1};  // of the instance's node
  std::string node;                 // its name

  bool is_at_origin() const { return world_from_object == glm::dmat4(1); }
};

// Finds the vertices with these numbers. Vertices are counted from 0, over the positions of the
// meshes of all instances in their order. An error if there is no such vertex, or if they belong to
// several instances, which may have several model matrices.
Result<SceneVertices> vertices_of(const Scene& scene, const std::vector<std::uint32_t>& numbers);

// Parses numbers: "0,5,7". Otherwise throws CLI::ValidationError, which names the option.
std::vector<std::uint32_t> parse_vertex_numbers(const std::string& option, const std::string& text);

}  // namespace glassbox::app
