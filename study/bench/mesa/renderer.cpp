#include "study/bench/mesa/renderer.h"

#include <algorithm>
#include <array>

#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/normal_transform.h>
#include <glassbox/raster/shading.h>
#include <glassbox/render/engine/stopwatch.h>

#include "study/bench/mesa/shaders.h"
#include "study/scenes/vertex_arrays.h"

namespace glassbox::study {

namespace {

const Mesh& mesh_of(const BenchScene& bench) {
  return bench.scene.meshes.front();
}

const Material& material_of(const BenchScene& bench) {
  return bench.scene.materials[mesh_of(bench).material];
}

Ingredients ingredients_of(const BenchScene& bench) {
  const Material& material = material_of(bench);
  return {!material.unlit, material.texture.has_value(), !mesh_of(bench).colors.empty()};
}

Transform<Eye, Object> eye_from_object(const BenchScene& bench, const View& view) {
  return view.eye_from_world * bench.scene.nodes.front().world_from_node;
}

// Depth from -1 to 1, which OpenGL's viewport carries back to what ours is.
glm::mat4 gl_matrix(const BenchScene& bench, const View& view) {
  return round_to_float(clip_gl_from_clip() * view.clip_from_eye * eye_from_object(bench, view))
      .columns;
}

tl::unexpected<Error> refused(const std::string& cause) {
  return fail("OpenGL", cause, "try another Mesa, or leave --against out");
}

}  // namespace

Result<std::unique_ptr<MesaRenderer>> MesaRenderer::make(const BenchScene& bench) {
  auto mesa = OsMesa::open();
  if (!mesa) return tl::unexpected(mesa.error());
  std::unique_ptr<MesaRenderer> made(new MesaRenderer(bench, std::move(*mesa)));
  if (const auto ready = made->make_framebuffer(); !ready) return tl::unexpected(ready.error());
  if (const auto ready = made->make_program(); !ready) return tl::unexpected(ready.error());
  made->upload_mesh();
  if (material_of(bench).texture) made->upload_texture();
  if (!material_of(bench).unlit) made->set_light();
  if (made->gl_.GetError() != 0) return refused("the scene's set-up was not accepted");
  return made;
}

MesaRenderer::MesaRenderer(const BenchScene& bench, std::unique_ptr<OsMesa> mesa)
    : bench_(bench), mesa_(std::move(mesa)), gl_(mesa_->gl()) {
  for (const BenchPass& pass : bench.passes) matrices_.push_back(gl_matrix(bench, pass.view));
}

std::string MesaRenderer::description() const {
  const auto text = [&](gl::Enum what) {
    return std::string(reinterpret_cast<const char*>(gl_.GetString(what)));
  };
  const std::string version = text(gl::kVersion);  // "3.3 (Core Profile) Mesa 22.3.6"
  return text(gl::kRenderer) + ", " +
         version.substr(std::min(version.find("Mesa"), version.size()));
}

// ---- set-up ----

Result<void> MesaRenderer::make_framebuffer() {
  const int width = bench_.width(), height = bench_.height();
  std::array<gl::Uint, 2> planes{};
  gl::Uint framebuffer = 0;
  gl_.GenFramebuffers(1, &framebuffer);
  gl_.BindFramebuffer(gl::kFramebuffer, framebuffer);
  gl_.GenRenderbuffers(2, planes.data());
  const auto attach = [&](gl::Uint plane, gl::Enum format, gl::Enum where) {
    gl_.BindRenderbuffer(gl::kRenderbuffer, plane);
    gl_.RenderbufferStorage(gl::kRenderbuffer, format, width, height);
    gl_.FramebufferRenderbuffer(gl::kFramebuffer, where, gl::kRenderbuffer, plane);
  };
  attach(planes[0], gl::Enum(gl::kRgba8), gl::kColorAttachment0);
  attach(planes[1], gl::kDepthComponent32F, gl::kDepthAttachment);
  if (gl_.CheckFramebufferStatus(gl::kFramebuffer) != gl::kFramebufferComplete) {
    return refused("there is no framebuffer of this size");
  }
  const Rgba8& back = bench_.settings.background;
  gl_.ClearColor(float(back.r) / 255.0f, float(back.g) / 255.0f, float(back.b) / 255.0f, 1.0f);
  gl_.Viewport(0, 0, width, height);
  gl_.Enable(gl::kDepthTest);
  gl_.DepthFunc(gl::kLess);
  gl_.Enable(gl::kCullFace);
  return {};
}

Result<gl::Uint> MesaRenderer::compile(gl::Enum kind, const std::string& text) const {
  const gl::Uint shader = gl_.CreateShader(kind);
  const char* lines = text.c_str();
  gl_.ShaderSource(shader, 1, &lines, nullptr);
  gl_.CompileShader(shader);
  gl::Int compiled = 0;
  gl_.GetShaderiv(shader, gl::kCompileStatus, &compiled);
  if (compiled != 0) return shader;
  std::array<char, 1000> log{};
  gl_.GetShaderInfoLog(shader, gl::Size(log.size()), nullptr, log.data());
  return refused(std::string("a shader was not accepted: ") + log.data());
}

Result<void> MesaRenderer::make_program() {
  const Ingredients ingredients = ingredients_of(bench_);
  program_ = gl_.CreateProgram();
  for (const auto& [kind, text] : {std::pair{gl::kVertexShader, vertex_shader(ingredients)},
                                   std::pair{gl::kFragmentShader, fragment_shader(ingredients)}}) {
    const auto shader = compile(kind, text);
    if (!shader) return tl::unexpected(shader.error());
    gl_.AttachShader(program_, *shader);
  }
  gl_.LinkProgram(program_);
  gl::Int linked = 0;
  gl_.GetProgramiv(program_, gl::kLinkStatus, &linked);
  if (linked == 0) return refused("the shaders do not fit together");
  gl_.UseProgram(program_);
  clip_from_object_ = uniform("clip_from_object");
  const Rgba& color = material_of(bench_).base_color;
  gl_.Uniform3fv(uniform("base_color"), 1, &color.r);
  return {};
}

gl::Int MesaRenderer::uniform(const char* name) const {
  return gl_.GetUniformLocation(program_, name);
}

void MesaRenderer::upload_mesh() {
  const VertexArrays arrays = vertex_arrays(mesh_of(bench_));
  index_count_ = gl::Size(arrays.indices.size());
  gl::Uint vertex_array = 0;
  std::array<gl::Uint, 2> buffers{};
  gl_.GenVertexArrays(1, &vertex_array);
  gl_.BindVertexArray(vertex_array);
  gl_.GenBuffers(2, buffers.data());
  const auto upload = [&](gl::Enum where, gl::Uint buffer, const auto& values) {
    gl_.BindBuffer(where, buffer);
    gl_.BufferData(where, std::ptrdiff_t(values.size() * sizeof(values[0])), values.data(),
                   gl::kStaticDraw);
  };
  upload(gl::kArrayBuffer, buffers[0], arrays.vertices);
  upload(gl::kElementArrayBuffer, buffers[1], arrays.indices);

  std::size_t offset = 0;  // floats
  const auto attribute = [&](bool present, unsigned at, int floats) {
    if (!present) return;
    // The API wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* offset_in_buffer = reinterpret_cast<const void*>(offset * sizeof(float));
    gl_.VertexAttribPointer(at, floats, gl::kFloat, gl::kFalse,
                            gl::Size(arrays.floats_per_vertex() * sizeof(float)), offset_in_buffer);
    gl_.EnableVertexAttribArray(at);
    offset += std::size_t(floats);
  };
  attribute(true, kPositionAt, 3);
  attribute(arrays.normals, kNormalAt, 3);
  attribute(arrays.texcoords, kTexcoordAt, 2);
  attribute(arrays.colors, kColorAt, 3);
}

void MesaRenderer::upload_texture() {
  const Texture& texture = bench_.scene.textures[*material_of(bench_).texture];
  const Image<Rgba8>& image = bench_.scene.images[texture.image];
  gl::Uint name = 0;
  gl_.GenTextures(1, &name);
  gl_.BindTexture(gl::kTexture2D, name);
  gl_.TexImage2D(gl::kTexture2D, 0, gl::kRgba8, image.width, image.height, 0, gl::kRgba,
                 gl::kUnsignedByte, image.pixels.data());
  for (const gl::Enum filter : {gl::kTextureMinFilter, gl::kTextureMagFilter}) {
    gl_.TexParameteri(gl::kTexture2D, filter, gl::kLinear);
  }
  for (const gl::Enum wrap : {gl::kTextureWrapS, gl::kTextureWrapT}) {
    gl_.TexParameteri(gl::kTexture2D, wrap, gl::kRepeat);
  }
}

// Both eyes of a pair share eye space.
void MesaRenderer::set_light() const {
  const View& view = bench_.passes.front().view;
  const Lighting lighting = light_scene(bench_.scene, view);
  const EyeLight& light = lighting.lights.front();
  gl_.Uniform3fv(uniform("towards_light"), 1, &light.towards.x);
  gl_.Uniform3fv(uniform("radiance"), 1, light.radiance.data());
  gl_.Uniform1f(uniform("ambient"), lighting.ambient);
  const auto normals = normal_transform(eye_from_object(bench_, view));
  gl_.UniformMatrix3fv(uniform("eye_normal_from_object"), 1, gl::kFalse, &normals.columns[0][0]);
}

// ---- frames ----

void MesaRenderer::draw_pass(std::size_t index) const {
  const auto bit = [](bool on) { return on ? gl::kTrue : gl::kFalse; };
  const ColorMask& mask = bench_.passes[index].mask;
  gl_.ColorMask(bit(mask.r), bit(mask.g), bit(mask.b), bit(mask.a));
  gl_.UniformMatrix4fv(clip_from_object_, 1, gl::kFalse, &matrices_[index][0][0]);
  gl_.DrawElements(gl::kTriangles, index_count_, gl::kUnsignedInt, nullptr);
}

double MesaRenderer::frame_ms() {
  double elapsed = 0;
  {
    const Stopwatch watch(elapsed);
    gl_.ColorMask(gl::kTrue, gl::kTrue, gl::kTrue, gl::kTrue);
    gl_.Clear(gl::kColorBufferBit | gl::kDepthBufferBit);
    for (std::size_t i = 0; i < bench_.passes.size(); ++i) {
      if (i > 0) gl_.Clear(gl::kDepthBufferBit);
      draw_pass(i);
    }
    gl_.Finish();
  }
  return elapsed;
}

Picture MesaRenderer::picture() const {
  const int width = bench_.width(), height = bench_.height();
  Picture read{Image<Rgba8>(width, height), Image<std::uint8_t>(width, height)};
  Image<float> depth(width, height);
  // OpenGL's rows come from the bottom.
  for (int y = 0; y < height; ++y) {
    const int row = height - 1 - y;
    gl_.ReadPixels(0, y, width, 1, gl::kRgba, gl::kUnsignedByte, &read.color.at(0, row));
    gl_.ReadPixels(0, y, width, 1, gl::kDepthComponent, gl::kFloat, &depth.at(0, row));
  }
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    read.covered.pixels[i] = depth.pixels[i] < 1.0f ? 1 : 0;
  }
  return read;
}

}  // namespace glassbox::study
