// The tables of `glassbox info --tables`: the vertices, edges and faces of a mesh, the neighbours
// of each, and the normal of each face in two ways (S4-15 to S4-17).
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>

namespace glassbox::app {

// The tables of all meshes in lines of at most 100 columns where the lists of neighbours allow it.
// Each table has at most `rows` rows, and a line says how many are left out; Newell's sums of a
// face with few corners are whole. At most `rows` meshes have tables.
std::string tables_text(const Scene& scene, std::size_t rows);

// The same of one mesh. Lists have at most 1000 numbers; the fields ..._left_out say how many rows
// and numbers are missing.
nlohmann::ordered_json tables_json(const Mesh& mesh, std::size_t rows);

}  // namespace glassbox::app
