// The normals of a scene's triangles, for samples that know which one they are of.
#pragma once

#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

// By a triangle's number as Framebuffer::id has it, counted from 1; that of number 0, of degenerate triangles and of such that are too far away for
// numbers is not known. They are those of the triangles' planes, whatever normals the mesh is lit by.
std::vector<SampleNormal> triangle_normals(const Scene& scene);

// Of any length but 0; not known where it is not finite.
SampleNormal stored_normal(double x, double y, double z);

}  // namespace glassbox::views
