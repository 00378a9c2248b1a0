#include <glassbox/raster/shading.h>

#include <algorithm>
#include <cmath>

#include <glassbox/base/trig.h>

namespace glassbox {

namespace {

Vector<Eye> normalised(const Vector<Eye>& v) {
  const float length = std::sqrt(dot(v, v));
  return length > 0.0f ? v * (1.0f / length) : Vector<Eye>{};
}

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
  light.towards = normalised({1.0f, 1.0f, 2.0f});
  return light;
}

// base^exponent by repeated squaring: no library function, so the same bits everywhere.
float power(float base, int exponent) {
  float result = 1.0f;
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) result *= base;
    base *= base;
  }
  return result;
}

// What is left of a light at a point: distance, range and cone.
struct Arrival {
  Vector<Eye> towards;  // unit vector at the light
  float fraction = 1;
};

Arrival arrive(const EyeLight& light, const Point<Eye>& at) {
  if (light.kind == LightKind::kDirectional) return {light.towards, 1.0f};

  const Vector<Eye> path = light.position - at;
  const float squared = dot(path, path);
  if (!(squared > 0.0f)) return {{}, 0.0f};
  Arrival arrival{normalised(path), std::min(1.0f / squared, kBrightest)};
  if (light.inverse_range > 0.0f) {
    const float reach = squared * light.inverse_range * light.inverse_range;
    arrival.fraction *= std::max(0.0f, 1.0f - reach * reach);
  }
  if (light.kind == LightKind::kSpot) {
    const float cosine = dot(light.towards, arrival.towards);
    const float cone = std::clamp(cosine * light.cone_scale + light.cone_offset, 0.0f, 1.0f);
    arrival.fraction *= cone * cone;
  }
  return arrival;
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
  const Point<Eye> position{position_eye[0], position_eye[1], position_eye[2]};
  const Vector<Eye> n = normalised({normal_eye[0], normal_eye[1], normal_eye[2]});
  const Vector<Eye> viewer =
      lighting.perspective ? normalised(Point<Eye>{} - position) : Vector<Eye>{0.0f, 0.0f, 1.0f};

  Reflection reflection{{lighting.ambient, lighting.ambient, lighting.ambient}, {}};
  for (const EyeLight& light : lighting.lights) {
    const Arrival arrival = arrive(light, position);
    const float facing = dot(n, arrival.towards);
    if (!(facing > 0.0f)) continue;
    const float cosine =
        std::min(1.0f, std::max(0.0f, dot(n, normalised(arrival.towards + viewer))));
    const float highlight = power(cosine, shininess);
    for (std::size_t i = 0; i < 3; ++i) {
      const float incoming = light.radiance[i] * arrival.fraction;
      reflection.diffuse[i] += incoming * facing;
      reflection.specular[i] += incoming * highlight;
    }
  }
  return reflection;
}

}  // namespace glassbox
