// Computes the attributes of fragments if all lanes show one large triangle.

#if defined(GLASSBOX_LARGE_SOURCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_LARGE_SOURCE_INL_H_
#undef GLASSBOX_LARGE_SOURCE_INL_H_
#else
#define GLASSBOX_LARGE_SOURCE_INL_H_
#endif

#include <glassbox/raster/lanes/shading_points-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// How a large triangle's edge functions change within a quad. It is used again while neighbouring
// quads show the same triangle.
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

// The part of a fragment's data that its attributes need.
struct PointInLargeTriangle {
  const LargeTriangle* triangle = nullptr;
  Floats weight1, weight2;  // barycentric, in space, of vertices 1 and 2
};
template <class Self>
class LargeAttributes {
public:
  HWY_INLINE Float3 normal() const { return attribute<3>(&Varyings::normal); }
  HWY_INLINE Float3 position() const { return attribute<3>(&Varyings::position); }
  HWY_INLINE Rgb color() const { return attribute<3>(&Varyings::color); }
  HWY_INLINE Floats alpha() const { return attribute<4>(&Varyings::color)[3]; }
  HWY_INLINE Float2 texcoord() const { return attribute<2>(&Varyings::texcoord); }
  HWY_INLINE static bool is_lit_at_vertices(const ShadeDraw& draw) {
    return draw.light == LightAt::kVertices;
  }
  HWY_INLINE ReflectionOf<Floats> light_of_vertices(const ShadeDraw&, const Lighting&) const {
    return {attribute<3>(&Varyings::diffuse), attribute<3>(&Varyings::specular)};
  }
  Ints id() const { return std::int32_t(self().triangle->number + 1); }

private:
  // Interpolates the first N components of one of the varyings.
  template <std::size_t N, class Member>
  HWY_INLINE std::array<Floats, N> attribute(Member member) const {
    const auto& a0 = self().triangle->vertices[0].*member;
    const auto& a1 = self().triangle->vertices[1].*member;
    const auto& a2 = self().triangle->vertices[2].*member;
    std::array<Floats, N> here;
    for (std::size_t i = 0; i < N; ++i) {
      here[i] = interpolate(Floats(a0[i]), Floats(a1[i] - a0[i]), Floats(a2[i] - a0[i]),
                            self().weight1, self().weight2);
    }
    return here;
  }

  const Self& self() const { return static_cast<const Self&>(*this); }
};
struct LargeFragments : PointInLargeTriangle, LargeAttributes<LargeFragments> {};

// The fragments of one large triangle in all lanes. The lanes begin at pixel `i` of the quad at (x,
// y).
class LargeSource : public PointInLargeTriangle, public LargeAttributes<LargeSource> {
public:
  using Fragments = LargeFragments;

  template <class ShadingPoint>
  HWY_INLINE LargeSource(const LargeShape& shape, int x, int y, std::size_t i,
                         const ShadingPoint& point)
      : PointInLargeTriangle{shape.triangle, {}, {}} {
    const TriangleSetup& setup = triangle->setup;
    const std::size_t vector = i / kLanes;
    std::array<Doubles, 3> e{shape.offsets0[vector] + edge_at_pixel(setup.edges[0], x, y),
                             shape.offsets1[vector] + edge_at_pixel(setup.edges[1], x, y),
                             shape.offsets2[vector] + edge_at_pixel(setup.edges[2], x, y)};
    point.move_edges(setup, e);
    const Floats inverse_area = setup.inverse_area;
    const Floats lambda0 = screen_weight(rounded(e[0]), inverse_area);
    lambda1_ = screen_weight(rounded(e[1]), inverse_area);
    lambda2_ = screen_weight(rounded(e[2]), inverse_area);
    const Floats w0 = setup.inverse_w[0], w1 = setup.inverse_w[1], w2 = setup.inverse_w[2];
    at_ = setup.affine ? WeightsInSpace<Floats>{lambda0, lambda1_, lambda2_, w0}
                       : perspective_weights<Floats>({lambda0, lambda1_, lambda2_}, {w0, w1, w2});
    weight1 = at_.weight1;
    weight2 = at_.weight2;
  }

  HWY_INLINE Fragments fragments() const { return {{*this}, {}}; }
  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE Floats depth() const {
    const std::array<float, 3>& d = triangle->setup.depth;
    return interpolate(Floats(d[0]), Floats(d[1] - d[0]), Floats(d[2] - d[0]), lambda1_, lambda2_);
  }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    const TexturePlanes& p = triangle->texture;
    return {{Floats(p.origin[0]), Floats(p.origin[1])},
            {{{Floats(p.over_w[0][0]), Floats(p.over_w[0][1])},
              {Floats(p.over_w[1][0]), Floats(p.over_w[1][1])}}},
            {Floats(p.inverse_w[0]), Floats(p.inverse_w[1])}};
  }

private:
  Floats lambda1_, lambda2_;
  WeightsInSpace<Floats> at_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
