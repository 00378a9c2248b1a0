// Light that arrives at a surface and light that leaves it. raster/shading.h has the formula whose
// terms these are.

// base^exponent by repeated squaring. It uses no library function, so it gives the same bits
// everywhere.
template <Number F>
inline F power(F base, int exponent) {
  F result = 1.0f;
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = result * base;
    base = base * base;
  }
  return result;
}

// The light that arrives at a point: its direction, and the fraction of the light's brightness that
// is left after the effects of distance, range and cone.
template <Number F>
struct IncidentLight {
  std::array<F, 3> towards;  // unit vector from the point to the light
  F fraction;
};

template <Number F>
inline IncidentLight<F> incident_light(const EyeLight& light, const std::array<F, 3>& at) {
  const std::array<F, 3> axis{F(light.towards.x), F(light.towards.y), F(light.towards.z)};
  if (light.kind == LightKind::kDirectional) return {axis, F(1.0f)};

  const std::array<F, 3> position{F(light.position.x), F(light.position.y), F(light.position.z)};
  const std::array<F, 3> path = difference(position, at);
  const F squared = dot(path, path);
  const std::array<F, 3> towards = unit(path);
  F fraction = least(1.0f / squared, F(kBrightest));
  if (light.inverse_range > 0.0f) {
    const F reach = squared * light.inverse_range * light.inverse_range;
    fraction = fraction * greatest(F(0.0f), 1.0f - reach * reach);
  }
  if (light.kind == LightKind::kSpot) {
    const F cosine = dot(axis, towards);
    const F cone = clamped(cosine * light.cone_scale + light.cone_offset, F(0.0f), F(1.0f));
    fraction = fraction * (cone * cone);
  }
  const auto apart = squared > 0.0f;
  return {zero_unless(apart, towards), select(apart, fraction, F(0.0f))};
}

// The light reflected by a surface. `normal` need not be of unit length. Without `highlights` the
// specular part is not computed and is 0. Computes kChannels channels, from channel `first` on.
template <std::size_t kChannels = 3, Number F>
inline ReflectionOf<F, kChannels> reflected_light(const Lighting& lighting,
                                                  const std::array<F, 3>& position,
                                                  const std::array<F, 3>& normal, int shininess,
                                                  bool highlights, std::size_t first = 0) {
  const F zero = 0.0f, ambient = lighting.ambient;
  const std::array<F, 3> n = unit(normal);
  std::array<F, 3> viewer{zero, zero, F(1.0f)};
  if (highlights && lighting.perspective) {
    viewer = unit(difference({zero, zero, zero}, position));
  }
  ReflectionOf<F, kChannels> reflection;
  reflection.diffuse.fill(ambient);
  reflection.specular.fill(zero);
  for (const EyeLight& light : lighting.lights) {
    const IncidentLight<F> incident = incident_light(light, position);
    const F facing = dot(n, incident.towards);
    const auto lit = facing > 0.0f;
    if (none(lit)) continue;
    F highlight = zero;
    if (highlights) {
      const F cosine = dot(n, unit(sum(incident.towards, viewer)));
      highlight = power(least(F(1.0f), greatest(zero, cosine)), shininess);
    }
    for (std::size_t i = 0; i < kChannels; ++i) {
      const F incoming = light.radiance[first + i] * incident.fraction;
      const F diffuse = reflection.diffuse[i], specular = reflection.specular[i];
      reflection.diffuse[i] = select(lit, diffuse + incoming * facing, diffuse);
      if (highlights) {
        reflection.specular[i] = select(lit, specular + incoming * highlight, specular);
      }
    }
  }
  return reflection;
}

// The light that a surface sends out, given the light that falls on it. A surface without a normal
// shows its base colour unlit (glTF 2.0, 3.7.2.1). Without `highlights` the specular part is left
// out.
template <Number F, std::size_t kChannels>
inline std::array<F, kChannels> reflected_color(const std::array<F, kChannels>& base,
                                                const std::array<F, 3>& normal,
                                                const ReflectionOf<F, kChannels>& light,
                                                const std::array<float, kChannels>& specular,
                                                bool highlights) {
  const auto has_normal = normal[0] != 0.0f || normal[1] != 0.0f || normal[2] != 0.0f;
  std::array<F, kChannels> color;
  for (std::size_t i = 0; i < kChannels; ++i) {
    F reflected = base[i] * light.diffuse[i];
    if (highlights) reflected = reflected + specular[i] * light.specular[i];
    color[i] = select(has_normal, reflected, base[i]);
  }
  return color;
}
