// Light on surfaces, in eye space and linear light. For each light with incoming light E along the
// unit vector l (pointing at the light), unit normal n, unit vector v at the viewer, h = (l + v) /
// |l + v| (Blinn 1977):
//
//   diffuse  = ambient + sum E max(0, n . l)
//   specular = sum E max(0, n . h)^shininess          where n . l > 0
//   colour   = base_color * diffuse + material.specular * specular + emission
//
// E is the light's colour times its intensity over pi, so that a white matte surface facing a
// directional light of pi lux is exactly white; point and spot lights fall off with the square of
// the distance (KHR_lights_punctual).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glassbox/base/spaces.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// An upper limit for amounts of light (a light's radiance, the factor for its distance), so that no
// product of two such numbers overflows: infinity times 0 is NaN, which would make the brightest
// places black.
inline constexpr float kBrightest = 1e18f;

struct EyeLight {
  LightKind kind = LightKind::kDirectional;
  std::array<float, 3> radiance{};  // colour * intensity / pi
  Vector<Eye> towards;              // unit vector to the light, for directional and spot lights
  Point<Eye> position;              // for point and spot lights
  float inverse_range = 0;          // 0: no limit
  float cone_scale = 0;             // spot: clamp(cosine * scale + offset, 0, 1)^2
  float cone_offset = 0;
};

struct Lighting {
  std::vector<EyeLight> lights;
  float ambient = 0.1f;     // light from all directions
  bool perspective = true;  // false: the viewer is infinitely far away along +z
};

// Light that leaves a surface, before the surface's colours are multiplied in.
template <class F, std::size_t kChannels = 3>
struct ReflectionOf {
  std::array<F, kChannels> diffuse{};
  std::array<F, kChannels> specular{};
};
using Reflection = ReflectionOf<float>;

// The scene's lights as the view sees them. A scene without lights gets a headlight: directional,
// 0.9 pi lux, from behind the viewer's right shoulder, along (1, 1, 2) in eye space.
Lighting light_scene(const Scene& scene, const View& view);

// `normal_eye` need not be of unit length; a zero normal receives only the ambient light.
Reflection illuminate(const Lighting& lighting, const std::array<float, 3>& position_eye,
                      const std::array<float, 3>& normal_eye, int shininess);

}  // namespace glassbox
