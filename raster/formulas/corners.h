// The attributes at the corners of triangles, lines and points, and at the vertices after clipping.
//
// The functions get their inputs from `tables`, a class with the vertices of one draw: plain
// numbers in render/staged/corners.cpp, numbers with bounds in render/trace/corner_bounds.cpp. The
// vectorised code loads the attributes of many corners itself (raster/lanes/small_source-inl.h),
// and calls only the functions that do not need tables.

// The attributes that the mesh has at a corner; position and normal in eye space.
template <class Tables>
inline auto modelled_corner_attributes(const Tables& tables, const Corner& corner) {
  using F = typename Tables::Float;
  const Mesh& mesh = tables.mesh();
  VaryingsOf<F> at;
  if (corner.texcoord != kNone) {
    const TexCoord& texcoord = mesh.texcoords[corner.texcoord];
    at.texcoord = {F(texcoord.u), F(texcoord.v)};
  }
  if (corner.color != kNone) {
    const Rgba& color = mesh.colors[corner.color];
    at.color = {F(color.r), F(color.g), F(color.b), F(color.a)};
  }
  if (tables.has_positions()) at.position = tables.position(corner.position);
  if (corner.normal != kNone && tables.has_normals()) at.normal = tables.normal(corner.normal);
  return at;
}

// A surface seen from behind is lit as if its normals pointed the other way.
template <class Condition, Number F>
inline std::array<F, 3> normal_facing_viewer(Condition back, const std::array<F, 3>& n) {
  return {select(back, -n[0], n[0]), select(back, -n[1], n[1]), select(back, -n[2], n[2])};
}

// The mean of a face's corners in eye space, summed from the first on.
template <class Corners>
inline auto centre_of_face(const Corners& corners) {
  using F = typename Corners::Float;
  const F zero = 0.0f;
  std::array<F, 3> sum{zero, zero, zero};
  for (std::int32_t k = 0;; ++k) {
    const auto is_there = corners.has(k);
    if (none(is_there)) break;
    const std::array<F, 3> p = corners.position(k);
    for (std::size_t i = 0; i < 3; ++i) sum[i] = select(is_there, sum[i] + p[i], sum[i]);
  }
  const F share = F(1.0f) / corners.count();
  return std::array<F, 3>{sum[0] * share, sum[1] * share, sum[2] * share};
}

// Stores in `at` the light that arrives at `place`, in eye space, and is reflected there.
template <class Tables, class Place, class Attributes>
inline void light_corner(const Tables& tables, const Place& place, Attributes& at) {
  constexpr bool kHighlights = true;
  const auto light =
      reflected_light(tables.lighting(), place, at.normal, tables.shininess(), kHighlights);
  at.diffuse = light.diffuse;
  at.specular = light.specular;
}

// The attributes at a corner of a face, as the fragments interpolate them. With shading per face or
// per vertex they include the light. `front`: whether the front of the face is visible.
template <class Tables>
inline auto face_corner_attributes(const Tables& tables, std::uint32_t face, const Corner& corner,
                                   bool front) {
  auto at = modelled_corner_attributes(tables, corner);
  if (!tables.is_lit()) return at;
  if (tables.is_lit_by_face() || corner.normal == kNone) at.normal = tables.face_normal(face);
  at.normal = normal_facing_viewer(!front, at.normal);
  if (tables.is_lit_by_face()) light_corner(tables, centre_of_face(tables.corners(face)), at);
  if (tables.is_lit_by_vertex()) light_corner(tables, at.position, at);
  return at;
}

// The weighted sum of three attributes, computed in double precision and rounded once.
template <Number F, std::size_t N, class Weight>
inline std::array<F, N> weighted_sum(const std::array<F, N>& a, const std::array<F, N>& b,
                                     const std::array<F, N>& c,
                                     const std::array<Weight, 3>& weights) {
  std::array<F, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = rounded(weights[0] * widened(a[i]) + weights[1] * widened(b[i]) +
                        weights[2] * widened(c[i]));
  }
  return result;
}

// The attributes at a vertex after clipping: the sum of the triangle's corners' attributes with
// these weights. Most vertices are still corners of the triangle, with one weight of 1 and two of
// 0. They keep the corner's attributes: the sum would be the same, except for the sign of a zero,
// which no later stage reads.
template <class Attributes, class Weight>
inline Attributes clipped_vertex_attributes(const std::array<Attributes, 3>& corners,
                                            const std::array<Weight, 3>& weights) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Weight &own = weights[k], &second = weights[(k + 1) % 3], &third = weights[(k + 2) % 3];
    if (none(own != 1.0) && none(second != 0.0) && none(third != 0.0)) return corners[k];
  }
  return combine(corners, [&](const auto& a, const auto& b, const auto& c) {
    return weighted_sum(a, b, c, weights);
  });
}
