// Small triangles, one a lane: their vertices in the order of the setup, and their edge functions in 32 bits.

#if defined(GLASSBOX_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SETUP_INL_H_
#undef GLASSBOX_SETUP_INL_H_
#else
#define GLASSBOX_SETUP_INL_H_
#endif

#include <glassbox/raster/lanes/lanes-inl.h>
#include <glassbox/raster/lanes/tables.h>
#include <glassbox/raster/lanes/tile_buffer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Words `at` and `at` + 1 of a table: where there are vectors, one gather of 64 bits for both.
struct Pair {
  VI first, second;
};
HWY_INLINE Pair gather_pair(const std::int32_t* table, VI at) {
#if HWY_TARGET == HWY_SCALAR
  return {hn::GatherIndex(kI, table, at), hn::GatherIndex(kI, table + 1, at)};
#else
  using D64 = hn::Repartition<std::int64_t, DI>;
  const D64 d64;
  const hn::Half<DI> half;
  const auto* from = reinterpret_cast<const std::int64_t*>(table);
  const auto gathered = [&](auto words) HWY_ATTR {
    const auto bytes = hn::ShiftLeft<2>(hn::PromoteTo(d64, words));
    return hn::BitCast(kI, hn::GatherOffset(d64, from, bytes));
  };
  const VI low = gathered(hn::LowerHalf(half, at)), high = gathered(hn::UpperHalf(half, at));
  return {hn::ConcatEven(kI, high, low), hn::ConcatOdd(kI, high, low)};
#endif
}

// One entry for each vertex of a triangle.
template <class V>
struct Triple {
  V v0, v1, v2;
};

// The indices of triangle `triangle` in each lane.
HWY_INLINE Triple<VI> gather_indices(IndexTriples triples, VI triangle) {
  const auto* from = reinterpret_cast<const std::int32_t*>(triples);
  const VI at = hn::Add(hn::Add(triangle, triangle), triangle);
  const Pair two = gather_pair(from, at);
  return {two.first, two.second, hn::GatherIndex(kI, from + 2, at)};
}
template <class D, class T>
HWY_INLINE Triple<hn::Vec<D>> gather(D d, const T* table, const Triple<VI>& at) {
  return {hn::GatherIndex(d, table, at.v0), hn::GatherIndex(d, table, at.v1),
          hn::GatherIndex(d, table, at.v2)};
}

// Columns of the screen's table, at the vertices. An entry is four words.
HWY_INLINE Triple<VI> entries_of(const Triple<VI>& vertices) {
  static_assert(sizeof(SnappedEntry) == 4 * sizeof(std::int32_t));
  return {hn::ShiftLeft<2>(vertices.v0), hn::ShiftLeft<2>(vertices.v1),
          hn::ShiftLeft<2>(vertices.v2)};
}
HWY_INLINE void gather_position(const SnappedEntry* screen, const Triple<VI>& entries,
                                Triple<VI>& x, Triple<VI>& y) {
  const Pair p0 = gather_pair(&screen->x, entries.v0);
  const Pair p1 = gather_pair(&screen->x, entries.v1);
  const Pair p2 = gather_pair(&screen->x, entries.v2);
  x = {p0.first, p1.first, p2.first};
  y = {p0.second, p1.second, p2.second};
}
HWY_INLINE Triple<VF> gather_z(const SnappedEntry* screen, const Triple<VI>& entries) {
  return gather(kF, &screen->z, entries);
}
HWY_INLINE Triple<VF> gather_inverse_w(const SnappedEntry* screen, const Triple<VI>& entries) {
  return gather(kF, &screen->inverse_w, entries);
}

// double_area() of fan.h: positive where the triangle runs clockwise on the screen.
HWY_INLINE VI double_area(const Triple<VI>& x, const Triple<VI>& y) {
  return hn::Sub(hn::Mul(hn::Sub(x.v1, x.v0), hn::Sub(y.v2, y.v0)),
                 hn::Mul(hn::Sub(x.v2, x.v0), hn::Sub(y.v1, y.v0)));
}

// How setup_triangle() orders the vertices: clockwise, beginning with the one of smallest depth.
struct Order {
  MI swapped;                  // 1 and 2 have changed places
  MI from_second, from_third;  // then rotated to begin there
};

HWY_INLINE Order order_of(VI area, const Triple<VF>& z) {
  const MI swapped = hn::Lt(area, hn::Zero(kI));
  const MF swapped_f = as_float_mask(swapped);
  const VF second = hn::IfThenElse(swapped_f, z.v2, z.v1);
  const VF third = hn::IfThenElse(swapped_f, z.v1, z.v2);
  const MF second_nearer = hn::Lt(second, z.v0);
  const MF third_nearest = hn::Lt(third, hn::IfThenElse(second_nearer, second, z.v0));
  return {swapped, as_int_mask(hn::AndNot(third_nearest, second_nearer)),
          as_int_mask(third_nearest)};
}

// An order as a number below kReferenceStep, and back.
HWY_INLINE VI code_of(const Order& order) {
  return hn::Or(hn::IfThenElseZero(order.swapped, set(1)),
                hn::Or(hn::IfThenElseZero(order.from_second, set(2)),
                       hn::IfThenElseZero(order.from_third, set(4))));
}
HWY_INLINE Order order_of_code(VI code) {
  return {hn::TestBit(code, set(1)), hn::TestBit(code, set(2)), hn::TestBit(code, set(4))};
}

template <class V>
HWY_INLINE Triple<V> put_in_order(const Order& order, const Triple<V>& v) {
  const hn::DFromV<V> d;
  const auto swapped = hn::RebindMask(d, order.swapped);
  const auto from_second = hn::RebindMask(d, order.from_second);
  const auto from_third = hn::RebindMask(d, order.from_third);
  const V one = hn::IfThenElse(swapped, v.v2, v.v1);
  const V two = hn::IfThenElse(swapped, v.v1, v.v2);
  return {hn::IfThenElse(from_third, two, hn::IfThenElse(from_second, one, v.v0)),
          hn::IfThenElse(from_third, v.v0, hn::IfThenElse(from_second, two, one)),
          hn::IfThenElse(from_third, one, hn::IfThenElse(from_second, v.v0, two))};
}

// The edge function opposite a vertex, as edge_function() of triangle_setup.cpp, with its value at a point instead of c.
struct EdgeLanes {
  VI a, b;
  VI value;
};
HWY_INLINE EdgeLanes edge_at(VI from_x, VI from_y, VI to_x, VI to_y, VI at_x, VI at_y) {
  const VI a = hn::Sub(from_y, to_y);
  const VI b = hn::Sub(to_x, from_x);
  return {a, b, hn::Add(hn::Mul(a, hn::Sub(at_x, from_x)), hn::Mul(b, hn::Sub(at_y, from_y)))};
}

// The largest value of an edge function that counts as outside: -1 of a top or left edge, 0 of others.
HWY_INLINE VI outside_up_to(const EdgeLanes& edge) {
  const MI top = hn::And(hn::Eq(edge.a, hn::Zero(kI)), hn::Gt(edge.b, hn::Zero(kI)));
  const MI left = hn::Gt(edge.a, hn::Zero(kI));
  return hn::VecFromMask(kI, hn::Or(top, left));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
