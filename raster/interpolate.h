// Depth and attributes at a pixel centre, from the integer edge functions there.
//
// With E_k the edge functions and A their sum, exact integers, `fl` the rounding to float, and every operation rounded:
//
//   lambda_k   = fl(E_k) * fl(1 / fl(A))
//   depth      = d0 + (lambda_1 (d1 - d0) + lambda_2 (d2 - d0))
//   q          = (lambda_0 / w0 + lambda_1 / w1) + lambda_2 / w2            (the 1/w_k are inputs)
//   weight_k   = (lambda_k / w_k) * (1 / q)
//   attribute  = a0 + (weight_1 (a1 - a0) + weight_2 (a2 - a0))
//
// Nothing depends on where the walk over the pixels began, so every way of walking gives the same bits.
// Errors to first order in u = 2^-24, relative to the exact value for the snapped triangle and the 1/w_k as given
// (tests/raster/interpolate_test.cpp holds them against rationals):
//   - lambda: 4u (E_k, A, 1/A and the product are rounded), also in the far corner of a sliver.
//   - depth: 8u, which a reversed depth range needs near 0. Vertex 0 is the one of smallest depth, so nothing cancels:
//     4u of lambda, then a difference, a product and two sums of numbers that are not negative. Never below the
//     smallest depth; and a flat triangle has exactly its own.
//   - q: 7u. A sum of positive numbers: no cancellation however different the w are (C-66).
//   - weight: 10u. The rounding of A and 1/A divides out, which leaves 3u of lambda_k / w_k, 5u of q and two operations.
//   - attribute: 13u (weight_1 |a1 - a0| + weight_2 |a2 - a0|) + u |attribute|, absolute. One that is equal at the three
//     vertices is exactly that everywhere.
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

inline float depth_from(const std::array<float, 3>& lambda, const std::array<float, 3>& depth) {
  const auto& [d0, d1, d2] = depth;
  return d0 + (lambda[1] * (d1 - d0) + lambda[2] * (d2 - d0));
}

// The common part: a fragment from its screen-space weights.
inline Fragment fragment_from(const std::array<float, 3>& lambda, const std::array<float, 3>& depth,
                              const std::array<float, 3>& inverse_w, bool affine) {
  Fragment fragment;
  fragment.lambda = lambda;
  fragment.depth = depth_from(lambda, depth);
  if (affine) {
    fragment.inverse_w = inverse_w[0];
    fragment.weights = lambda;
    return fragment;
  }
  const std::array<float, 3> share{lambda[0] * inverse_w[0], lambda[1] * inverse_w[1],
                                   lambda[2] * inverse_w[2]};
  fragment.inverse_w = share[0] + share[1] + share[2];
  const float w = 1.0f / fragment.inverse_w;
  for (std::size_t k = 0; k < 3; ++k) fragment.weights[k] = share[k] * w;
  return fragment;
}

inline std::array<float, 3> screen_weights(const TriangleSetup& triangle, const Coverage& at) {
  std::array<float, 3> lambda;
  for (std::size_t k = 0; k < 3; ++k) lambda[k] = float(at.edges[k]) * triangle.inverse_area;
  return lambda;
}

// The same depth as that of the whole fragment.
inline float interpolate_depth(const TriangleSetup& triangle, const Coverage& at) {
  return depth_from(screen_weights(triangle, at), triangle.depth);
}

inline Fragment interpolate(const TriangleSetup& triangle, const Coverage& pixel) {
  Fragment fragment = fragment_from(screen_weights(triangle, pixel), triangle.depth,
                                    triangle.inverse_w, triangle.affine);
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  return fragment;
}

// A line is a triangle whose vertex 0 has no weight, and the smaller of the two depths. Its attributes follow from the
// weights with those of the first end in place of vertex 0.
inline Fragment interpolate(const std::array<ScreenVertex, 2>& ends, const LinePixel& pixel) {
  const float share = 1.0f / float(pixel.steps);
  const std::array<float, 3> lambda{0.0f, float(pixel.steps - pixel.step) * share,
                                    float(pixel.step) * share};
  const float za = ends[0].position.z, zb = ends[1].position.z;
  const float wa = ends[0].inverse_w, wb = ends[1].inverse_w;
  Fragment fragment = fragment_from(lambda, {za < zb ? za : zb, za, zb}, {wa, wa, wb}, wa == wb);
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  return fragment;
}

template <std::size_t N>
std::array<float, N> interpolate(const std::array<float, N>& a0, const std::array<float, N>& a1,
                                 const std::array<float, N>& a2,
                                 const std::array<float, 3>& weights) {
  std::array<float, N> a;
  for (std::size_t i = 0; i < N; ++i) {
    a[i] = a0[i] + (weights[1] * (a1[i] - a0[i]) + weights[2] * (a2[i] - a0[i]));
  }
  return a;
}

// mix(a0, a1, a2) for each attribute of three vertices.
template <class Mix>
Varyings combine(const std::array<Varyings, 3>& v, const Mix& mix) {
  return {mix(v[0].normal, v[1].normal, v[2].normal),
          mix(v[0].position, v[1].position, v[2].position),
          mix(v[0].diffuse, v[1].diffuse, v[2].diffuse),
          mix(v[0].specular, v[1].specular, v[2].specular),
          mix(v[0].color, v[1].color, v[2].color),
          mix(v[0].texcoord, v[1].texcoord, v[2].texcoord)};
}

// The varyings of the three vertices are in the order of the setup (TriangleSetup::order).
inline Varyings interpolate(const std::array<Varyings, 3>& vertices,
                            const std::array<float, 3>& weights) {
  return combine(vertices, [&](const auto& a0, const auto& a1, const auto& a2) {
    return interpolate(a0, a1, a2, weights);
  });
}

}  // namespace glassbox
