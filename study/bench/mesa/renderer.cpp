#include "study/bench/mesa/renderer.h"

#include <algorithm>

#include <glassbox/raster/transfer.h>
#include <glassbox/render/engine/stopwatch.h>

#include "study/bench/mesa/refusal.h"

namespace glassbox::study {

struct MesaRenderer::State {
  const GlProgram* program = nullptr;
  const Material* material = nullptr;
  gl::Uint vertex_array = 0, texture = 0, emission_texture = 0;
  std::optional<CulledFaces> culled_faces;
  std::optional<bool> mirrored, blended;
};

Result<std::unique_ptr<MesaRenderer>> MesaRenderer::make(const BenchScene& bench) {
  auto mesa = OsMesa::open();
  if (!mesa) return tl::unexpected(mesa.error());
  std::unique_ptr<MesaRenderer> made(new MesaRenderer(bench, std::move(*mesa)));
  if (const auto ready = made->set_up(); !ready) return tl::unexpected(ready.error());
  return made;
}

MesaRenderer::MesaRenderer(const BenchScene& bench, std::unique_ptr<OsMesa> mesa)
    : bench_(bench),
      prepared_(prepare_scene(bench.scene, bench.settings.transfer)),
      mesa_(std::move(mesa)),
      gl_(mesa_->gl()),
      meshes_(bench.scene.meshes.size()),
      textures_(bench.scene.textures.size()) {}

std::string MesaRenderer::description() const {
  const auto text = [&](gl::Enum what) {
    return std::string(reinterpret_cast<const char*>(gl_.GetString(what)));
  };
  const std::string version = text(gl::kVersion);  // for example "3.3 (Core Profile) Mesa 22.3.6"
  return text(gl::kRenderer) + ", " +
         version.substr(std::min(version.find("Mesa"), version.size()));
}

// ---- set-up ----

Result<void> MesaRenderer::set_up() {
  const RenderSettings& settings = bench_.settings;
  auto framebuffer = GlFramebuffer::make(
      gl_, {bench_.width(), bench_.height(), settings.samples, settings.transfer});
  if (!framebuffer) return tl::unexpected(framebuffer.error());
  framebuffer_ = *framebuffer;
  const Rgba8& back = settings.background;
  const auto linear = [&](std::uint8_t stored) { return decode(settings.transfer, stored); };
  gl_.ClearColor(linear(back.r), linear(back.g), linear(back.b), 1.0f);
  gl_.Enable(gl::kDepthTest);
  gl_.DepthFunc(gl::kLess);
  // The shaders multiply the colour by alpha, because OpenGL would clamp the light before it blends
  // (4.1.8 of its specification): a highlight brighter than white must be multiplied before it is
  // clamped.
  gl_.BlendFunc(gl::kOne, gl::kOneMinusSourceAlpha);
  for (const BenchPass& pass : bench_.passes) {
    const DrawList list = make_draw_list(bench_.scene, prepared_, pass.view);
    // Both eyes of a stereo pair have the same eye space, so the lights in it are the same too.
    if (!programs_) programs_.emplace(gl_, list.lighting);
    passes_.emplace_back();
    if (const auto made = make_draws(list); !made) return made;
  }
  if (gl_.GetError() != 0) return refused("OpenGL reported an error when the scene was set up");
  return {};
}

// Makes the draws of the pass that was added last.
Result<void> MesaRenderer::make_draws(const DrawList& list) {
  const View& view = bench_.passes[passes_.size() - 1].view;
  for (const PeerDraw& peer_draw : peer_draws(bench_, list, view)) {
    if (prepared_.meshes[peer_draw.mesh].triangulation.triangles.empty()) continue;
    if (peer_draw.culled_faces == CulledFaces::kAll) continue;
    const auto program = programs_->program_for(ingredients_of(bench_, peer_draw, list.lighting));
    if (!program) return tl::unexpected(program.error());
    passes_.back().push_back({peer_draw, *program, mesh_of(peer_draw),
                              texture_of(peer_draw.texture),
                              texture_of(peer_draw.emission_texture)});
  }
  return {};
}

GlMesh MesaRenderer::mesh_of(const PeerDraw& draw) {
  std::optional<GlMesh>& uploaded = meshes_[draw.mesh];
  if (!uploaded) {
    const PreparedMesh& prepared = prepared_.meshes[draw.mesh];
    uploaded = upload_mesh(gl_, vertex_arrays(bench_.scene.meshes[draw.mesh], prepared,
                                              !draw.material->unlit, anchor_for(prepared.bounds)));
  }
  return *uploaded;
}

gl::Uint MesaRenderer::texture_of(std::uint32_t texture) {
  if (texture == kNone) return 0;
  gl::Uint& uploaded = textures_[texture];
  if (uploaded == 0) {
    uploaded = upload_texture(gl_, prepared_.textures[texture]->get(),
                              bench_.scene.textures[texture].sampler, bench_.settings.transfer);
  }
  return uploaded;
}

// ---- frames ----

double MesaRenderer::frame_ms() {
  double elapsed = 0;
  {
    const Stopwatch watch(elapsed);
    framebuffer_->draw_to_samples();
    draw_frame();
    framebuffer_->resolve();
    gl_.Finish();
  }
  return elapsed;
}

Picture MesaRenderer::picture() {
  frame_ms();
  Picture read{framebuffer_->colors(), {}};
  framebuffer_->draw_to_centres();
  draw_frame();
  read.covered = framebuffer_->covered();
  return read;
}

void MesaRenderer::draw_frame() const {
  gl_.ColorMask(gl::kTrue, gl::kTrue, gl::kTrue, gl::kTrue);
  gl_.DepthMask(gl::kTrue);
  gl_.Clear(gl::kColorBufferBit | gl::kDepthBufferBit);
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    gl_.DepthMask(gl::kTrue);
    if (i > 0) gl_.Clear(gl::kDepthBufferBit);
    draw_pass(i);
  }
}

void MesaRenderer::draw_pass(std::size_t pass) const {
  const auto bit = [](bool on) { return on ? gl::kTrue : gl::kFalse; };
  const ColorMask& mask = bench_.passes[pass].mask;
  gl_.ColorMask(bit(mask.r), bit(mask.g), bit(mask.b), bit(mask.a));
  State state;
  for (const GlDraw& draw : passes_[pass]) {
    const PeerDraw& peer_draw = draw.peer_draw;
    const GlProgram& program = *draw.program;
    if (state.program != draw.program || state.material != peer_draw.material) {
      set_material(draw, state);
    }
    set_textures(draw, state);
    set_faces(peer_draw, state);
    set_blending(peer_draw, state);
    gl_.UniformMatrix4fv(program.clip_from_object, 1, gl::kFalse,
                         &peer_draw.clip_from_object[0][0]);
    if (program.eye_from_object >= 0) {
      gl_.UniformMatrix4fv(program.eye_from_object, 1, gl::kFalse,
                           &peer_draw.eye_from_object[0][0]);
    }
    if (program.eye_normal_from_object >= 0) {
      gl_.UniformMatrix3fv(program.eye_normal_from_object, 1, gl::kFalse,
                           &peer_draw.eye_normal_from_object[0][0]);
    }
    if (state.vertex_array != draw.mesh.vertex_array) gl_.BindVertexArray(draw.mesh.vertex_array);
    state.vertex_array = draw.mesh.vertex_array;
    gl_.DrawElements(gl::kTriangles, draw.mesh.index_count, gl::kUnsignedInt, nullptr);
  }
}

void MesaRenderer::set_material(const GlDraw& draw, State& state) const {
  const Material& material = *draw.peer_draw.material;
  const GlProgram& program = *draw.program;
  if (state.program != draw.program) gl_.UseProgram(program.name);
  gl_.Uniform4fv(program.base_color, 1, &material.base_color.r);
  gl_.Uniform1f(program.cutoff, material.alpha_cutoff);
  gl_.Uniform3fv(program.emission, 1, draw.peer_draw.emission.data());
  gl_.Uniform3fv(program.specular_color, 1, material.specular.data());
  state.program = draw.program;
  state.material = draw.peer_draw.material;
}

void MesaRenderer::set_textures(const GlDraw& draw, State& state) const {
  const auto bind = [&](int unit, gl::Uint texture, gl::Uint& bound) {
    if (texture == 0 || texture == bound) return;
    gl_.ActiveTexture(gl::kTexture0 + gl::Enum(unit));
    gl_.BindTexture(gl::kTexture2D, texture);
    bound = texture;
  };
  bind(kBaseColorUnit, draw.texture, state.texture);
  bind(kEmissionUnit, draw.emission_texture, state.emission_texture);
}

void MesaRenderer::set_faces(const PeerDraw& draw, State& state) const {
  if (state.culled_faces != draw.culled_faces) {
    if (draw.culled_faces == CulledFaces::kNone) {
      gl_.Disable(gl::kCullFace);
    } else {
      gl_.Enable(gl::kCullFace);
      gl_.CullFace(draw.culled_faces == CulledFaces::kBack ? gl::kBack : gl::kFront);
    }
  }
  // The picture is upside down, so counter-clockwise triangles become clockwise.
  if (state.mirrored != draw.mirrored) {
    gl_.FrontFace(draw.mirrored ? gl::kCounterClockwise : gl::kClockwise);
  }
  state.culled_faces = draw.culled_faces;
  state.mirrored = draw.mirrored;
}

void MesaRenderer::set_blending(const PeerDraw& draw, State& state) const {
  const bool blended = draw.material->alpha_mode == AlphaMode::kBlend;
  if (state.blended == blended) return;
  if (blended) {
    gl_.Enable(gl::kBlend);
  } else {
    gl_.Disable(gl::kBlend);
  }
  gl_.DepthMask(blended ? gl::kFalse : gl::kTrue);
  state.blended = blended;
}

}  // namespace glassbox::study
