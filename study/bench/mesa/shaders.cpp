#include "study/bench/mesa/shaders.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace glassbox::study {

namespace {

std::string head(const Ingredients& ingredients) {
  std::string text = "#version 330 core\n";
  const auto define = [&](bool wanted, const char* name) {
    if (wanted) text += fmt::format("#define {}\n", name);
  };
  define(ingredients.textured, "TEXTURED");
  define(ingredients.colored, "COLORED");
  define(ingredients.textured || ingredients.emission_textured, "HAS_UV");
  define(ingredients.alpha == AlphaMode::kMask, "MASKED");
  define(ingredients.alpha == AlphaMode::kBlend, "BLENDED");
  define(ingredients.emits, "EMITS");
  define(ingredients.emission_textured, "EMISSION_TEXTURED");
  define(ingredients.lit, "LIT");
  define(ingredients.two_sided, "TWO_SIDED");
  define(ingredients.unequal_normals, "UNEQUAL_NORMALS");
  define(needs_eye_position(ingredients), "HAS_PLACE");
  define(ingredients.shininess > 0, "HIGHLIGHTS");
  define(ingredients.perspective, "PERSPECTIVE");
  return text;
}

// Attributes are interpolated to pixel centres, even with several samples. OpenGL could also take
// them at the "centroid" of the covered samples; but the distances between centroids are irregular,
// so no mipmap level could be computed from the differences between neighbouring pixels.
constexpr const char* kVertex = R"(
uniform mat4 clip_from_object;
layout(location = 0) in vec3 position;
#ifdef LIT
uniform mat3 eye_normal_from_object;
layout(location = 1) in vec3 normal;
out vec3 eye_normal;
#endif
#ifdef HAS_PLACE
uniform mat4 eye_from_object;
out vec3 eye_position;
#endif
#ifdef HAS_UV
layout(location = 2) in vec2 texcoord;
out vec2 uv;
#endif
#ifdef COLORED
layout(location = 3) in vec4 color;
out vec4 vertex_color;
#endif

void main() {
  gl_Position = clip_from_object * vec4(position, 1.0);
#ifdef LIT
  eye_normal = eye_normal_from_object * normal;
#ifdef UNEQUAL_NORMALS
  eye_normal = normalize(eye_normal);
#endif
#endif
#ifdef HAS_PLACE
  eye_position = (eye_from_object * vec4(position, 1.0)).xyz;
#endif
#ifdef HAS_UV
  uv = texcoord;
#endif
#ifdef COLORED
  vertex_color = color;
#endif
}
)";

constexpr const char* kFragmentInputs = R"(
uniform vec4 base_color;
#ifdef HAS_UV
in vec2 uv;
#endif
#ifdef TEXTURED
uniform sampler2D image;
#endif
#ifdef COLORED
in vec4 vertex_color;
#endif
#ifdef MASKED
uniform float cutoff;
#endif
#ifdef EMITS
uniform vec3 emission;
#endif
#ifdef EMISSION_TEXTURED
uniform sampler2D emission_image;
#endif
#ifdef LIT
uniform float ambient;
in vec3 eye_normal;
#endif
#ifdef HAS_PLACE
in vec3 eye_position;
#endif
#ifdef HIGHLIGHTS
uniform vec3 specular_color;
#endif
out vec4 stored;
)";

constexpr const char* kSurface = R"(
void main() {
  vec4 color = base_color;
#ifdef COLORED
  color *= vertex_color;
#endif
#ifdef TEXTURED
  color *= texture(image, uv);
#endif
#ifdef EMITS
  vec3 own = emission;
#ifdef EMISSION_TEXTURED
  own *= texture(emission_image, uv).rgb;
#endif
#endif
#ifdef MASKED
  if (!(color.a >= cutoff)) discard;
#endif
#ifdef LIT
  vec3 n = normalize(eye_normal);
#ifdef TWO_SIDED
  if (!gl_FrontFacing) n = -n;
#endif
  vec3 diffuse = vec3(ambient);
#ifdef HIGHLIGHTS
  vec3 highlights = vec3(0.0);
#ifdef PERSPECTIVE
  vec3 viewer = normalize(-eye_position);
#else
  vec3 viewer = vec3(0.0, 0.0, 1.0);
#endif
#endif
#endif
)";

// The code for light number N.
constexpr const char* kLight = R"(  {
    vec3 arriving = radiance_N;
#ifdef PLACED_N
    vec3 path = position_N - eye_position;
    float squared = dot(path, path);
    vec3 towards = path * inversesqrt(squared);
    arriving *= min(1.0 / squared, 1e18);
#else
    vec3 towards = towards_N;
#endif
#ifdef RANGED_N
    float reach = squared * inverse_range_N * inverse_range_N;
    arriving *= max(0.0, 1.0 - reach * reach);
#endif
#ifdef SPOT_N
    float cone = clamp(dot(towards_N, towards) * cone_N.x + cone_N.y, 0.0, 1.0);
    arriving *= cone * cone;
#endif
    float facing = dot(n, towards);
    diffuse += arriving * max(0.0, facing);
#ifdef HIGHLIGHTS
    if (facing > 0.0) {
      float highlight = clamp(dot(n, normalize(towards + viewer)), 0.0, 1.0);
      highlights += arriving * to_shininess(highlight);
    }
#endif
  }
)";

constexpr const char* kLightInputs = R"(
uniform vec3 radiance_N;
#ifdef PLACED_N
uniform vec3 position_N;
#endif
#ifndef POINT_N
uniform vec3 towards_N;
#endif
#ifdef RANGED_N
uniform float inverse_range_N;
#endif
#ifdef SPOT_N
uniform vec2 cone_N;
#endif
)";

constexpr const char* kEnd = R"(
#ifdef LIT
  color.rgb *= diffuse;
#ifdef HIGHLIGHTS
  color.rgb += specular_color * highlights;
#endif
#endif
#ifdef EMITS
  color.rgb += own;
#endif
#ifdef BLENDED
  float alpha = clamp(color.a, 0.0, 1.0);
  stored = vec4(color.rgb * alpha, alpha);
#else
  stored = vec4(color.rgb, 1.0);
#endif
}
)";

std::string numbered(std::string text, std::size_t light) {
  constexpr std::string_view kNumber = "_N";
  for (std::size_t at = 0; (at = text.find(kNumber, at)) != std::string::npos;) {
    text.replace(at, kNumber.size(), fmt::format("_{}", light));
  }
  return text;
}

std::string light_inputs(const LightIngredient& light, std::size_t number) {
  std::string text;
  if (light.kind != LightKind::kDirectional) text += "#define PLACED_N\n";
  if (light.kind == LightKind::kPoint) text += "#define POINT_N\n";
  if (light.kind == LightKind::kSpot) text += "#define SPOT_N\n";
  if (light.ranged) text += "#define RANGED_N\n";
  return numbered(text + kLightInputs, number);
}

// Computes the power by repeated squaring, like power() in raster/formulas/lighting.h.
std::string power_function(int exponent) {
  std::string text = "float to_shininess(float base) {\n  float result = 1.0;\n";
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) text += "  result *= base;\n";
    if (exponent > 1) text += "  base *= base;\n";
  }
  return text + "  return result;\n}\n";
}

}  // namespace

bool needs_eye_position(const Ingredients& ingredients) {
  const auto is_placed = [](const LightIngredient& light) {
    return light.kind != LightKind::kDirectional;
  };
  return ingredients.lit && ((ingredients.shininess > 0 && ingredients.perspective) ||
                             std::ranges::any_of(ingredients.lights, is_placed));
}

std::string vertex_shader(const Ingredients& ingredients) {
  return head(ingredients) + kVertex;
}

std::string fragment_shader(const Ingredients& ingredients) {
  std::string text = head(ingredients) + kFragmentInputs;
  for (std::size_t i = 0; i < ingredients.lights.size(); ++i) {
    text += light_inputs(ingredients.lights[i], i);
  }
  if (ingredients.shininess > 0) text += power_function(ingredients.shininess);
  text += kSurface;
  for (std::size_t i = 0; i < ingredients.lights.size(); ++i) text += numbered(kLight, i);
  return text + kEnd;
}

}  // namespace glassbox::study
