// Uploads meshes and textures to the OpenGL peer.
#pragma once

#include "study/bench/mesa/gl.h"
#include "study/scenes/vertex_arrays.h"

#include <glassbox/mesh/scene.h>
#include <glassbox/raster/texture.h>

namespace glassbox::study {

struct GlMesh {
  gl::Uint vertex_array = 0;
  gl::Size index_count = 0;
};
GlMesh upload_mesh(const gl::Functions& gl, const VertexArrays& arrays);

// Uploads all levels of the chain, with unchanged bytes, and sets what the sampler prescribes.
// Returns the texture's name.
gl::Uint upload_texture(const gl::Functions& gl, const MipChain& chain, const Sampler& sampler,
                        Transfer transfer);

}  // namespace glassbox::study
