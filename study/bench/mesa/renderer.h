// Draws a scene with OpenGL, into a framebuffer of 8-bit colours and 32-bit depths.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/render/engine/prepared_scene.h>

#include "study/bench/mesa/draws.h"
#include "study/bench/mesa/framebuffer.h"
#include "study/bench/mesa/osmesa.h"
#include "study/bench/mesa/programs.h"
#include "study/bench/mesa/uploads.h"
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

// The scene must be one for which peer_cannot_draw (limits.h) gives no reason.
class MesaRenderer {
public:
  static Result<std::unique_ptr<MesaRenderer>> make(const BenchScene& bench);

  // For example "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6".
  std::string description() const;
  // Draws a frame. Returns the time from the first clear to the end of glFinish, in milliseconds.
  double frame_ms();
  // Draws a frame and returns its picture.
  Picture picture();

private:
  struct GlDraw {
    PeerDraw peer_draw;
    const GlProgram* program = nullptr;
    GlMesh mesh;
    gl::Uint texture = 0, emission_texture = 0;  // 0: none
  };
  // The OpenGL state that the previous draw has left.
  struct State;

  MesaRenderer(const BenchScene& bench, std::unique_ptr<OsMesa> mesa);
  Result<void> set_up();
  Result<void> make_draws(const DrawList& list);
  GlMesh mesh_of(const PeerDraw& draw);
  gl::Uint texture_of(std::uint32_t texture);

  void draw_frame() const;
  void draw_pass(std::size_t pass) const;
  void set_material(const GlDraw& draw, State& state) const;
  void set_textures(const GlDraw& draw, State& state) const;
  void set_faces(const PeerDraw& draw, State& state) const;
  void set_blending(const PeerDraw& draw, State& state) const;

  const BenchScene& bench_;
  PreparedScene prepared_;
  std::unique_ptr<OsMesa> mesa_;
  const gl::Functions& gl_;
  std::optional<GlFramebuffer> framebuffer_;
  std::optional<GlPrograms> programs_;
  std::vector<std::optional<GlMesh>> meshes_;  // indexed by mesh
  std::vector<gl::Uint> textures_;             // indexed by texture; 0 where no draw uses it
  std::vector<std::vector<GlDraw>> passes_;
};

}  // namespace glassbox::study
