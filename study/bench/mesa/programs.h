// The OpenGL peer's programs, one for each set of ingredients.
#pragma once

#include <map>

#include <glassbox/base/error.h>
#include <glassbox/raster/shading.h>

#include "study/bench/mesa/gl.h"
#include "study/bench/mesa/shaders.h"

namespace glassbox::study {

// A linked program; its uniforms are -1 where it has none of the name.
struct GlProgram {
  gl::Uint name = 0;
  gl::Int clip_from_object = -1, eye_from_object = -1, eye_normal_from_object = -1;
  gl::Int base_color = -1, cutoff = -1, emission = -1, specular_color = -1;
};

class GlPrograms {
public:
  GlPrograms(const gl::Functions& gl, const Lighting& lighting) : gl_(gl), lighting_(lighting) {}

  // Made and lit when it is asked for first. It stays where it is.
  Result<const GlProgram*> with(const Ingredients& ingredients);

private:
  Result<GlProgram> make(const Ingredients& ingredients) const;
  Result<gl::Uint> compile(gl::Enum kind, const std::string& text) const;
  // In the program that is in use.
  void set_lights(gl::Uint program) const;

  const gl::Functions& gl_;
  Lighting lighting_;
  std::map<Ingredients, GlProgram> made_;
};

}  // namespace glassbox::study
