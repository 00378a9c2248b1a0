// Light on surfaces: illuminate() of shading.h over lanes.

#if defined(GLASSBOX_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_LIGHTING_INL_H_
#undef GLASSBOX_LIGHTING_INL_H_
#else
#define GLASSBOX_LIGHTING_INL_H_
#endif

#include <glassbox/raster/lanes/lanes-inl.h>
#include <glassbox/raster/shading.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

HWY_INLINE Vec3 broadcast(const Vector<Eye>& v) {
  return {set(v.x), set(v.y), set(v.z)};
}

HWY_INLINE Vec3 normalised(const Vec3& v) {
  const VF length = hn::Sqrt(dot(v, v));
  const MF positive = hn::Gt(length, hn::Zero(kF));
  const Vec3 unit = scale(v, hn::Div(set(1.0f), length));
  return {hn::IfThenElseZero(positive, unit.x), hn::IfThenElseZero(positive, unit.y),
          hn::IfThenElseZero(positive, unit.z)};
}

HWY_INLINE VF power(VF base, int exponent) {
  VF result = set(1.0f);
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = hn::Mul(result, base);
    base = hn::Mul(base, base);
  }
  return result;
}

// std::min(a, b) and std::max(a, b): the first where neither is smaller, NaN included.
HWY_INLINE VF std_min(VF a, VF b) {
  return hn::IfThenElse(hn::Lt(b, a), b, a);
}
HWY_INLINE VF std_max(VF a, VF b) {
  return hn::IfThenElse(hn::Lt(a, b), b, a);
}

struct ArrivalLanes {
  Vec3 towards;
  VF fraction;
};

HWY_INLINE ArrivalLanes arrive(const EyeLight& light, const Vec3& at) {
  if (light.kind == LightKind::kDirectional) return {broadcast(light.towards), set(1.0f)};

  const Vec3 path =
      subtract({set(light.position.x), set(light.position.y), set(light.position.z)}, at);
  const VF squared = dot(path, path);
  const MF apart = hn::Gt(squared, hn::Zero(kF));
  ArrivalLanes arrival{normalised(path), std_min(hn::Div(set(1.0f), squared), set(kBrightest))};
  if (light.inverse_range > 0.0f) {
    const VF reach = hn::Mul(hn::Mul(squared, set(light.inverse_range)), set(light.inverse_range));
    arrival.fraction =
        hn::Mul(arrival.fraction, std_max(hn::Zero(kF), hn::Sub(set(1.0f), hn::Mul(reach, reach))));
  }
  if (light.kind == LightKind::kSpot) {
    const VF cosine = dot(broadcast(light.towards), arrival.towards);
    const VF ramp = hn::Add(hn::Mul(cosine, set(light.cone_scale)), set(light.cone_offset));
    const VF cone = hn::IfThenElse(hn::Lt(ramp, hn::Zero(kF)), hn::Zero(kF),
                                   hn::IfThenElse(hn::Lt(set(1.0f), ramp), set(1.0f), ramp));
    arrival.fraction = hn::Mul(arrival.fraction, hn::Mul(cone, cone));
  }
  arrival.towards = {hn::IfThenElseZero(apart, arrival.towards.x),
                     hn::IfThenElseZero(apart, arrival.towards.y),
                     hn::IfThenElseZero(apart, arrival.towards.z)};
  arrival.fraction = hn::IfThenElseZero(apart, arrival.fraction);
  return arrival;
}

struct ReflectionLanes {
  Vec3 diffuse, specular;
};

// Without `highlights` the specular part is not computed, and is 0.
HWY_INLINE ReflectionLanes illuminate(const Lighting& lighting, const Vec3& position,
                                      const Vec3& normal, int shininess, bool highlights) {
  const Vec3 n = normalised(normal);
  const VF ambient = set(lighting.ambient), zero = hn::Zero(kF);
  ReflectionLanes reflection{{ambient, ambient, ambient}, {zero, zero, zero}};
  Vec3 viewer{zero, zero, set(1.0f)};
  if (highlights && lighting.perspective) {
    viewer = normalised(
        {hn::Sub(zero, position.x), hn::Sub(zero, position.y), hn::Sub(zero, position.z)});
  }
  for (const EyeLight& light : lighting.lights) {
    const ArrivalLanes arrival = arrive(light, position);
    const VF facing = dot(n, arrival.towards);
    const MF lit = hn::Gt(facing, zero);
    const Vec3 incoming = scale(
        {set(light.radiance[0]), set(light.radiance[1]), set(light.radiance[2])}, arrival.fraction);
    const auto add_lit = [&](const Vec3& sum, VF factor) HWY_ATTR {
      const auto one = [&](VF s, VF i) HWY_ATTR {
        return hn::IfThenElse(lit, hn::Add(s, hn::Mul(i, factor)), s);
      };
      return Vec3{one(sum.x, incoming.x), one(sum.y, incoming.y), one(sum.z, incoming.z)};
    };
    reflection.diffuse = add_lit(reflection.diffuse, facing);
    if (!highlights) continue;
    const VF cosine =
        std_min(set(1.0f), std_max(zero, dot(n, normalised(add(arrival.towards, viewer)))));
    reflection.specular = add_lit(reflection.specular, power(cosine, shininess));
  }
  return reflection;
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
