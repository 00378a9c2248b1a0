#include "study/bench/mesa/uploads.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "study/bench/mesa/shaders.h"

namespace glassbox::study {

namespace {

gl::Int wrap_code(Wrap wrap) {
  switch (wrap) {
    case Wrap::kMirroredRepeat:
      return gl::kMirroredRepeat;
    case Wrap::kClampToEdge:
      return gl::kClampToEdge;
    case Wrap::kRepeat:
      break;
  }
  return gl::kRepeat;
}

gl::Int filter_code(Filter filter) {
  return filter == Filter::kNearest ? gl::kNearest : gl::kLinear;
}

gl::Int filter_code(Filter filter, MipFilter mip) {
  const bool nearest = filter == Filter::kNearest;
  switch (mip) {
    case MipFilter::kNearest:
      return nearest ? gl::kNearestMipNearest : gl::kLinearMipNearest;
    case MipFilter::kLinear:
      return nearest ? gl::kNearestMipLinear : gl::kLinearMipLinear;
    case MipFilter::kNone:
      break;
  }
  return filter_code(filter);
}

// A mipmap level as encoded bytes, which OpenGL decodes itself. Level 0 has the unchanged bytes of
// the image.
std::vector<Rgba8> stored_level(const MipChain& chain, int level, Transfer transfer) {
  const auto first = std::size_t(chain.first[std::size_t(level)]);
  const bool is_last = level == chain.last_level();
  const std::size_t end =
      is_last ? chain.texels.size() : std::size_t(chain.first[std::size_t(level) + 1]);
  std::vector<Rgba8> stored;
  for (const Texel& texel : std::span(chain.texels).subspan(first, end - first)) {
    stored.push_back(stored_texel(texel, transfer));
  }
  return stored;
}

}  // namespace

GlMesh upload_mesh(const gl::Functions& gl, const VertexArrays& arrays) {
  GlMesh mesh;
  mesh.index_count = gl::Size(arrays.indices.size());
  std::array<gl::Uint, 2> buffers{};
  gl.GenVertexArrays(1, &mesh.vertex_array);
  gl.BindVertexArray(mesh.vertex_array);
  gl.GenBuffers(2, buffers.data());
  const auto upload = [&](gl::Enum where, gl::Uint buffer, const auto& values) {
    gl.BindBuffer(where, buffer);
    gl.BufferData(where, std::ptrdiff_t(values.size() * sizeof(values[0])), values.data(),
                  gl::kStaticDraw);
  };
  upload(gl::kArrayBuffer, buffers[0], arrays.vertices);
  upload(gl::kElementArrayBuffer, buffers[1], arrays.indices);
  const auto stride = gl::Size(arrays.floats_per_vertex() * sizeof(float));
  std::size_t offset = 0;
  const auto attribute = [&](bool present, gl::Uint at, int floats) {
    if (!present) return;
    // OpenGL takes an offset into the buffer as a pointer.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* place = reinterpret_cast<const void*>(offset);
    gl.VertexAttribPointer(at, floats, gl::kFloat, gl::kFalse, stride, place);
    gl.EnableVertexAttribArray(at);
    offset += std::size_t(floats) * sizeof(float);
  };
  attribute(true, kPositionAt, 3);
  attribute(arrays.normals, kNormalAt, 3);
  attribute(arrays.texcoords, kTexcoordAt, 2);
  attribute(arrays.colors, kColorAt, 4);
  return mesh;
}

gl::Uint upload_texture(const gl::Functions& gl, const MipChain& chain, const Sampler& sampler,
                        Transfer transfer) {
  gl::Uint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(gl::kTexture2D, name);
  const gl::Int format = transfer == Transfer::kSrgb ? gl::kSrgb8Alpha8 : gl::kRgba8;
  for (int level = 0; level <= chain.last_level(); ++level) {
    gl.TexImage2D(gl::kTexture2D, level, format, std::max(1, chain.width >> level),
                  std::max(1, chain.height >> level), 0, gl::kRgba, gl::kUnsignedByte,
                  stored_level(chain, level, transfer).data());
  }
  const auto set = [&](gl::Enum what, gl::Int value) {
    gl.TexParameteri(gl::kTexture2D, what, value);
  };
  set(gl::kTextureBaseLevel, 0);
  set(gl::kTextureMaxLevel, chain.last_level());
  set(gl::kTextureMinFilter, filter_code(sampler.minify, sampler.mip));
  set(gl::kTextureMagFilter, filter_code(sampler.magnify));
  set(gl::kTextureWrapS, wrap_code(sampler.wrap_u));
  set(gl::kTextureWrapT, wrap_code(sampler.wrap_v));
  return name;
}

}  // namespace glassbox::study
