// Groups of neighbouring instances of a scene. Each has what is needed to decide about all its
// instances at once. Made once for a scene; they do not depend on the view.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

struct PreparedMesh;

inline constexpr std::uint32_t kGroupInstances = 64;
// Scenes with fewer instances are quicker to test one by one.
inline constexpr std::size_t kLeastGroupedInstances = 1024;

// Notation: x is a vertex of an instance relative to the anchor of its mesh; W0, W1, W2 are the
// first three columns of world_from_object, whose fourth column is the origin; |.| is a length.
struct InstanceGroup {
  Box<World> box;          // of all vertices in world space, rounding errors included
  bool all_finite = true;  // otherwise nothing is known about the group
  // The largest values over the group's instances:
  // The largest distance of a vertex from the anchor: |W0| |x0| + |W1| |x1| + |W2| |x2|.
  double reach = 0;
  double sizes = 0;   // |x0| + |x1| + |x2|
  double column = 0;  // max(|W0|, |W1|, |W2|)
  // The sum of the absolute values of the terms of a world coordinate, where anchor and vertex are
  // separate terms.
  double far = 0;
};

struct InstanceGroups {
  std::vector<InstanceGroup> groups;
  std::vector<std::uint32_t> of_instance;  // the group of each instance
};

// `meshes`: one for each mesh of the scene.
InstanceGroups make_instance_groups(const Scene& scene, const std::vector<PreparedMesh>& meshes);

}  // namespace glassbox
