// Features of a glTF file that are missing in the picture.
#pragma once

#include <glassbox/mesh/gltf/asset.h>
#include <glassbox/mesh/gltf/materials.h>
#include <glassbox/mesh/gltf/nodes.h>

namespace glassbox::gltf {

// Adds one warning, with its count, for each kind of thing that is in the file but not in the
// picture: textures other than those of base colour and emission, animations, skins (which are
// drawn in the pose of their nodes), vertex attributes that are not read, cameras after the first,
// and things outside the scene that is drawn. Unsupported extensions have been reported by
// open_asset(), and single things that cannot be drawn have been reported where they were found.
void warn_about_missing_features(Asset& asset, const NodeTree& tree, const Materials& materials,
                                 const Scene& scene);

}  // namespace glassbox::gltf
