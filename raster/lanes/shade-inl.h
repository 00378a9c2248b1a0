// Colours of fragments: attributes, texture and light, as fragments.cpp has them, over lanes. All fragments of a call belong to one
// draw; each has a small triangle of its own, or all share a large one.

#if defined(GLASSBOX_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHADE_INL_H_
#undef GLASSBOX_SHADE_INL_H_
#else
#define GLASSBOX_SHADE_INL_H_
#endif

#include <glassbox/raster/lanes/interpolate-inl.h>
#include <glassbox/raster/lanes/lighting-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// ---- where attributes come from ----

struct TexcoordLanes {
  VF u, v;
};
struct TexcoordTriples {
  Triple<VF> u, v;
};
// TexturePlanes of texture.h.
struct PlaneLanes {
  TexcoordLanes origin;
  TexcoordLanes over_w[2];
  VF inverse_w[2];
};

template <class T>
HWY_INLINE Vec3 gather_vec3(const T* table, VI at) {
  const float* from = &table->x;
  const VI word = hn::Add(hn::Add(at, at), at);
  const Pair xy = gather_pair(reinterpret_cast<const std::int32_t*>(from), word);
  return {hn::BitCast(kF, xy.first), hn::BitCast(kF, xy.second),
          hn::GatherIndex(kF, from + 2, word)};
}

// A small triangle in every lane: gathered from the draw's tables.
class SmallSource {
public:
  // `reference`: of the lane's triangle, less the draw's first.
  HWY_INLINE SmallSource(const ShadeDraw& draw, VI reference, VI pixel_x, VI pixel_y)
      : draw_(draw),
        triangle_(hn::ShiftRight<3>(reference)),
        order_(order_of_code(reference)),
        vertices_(put_in_order(order_, gather_indices(draw.positions, triangle_))) {
    static_assert(kReferenceStep == 1 << 3);
    const Triple<VI> entries = entries_of(vertices_);
    Triple<VI> x, y;
    gather_position(draw.screen, entries, x, y);
    const Triple<VF> inverse_w = gather_inverse_w(draw.screen, entries);
    const VI at_x = hn::Add(hn::ShiftLeft<kSubpixelBits>(pixel_x), set(kPixelCentre));
    const VI at_y = hn::Add(hn::ShiftLeft<kSubpixelBits>(pixel_y), set(kPixelCentre));
    const EdgeLanes edge1 = edge_at(x.v2, y.v2, x.v0, y.v0, at_x, at_y);
    const EdgeLanes edge2 = edge_at(x.v0, y.v0, x.v1, y.v1, at_x, at_y);
    const VI area = double_area(x, y);
    const VI e0 = hn::Sub(hn::Sub(area, edge1.value), edge2.value);
    const VF inverse_area = hn::Div(set(1.0f), to_float(area));
    lambda1_ = hn::Mul(to_float(edge1.value), inverse_area);
    lambda2_ = hn::Mul(to_float(edge2.value), inverse_area);
    at_ = draw.w_is_one
              ? FragmentLanes{lambda1_, lambda2_, inverse_w.v0}
              : fragment_from(hn::Mul(to_float(e0), inverse_area), lambda1_, lambda2_, inverse_w);
    const auto slope = [&](VI step, VF over_w) HWY_ATTR {
      return hn::Mul(hn::Mul(to_float(hn::ShiftLeft<kSubpixelBits>(step)), inverse_area), over_w);
    };
    // Edge 0 runs from vertex 1 to vertex 2.
    slopes_[0] = {slope(hn::Sub(y.v1, y.v2), inverse_w.v0), slope(edge1.a, inverse_w.v1),
                  slope(edge2.a, inverse_w.v2)};
    slopes_[1] = {slope(hn::Sub(x.v2, x.v1), inverse_w.v0), slope(edge1.b, inverse_w.v1),
                  slope(edge2.b, inverse_w.v2)};
    affine_ = hn::And(hn::Eq(inverse_w.v0, inverse_w.v1), hn::Eq(inverse_w.v1, inverse_w.v2));
  }

  const FragmentLanes& at() const { return at_; }
  HWY_INLINE VF depth() const {
    const Triple<VF> z = gather_z(draw_.screen, entries_of(vertices_));
    return depth_at(z.v0, hn::Sub(z.v1, z.v0), hn::Sub(z.v2, z.v0), lambda1_, lambda2_);
  }

  HWY_INLINE Vec3 normal() const {
    const Triple<VI> corner = corners(draw_.normal_indices);
    const Vec3 n = interpolate(at_, Vec3Triple{facing(gather_vec3(draw_.normals, corner.v0)),
                                               facing(gather_vec3(draw_.normals, corner.v1)),
                                               facing(gather_vec3(draw_.normals, corner.v2))});
    return n;
  }
  HWY_INLINE Vec3 position() const {
    return interpolate(at_, Vec3Triple{gather_vec3(draw_.eye_positions, vertices_.v0),
                                       gather_vec3(draw_.eye_positions, vertices_.v1),
                                       gather_vec3(draw_.eye_positions, vertices_.v2)});
  }
  HWY_INLINE RgbLanes color() const {
    const Triple<VI> corner = corners(draw_.color_indices);
    const float* table = &draw_.colors->r;
    const auto channel = [&](int c) HWY_ATTR {
      const auto at_vertex = [&](VI i) HWY_ATTR {
        return hn::GatherIndex(kF, table + c, hn::ShiftLeft<2>(i));
      };
      return interpolate(at_, at_vertex(corner.v0), at_vertex(corner.v1), at_vertex(corner.v2));
    };
    return {channel(0), channel(1), channel(2)};
  }
  HWY_INLINE TexcoordLanes texcoord() const {
    const TexcoordTriples t = texcoords();
    return {interpolate(at_, t.u), interpolate(at_, t.v)};
  }
  // As texture_planes() of texture.h.
  HWY_INLINE PlaneLanes texture_planes() const {
    const TexcoordTriples t = texcoords();
    PlaneLanes planes;
    planes.origin = {t.u.v0, t.v.v0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Triple<VF>& slope = slopes_[axis];
      const auto over_w = [&](const Triple<VF>& c) HWY_ATTR {
        return hn::Add(hn::Mul(slope.v1, hn::Sub(c.v1, c.v0)),
                       hn::Mul(slope.v2, hn::Sub(c.v2, c.v0)));
      };
      planes.over_w[axis] = {over_w(t.u), over_w(t.v)};
      planes.inverse_w[axis] =
          hn::IfThenZeroElse(affine_, hn::Add(hn::Add(slope.v0, slope.v1), slope.v2));
    }
    return planes;
  }
  HWY_INLINE ReflectionLanes reflection(const ShadeDraw& draw, const ResolveJob& job,
                                        const Vec3& normal) const {
    const VF zero = hn::Zero(kF);
    const Vec3 where = draw.eye_positions != nullptr ? position() : Vec3{zero, zero, zero};
    return illuminate(*job.lighting, where, normal, draw.material->shininess, draw.highlights);
  }
  // 1 + the triangle's number in the scene.
  HWY_INLINE VI id() const {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(draw_.triangles);
    constexpr int kWords = sizeof(Triangle) / sizeof(std::int32_t);
    const VI at = hn::Add(hn::Mul(triangle_, set(kWords)),
                          set(std::int32_t(offsetof(Triangle, number) / sizeof(std::int32_t))));
    return hn::Add(hn::GatherIndex(kI, numbers, at), set(std::int32_t(draw_.first_number + 1)));
  }

private:
  HWY_INLINE TexcoordTriples texcoords() const {
    const Triple<VI> corner = corners(draw_.texcoord_indices);
    const auto coordinate = [&](const float* table) HWY_ATTR {
      return gather(kF, table,
                    {hn::Add(corner.v0, corner.v0), hn::Add(corner.v1, corner.v1),
                     hn::Add(corner.v2, corner.v2)});
    };
    return {coordinate(&draw_.texcoords->u), coordinate(&draw_.texcoords->v)};
  }
  HWY_INLINE Triple<VI> corners(IndexTriples indices) const {
    if (indices == draw_.positions) return vertices_;
    return put_in_order(order_, gather_indices(indices, triangle_));
  }
  // Seen from behind, a surface is lit as if its normals pointed the other way.
  HWY_INLINE Vec3 facing(const Vec3& n) const {
    if (!draw_.shows_backs) return n;
    // Counter-clockwise on the screen is the front, and the back of what is mirrored.
    const MF back = as_float_mask(draw_.mirrored ? order_.swapped : hn::Not(order_.swapped));
    return {hn::IfThenElse(back, hn::Neg(n.x), n.x), hn::IfThenElse(back, hn::Neg(n.y), n.y),
            hn::IfThenElse(back, hn::Neg(n.z), n.z)};
  }

  const ShadeDraw& draw_;
  VI triangle_;
  Order order_;
  Triple<VI> vertices_;
  VF lambda1_, lambda2_;
  FragmentLanes at_;
  Triple<VF> slopes_[2];  // d lambda_k over one pixel along x and y, times 1/w_k
  MF affine_;
};

// A large triangle's edge functions over a quad, for as long as neighbouring quads show the same one.
struct LargeShape {
  const LargeTriangle* triangle = nullptr;
  Doubles offsets0[kQuadVectors], offsets1[kQuadVectors], offsets2[kQuadVectors];

  LargeShape() = default;
  HWY_INLINE explicit LargeShape(const LargeTriangle& of) : triangle(&of) {
    for (std::size_t k = 0; k < kQuadVectors; ++k) {
      offsets0[k] = quad_offsets<0>(of.setup, k * kLanes);
      offsets1[k] = quad_offsets<1>(of.setup, k * kLanes);
      offsets2[k] = quad_offsets<2>(of.setup, k * kLanes);
    }
  }
};

// One large triangle in all lanes, which begin at pixel `i` of the quad at (x, y).
class LargeSource {
public:
  HWY_INLINE LargeSource(const LargeShape& shape, int x, int y, std::size_t i)
      : triangle_(shape.triangle) {
    const TriangleSetup& setup = triangle_->setup;
    const VF inverse_area = set(setup.inverse_area);
    const auto lambda = [&](const Doubles& offsets, std::size_t k) HWY_ATTR {
      return hn::Mul(round_to_float(plus(offsets, edge_at_pixel(setup.edges[k], x, y))),
                     inverse_area);
    };
    const std::size_t vector = i / kLanes;
    lambda1_ = lambda(shape.offsets1[vector], 1);
    lambda2_ = lambda(shape.offsets2[vector], 2);
    if (setup.affine) {
      at_ = {lambda1_, lambda2_, set(setup.inverse_w[0])};
    } else {
      at_ =
          perspective(lambda(shape.offsets0[vector], 0), lambda1_, lambda2_,
                      {set(setup.inverse_w[0]), set(setup.inverse_w[1]), set(setup.inverse_w[2])});
    }
  }

  const LargeTriangle& triangle() const { return *triangle_; }
  const FragmentLanes& at() const { return at_; }
  HWY_INLINE VF depth() const {
    const std::array<float, 3>& d = triangle_->setup.depth;
    return depth_at(set(d[0]), set(d[1] - d[0]), set(d[2] - d[0]), lambda1_, lambda2_);
  }
  HWY_INLINE Vec3 normal() const { return vector(&Varyings::normal); }
  HWY_INLINE RgbLanes color() const {
    return {component(&Varyings::color, 0), component(&Varyings::color, 1),
            component(&Varyings::color, 2)};
  }
  HWY_INLINE TexcoordLanes texcoord() const {
    return {component(&Varyings::texcoord, 0), component(&Varyings::texcoord, 1)};
  }
  HWY_INLINE PlaneLanes texture_planes() const {
    const TexturePlanes& p = triangle_->texture;
    return {
        {set(p.origin[0]), set(p.origin[1])},
        {{set(p.over_w[0][0]), set(p.over_w[0][1])}, {set(p.over_w[1][0]), set(p.over_w[1][1])}},
        {set(p.inverse_w[0]), set(p.inverse_w[1])}};
  }
  HWY_INLINE ReflectionLanes reflection(const ShadeDraw& draw, const ResolveJob& job,
                                        const Vec3& normal) const {
    if (draw.light == LightAt::kVertices) {
      return {vector(&Varyings::diffuse), vector(&Varyings::specular)};
    }
    return illuminate(*job.lighting, vector(&Varyings::position), normal, draw.material->shininess,
                      draw.highlights);
  }
  VI id() const { return set(std::int32_t(triangle_->number + 1)); }

private:
  template <class Member>
  HWY_INLINE VF component(Member member, std::size_t i) const {
    const std::array<Varyings, 3>& v = triangle_->vertices;
    return interpolate(at_, set((v[0].*member)[i]), set((v[1].*member)[i]), set((v[2].*member)[i]));
  }
  template <class Member>
  HWY_INLINE Vec3 vector(Member member) const {
    return {component(member, 0), component(member, 1), component(member, 2)};
  }

  const LargeTriangle* triangle_;
  VF lambda1_, lambda2_;
  FragmentLanes at_;
};

// ---- colour ----

// Samples that look at several levels, one lane after the other.
template <class Source>
HWY_INLINE RgbLanes sample_levels(const MipChain& texture, const Sampler& sampler,
                                  const ResolveJob& job, const Source& source,
                                  const TexcoordLanes& at) {
  const PlaneLanes planes = source.texture_planes();
  const VF w = hn::Div(set(1.0f), source.at().inverse_w);
  const auto change = [&](VF over_w, VF coordinate, VF origin, VF inverse_w) HWY_ATTR {
    return hn::Mul(hn::Sub(over_w, hn::Mul(hn::Sub(coordinate, origin), inverse_w)), w);
  };
  HWY_ALIGN float u[kLanes], v[kLanes], change_u[2][kLanes], change_v[2][kLanes];
  hn::Store(at.u, kF, u);
  hn::Store(at.v, kF, v);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    hn::Store(change(planes.over_w[axis].u, at.u, planes.origin.u, planes.inverse_w[axis]), kF,
              change_u[axis]);
    hn::Store(change(planes.over_w[axis].v, at.v, planes.origin.v, planes.inverse_w[axis]), kF,
              change_v[axis]);
  }
  const Image<Rgba8>& base = texture.levels.front();
  HWY_ALIGN float r[kLanes], g[kLanes], b[kLanes];
  for (std::size_t i = 0; i < kLanes; ++i) {
    const TextureGradient gradient{{change_u[0][i], change_v[0][i]},
                                   {change_u[1][i], change_v[1][i]}};
    const float detail = level_of_detail(gradient, base.width, base.height);
    const Rgba texel = sample(texture, sampler, {u[i], v[i]}, detail, job.transfer,
                              ColorMask{true, true, true, false});
    r[i] = texel.r, g[i] = texel.g, b[i] = texel.b;
  }
  return {hn::Load(kF, r), hn::Load(kF, g), hn::Load(kF, b)};
}

template <class Source>
HWY_INLINE RgbLanes texture_color(const MipChain& texture, const Sampler& sampler,
                                  const ResolveJob& job, const Source& source) {
  const TexcoordLanes at = source.texcoord();
  if (!samples_base_only(sampler)) return sample_levels(texture, sampler, job, source, at);
  return sample_base(texture, sampler, at.u, at.v, job.transfer);
}

template <class Source>
HWY_INLINE RgbLanes surface_color(const ShadeDraw& draw, const ResolveJob& job,
                                  const Source& source) {
  const Rgba& base = draw.material->base_color;
  RgbLanes color{set(base.r), set(base.g), set(base.b)};
  if (draw.color_indices != nullptr) {
    const RgbLanes vertex = source.color();
    color = {hn::Mul(color.r, vertex.r), hn::Mul(color.g, vertex.g), hn::Mul(color.b, vertex.b)};
  }
  if (draw.texture != nullptr) {
    const RgbLanes texel = texture_color(*draw.texture, *draw.sampler, job, source);
    color = {hn::Mul(color.r, texel.r), hn::Mul(color.g, texel.g), hn::Mul(color.b, texel.b)};
  }
  return color;
}

HWY_INLINE VF reflected(VF base, VF diffuse, float material_specular, VF specular,
                        bool highlights) {
  const VF matte = hn::Mul(base, diffuse);
  return highlights ? hn::Add(matte, hn::Mul(set(material_specular), specular)) : matte;
}

template <class Source>
HWY_INLINE RgbLanes lit(const ShadeDraw& draw, const ResolveJob& job, const Source& source,
                        const RgbLanes& base) {
  if (draw.light == LightAt::kNowhere) return base;
  const Vec3 normal = source.normal();
  const ReflectionLanes light = source.reflection(draw, job, normal);
  const VF zero = hn::Zero(kF);
  const MF has_normal =
      hn::Or(hn::Or(hn::Ne(normal.x, zero), hn::Ne(normal.y, zero)), hn::Ne(normal.z, zero));
  const std::array<float, 3>& shine = draw.material->specular;
  return {
      hn::IfThenElse(
          has_normal,
          reflected(base.r, light.diffuse.x, shine[0], light.specular.x, draw.highlights), base.r),
      hn::IfThenElse(
          has_normal,
          reflected(base.g, light.diffuse.y, shine[1], light.specular.y, draw.highlights), base.g),
      hn::IfThenElse(
          has_normal,
          reflected(base.b, light.diffuse.z, shine[2], light.specular.z, draw.highlights), base.b)};
}

// emission_at() of fragment_color.h.
template <class Source>
HWY_INLINE RgbLanes emission(const ShadeDraw& draw, const ResolveJob& job, const Source& source) {
  const std::array<float, 3>& factor = draw.emission;
  const RgbLanes own{set(factor[0]), set(factor[1]), set(factor[2])};
  if (draw.emission_texture == nullptr) return own;
  const RgbLanes texel = texture_color(*draw.emission_texture, *draw.emission_sampler, job, source);
  return {hn::Mul(own.r, texel.r), hn::Mul(own.g, texel.g), hn::Mul(own.b, texel.b)};
}

// The bytes of an opaque fragment as one integer; those that are not wanted are 0.
template <class Source>
HWY_INLINE VI shade(const ShadeDraw& draw, const ResolveJob& job, const Source& source) {
  RgbLanes color = lit(draw, job, source, surface_color(draw, job, source));
  if (HWY_UNLIKELY(draw.emits)) {
    const RgbLanes own = emission(draw, job, source);
    color = {hn::Add(color.r, own.r), hn::Add(color.g, own.g), hn::Add(color.b, own.b)};
  }
  const auto byte = [&](bool wanted, VF channel)
                        HWY_ATTR { return wanted ? encode(job.transfer, channel) : hn::Zero(kI); };
  return hn::Or(
      hn::Or(byte(job.channels.r, color.r), hn::ShiftLeft<8>(byte(job.channels.g, color.g))),
      hn::Or(hn::ShiftLeft<16>(byte(job.channels.b, color.b)), set(std::int32_t(0xff000000u))));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
