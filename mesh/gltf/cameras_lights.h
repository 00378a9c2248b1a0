// Cameras and lights, placed by the nodes that carry them.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/nodes.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

// One Camera and one Light for each node of the drawn scene that carries one, in the order of the nodes. A camera's
// node may be scaled or sheared; its pose is the rigid one with the same place, gaze and plane of the gaze and up.
Result<void> place_cameras_and_lights(const Asset& asset, const NodeTree& tree, Scene& scene);

}  // namespace glassbox::gltf
