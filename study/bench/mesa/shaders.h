// The shaders of the OpenGL peer: they compute exactly what Glassbox computes for the same material
// and lights (raster/shading.h).
#pragma once

#include <compare>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>

namespace glassbox::study {

// The attribute locations of the vertex shader's inputs.
inline constexpr unsigned kPositionAt = 0, kNormalAt = 1, kTexcoordAt = 2, kColorAt = 3;
// The texture units of the surface's colour and of its emission.
inline constexpr int kBaseColorUnit = 0, kEmissionUnit = 1;

struct LightIngredient {
  LightKind kind = LightKind::kDirectional;
  bool ranged = false;
  friend auto operator<=>(const LightIngredient&, const LightIngredient&) = default;
};

// What the colours of a draw depend on. Draws with the same ingredients share a program.
struct Ingredients {
  bool textured = false;
  bool colored = false;  // has vertex colours
  AlphaMode alpha = AlphaMode::kOpaque;
  bool emits = false;
  bool emission_textured = false;

  bool lit = false;  // the fields below matter only if this is true
  std::vector<LightIngredient> lights;
  bool perspective = true;
  bool two_sided = false;        // back faces are visible
  bool unequal_normals = false;  // the vertex normals may have different lengths in eye space
  int shininess = 0;             // 0: no highlights
  friend auto operator<=>(const Ingredients&, const Ingredients&) = default;
};

// Whether the light at a point of the surface depends on its position.
bool needs_eye_position(const Ingredients& ingredients);

std::string vertex_shader(const Ingredients& ingredients);
// The uniforms of light number i are towards_i, radiance_i, position_i, inverse_range_i and cone_i
// (scale, offset).
std::string fragment_shader(const Ingredients& ingredients);

}  // namespace glassbox::study
