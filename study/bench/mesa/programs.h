// The shader programs of the OpenGL peer, one for each set of ingredients (what the colours of a
// draw depend on, see shaders.h).
#pragma once

#include <map>

#include <glassbox/base/error.h>
#include <glassbox/raster/shading.h>

#include "study/bench/mesa/gl.h"
#include "study/bench/mesa/shaders.h"

namespace glassbox::study {

// A linked program and the locations of its uniforms; the location is -1 for a uniform that the
// program does not have.
struct GlProgram {
  gl::Uint name = 0;
  gl::Int clip_from_object = -1, eye_from_object = -1, eye_normal_from_object = -1;
  gl::Int base_color = -1, cutoff = -1, emission = -1, specular_color = -1;
};

class GlPrograms {
public:
  GlPrograms(const gl::Functions& gl, const Lighting& lighting) : gl_(gl), lighting_(lighting) {}

  // Returns the program for these ingredients. It is compiled, and its lights are set, on the first
  // request. The pointer stays valid.
  Result<const GlProgram*> program_for(const Ingredients& ingredients);

private:
  Result<GlProgram> make(const Ingredients& ingredients) const;
  Result<gl::Uint> compile(gl::Enum kind, const std::string& text) const;
  // Sets the lights of `program`, which must be in use.
  void set_lights(gl::Uint program) const;

  const gl::Functions& gl_;
  Lighting lighting_;
  std::map<Ingredients, GlProgram> made_;
};

}  // namespace glassbox::study
