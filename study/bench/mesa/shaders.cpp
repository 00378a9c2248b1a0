#include "study/bench/mesa/shaders.h"

namespace glassbox::study {

namespace {

std::string head(const Ingredients& ingredients) {
  std::string text = "#version 330 core\n";
  if (ingredients.lit) text += "#define LIT\n";
  if (ingredients.textured) text += "#define TEXTURED\n";
  if (ingredients.colored) text += "#define COLORED\n";
  return text;
}

constexpr const char* kVertex = R"(
uniform mat4 clip_from_object;
layout(location = 0) in vec3 position;
#ifdef LIT
uniform mat3 eye_normal_from_object;
layout(location = 1) in vec3 normal;
out vec3 eye_normal;
#endif
#ifdef TEXTURED
layout(location = 2) in vec2 texcoord;
out vec2 uv;
#endif
#ifdef COLORED
layout(location = 3) in vec3 color;
out vec3 vertex_color;
#endif

void main() {
  gl_Position = clip_from_object * vec4(position, 1.0);
#ifdef LIT
  eye_normal = eye_normal_from_object * normal;
#endif
#ifdef TEXTURED
  uv = texcoord;
#endif
#ifdef COLORED
  vertex_color = color;
#endif
}
)";

constexpr const char* kFragment = R"(
uniform vec3 base_color;
#ifdef LIT
uniform vec3 towards_light;
uniform vec3 radiance;
uniform float ambient;
in vec3 eye_normal;
#endif
#ifdef TEXTURED
uniform sampler2D image;
in vec2 uv;
#endif
#ifdef COLORED
in vec3 vertex_color;
#endif
out vec4 stored;

void main() {
  vec3 color = base_color;
#ifdef COLORED
  color *= vertex_color;
#endif
#ifdef TEXTURED
  color *= texture(image, uv).rgb;
#endif
#ifdef LIT
  color *= ambient + radiance * max(0.0, dot(normalize(eye_normal), towards_light));
#endif
  stored = vec4(color, 1.0);
}
)";

}  // namespace

std::string vertex_shader(const Ingredients& ingredients) {
  return head(ingredients) + kVertex;
}

std::string fragment_shader(const Ingredients& ingredients) {
  return head(ingredients) + kFragment;
}

}  // namespace glassbox::study
