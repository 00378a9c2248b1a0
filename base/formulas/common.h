// The smaller number. If the numbers are equal, or if one is a NaN, the result is the first.
template <class T>
inline T least(T a, T b) {
  return select(b < a, b, a);
}
template <class T>
inline T greatest(T a, T b) {
  return select(a < b, b, a);
}

// x limited to [low, high]; NaN stays NaN.
template <class T>
inline T clamped(T x, T low, T high) {
  return select(x < low, low, select(high < x, high, x));
}

// x limited to [0, 1]; NaN becomes 0.
template <Number F>
inline F in_unit_range(F x) {
  const F zero = 0.0f, one = 1.0f;
  return select(x > zero, select(x < one, x, one), zero);
}

template <Number F>
inline auto is_finite(F x) {
  return abs(x) <= std::numeric_limits<float>::max();
}

// Linear interpolation: a at t = 0, b at t = 1.
template <Number F>
inline F mix(F a, F b, F t) {
  return a + t * (b - a);
}

// ---- directions in space ----

template <Number F>
inline F dot(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <Number F>
inline std::array<F, 3> sum(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <Number F>
inline std::array<F, 3> product(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

template <Number F>
inline std::array<F, 3> difference(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Condition, Number F>
inline std::array<F, 3> zero_unless(Condition condition, const std::array<F, 3>& v) {
  const F zero = 0.0f;
  return {select(condition, v[0], zero), select(condition, v[1], zero),
          select(condition, v[2], zero)};
}

// v / |v|; zero where v has no direction (its length is 0 or NaN).
template <Number F>
inline std::array<F, 3> unit(const std::array<F, 3>& v) {
  const F length = sqrt(dot(v, v));
  const F scale = 1.0f / length;
  return zero_unless(length > 0.0f, std::array<F, 3>{v[0] * scale, v[1] * scale, v[2] * scale});
}
