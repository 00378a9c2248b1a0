// Small triangles, one in each lane: reads their vertices from the tables and puts them in the
// order of the setup.

#if defined(GLASSBOX_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SETUP_INL_H_
#undef GLASSBOX_SETUP_INL_H_
#else
#define GLASSBOX_SETUP_INL_H_
#endif

#include <glassbox/raster/lanes/formulas-inl.h>
#include <glassbox/raster/lanes/loads-inl.h>
#include <glassbox/raster/lanes/tables.h>
#include <glassbox/raster/lanes/tile_buffer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// ---- tables ----

HWY_INLINE Ints gather(const std::int32_t* table, Ints at) {
  return hn::GatherIndex(kI, table, at.v);
}
HWY_INLINE Floats gather(const float* table, Ints at) {
  return hn::GatherIndex(kF, table, at.v);
}

// Words `at` and `at` + 1 of a table, each in a vector of its own.
struct WordPair {
  Ints first, second;
};
HWY_INLINE WordPair gather_pair(const std::int32_t* table, Ints at) {
#if HWY_TARGET == HWY_SCALAR
  return {gather(table, at), gather(table + 1, at)};
#else
  const LaneIndices indices(at);
  // Loads the words for lanes `first` and `first` + 1 of each block of four lanes.
  const auto two = [&](int first) HWY_ATTR {
    return combine_blocks([&](int block) HWY_ATTR {
      const std::int32_t* at_two = indices.lane + block + first;
      return two_words<4>(table, at_two[0], at_two[1]);
    });
  };
  const auto a = two(0), b = two(2);
  const auto even = hn::InterleaveLower(kI, a, b), odd = hn::InterleaveUpper(kI, a, b);
  return {hn::InterleaveLower(kI, even, odd), hn::InterleaveUpper(kI, even, odd)};
#endif
}

// One entry for each vertex of a triangle.
template <class T>
using PerVertex = std::array<T, 3>;

// Returns the indices of triangle `triangle` in each lane.
HWY_INLINE PerVertex<Ints> gather_indices(IndexTriples triples, Ints triangle) {
  const auto* from = reinterpret_cast<const std::int32_t*>(triples);
  const Ints at = triangle + triangle + triangle;
  const WordPair two = gather_pair(from, at);
  return {two.first, two.second, gather(from + 2, at)};
}
template <class T>
HWY_INLINE auto gather(const T* table, const PerVertex<Ints>& at) {
  return PerVertex<decltype(gather(table, at[0]))>{gather(table, at[0]), gather(table, at[1]),
                                                   gather(table, at[2])};
}

// Four words of a table, beginning at word `at`, each in a vector of its own. A vector that is not
// used costs nothing.
struct FourWords {
  Ints first, second, third, fourth;
};
HWY_INLINE FourWords gather_four(const std::int32_t* table, Ints at) {
#if HWY_TARGET == HWY_SCALAR
  return {gather(table, at), gather(table + 1, at), gather(table + 2, at), gather(table + 3, at)};
#else
  const LaneIndices indices(at);
  // Loads the four words for lane `first` of each block of four lanes.
  const auto one = [&](int first) HWY_ATTR {
    return combine_blocks([&](int block)
                              HWY_ATTR { return four_words(table, indices.lane[block + first]); });
  };
  // Transposes each block as a 4 x 4 matrix.
  const auto a = one(0), b = one(1), c = one(2), d = one(3);
  const auto ac = hn::InterleaveLower(kI, a, c), more_ac = hn::InterleaveUpper(kI, a, c);
  const auto bd = hn::InterleaveLower(kI, b, d), more_bd = hn::InterleaveUpper(kI, b, d);
  return {hn::InterleaveLower(kI, ac, bd), hn::InterleaveUpper(kI, ac, bd),
          hn::InterleaveLower(kI, more_ac, more_bd), hn::InterleaveUpper(kI, more_ac, more_bd)};
#endif
}

// The entries of the screen's table for the triangles' vertices: one vector for each member.
struct ScreenColumns {
  PerVertex<Ints> x, y;
  PerVertex<Floats> z, inverse_w;

  HWY_INLINE ScreenColumns(const SnappedEntry* screen, const PerVertex<Ints>& vertices) {
    static_assert(sizeof(SnappedEntry) == 4 * sizeof(std::int32_t));
    for (std::size_t k = 0; k < 3; ++k) {
      const FourWords entry = gather_four(&screen->x, shifted_left<2>(vertices[k]));
      x[k] = entry.first;
      y[k] = entry.second;
      z[k] = float_of(entry.third);
      inverse_w[k] = float_of(entry.fourth);
    }
  }
};

// ---- order ----

// The order of the vertices in setup_triangle(): clockwise, beginning with the one of smallest
// depth. It is implemented a second time, because vector code selects where code for one triangle
// sorts. tests/raster/lanes compares the two implementations.
struct VertexOrder {
  IntMask swapped;                  // vertices 1 and 2 were exchanged
  IntMask from_second, from_third;  // then rotated to begin with vertex 1 or 2
};

HWY_INLINE VertexOrder vertex_order(Ints area, const PerVertex<Floats>& z) {
  const IntMask swapped = area < 0;
  const FloatMask swapped_f = float_mask(swapped);
  const Floats second = select(swapped_f, z[2], z[1]);
  const Floats third = select(swapped_f, z[1], z[2]);
  const FloatMask second_nearer = second < z[0];
  const FloatMask third_nearest = third < select(second_nearer, second, z[0]);
  return {swapped, int_mask(second_nearer && !third_nearest), int_mask(third_nearest)};
}

// Converts an order to a number below kReferenceStep, and back.
HWY_INLINE Ints code_of(const VertexOrder& order) {
  const Ints none = 0;
  return select(order.swapped, 1, none) |
         (select(order.from_second, 2, none) | select(order.from_third, 4, none));
}
HWY_INLINE IntMask has_bit(Ints code, std::int32_t bit) {
  return {hn::TestBit(code.v, hn::Set(kI, bit))};
}
HWY_INLINE VertexOrder vertex_order_of_code(Ints code) {
  return {has_bit(code, 1), has_bit(code, 2), has_bit(code, 4)};
}

template <class V, class Mask>
HWY_INLINE PerVertex<V> put_in_order(Mask swapped, Mask from_second, Mask from_third,
                                     const PerVertex<V>& v) {
  const V one = select(swapped, v[2], v[1]);
  const V two = select(swapped, v[1], v[2]);
  return {select(from_third, two, select(from_second, one, v[0])),
          select(from_third, v[0], select(from_second, two, one)),
          select(from_third, one, select(from_second, v[0], two))};
}
HWY_INLINE PerVertex<Ints> put_in_order(const VertexOrder& order, const PerVertex<Ints>& v) {
  return put_in_order(order.swapped, order.from_second, order.from_third, v);
}
HWY_INLINE PerVertex<Floats> put_in_order(const VertexOrder& order, const PerVertex<Floats>& v) {
  return put_in_order(float_mask(order.swapped), float_mask(order.from_second),
                      float_mask(order.from_third), v);
}

// ---- edges ----

// Edge k is opposite vertex k, as in TriangleSetup.
template <std::size_t kEdge>
HWY_INLINE EdgeSlopes<Ints> edge_of(const PerVertex<Ints>& x, const PerVertex<Ints>& y) {
  constexpr std::size_t from = (kEdge + 1) % 3, to = (kEdge + 2) % 3;
  return edge_slopes(x[from], y[from], x[to], y[to]);
}
template <std::size_t kEdge>
HWY_INLINE Ints value_of(const EdgeSlopes<Ints>& edge, const PerVertex<Ints>& x,
                         const PerVertex<Ints>& y, Ints at_x, Ints at_y) {
  constexpr std::size_t from = (kEdge + 1) % 3;
  return edge_value(edge, x[from], y[from], at_x, at_y);
}

HWY_INLINE Ints smallest(const PerVertex<Ints>& v) {
  return least(v[0], least(v[1], v[2]));
}
HWY_INLINE Ints largest(const PerVertex<Ints>& v) {
  return greatest(v[0], greatest(v[1], v[2]));
}

// The largest value of an edge function at points outside the triangle: -1 for a top or left edge,
// 0 for other edges.
HWY_INLINE Ints outside_up_to(const EdgeSlopes<Ints>& edge) {
  return 0 - one_where(owns_its_points(edge));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
