#include "study/bench/mesa/programs.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "study/bench/mesa/refusal.h"

namespace glassbox::study {

Result<const GlProgram*> GlPrograms::program_for(const Ingredients& ingredients) {
  auto known = made_.find(ingredients);
  if (known == made_.end()) {
    const auto program = make(ingredients);
    if (!program) return tl::unexpected(program.error());
    known = made_.emplace(ingredients, *program).first;
  }
  return &known->second;
}

Result<GlProgram> GlPrograms::make(const Ingredients& ingredients) const {
  GlProgram program;
  program.name = gl_.CreateProgram();
  for (const auto& [kind, text] : {std::pair{gl::kVertexShader, vertex_shader(ingredients)},
                                   std::pair{gl::kFragmentShader, fragment_shader(ingredients)}}) {
    const auto shader = compile(kind, text);
    if (!shader) return tl::unexpected(shader.error());
    gl_.AttachShader(program.name, *shader);
  }
  gl_.LinkProgram(program.name);
  gl::Int linked = 0;
  gl_.GetProgramiv(program.name, gl::kLinkStatus, &linked);
  if (linked == 0) return refused("the shaders cannot be linked");
  const auto uniform = [&](const char* name) { return gl_.GetUniformLocation(program.name, name); };
  program.clip_from_object = uniform("clip_from_object");
  program.eye_from_object = uniform("eye_from_object");
  program.eye_normal_from_object = uniform("eye_normal_from_object");
  program.base_color = uniform("base_color");
  program.cutoff = uniform("cutoff");
  program.emission = uniform("emission");
  program.specular_color = uniform("specular_color");
  gl_.UseProgram(program.name);
  gl_.Uniform1i(uniform("image"), kBaseColorUnit);
  gl_.Uniform1i(uniform("emission_image"), kEmissionUnit);
  set_lights(program.name);
  return program;
}

Result<gl::Uint> GlPrograms::compile(gl::Enum kind, const std::string& text) const {
  const gl::Uint shader = gl_.CreateShader(kind);
  const char* lines = text.c_str();
  gl_.ShaderSource(shader, 1, &lines, nullptr);
  gl_.CompileShader(shader);
  gl::Int compiled = 0;
  gl_.GetShaderiv(shader, gl::kCompileStatus, &compiled);
  if (compiled != 0) return shader;
  std::array<char, 1000> log{};
  gl_.GetShaderInfoLog(shader, gl::Size(log.size()), nullptr, log.data());
  return refused(std::string("a shader was refused: ") + log.data());
}

void GlPrograms::set_lights(gl::Uint program) const {
  gl_.Uniform1f(gl_.GetUniformLocation(program, "ambient"), lighting_.ambient);
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const EyeLight& light = lighting_.lights[i];
    const auto uniform = [&](const char* name) {
      return gl_.GetUniformLocation(program, fmt::format("{}_{}", name, i).c_str());
    };
    gl_.Uniform3fv(uniform("radiance"), 1, light.radiance.data());
    gl_.Uniform3fv(uniform("towards"), 1, &light.towards.x);
    gl_.Uniform3fv(uniform("position"), 1, &light.position.x);
    gl_.Uniform1f(uniform("inverse_range"), light.inverse_range);
    gl_.Uniform2f(uniform("cone"), light.cone_scale, light.cone_offset);
  }
}

}  // namespace glassbox::study
