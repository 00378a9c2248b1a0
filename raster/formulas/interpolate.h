// Depth and attributes at a point of a triangle. E_k are the edge functions there and A is their
// sum, all exact integers; d_k, w_k and a_k are the depth, w and attribute at vertex k; `fl` rounds
// to float, and every operation is rounded:
//
//   lambda_k   = fl(E_k) * fl(1 / fl(A))
//   depth      = d0 + (lambda_1 (d1 - d0) + lambda_2 (d2 - d0))
//   q          = (lambda_0 / w0 + lambda_1 / w1) + lambda_2 / w2            (the 1/w_k are inputs)
//   weight_k   = (lambda_k / w_k) * (1 / q)
//   attribute  = a0 + (weight_1 (a1 - a0) + weight_2 (a2 - a0))
//
// No number is computed from that of a neighbouring pixel, so every order of visiting the pixels
// gives the same bits. Errors to first order in u = 2^-24, relative to the exact value for the
// snapped triangle and the given 1/w_k (tests/raster/interpolate_test.cpp compares them with
// rationals):
// - lambda: 4u (E_k, A, 1/A and the product are rounded), even in the far corner of a sliver.
// - depth: 8u, which a reversed depth range needs near 0. Vertex 0 has the smallest depth, so
//   nothing cancels: 4u of lambda, then a difference, a product and two sums of numbers that are
//   not negative. The result is never below the smallest depth, and a triangle of constant depth
//   gets exactly that depth.
// - q: 7u. It is a sum of positive numbers, so nothing cancels, however different the w are (C-66).
// - weight: 10u. The rounding errors of A and 1/A divide out, which leaves 3u of lambda_k / w_k, 5u
//   of q and two operations.
// - attribute: 13u (weight_1 |a1 - a0| + weight_2 |a2 - a0|) + u |attribute|, absolute. An
//   attribute that is equal at the three vertices has exactly that value everywhere.

template <Number F>
inline F screen_weight(F edge, F inverse_area) {
  return edge * inverse_area;
}

// Interpolates from the value at vertex 0, the differences of the other two values from it, and the
// weights of the other two vertices: the screen weights for depth, the weights in space for
// attributes.
template <Number F>
inline F interpolate(F a0, F a1_less_a0, F a2_less_a0, F weight1, F weight2) {
  return a0 + (weight1 * a1_less_a0 + weight2 * a2_less_a0);
}

// Interpolates each component of an attribute from those of the three vertices.
template <Number F, std::size_t N>
inline std::array<F, N> interpolate(const std::array<F, N>& a0, const std::array<F, N>& a1,
                                    const std::array<F, N>& a2, F weight1, F weight2) {
  std::array<F, N> a;
  for (std::size_t i = 0; i < N; ++i) {
    a[i] = interpolate(a0[i], a1[i] - a0[i], a2[i] - a0[i], weight1, weight2);
  }
  return a;
}

// Barycentric weights on the triangle in space, and 1/w at that point.
template <Number F>
struct WeightsInSpace {
  F weight0, weight1, weight2;
  F inverse_w;
};

template <Number F>
inline WeightsInSpace<F> perspective_weights(const std::array<F, 3>& lambda,
                                             const std::array<F, 3>& inverse_w) {
  const F share0 = lambda[0] * inverse_w[0];
  const F share1 = lambda[1] * inverse_w[1];
  const F share2 = lambda[2] * inverse_w[2];
  const F q = share0 + share1 + share2;
  const F w = 1.0f / q;
  return {share0 * w, share1 * w, share2 * w, q};
}

// Whether all three w are equal, so that perspective changes nothing.
template <Number F>
inline auto is_affine(const std::array<F, 3>& inverse_w) {
  return inverse_w[0] == inverse_w[1] && inverse_w[1] == inverse_w[2];
}

template <Number F>
inline WeightsInSpace<F> weights_in_space(const std::array<F, 3>& lambda,
                                          const std::array<F, 3>& inverse_w) {
  const auto affine = is_affine(inverse_w);
  const WeightsInSpace<F> seen = perspective_weights(lambda, inverse_w);
  return {select(affine, lambda[0], seen.weight0), select(affine, lambda[1], seen.weight1),
          select(affine, lambda[2], seen.weight2), select(affine, inverse_w[0], seen.inverse_w)};
}
