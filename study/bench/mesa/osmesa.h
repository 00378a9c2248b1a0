// An OpenGL context without a display: Mesa's OSMesa, opened at run time if it is installed.
#pragma once

#include <memory>

#include <glassbox/base/error.h>

#include "study/bench/mesa/gl.h"

namespace glassbox::study {

// The context is current on the thread that creates it, until it is destroyed.
class OsMesa {
public:
  static Result<std::unique_ptr<OsMesa>> open();
  ~OsMesa();
  OsMesa(const OsMesa&) = delete;
  OsMesa& operator=(const OsMesa&) = delete;

  const gl::Functions& gl() const { return gl_; }

private:
  OsMesa() = default;
  Result<void> make_context();
  Result<void> find_functions();

  void* library_ = nullptr;
  void* context_ = nullptr;
  // OSMesa needs a default framebuffer of its own; nothing is drawn into it.
  unsigned char unused_[4 * 4 * 4] = {};
  gl::Functions gl_;
};

}  // namespace glassbox::study
