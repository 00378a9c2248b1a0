// Depth and attributes at a pixel centre, from the integer edge functions there.
// formulas/interpolate.h has the formulas and the bounds of their errors.
#pragma once

#include <array>
#include <cstddef>

#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/formulas.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

inline float depth_from(const std::array<float, 3>& lambda, const std::array<float, 3>& depth) {
  const auto& [d0, d1, d2] = depth;
  return interpolate(d0, d1 - d0, d2 - d0, lambda[1], lambda[2]);
}

// Computes a fragment of a triangle or a line from its screen-space weights.
inline Fragment fragment_from(const std::array<float, 3>& lambda, const std::array<float, 3>& depth,
                              const std::array<float, 3>& inverse_w, bool affine) {
  Fragment fragment;
  fragment.lambda = lambda;
  fragment.depth = depth_from(lambda, depth);
  const WeightsInSpace<float> in_space =
      affine ? WeightsInSpace<float>{lambda[0], lambda[1], lambda[2], inverse_w[0]}
             : perspective_weights(lambda, inverse_w);
  fragment.weights = {in_space.weight0, in_space.weight1, in_space.weight2};
  fragment.inverse_w = in_space.inverse_w;
  return fragment;
}

inline std::array<float, 3> screen_weights(const TriangleSetup& triangle, const Coverage& at) {
  std::array<float, 3> lambda;
  for (std::size_t k = 0; k < 3; ++k) {
    lambda[k] = screen_weight(to_float(at.edges[k]), triangle.inverse_area);
  }
  return lambda;
}

// Computes only the depth, bit for bit the depth of the fragment that interpolate() returns.
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

// A line is treated as a triangle whose vertex 0 has weight 0 and the smaller of the two depths.
// Its attributes are interpolated with the same weights; vertex 0 gets the first end's attributes.
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
  return interpolate(a0, a1, a2, weights[1], weights[2]);
}

// Applies mix(a0, a1, a2) to each attribute of three vertices.
template <class Attributes, class Mix>
Attributes combine(const std::array<Attributes, 3>& v, const Mix& mix) {
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
