// Codes of depth: the smaller is nearer. Depth outside [0, 1] (rounding at a clipped edge) is clamped, and NaN is 0.

// Floats that are not negative order as their bits do.
template <Number F>
inline auto float_depth_code(F depth) {
  return bits_of(in_unit_range(depth));
}
template <Number F>
inline auto reversed_depth_code(F depth) {
  return bits_of(F(1.0f)) - bits_of(in_unit_range(depth));
}

// round-half-up of z (2^bits - 1), `steps`. Exact: 24-bit z times at most 24 bits fits a double, and so does the sum with a half
// wherever it could reach the next integer.
template <Number F>
inline auto unorm_depth_code(F depth, double steps) {
  return to_integer(floor(widened(in_unit_range(depth)) * steps + 0.5));
}
