// Converts the tables of the whole file to one mesh for each part.
#pragma once

#include <glassbox/mesh/obj/materials.h>
#include <glassbox/mesh/obj/parse.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::obj {

// Adds the meshes of `tables`, their materials, one node and the instances to `scene`. Each mesh
// gets the entries that it uses, in the order of their first use. Time and memory are proportional
// to the tables.
void build_meshes(const Tables& tables, MaterialMaker& materials, Scene& scene, Warnings& warnings);

}  // namespace glassbox::obj
