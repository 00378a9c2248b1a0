// Computes the attributes of fragments if there is a small triangle in every lane.

#if defined(GLASSBOX_SMALL_SOURCE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SMALL_SOURCE_INL_H_
#undef GLASSBOX_SMALL_SOURCE_INL_H_
#else
#define GLASSBOX_SMALL_SOURCE_INL_H_
#endif

#include <glassbox/raster/lanes/shading_points-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

template <class T>
HWY_INLINE Float3 gather_triple(const T* table, Ints at) {
  const float* from = &table->x;
  const Ints word = at + at + at;
  const WordPair xy = gather_pair(reinterpret_cast<const std::int32_t*>(from), word);
  return {float_of(xy.first), float_of(xy.second), gather(from + 2, word)};
}

// Gathers a 32-bit member of a table's entries.
template <class T, class Member>
HWY_INLINE Ints gather_member(const T* table, Ints at, Member member) {
  static_assert(std::is_same_v<Member, std::uint32_t T::*>);
  constexpr int kWords = sizeof(T) / sizeof(std::int32_t);
  return gather(reinterpret_cast<const std::int32_t*>(&(table->*member)), at * kWords);
}

// The part of a fragment's data that its attributes need; attributes are gathered from the draw's
// tables.
struct PointInSmallTriangle {
  const ShadeDraw* draw = nullptr;
  Ints triangle;
  VertexOrder order;
  PerVertex<Ints> vertices;
  Floats weight1, weight2;  // barycentric, in space, of vertices 1 and 2
};

// Computes the attributes for a derived class `Self` that has the members of PointInSmallTriangle.
template <class Self>
class SmallAttributes {
public:
  HWY_INLINE Float3 normal() const {
    if (HWY_UNLIKELY(self().draw->faces != nullptr)) return face_normal();
    return interpolated<3>(normals());
  }
  HWY_INLINE Float3 position() const {
    if (self().draw->eye_positions != nullptr) return interpolated<3>(positions());
    const Floats zero = 0.0f;
    return {zero, zero, zero};
  }
  HWY_INLINE Rgb color() const { return interpolated<3>(colors()); }
  HWY_INLINE Floats alpha() const { return interpolated<1>(alphas())[0]; }
  HWY_INLINE Float2 texcoord() const { return interpolated<2>(texcoords()); }

  HWY_INLINE static bool is_lit_at_vertices(const ShadeDraw& draw) {
    return HWY_UNLIKELY(draw.light == LightAt::kVertices);
  }
  // The light at the pixel: computed at the vertices and interpolated, or once for a whole face.
  HWY_NOINLINE ReflectionOf<Floats> light_of_vertices(const ShadeDraw& draw,
                                                      const Lighting& lighting) const {
    const auto at = [&](const Float3& place, const Float3& n) HWY_ATTR {
      return reflected_light(lighting, place, n, draw.material->shininess, draw.highlights);
    };
    if (draw.faces != nullptr) return at(centre_of_face(FaceCorners(draw, face())), face_normal());
    const PerVertex<Float3> normal = normals();
    PerVertex<Float3> diffuse, specular;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto light = at(gather_triple(draw.eye_positions, self().vertices[k]), normal[k]);
      diffuse[k] = light.diffuse;
      specular[k] = light.specular;
    }
    return {interpolated<3>(diffuse), interpolated<3>(specular)};
  }
  // 1 + the triangle's number in the scene.
  HWY_INLINE Ints id() const {
    return gather_member(self().draw->triangles, self().triangle, &Triangle::number) +
           std::int32_t(self().draw->first_number + 1);
  }

  // ---- at the vertices ----

  HWY_INLINE PerVertex<Float3> normals() const {
    const PerVertex<Ints> corner = corners(self().draw->normal_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      return facing(gather_triple(self().draw->normals, corner[k]));
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }
  HWY_INLINE PerVertex<Float3> positions() const {
    const PerVertex<Ints>& vertices = self().vertices;
    const Point<Eye>* from = self().draw->eye_positions;
    return {gather_triple(from, vertices[0]), gather_triple(from, vertices[1]),
            gather_triple(from, vertices[2])};
  }
  HWY_INLINE PerVertex<Rgb> colors() const {
    const PerVertex<Ints> corner = corners(self().draw->color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = shifted_left<2>(corner[k]);
      return Rgb{gather(&self().draw->colors->r, at), gather(&self().draw->colors->g, at),
                 gather(&self().draw->colors->b, at)};
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }
  HWY_INLINE PerVertex<std::array<Floats, 1>> alphas() const {
    const PerVertex<Ints> corner = corners(self().draw->color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      return std::array{gather(&self().draw->colors->a, shifted_left<2>(corner[k]))};
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }
  HWY_INLINE PerVertex<Float2> texcoords() const {
    const PerVertex<Ints> corner = corners(self().draw->texcoord_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = corner[k] + corner[k];
      return Float2{gather(&self().draw->texcoords->u, at), gather(&self().draw->texcoords->v, at)};
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }

private:
  // ---- faces ----

  HWY_INLINE Ints face() const {
    return gather_member(self().draw->triangles, self().triangle, &Triangle::face);
  }
  HWY_INLINE Float3 face_normal() const {
    return facing(gather_triple(self().draw->face_normals, face()));
  }
  // The corners of a face, with the members that formulas/corners.h needs.
  struct FaceCorners {
    using Float = Floats;
    const ShadeDraw& draw;
    Ints first, corners;

    HWY_INLINE FaceCorners(const ShadeDraw& of_draw, Ints face)
        : draw(of_draw),
          first(gather_member(draw.faces, face, &Face::first)),
          corners(gather_member(draw.faces, face, &Face::count)) {}
    HWY_INLINE FloatMask has(std::int32_t k) const { return float_mask(corners > k); }
    HWY_INLINE Float3 position(std::int32_t k) const {
      const Ints corner = first + select(corners > k, Ints(k), Ints(0));
      return gather_triple(draw.eye_positions,
                           gather_member(draw.corners, corner, &Corner::position));
    }
    HWY_INLINE Floats count() const { return to_float(corners); }
  };

  // Interpolates an attribute of the three vertices at the pixel.
  template <std::size_t N>
  HWY_INLINE std::array<Floats, N> interpolated(const PerVertex<std::array<Floats, N>>& a) const {
    return interpolate(a[0], a[1], a[2], self().weight1, self().weight2);
  }
  HWY_INLINE PerVertex<Ints> corners(IndexTriples indices) const {
    if (HWY_LIKELY(indices == self().draw->positions)) return self().vertices;
    return put_in_order(self().order, gather_indices(indices, self().triangle));
  }
  HWY_INLINE Float3 facing(const Float3& n) const {
    if (!self().draw->shows_backs) return n;
    // Triangles that are counter-clockwise on the screen show their front; if the draw is mirrored,
    // they show their back.
    const FloatMask back =
        float_mask(self().draw->mirrored ? self().order.swapped : !self().order.swapped);
    return normal_facing_viewer(back, n);
  }

  const Self& self() const { return static_cast<const Self&>(*this); }
};
struct SmallFragments : PointInSmallTriangle, SmallAttributes<SmallFragments> {};

// Triangles on the screen: their edges, the values of two edge functions at a point of a pixel, and
// 1/w for perspective.
struct SmallOnScreen {
  std::array<EdgeSlopes<Ints>, 3> edges;
  Ints e1, e2, area;
  Floats inverse_area;
  PerVertex<Floats> inverse_w;

  template <class ShadingPoint>
  HWY_INLINE SmallOnScreen(const SnappedEntry* screen, const PerVertex<Ints>& vertices,
                           Ints pixel_x, Ints pixel_y, const ShadingPoint& point) {
    const ScreenColumns columns(screen, vertices);
    const PerVertex<Ints>&x = columns.x, &y = columns.y;
    inverse_w = columns.inverse_w;
    const Ints at_x = shifted_left<kSubpixelBits>(pixel_x) + kPixelCentre;
    const Ints at_y = shifted_left<kSubpixelBits>(pixel_y) + kPixelCentre;
    edges = {edge_of<0>(x, y), edge_of<1>(x, y), edge_of<2>(x, y)};
    area = double_area(x, y);
    e1 = value_of<1>(edges[1], x, y, at_x, at_y);
    e2 = value_of<2>(edges[2], x, y, at_x, at_y);
    point.move_edges(edges, area, e1, e2);
    inverse_area = 1.0f / to_float(area);
  }

  HWY_INLINE TexturePlanesOf<Floats> texture_planes(const PerVertex<Float2>& texcoords) const {
    std::array<Float3, 2> slopes;  // d lambda_k over one pixel along x and y, times 1/w_k
    for (std::size_t k = 0; k < 3; ++k) {
      const auto slope = [&](Ints step) HWY_ATTR {
        return slope_over_w(to_float(shifted_left<kSubpixelBits>(step)), inverse_area,
                            inverse_w[k]);
      };
      slopes[0][k] = slope(edges[k].a);
      slopes[1][k] = slope(edges[k].b);
    }
    return planes_over_w(slopes, texcoords, is_affine(inverse_w));
  }
};

HWY_INLINE PointInSmallTriangle point_in_small_triangle(const ShadeDraw& draw, Ints reference) {
  static_assert(kReferenceStep == 1 << 3);
  PointInSmallTriangle point;
  point.draw = &draw;
  point.triangle = shifted_right<3>(reference);
  point.order = vertex_order_of_code(reference);
  point.vertices = put_in_order(point.order, gather_indices(draw.positions, point.triangle));
  return point;
}

// Fragments of small triangles: every lane has a triangle and a pixel of its own.
class SmallSource : public PointInSmallTriangle, public SmallAttributes<SmallSource> {
public:
  using Fragments = SmallFragments;

  // `reference`: the reference of the lane's triangle minus the draw's first reference.
  template <class ShadingPoint>
  HWY_INLINE SmallSource(const ShadeDraw& of_draw, Ints reference, Ints pixel_x, Ints pixel_y,
                         const ShadingPoint& point)
      : PointInSmallTriangle(point_in_small_triangle(of_draw, reference)),
        screen_(draw->screen, vertices, pixel_x, pixel_y, point),
        lambda1_(screen_weight(to_float(screen_.e1), screen_.inverse_area)),
        lambda2_(screen_weight(to_float(screen_.e2), screen_.inverse_area)) {
    const Ints e0 = screen_.area - screen_.e1 - screen_.e2;
    const Floats lambda0 = screen_weight(to_float(e0), screen_.inverse_area);
    const PerVertex<Floats>& inverse_w = screen_.inverse_w;
    at_ = draw->w_is_one ? WeightsInSpace<Floats>{lambda0, lambda1_, lambda2_, inverse_w[0]}
                         : weights_in_space({lambda0, lambda1_, lambda2_}, inverse_w);
    weight1 = at_.weight1;
    weight2 = at_.weight2;
  }

  HWY_INLINE Fragments fragments() const { return {{*this}, {}}; }
  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE Floats depth() const {
    const PerVertex<Floats> z = ScreenColumns(draw->screen, vertices).z;
    return interpolate(z[0], z[1] - z[0], z[2] - z[0], lambda1_, lambda2_);
  }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    return screen_.texture_planes(texcoords());
  }

private:
  SmallOnScreen screen_;
  Floats lambda1_, lambda2_;
  WeightsInSpace<Floats> at_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
