// Meshes and textures in the OpenGL peer's memory.
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

// All levels of the chain, bytes as they are, and what the sampler says. The texture's name.
gl::Uint upload_texture(const gl::Functions& gl, const MipChain& chain, const Sampler& sampler,
                        Transfer transfer);

}  // namespace glassbox::study
