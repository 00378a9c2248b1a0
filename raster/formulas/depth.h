// Codes of depth: the smaller code is nearer. Depth outside [0, 1] (from rounding at a clipped
// edge) is clamped, and NaN becomes 0.

// The code is made from the float's bits: for floats that are not negative, these have the same
// order as the floats.
template <Number F>
inline auto float_depth_code(F depth) {
  return bits_of(in_unit_range(depth));
}
template <Number F>
inline auto reversed_depth_code(F depth) {
  return bits_of(F(1.0f)) - bits_of(in_unit_range(depth));
}

// z (2^bits - 1) rounded to nearest, halves up; `steps` is 2^bits - 1. The result is exact: a z of
// 24 bits times at most 24 bits fits in a double, and so does the sum with a half wherever it could
// reach the next integer.
template <Number F>
inline auto unorm_depth_code(F depth, double steps) {
  return to_integer(floor(widened(in_unit_range(depth)) * steps + 0.5));
}
