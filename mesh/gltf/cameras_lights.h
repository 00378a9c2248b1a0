// Cameras and lights, placed at the nodes that refer to them.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/nodes.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

// Adds one Camera and one Light for each node of the drawn scene that has one, in the order of the
// nodes. A camera's node may be scaled or sheared; the camera's pose is the rigid one with the same
// position, the same gaze and the same plane through gaze and up. Where a scale is negative or zero
// it is ignored. A camera that cannot be used has a fault (mesh/scene.h), and is a warning.
Result<void> place_cameras_and_lights(Asset& asset, const NodeTree& tree, Scene& scene);

}  // namespace glassbox::gltf
