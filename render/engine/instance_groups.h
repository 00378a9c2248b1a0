// The instances of a scene by neighbourhood, each group with what is needed to ask about all of it at once. Made once for a scene; no
// view changes it.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

struct PreparedMesh;

inline constexpr std::uint32_t kGroupInstances = 64;
inline constexpr std::size_t kLeastGroupedInstances = 1024;  // fewer are quicker to ask one by one

// Below, x is a vertex of an instance relative to the anchor of its mesh, W the columns of world_from_object, the fourth where the
// origin is, and |.| a length.
struct InstanceGroup {
  Box<World> box;          // of all vertices in the world, roundings included
  bool all_finite = true;  // otherwise nothing is known
  // The largest of their instances':
  double reach =
      0;  // |W0| |x0| + |W1| |x1| + |W2| |x2|: how far a vertex is from the anchor at most
  double sizes = 0;   // |x0| + |x1| + |x2|
  double column = 0;  // |W0|, |W1|, |W2|
  double far =
      0;  // the terms of a world coordinate without their signs, anchor and vertex taken apart
};

struct InstanceGroups {
  std::vector<InstanceGroup> groups;
  std::vector<std::uint32_t> of_instance;  // the group of each
};

// `meshes`: by mesh of the scene.
InstanceGroups make_instance_groups(const Scene& scene, const std::vector<PreparedMesh>& meshes);

}  // namespace glassbox
