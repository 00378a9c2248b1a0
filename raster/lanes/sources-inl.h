// Where the attributes of fragments come from: a small triangle in every lane, or one large triangle in all.

#if defined(GLASSBOX_SOURCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SOURCES_INL_H_
#undef GLASSBOX_SOURCES_INL_H_
#else
#define GLASSBOX_SOURCES_INL_H_
#endif

#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>
#include <glassbox/raster/lanes/texture-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

using Float3 = std::array<Floats, 3>;
using Float2 = std::array<Floats, 2>;

template <class T>
HWY_INLINE Float3 gather_triple(const T* table, Ints at) {
  const float* from = &table->x;
  const Ints word = at + at + at;
  const Pair xy = gather_pair(reinterpret_cast<const std::int32_t*>(from), word);
  return {float_of(xy.first), float_of(xy.second), gather(from + 2, word)};
}

// A member of 32 bits of a table's entries.
template <class T>
HWY_INLINE Ints gather_member(const T* table, Ints at, std::uint32_t T::*member) {
  constexpr int kWords = sizeof(T) / sizeof(std::int32_t);
  return gather(reinterpret_cast<const std::int32_t*>(&(table->*member)), at * kWords);
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

// ---- a small triangle in every lane ----

// What of it is needed for attributes, which are gathered from the draw's tables.
struct SmallPlace {
  const ShadeDraw* draw = nullptr;
  Ints triangle;
  Order order;
  OfVertices<Ints> vertices;
  Floats weight1, weight2;  // in space, of vertices 1 and 2
};

// Attributes, of any class that has the members of a place.
template <class Self>
class SmallAttributes {
public:
  HWY_INLINE Float3 normal() const {
    if (HWY_UNLIKELY(self().draw->faces != nullptr)) return face_normal();
    return here<3>(normals());
  }
  HWY_INLINE Float3 position() const {
    return here<3>({gather_triple(self().draw->eye_positions, self().vertices[0]),
                    gather_triple(self().draw->eye_positions, self().vertices[1]),
                    gather_triple(self().draw->eye_positions, self().vertices[2])});
  }
  HWY_INLINE Rgb color() const {
    const OfVertices<Ints> corner = corners(self().draw->color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = shifted_left<2>(corner[k]);
      return Rgb{gather(&self().draw->colors->r, at), gather(&self().draw->colors->g, at),
                 gather(&self().draw->colors->b, at)};
    };
    return here<3>({at_vertex(0), at_vertex(1), at_vertex(2)});
  }
  HWY_INLINE Floats alpha() const {
    const OfVertices<Ints> corner = corners(self().draw->color_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      return gather(&self().draw->colors->a, shifted_left<2>(corner[k]));
    };
    const Floats a0 = at_vertex(0);
    return interpolate(a0, at_vertex(1) - a0, at_vertex(2) - a0, self().weight1, self().weight2);
  }
  HWY_INLINE Float2 texcoord() const { return here<2>(texcoords()); }
  HWY_INLINE OfVertices<Float2> texcoords() const {
    const OfVertices<Ints> corner = corners(self().draw->texcoord_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      const Ints at = corner[k] + corner[k];
      return Float2{gather(&self().draw->texcoords->u, at), gather(&self().draw->texcoords->v, at)};
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }
  HWY_INLINE ReflectionOf<Floats> reflection(const ShadeDraw& draw, const ResolveJob& job,
                                             const Float3& normal) const {
    if (HWY_UNLIKELY(draw.light == LightAt::kVertices)) return reflection_of_vertices(draw, job);
    const Floats zero = 0.0f;
    const Float3 where = draw.eye_positions != nullptr ? position() : Float3{zero, zero, zero};
    return reflected_light(*job.lighting, where, normal, draw.material->shininess, draw.highlights);
  }
  // 1 + the triangle's number in the scene.
  HWY_INLINE Ints id() const {
    return gather_member(self().draw->triangles, self().triangle, &Triangle::number) +
           std::int32_t(self().draw->first_number + 1);
  }

private:
  HWY_INLINE OfVertices<Float3> normals() const {
    const OfVertices<Ints> corner = corners(self().draw->normal_indices);
    const auto at_vertex = [&](std::size_t k) HWY_ATTR {
      return facing(gather_triple(self().draw->normals, corner[k]));
    };
    return {at_vertex(0), at_vertex(1), at_vertex(2)};
  }

  // ---- light that is computed at the vertices, or once for a face ----

  HWY_NOINLINE ReflectionOf<Floats> reflection_of_vertices(const ShadeDraw& draw,
                                                           const ResolveJob& job) const {
    const auto light_at = [&](const Float3& place, const Float3& n) HWY_ATTR {
      return reflected_light(*job.lighting, place, n, draw.material->shininess, draw.highlights);
    };
    if (draw.faces != nullptr) return light_at(face_centre(), face_normal());
    const OfVertices<Float3> normal = normals();
    OfVertices<Float3> diffuse, specular;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto light = light_at(gather_triple(draw.eye_positions, self().vertices[k]), normal[k]);
      diffuse[k] = light.diffuse;
      specular[k] = light.specular;
    }
    return {here<3>(diffuse), here<3>(specular)};
  }

  HWY_INLINE Ints face() const {
    return gather_member(self().draw->triangles, self().triangle, &Triangle::face);
  }
  HWY_INLINE Float3 face_normal() const {
    return facing(gather_triple(self().draw->face_normals, face()));
  }
  // The mean of the face's corners, summed from the first on (render/staged/corners.cpp).
  HWY_INLINE Float3 face_centre() const {
    const ShadeDraw& draw = *self().draw;
    const Ints at = face();
    const Ints first = gather_member(draw.faces, at, &Face::first);
    const Ints count = gather_member(draw.faces, at, &Face::count);
    const Floats zero = 0.0f;
    Float3 sum{zero, zero, zero};
    for (std::int32_t k = 0;; ++k) {
      const IntMask inside = count > k;
      if (none(inside)) break;
      const Ints corner = first + select(inside, Ints(k), Ints(0));
      const Float3 p =
          gather_triple(draw.eye_positions, gather_member(draw.corners, corner, &Corner::position));
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] = select(float_mask(inside), sum[i] + p[i], sum[i]);
    }
    const Floats share = 1.0f / to_float(count);
    return {sum[0] * share, sum[1] * share, sum[2] * share};
  }

  // An attribute of the three vertices, at the pixel.
  template <std::size_t N>
  HWY_INLINE std::array<Floats, N> here(const OfVertices<std::array<Floats, N>>& a) const {
    return interpolate(a[0], a[1], a[2], self().weight1, self().weight2);
  }
  HWY_INLINE OfVertices<Ints> corners(IndexTriples indices) const {
    if (HWY_LIKELY(indices == self().draw->positions)) return self().vertices;
    return put_in_order(self().order, gather_indices(indices, self().triangle));
  }
  // Seen from behind, a surface is lit as if its normals pointed the other way.
  HWY_INLINE Float3 facing(const Float3& n) const {
    if (!self().draw->shows_backs) return n;
    // Counter-clockwise on the screen is the front, and the back of what is mirrored.
    const FloatMask back =
        float_mask(self().draw->mirrored ? self().order.swapped : !self().order.swapped);
    return {select(back, -n[0], n[0]), select(back, -n[1], n[1]), select(back, -n[2], n[2])};
  }

  const Self& self() const { return static_cast<const Self&>(*this); }
};
struct SmallFragments : SmallPlace, SmallAttributes<SmallFragments> {};

// The triangle on the screen, too.
class SmallSource : public SmallPlace, public SmallAttributes<SmallSource> {
public:
  using Fragments = SmallFragments;

  // `reference`: of the lane's triangle, less the draw's first.
  template <class Place>
  HWY_INLINE SmallSource(const ShadeDraw& of_draw, Ints reference, Ints pixel_x, Ints pixel_y,
                         const Place& place)
      : SmallPlace(place_of(of_draw, reference)) {
    const OfVertices<Ints> entries = entries_of(vertices);
    OfVertices<Ints> x, y;
    gather_position(draw->screen, entries, x, y);
    inverse_w_ = gather(&draw->screen->inverse_w, entries);
    const Ints at_x = shifted_left<kSubpixelBits>(pixel_x) + kPixelCentre;
    const Ints at_y = shifted_left<kSubpixelBits>(pixel_y) + kPixelCentre;
    edges_ = {edge_of<0>(x, y), edge_of<1>(x, y), edge_of<2>(x, y)};
    const Ints area = double_area(x, y);
    Ints e1 = value_of<1>(edges_[1], x, y, at_x, at_y);
    Ints e2 = value_of<2>(edges_[2], x, y, at_x, at_y);
    place.move(edges_, area, e1, e2);
    const Ints e0 = area - e1 - e2;
    inverse_area_ = 1.0f / to_float(area);
    lambda1_ = screen_weight(to_float(e1), inverse_area_);
    lambda2_ = screen_weight(to_float(e2), inverse_area_);
    const Floats lambda0 = screen_weight(to_float(e0), inverse_area_);
    at_ = draw->w_is_one ? WeightsInSpace<Floats>{lambda0, lambda1_, lambda2_, inverse_w_[0]}
                         : weights_in_space({lambda0, lambda1_, lambda2_}, inverse_w_);
    weight1 = at_.weight1;
    weight2 = at_.weight2;
  }

  HWY_INLINE Fragments fragments() const { return {{*this}, {}}; }
  const WeightsInSpace<Floats>& at() const { return at_; }
  HWY_INLINE Floats depth() const {
    const OfVertices<Floats> z = gather(&draw->screen->z, entries_of(vertices));
    return interpolate(z[0], z[1] - z[0], z[2] - z[0], lambda1_, lambda2_);
  }
  HWY_INLINE TexturePlanesOf<Floats> texture_planes() const {
    std::array<Float3, 2> slopes;  // d lambda_k over one pixel along x and y, times 1/w_k
    for (std::size_t k = 0; k < 3; ++k) {
      const auto slope = [&](Ints step) HWY_ATTR {
        return slope_over_w(to_float(shifted_left<kSubpixelBits>(step)), inverse_area_,
                            inverse_w_[k]);
      };
      slopes[0][k] = slope(edges_[k].a);
      slopes[1][k] = slope(edges_[k].b);
    }
    return planes_over_w(slopes, texcoords(), is_affine(inverse_w_));
  }

private:
  HWY_INLINE static SmallPlace place_of(const ShadeDraw& draw, Ints reference) {
    static_assert(kReferenceStep == 1 << 3);
    SmallPlace place;
    place.draw = &draw;
    place.triangle = shifted_right<3>(reference);
    place.order = order_of_code(reference);
    place.vertices = put_in_order(place.order, gather_indices(draw.positions, place.triangle));
    return place;
  }

  std::array<EdgeSlopes<Ints>, 3> edges_;
  OfVertices<Floats> inverse_w_;
  Floats inverse_area_;
  Floats lambda1_, lambda2_;
  WeightsInSpace<Floats> at_;
};

// ---- one large triangle in all lanes ----

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

// What of it is needed for attributes.
struct LargePlace {
  const LargeTriangle* triangle = nullptr;
  Floats weight1, weight2;  // in space, of vertices 1 and 2
};
template <class Self>
class LargeAttributes {
public:
  HWY_INLINE Float3 normal() const { return attribute<3>(&Varyings::normal); }
  HWY_INLINE Rgb color() const { return attribute<3>(&Varyings::color); }
  HWY_INLINE Floats alpha() const { return attribute<4>(&Varyings::color)[3]; }
  HWY_INLINE Float2 texcoord() const { return attribute<2>(&Varyings::texcoord); }
  HWY_INLINE ReflectionOf<Floats> reflection(const ShadeDraw& draw, const ResolveJob& job,
                                             const Float3& normal) const {
    if (draw.light == LightAt::kVertices) {
      return {attribute<3>(&Varyings::diffuse), attribute<3>(&Varyings::specular)};
    }
    return reflected_light(*job.lighting, attribute<3>(&Varyings::position), normal,
                           draw.material->shininess, draw.highlights);
  }
  Ints id() const { return std::int32_t(self().triangle->number + 1); }

private:
  // The first N components of one of the varyings.
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
struct LargeFragments : LargePlace, LargeAttributes<LargeFragments> {};

// One large triangle in all lanes, which begin at pixel `i` of the quad at (x, y).
class LargeSource : public LargePlace, public LargeAttributes<LargeSource> {
public:
  using Fragments = LargeFragments;

  template <class Place>
  HWY_INLINE LargeSource(const LargeShape& shape, int x, int y, std::size_t i, const Place& place)
      : LargePlace{shape.triangle, {}, {}} {
    const TriangleSetup& setup = triangle->setup;
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
