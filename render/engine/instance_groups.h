// Groups of neighbouring instances of a scene. Each has what is needed to decide about all its
// instances at once. Groups are made once for a scene; they do not depend on the view.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

struct PreparedMesh;

inline constexpr std::uint32_t kGroupInstances = 64;
// In scenes with fewer instances it is quicker to test them one by one.
inline constexpr std::size_t kMinGroupedInstances = 1024;

// Notation: x is a vertex of an instance relative to the anchor of its mesh; W0, W1, W2 are the
// first three columns of world_from_object, whose fourth column is the origin; |.| is a length.
struct InstanceGroup {
  Box<World> box;          // of all vertices in world space, rounding errors included
  bool all_finite = true;  // all vertices are finite; otherwise nothing is known about the group
  // The following numbers are the largest over the group's instances. `reach` is a bound of the
  // distance of a vertex from the anchor in world space: |W0| |x0| + |W1| |x1| + |W2| |x2|.
  double reach = 0;
  double sizes = 0;   // |x0| + |x1| + |x2|, where x is a vertex minus the anchor
  double column = 0;  // the longest column, max(|W0|, |W1|, |W2|)
  // The sum of the absolute values of the terms of a world coordinate: of the origin, and of a
  // product for the anchor and one for the vertex relative to it along each axis.
  double far = 0;
};

struct InstanceGroups {
  std::vector<InstanceGroup> groups;
  std::vector<std::uint32_t> of_instance;  // by instance: the index of its group
};

// `meshes` has one entry for each mesh of the scene.
InstanceGroups make_instance_groups(const Scene& scene, const std::vector<PreparedMesh>& meshes);

}  // namespace glassbox
