#include <glassbox/raster/shading.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/raster/light_formulas.h>

namespace glassbox {

namespace {

Vector<Eye> eye_direction(const Transform<Eye, World>& eye_from_world,
                          const Vector<World, double>& v) {
  const Vector<Eye, double> eye = eye_from_world * v;
  return {float(eye.x), float(eye.y), float(eye.z)};
}

EyeLight eye_light(const Light& light, const Transform<Eye, World>& eye_from_world) {
  EyeLight eye;
  eye.kind = light.kind;
  for (std::size_t i = 0; i < 3; ++i) {
    eye.radiance[i] =
        float(std::min(double(light.color[i]) * light.intensity / kPi, double(kBrightest)));
  }
  eye.towards = eye_direction(eye_from_world, -light.direction);
  const Point<Eye, double> position = eye_from_world * light.position;
  eye.position = {float(position.x), float(position.y), float(position.z)};
  eye.inverse_range = light.range ? float(1.0 / *light.range) : 0.0f;
  const double inner = sin_cos(light.inner_cone_radians).cos;
  const double outer = sin_cos(light.outer_cone_radians).cos;
  const double scale = 1.0 / std::max(0.001, inner - outer);
  eye.cone_scale = float(scale);
  eye.cone_offset = float(-outer * scale);
  return eye;
}

EyeLight headlight() {
  EyeLight light;
  light.radiance = {0.9f, 0.9f, 0.9f};
  const auto [x, y, z] = unit<float>({1.0f, 1.0f, 2.0f});
  light.towards = {x, y, z};
  return light;
}

}  // namespace

Lighting light_scene(const Scene& scene, const View& view) {
  Lighting lighting;
  lighting.perspective = view.perspective;
  for (const Light& light : scene.lights) {
    lighting.lights.push_back(eye_light(light, view.eye_from_world));
  }
  if (lighting.lights.empty()) lighting.lights.push_back(headlight());
  return lighting;
}

Reflection illuminate(const Lighting& lighting, const std::array<float, 3>& position_eye,
                      const std::array<float, 3>& normal_eye, int shininess) {
  constexpr bool kHighlights = true;
  return reflected_light(lighting, position_eye, normal_eye, shininess, kHighlights);
}

}  // namespace glassbox
