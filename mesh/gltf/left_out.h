// What a glTF file asks for and the picture lacks.
#pragma once

#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/materials.h>
#include <glassbox/mesh/gltf/nodes.h>

namespace glassbox::gltf {

// Adds one warning, with its count, for each kind of thing that is in the file and not in the picture: textures other than
// those of base colour and emission, animations, skins (which stand in the pose of their nodes), vertex attributes that
// nothing reads, cameras beside the first, and what stands outside the scene that is drawn. Extensions have been named by
// open_asset(), and single things that cannot be drawn where they were met.
void name_left_out(Asset& asset, const NodeTree& tree, const Materials& materials);

}  // namespace glassbox::gltf
