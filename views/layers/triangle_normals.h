// The normals of a scene's triangles, for samples with a known triangle number.
#pragma once

#include <vector>

#include <glassbox/mesh/scene.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

// Indexed by the triangle's number as in Framebuffer::id, which counts from 1. They are the normals
// of the triangles' planes; the mesh's shading normals are not used. The normals of number 0, of
// degenerate triangles and of triangles too far away for finite numbers are unknown.
std::vector<SampleNormal> triangle_normals(const Scene& scene);

// Rounds a vector of any length but 0; the result is unknown if the vector is not finite.
SampleNormal stored_normal(double x, double y, double z);

}  // namespace glassbox::views
