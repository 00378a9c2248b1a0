// Computes the attributes of fragments if the pixels of a block show only a few small triangles.
// The data of the triangles is gathered and computed once, with one triangle in every lane; then
// each pixel looks up the data of its own triangle.

#if defined(GLASSBOX_SHARED_SOURCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHARED_SOURCE_INL_H_
#undef GLASSBOX_SHARED_SOURCE_INL_H_
#else
#define GLASSBOX_SHARED_SOURCE_INL_H_
#endif

#include <glassbox/raster/lanes/small_source-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// An attribute at vertex 0, and the differences of the other vertices from it.
template <std::size_t N>
struct AttributeDifferences {
  std::array<Floats, N> first, difference1, difference2;

  AttributeDifferences() = default;
  HWY_INLINE explicit AttributeDifferences(const PerVertex<std::array<Floats, N>>& a)
      : first(a[0]) {
    for (std::size_t i = 0; i < N; ++i) {
      difference1[i] = a[1][i] - a[0][i];
      difference2[i] = a[2][i] - a[0][i];
    }
  }
};

// Small triangles of a draw, one in each lane, relative to the first pixel of a block. Only the
// attributes that the draw has are set.
struct SharedTriangles {
  const ShadeDraw* draw;
  Ints e1, e2;                        // edge functions at the first pixel's centre
  Ints right1, right2, down1, down2;  // the change of e1 and e2 from one pixel to the next
  Ints area;
  Floats inverse_area;
  PerVertex<Floats> inverse_w;
  bool none_is_affine;
  AttributeDifferences<3> normal, position, color;
  AttributeDifferences<1> alpha;
  AttributeDifferences<2> texcoord;
  TexturePlanesOf<Floats> texture_planes;

  // Whether pixels of the draw may be shaded in this way. Draws that are lit at the vertices may
  // not, because their light may be that of a whole face, which is not stored here.
  static bool can_share(const ShadeDraw& draw) { return draw.light != LightAt::kVertices; }

  // `reference`: the triangle's reference minus the draw's first reference.
  HWY_INLINE SharedTriangles(const ShadeDraw& of_draw, Ints reference, int x, int y)
      : draw(&of_draw) {
    const SmallFragments at{point_in_small_triangle(of_draw, reference), {}};
    const SmallOnScreen screen(draw->screen, at.vertices, x, y, AtCentre());
    e1 = screen.e1;
    e2 = screen.e2;
    right1 = shifted_left<kSubpixelBits>(screen.edges[1].a);
    right2 = shifted_left<kSubpixelBits>(screen.edges[2].a);
    down1 = shifted_left<kSubpixelBits>(screen.edges[1].b);
    down2 = shifted_left<kSubpixelBits>(screen.edges[2].b);
    area = screen.area;
    inverse_area = screen.inverse_area;
    inverse_w = screen.inverse_w;
    none_is_affine = none(is_affine(inverse_w));
    if (draw->light != LightAt::kNowhere) normal = AttributeDifferences<3>(at.normals());
    if (draw->eye_positions != nullptr) position = AttributeDifferences<3>(at.positions());
    if (draw->color_indices != nullptr) {
      color = AttributeDifferences<3>(at.colors());
      alpha = AttributeDifferences<1>(at.alphas());
    }
    if (draw->texcoord_indices != nullptr) {
      const PerVertex<Float2> texcoords = at.texcoords();
      texcoord = AttributeDifferences<2>(texcoords);
      texture_planes = screen.texture_planes(texcoords);
    }
  }
};

// The part of a pixel's data that its attributes need.
struct PointInSharedTriangle {
  const SharedTriangles* triangles = nullptr;
  Ints lane;                // the lane of the pixel's triangle
  Floats weight1, weight2;  // barycentric, in space, of vertices 1 and 2
};
template <class Self>
class SharedAttributes {
public:
  HWY_INLINE Float3 normal() const { return interpolated(self().triangles->normal); }
  HWY_INLINE Float3 position() const {
    if (self().triangles->draw->eye_positions != nullptr)
      return interpolated(self().triangles->position);
    const Floats zero = 0.0f;
    return {zero, zero, zero};
  }
  HWY_INLINE Rgb color() const { return interpolated(self().triangles->color); }
  HWY_INLINE Floats alpha() const { return interpolated(self().triangles->alpha)[0]; }
  HWY_INLINE Float2 texcoord() const { return interpolated(self().triangles->texcoord); }
  // SharedTriangles::can_share excludes draws that are lit at the vertices.
  static constexpr bool is_lit_at_vertices(const ShadeDraw&) { return false; }
  HWY_INLINE ReflectionOf<Floats> light_of_vertices(const ShadeDraw&, const Lighting&) const {
    return {};
  }

protected:
  // Looks up the value of the pixel's own triangle.
  HWY_INLINE Ints lookup(Ints of_triangles) const {
    return hn::TableLookupLanes(of_triangles.v, hn::IndicesFromVec(kI, self().lane.v));
  }
  HWY_INLINE Floats lookup(Floats of_triangles) const {
    return hn::TableLookupLanes(of_triangles.v, hn::IndicesFromVec(kF, self().lane.v));
  }

private:
  template <std::size_t N>
  HWY_INLINE std::array<Floats, N> interpolated(const AttributeDifferences<N>& a) const {
    std::array<Floats, N> attribute;
    for (std::size_t i = 0; i < N; ++i) {
      attribute[i] = interpolate(lookup(a.first[i]), lookup(a.difference1[i]),
                                 lookup(a.difference2[i]), self().weight1, self().weight2);
    }
    return attribute;
  }

  const Self& self() const { return static_cast<const Self&>(*this); }
};
struct SharedFragments : PointInSharedTriangle, SharedAttributes<SharedFragments> {};

// The fragments in the pixels at given columns and rows of the block.
class SharedSource : public PointInSharedTriangle, public SharedAttributes<SharedSource> {
public:
  using Fragments = SharedFragments;

  template <class ShadingPoint>
  HWY_INLINE SharedSource(const SharedTriangles& shared, Ints of_pixels, Ints column, Ints row,
                          const ShadingPoint& point)
      : PointInSharedTriangle{&shared, of_pixels, {}, {}} {
    const Ints area = lookup(shared.area);
    const Ints right1 = lookup(shared.right1), down1 = lookup(shared.down1);
    const Ints right2 = lookup(shared.right2), down2 = lookup(shared.down2);
    Ints e1 = lookup(shared.e1) + right1 * column + down1 * row;
    Ints e2 = lookup(shared.e2) + right2 * column + down2 * row;
    point.move_edges(edges_of(right1, down1, right2, down2), area, e1, e2);
    const Ints e0 = area - e1 - e2;
    const Floats inverse_area = lookup(shared.inverse_area);
    const Float3 lambda{screen_weight(to_float(e0), inverse_area),
                        screen_weight(to_float(e1), inverse_area),
                        screen_weight(to_float(e2), inverse_area)};
    at_ = in_space(lambda);
    weight1 = at_.weight1;
    weight2 = at_.weight2;
  }

  HWY_INLINE Fragments fragments() const { return {{*this}, {}}; }
  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    const TexturePlanesOf<Floats>& p = triangles->texture_planes;
    return {{lookup(p.origin[0]), lookup(p.origin[1])},
            {{{lookup(p.over_w[0][0]), lookup(p.over_w[0][1])},
              {lookup(p.over_w[1][0]), lookup(p.over_w[1][1])}}},
            {lookup(p.inverse_w[0]), lookup(p.inverse_w[1])}};
  }

private:
  // Returns all three edges, given the changes of two of them from one pixel to the next. (The
  // three changes sum to zero.)
  HWY_INLINE static std::array<EdgeSlopes<Ints>, 3> edges_of(Ints right1, Ints down1, Ints right2,
                                                             Ints down2) {
    const EdgeSlopes<Ints> edge1{shifted_right<kSubpixelBits>(right1),
                                 shifted_right<kSubpixelBits>(down1)};
    const EdgeSlopes<Ints> edge2{shifted_right<kSubpixelBits>(right2),
                                 shifted_right<kSubpixelBits>(down2)};
    return {{{0 - edge1.a - edge2.a, 0 - edge1.b - edge2.b}, edge1, edge2}};
  }
  HWY_INLINE WeightsInSpace<Floats> in_space(const Float3& lambda) const {
    const PerVertex<Floats>& w = triangles->inverse_w;
    if (triangles->draw->w_is_one) return {lambda[0], lambda[1], lambda[2], lookup(w[0])};
    const Float3 inverse_w{lookup(w[0]), lookup(w[1]), lookup(w[2])};
    return triangles->none_is_affine ? perspective_weights<Floats>(lambda, inverse_w)
                                     : weights_in_space<Floats>(lambda, inverse_w);
  }

  WeightsInSpace<Floats> at_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
