// Makes the normals that smoothing groups ask for.
#pragma once

#include <glassbox/mesh/obj/parse.h>

namespace glassbox::obj {

// Gives the corners of all faces in smoothing groups a normal, if the file has no normals of its
// own: at each vertex, one for each group. It has the direction of the sum of the Newell vectors of
// the group's faces there, so larger faces count for more. Corners without a group, and those whose
// sum is zero, stay without a normal and are shaded flat. Takes O(n log n) for n corners.
void add_group_normals(Tables& tables);

}  // namespace glassbox::obj
