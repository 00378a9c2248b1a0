// A triangle's edge functions (Pineda 1988), in integers: nothing is rounded here. The corners run
// clockwise on the screen, where y points down.

// Twice the signed area: positive if the corners run clockwise.
template <WholeNumber I>
inline I double_area(const std::array<I, 3>& x, const std::array<I, 3>& y) {
  return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

// The coefficients a and b of the edge function a x + b y + c, which is positive on the inner side
// of the edge.
template <WholeNumber I>
struct EdgeSlopes {
  I a, b;
};
template <WholeNumber I>
inline EdgeSlopes<I> edge_slopes(I from_x, I from_y, I to_x, I to_y) {
  return {from_y - to_y, to_x - from_x};
}

// The edge function at a point; `on_x`, `on_y` is a point on the edge.
template <WholeNumber I>
inline I edge_value(const EdgeSlopes<I>& edge, I on_x, I on_y, I x, I y) {
  return edge.a * (x - on_x) + edge.b * (y - on_y);
}

// Whether the triangle owns the points on this edge. A top edge points right and a left edge points
// up: their points belong to the triangle, the points of other edges to its neighbour.
template <WholeNumber I>
inline auto owns_its_points(const EdgeSlopes<I>& edge) {
  const I zero = 0;
  const auto top = edge.a == zero && edge.b > zero;
  const auto left = edge.a > zero;
  return top || left;
}

// The first pixel whose centre is at or after `low`, and one past the last pixel whose centre is at
// or before `high`.
template <WholeNumber I>
inline I first_pixel(I low) {
  return shifted_right<kSubpixelBits>(low + (kPixelCentre - 1));
}
template <WholeNumber I>
inline I end_pixel(I high) {
  return shifted_right<kSubpixelBits>(high - kPixelCentre) + 1;
}
