// A triangle's edges (Pineda 1988), in integers: nothing here is rounded. Corners run clockwise on the screen, where y points
// down.

// Twice the signed area: positive where the corners run clockwise.
template <WholeNumber I>
inline I double_area(const std::array<I, 3>& x, const std::array<I, 3>& y) {
  return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

// a x + b y + c, positive on the inner side of the edge, without its c.
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

// A top edge points right and a left edge points up: points on it belong to the triangle, points on other edges to its
// neighbour.
template <WholeNumber I>
inline auto owns_its_points(const EdgeSlopes<I>& edge) {
  const I zero = 0;
  const auto top = edge.a == zero && edge.b > zero;
  const auto left = edge.a > zero;
  return top || left;
}

// Which pixel centres lie at or after `low`, and before or at `high`.
template <WholeNumber I>
inline I first_pixel(I low) {
  return shifted_right<kSubpixelBits>(low + (kPixelCentre - 1));
}
template <WholeNumber I>
inline I end_pixel(I high) {
  return shifted_right<kSubpixelBits>(high - kPixelCentre) + 1;
}
