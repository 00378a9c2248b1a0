// A scene of the benchmark drawn by OpenGL, into a framebuffer of 8-bit colours and 32-bit depths.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/bench/mesa/osmesa.h"
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

// The scene's one mesh, with one directional light or none: what peers_draw_it says.
class MesaRenderer {
public:
  static Result<std::unique_ptr<MesaRenderer>> make(const BenchScene& bench);

  // "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6"
  std::string description() const;
  // From the first clear to the end of glFinish, in milliseconds.
  double frame_ms();
  // What the last frame drew.
  Picture picture() const;

private:
  MesaRenderer(const BenchScene& bench, std::unique_ptr<OsMesa> mesa);
  Result<void> make_framebuffer();
  Result<void> make_program();
  Result<gl::Uint> compile(gl::Enum kind, const std::string& text) const;
  void upload_mesh();
  void upload_texture();
  void set_light() const;
  void draw_pass(std::size_t index) const;
  gl::Int uniform(const char* name) const;

  const BenchScene& bench_;
  std::unique_ptr<OsMesa> mesa_;
  const gl::Functions& gl_;
  gl::Uint program_ = 0;
  gl::Size index_count_ = 0;
  gl::Int clip_from_object_ = -1;
  std::vector<glm::mat4> matrices_;  // by pass
};

}  // namespace glassbox::study
