// Colours of fragments: attributes, texture and light, as render/staged/fragment_color.h has them, over lanes. All fragments of a call belong to one
// draw; each has a small triangle of its own, or all share a large one.

#if defined(GLASSBOX_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHADE_INL_H_
#undef GLASSBOX_SHADE_INL_H_
#else
#define GLASSBOX_SHADE_INL_H_
#endif

#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// ---- where attributes come from ----

using Float3 = std::array<Floats, 3>;
using Float2 = std::array<Floats, 2>;

template <class T>
HWY_INLINE Float3 gather_triple(const T* table, Ints at) {
  const float* from = &table->x;
  const Ints word = at + at + at;
  const Pair xy = gather_pair(reinterpret_cast<const std::int32_t*>(from), word);
  return {float_of(xy.first), float_of(xy.second), gather(from + 2, word)};
}

// Where in its pixel a fragment is shaded: with one sample to a pixel, at the centre.
struct AtCentre {
  HWY_INLINE void move(const std::array<EdgeSlopes<Ints>, 3>&, Ints, Ints&, Ints&) const {}
  HWY_INLINE void move(const TriangleSetup&, std::array<Doubles, 3>&) const {}
};

// With several: there too if the triangle covers it, otherwise at the first sample that it covers (shading_place() of samples.h).
struct AtSamples {
  std::span<const SampleOffset> points;
  IntMask lanes;  // that show the triangle; the others may stay where they are

  // Of small triangles: from the edge functions at the centre to those at the place. (That of edge 0 is what is left of the area.)
  HWY_INLINE void move(const std::array<EdgeSlopes<Ints>, 3>& edges, Ints area, Ints& e1,
                       Ints& e2) const {
    const Ints above0 = outside_up_to(edges[0]), above1 = outside_up_to(edges[1]),
               above2 = outside_up_to(edges[2]);
    const auto covered = [&](Ints at1, Ints at2) HWY_ATTR {
      return at1 > above1 && at2 > above2 && area - at1 - at2 > above0;
    };
    const Ints centre1 = e1, centre2 = e2;
    IntMask searching = lanes && !covered(e1, e2);
    for (const SampleOffset& point : points) {
      if (none(searching)) return;
      const Ints at1 = centre1 + edges[1].a * point.x + edges[1].b * point.y;
      const Ints at2 = centre2 + edges[2].a * point.x + edges[2].b * point.y;
      const IntMask here = searching && covered(at1, at2);
      e1 = select(here, at1, e1);
      e2 = select(here, at2, e2);
      searching = searching && !here;
    }
  }

  // Of a large one.
  HWY_INLINE void move(const TriangleSetup& setup, std::array<Doubles, 3>& e) const {
    const auto covered = [&](const SampleOffset& point) HWY_ATTR {
      IntMask all = first_lanes(kLanes);
      for (std::size_t k = 0; k < 3; ++k) {
        const EdgeFunction& edge = setup.edges[k];
        const Doubles at_point = e[k] + double(edge.a * point.x + edge.b * point.y);
        all = all && covers(at_point, least_inside(edge));
      }
      return all;
    };
    IntMask searching = lanes && !covered({});
    if (none(searching)) return;
    Floats x = 0.0f, y = 0.0f;
    for (const SampleOffset& point : points) {
      const IntMask here = searching && covered(point);
      x = select(float_mask(here), float(point.x), x);
      y = select(float_mask(here), float(point.y), y);
      searching = searching && !here;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const EdgeFunction& edge = setup.edges[k];
      e[k] = e[k] + widened(x) * double(edge.a) + widened(y) * double(edge.b);
    }
  }
};

// A small triangle in every lane: gathered from the draw's tables.
class SmallSource {
public:
  // `reference`: of the lane's triangle, less the draw's first.
  template <class Place>
  HWY_INLINE SmallSource(const ShadeDraw& draw, Ints reference, Ints pixel_x, Ints pixel_y,
                         const Place& place)
      : draw_(draw),
        triangle_(shifted_right<3>(reference)),
        order_(order_of_code(reference)),
        vertices_(put_in_order(order_, gather_indices(draw.positions, triangle_))) {
    static_assert(kReferenceStep == 1 << 3);
    const OfVertices<Ints> entries = entries_of(vertices_);
    OfVertices<Ints> x, y;
    gather_position(draw.screen, entries, x, y);
    const OfVertices<Floats> inverse_w = gather(&draw.screen->inverse_w, entries);
    const Ints at_x = shifted_left<kSubpixelBits>(pixel_x) + kPixelCentre;
    const Ints at_y = shifted_left<kSubpixelBits>(pixel_y) + kPixelCentre;
    const std::array<EdgeSlopes<Ints>, 3> edges{edge_of<0>(x, y), edge_of<1>(x, y),
                                                edge_of<2>(x, y)};
    const Ints area = double_area(x, y);
    Ints e1 = value_of<1>(edges[1], x, y, at_x, at_y);
    Ints e2 = value_of<2>(edges[2], x, y, at_x, at_y);
    place.move(edges, area, e1, e2);
    const Ints e0 = area - e1 - e2;
    const Floats inverse_area = 1.0f / to_float(area);
    lambda1_ = screen_weight(to_float(e1), inverse_area);
    lambda2_ = screen_weight(to_float(e2), inverse_area);
    const Floats lambda0 = screen_weight(to_float(e0), inverse_area);
    at_ = draw.w_is_one ? WeightsInSpace<Floats>{lambda0, lambda1_, lambda2_, inverse_w[0]}
                        : weights_in_space({lambda0, lambda1_, lambda2_}, inverse_w);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto slope = [&](Ints step) HWY_ATTR {
        return slope_over_w(to_float(shifted_left<kSubpixelBits>(step)), inverse_area,
                            inverse_w[k]);
      };
      slopes_[0][k] = slope(edges[k].a);
      slopes_[1][k] = slope(edges[k].b);
    }
    affine_ = is_affine(inverse_w);
  }

  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE Floats depth() const {
    const OfVertices<Floats> z = gather(&draw_.screen->z, entries_of(vertices_));
    return interpolate(z[0], z[1] - z[0], z[2] - z[0], lambda1_, lambda2_);
  }

  HWY_INLINE Float3 normal() const {
    const OfVertices<Ints> corner = corners(draw_.normal_indices);
    return here<3>({facing(gather_triple(draw_.normals, corner[0])),
                    facing(gather_triple(draw_.normals, corner[1])),
                    facing(gather_triple(draw_.normals, corner[2]))});
  }
  HWY_INLINE Float3 position() const {
    return here<3>({gather_triple(draw_.eye_positions, vertices_[0]),
                    gather_triple(draw_.eye_positions, vertices_[1]),
                    gather_triple(draw_.eye_positions, vertices_[2])});
  }
  HWY_INLINE Rgb color() const {
    const OfVertices<Ints> corner = corners(draw_.color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = shifted_left<2>(corner[k]);
      return Rgb{gather(&draw_.colors->r, at), gather(&draw_.colors->g, at),
                 gather(&draw_.colors->b, at)};
    };
    return here<3>({at_vertex(0), at_vertex(1), at_vertex(2)});
  }
  HWY_INLINE Floats alpha() const {
    const OfVertices<Ints> corner = corners(draw_.color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      return gather(&draw_.colors->a, shifted_left<2>(corner[k]));
    };
    const Floats a0 = at_vertex(0);
    return interpolate(a0, at_vertex(1) - a0, at_vertex(2) - a0, at_.weight1, at_.weight2);
  }
  HWY_INLINE Float2 texcoord() const { return here<2>(texcoords()); }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    return planes_over_w(slopes_, texcoords(), affine_);
  }
  HWY_INLINE ReflectionOf<Floats> reflection(const ShadeDraw& draw, const ResolveJob& job,
                                             const Float3& normal) const {
    const Floats zero = 0.0f;
    const Float3 where = draw.eye_positions != nullptr ? position() : Float3{zero, zero, zero};
    return reflected_light(*job.lighting, where, normal, draw.material->shininess, draw.highlights);
  }
  // 1 + the triangle's number in the scene.
  HWY_INLINE Ints id() const {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(draw_.triangles);
    constexpr int kWords = sizeof(Triangle) / sizeof(std::int32_t);
    constexpr int kNumber = offsetof(Triangle, number) / sizeof(std::int32_t);
    return gather(numbers, triangle_ * kWords + kNumber) + std::int32_t(draw_.first_number + 1);
  }

private:
  // An attribute of the three vertices, at the pixel.
  template <std::size_t N>
  HWY_INLINE std::array<Floats, N> here(const OfVertices<std::array<Floats, N>>& a) const {
    return interpolate(a[0], a[1], a[2], at_.weight1, at_.weight2);
  }
  HWY_INLINE OfVertices<Float2> texcoords() const {
    const OfVertices<Ints> corner = corners(draw_.texcoord_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = corner[k] + corner[k];
      return Float2{gather(&draw_.texcoords->u, at), gather(&draw_.texcoords->v, at)};
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }
  HWY_INLINE OfVertices<Ints> corners(IndexTriples indices) const {
    if (indices == draw_.positions) return vertices_;
    return put_in_order(order_, gather_indices(indices, triangle_));
  }
  // Seen from behind, a surface is lit as if its normals pointed the other way.
  HWY_INLINE Float3 facing(const Float3& n) const {
    if (!draw_.shows_backs) return n;
    // Counter-clockwise on the screen is the front, and the back of what is mirrored.
    const FloatMask back = float_mask(draw_.mirrored ? order_.swapped : !order_.swapped);
    return {select(back, -n[0], n[0]), select(back, -n[1], n[1]), select(back, -n[2], n[2])};
  }

  const ShadeDraw& draw_;
  Ints triangle_;
  Order order_;
  OfVertices<Ints> vertices_;
  Floats lambda1_, lambda2_;
  WeightsInSpace<Floats> at_;
  std::array<Float3, 2> slopes_;  // d lambda_k over one pixel along x and y, times 1/w_k
  FloatMask affine_;
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
  template <class Place>
  HWY_INLINE LargeSource(const LargeShape& shape, int x, int y, std::size_t i, const Place& place)
      : triangle_(shape.triangle) {
    const TriangleSetup& setup = triangle_->setup;
    const std::size_t vector = i / kLanes;
    std::array<Doubles, 3> e{shape.offsets0[vector] + edge_at_pixel(setup.edges[0], x, y),
                             shape.offsets1[vector] + edge_at_pixel(setup.edges[1], x, y),
                             shape.offsets2[vector] + edge_at_pixel(setup.edges[2], x, y)};
    place.move(setup, e);
    const Floats inverse_area = setup.inverse_area;
    const Floats lambda0 = screen_weight(rounded(e[0]), inverse_area);
    lambda1_ = screen_weight(rounded(e[1]), inverse_area);
    lambda2_ = screen_weight(rounded(e[2]), inverse_area);
    const Floats w0 = setup.inverse_w[0], w1 = setup.inverse_w[1], w2 = setup.inverse_w[2];
    at_ = setup.affine ? WeightsInSpace<Floats>{lambda0, lambda1_, lambda2_, w0}
                       : perspective<Floats>({lambda0, lambda1_, lambda2_}, {w0, w1, w2});
  }

  const LargeTriangle& triangle() const { return *triangle_; }
  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE Floats depth() const {
    const std::array<float, 3>& d = triangle_->setup.depth;
    return interpolate(Floats(d[0]), Floats(d[1] - d[0]), Floats(d[2] - d[0]), lambda1_, lambda2_);
  }
  HWY_INLINE Float3 normal() const { return attribute<3>(&Varyings::normal); }
  HWY_INLINE Rgb color() const { return attribute<3>(&Varyings::color); }
  HWY_INLINE Floats alpha() const { return attribute<4>(&Varyings::color)[3]; }
  HWY_INLINE Float2 texcoord() const { return attribute<2>(&Varyings::texcoord); }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    const TexturePlanes& p = triangle_->texture;
    return {{Floats(p.origin[0]), Floats(p.origin[1])},
            {{{Floats(p.over_w[0][0]), Floats(p.over_w[0][1])},
              {Floats(p.over_w[1][0]), Floats(p.over_w[1][1])}}},
            {Floats(p.inverse_w[0]), Floats(p.inverse_w[1])}};
  }
  HWY_INLINE ReflectionOf<Floats> reflection(const ShadeDraw& draw, const ResolveJob& job,
                                             const Float3& normal) const {
    if (draw.light == LightAt::kVertices) {
      return {attribute<3>(&Varyings::diffuse), attribute<3>(&Varyings::specular)};
    }
    return reflected_light(*job.lighting, attribute<3>(&Varyings::position), normal,
                           draw.material->shininess, draw.highlights);
  }
  Ints id() const { return std::int32_t(triangle_->number + 1); }

private:
  // The first N components of one of the varyings.
  template <std::size_t N, class Member>
  HWY_INLINE std::array<Floats, N> attribute(Member member) const {
    const auto& a0 = triangle_->vertices[0].*member;
    const auto& a1 = triangle_->vertices[1].*member;
    const auto& a2 = triangle_->vertices[2].*member;
    std::array<Floats, N> here;
    for (std::size_t i = 0; i < N; ++i) {
      here[i] = interpolate(Floats(a0[i]), Floats(a1[i] - a0[i]), Floats(a2[i] - a0[i]),
                            at_.weight1, at_.weight2);
    }
    return here;
  }

  const LargeTriangle* triangle_;
  Floats lambda1_, lambda2_;
  WeightsInSpace<Floats> at_;
};

HWY_INLINE Floats distance_of(const ResolveJob& job, Floats depth, Floats inverse_w) {
  if (job.perspective) return 1.0f / inverse_w;
  return parallel_distance(depth, job.reversed, job.near, job.far);
}

// ---- colour ----

inline std::int32_t bytes_of(const ColorMask& mask) {
  const Rgba8 bytes{std::uint8_t(mask.r ? 255 : 0), std::uint8_t(mask.g ? 255 : 0),
                    std::uint8_t(mask.b ? 255 : 0), std::uint8_t(mask.a ? 255 : 0)};
  return std::bit_cast<std::int32_t>(bytes);
}

// The textures of a draw, asked for before its pixels' numbers are in registers, which making one would push out.
struct DrawTextures {
  DrawTextures() = default;
  explicit DrawTextures(const ShadeDraw& draw)
      : color(draw.texture != nullptr ? &draw.texture->get() : nullptr),
        emission(draw.emission_texture != nullptr ? &draw.emission_texture->get() : nullptr) {}

  const MipChain* color = nullptr;
  const MipChain* emission = nullptr;
};

template <class Source>
HWY_INLINE Shorts sampled(const MipChain& texture, const Sampler& sampler, const Source& source) {
  const TextureInLanes texels(texture);
  const Float2 at = source.texcoord();
  if (HWY_LIKELY(samples_base_only(sampler))) return sample_base(texels, sampler, at);
  const TextureGradientOf<Floats> gradient =
      gradient_at(source.texture_planes(), at, source.at().inverse_w);
  return sample_texture(texels, sampler, at,
                        level_of_detail(gradient, texture.width, texture.height));
}

// Material times vertex colour times texture, and the alpha of the same factors. Whoever has no use for one of them computes none.
struct SurfaceColor {
  Rgb color;
  Floats alpha;
};

template <class Source>
HWY_INLINE SurfaceColor surface_color(const ShadeDraw& draw, const MipChain* texture,
                                      const Source& source) {
  const Rgba& base = draw.material->base_color;
  SurfaceColor surface{{Floats(base.r), Floats(base.g), Floats(base.b)}, Floats(base.a)};
  if (draw.color_indices != nullptr) {
    surface = {product(surface.color, source.color()), surface.alpha * source.alpha()};
  }
  if (texture != nullptr) {
    const Shorts texels = sampled(*texture, *draw.sampler, source);
    surface = {product(surface.color, color_of(texels)), surface.alpha * alpha_of(texels)};
  }
  return surface;
}

template <class Source>
HWY_INLINE Rgb lit(const ShadeDraw& draw, const ResolveJob& job, const Source& source,
                   const Rgb& base) {
  if (draw.light == LightAt::kNowhere) return base;
  const Float3 normal = source.normal();
  const ReflectionOf<Floats> light = source.reflection(draw, job, normal);
  return lit(base, normal, light, draw.material->specular, draw.highlights);
}

template <class Source>
HWY_INLINE Rgb emission(const ShadeDraw& draw, const MipChain* texture, const Source& source) {
  const Rgb own{Floats(draw.emission[0]), Floats(draw.emission[1]), Floats(draw.emission[2])};
  if (texture == nullptr) return own;
  return product(own, color_of(sampled(*texture, *draw.emission_sampler, source)));
}

// The surface in the light, and its own light with it.
template <class Source>
HWY_INLINE SurfaceColor shining(const ShadeDraw& draw, const DrawTextures& textures,
                                const ResolveJob& job, const Source& source) {
  SurfaceColor surface = surface_color(draw, textures.color, source);
  surface.color = lit(draw, job, source, surface.color);
  if (HWY_UNLIKELY(draw.emits)) {
    surface.color = sum(surface.color, emission(draw, textures.emission, source));
  }
  return surface;
}

// The colour alone, for whoever shades fewer pixels than resolving does: compiled once.
template <class Source>
HWY_NOINLINE Rgb shining_by_call(const ShadeDraw& draw, const DrawTextures& textures,
                                 const ResolveJob& job, const Source& source) {
  return shining(draw, textures, job, source).color;
}

// A colour's bytes as one integer, opaque; those that are not wanted are 0.
HWY_INLINE Ints encoded(const Rgb& color, const ResolveJob& job) {
  const auto byte = [&](bool wanted, Floats channel)
                        HWY_ATTR { return wanted ? encode(job.transfer, channel) : Ints(0); };
  return byte(job.channels.r, color[0]) | shifted_left<8>(byte(job.channels.g, color[1])) |
         (shifted_left<16>(byte(job.channels.b, color[2])) | std::int32_t(0xff000000u));
}

template <class Source>
HWY_INLINE Ints shade(const ShadeDraw& draw, const DrawTextures& textures, const ResolveJob& job,
                      const Source& source) {
  return encoded(shining(draw, textures, job, source).color, job);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
