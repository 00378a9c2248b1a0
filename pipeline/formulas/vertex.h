// Converts NDC to pixels along one axis; NDC -1 and 1 are at the pixel coordinates `at_minus_one`
// and `at_one`.
template <Number F>
inline F to_pixels(F ndc, float at_minus_one, float at_one) {
  return ndc * ((at_one - at_minus_one) * 0.5f) + (at_one + at_minus_one) * 0.5f;
}

// One row of a normal's transform: the row times the normal, summed from left to right.
template <class Matrix, Number F>
inline F transform_normal_row(const Matrix& m, int row, const std::array<F, 3>& n) {
  return m.at(row, 0) * n[0] + m.at(row, 1) * n[1] + m.at(row, 2) * n[2];
}

// n / |n|. The length is computed in double, where squares of floats neither overflow nor vanish.
// Zero stays zero.
template <Number F>
inline std::array<F, 3> unit_normal(const std::array<F, 3>& n) {
  const auto x = widened(n[0]), y = widened(n[1]), z = widened(n[2]);
  const auto length = sqrt(x * x + y * y + z * z);
  const auto divisor = select(length > 0.0, length, decltype(length)(1.0));
  return {rounded(x / divisor), rounded(y / divisor), rounded(z / divisor)};
}

// The distance along the gaze of a point of a parallel view, from its depth and the near and far
// planes.
template <Number F>
inline F parallel_distance(F depth, bool reversed, double near, double far) {
  const auto z = widened(depth);
  const auto from_near = reversed ? 1.0 - z : z;
  return rounded(near + from_near * (far - near));
}
