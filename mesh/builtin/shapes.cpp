#include <glassbox/mesh/builtin/shapes.h>

#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/normals.h>

namespace glassbox {

std::uint32_t add_position(Mesh& mesh, double x, double y, double z) {
  mesh.positions.emplace_back(float(x), float(y), float(z));
  return std::uint32_t(mesh.positions.size() - 1);
}

std::uint32_t add_normal(Mesh& mesh, const Vector<Object, double>& direction) {
  // A zero direction would give a zero normal. No shape here passes one; the tests would find it.
  mesh.normals.push_back(unit_normal(direction).value_or(Normal<Object>()));
  return std::uint32_t(mesh.normals.size() - 1);
}

std::uint32_t add_texcoord(Mesh& mesh, double u, double v) {
  mesh.texcoords.push_back({float(u), float(v)});
  return std::uint32_t(mesh.texcoords.size() - 1);
}

std::uint32_t add_color(Mesh& mesh, const Rgba& color) {
  mesh.colors.push_back(color);
  return std::uint32_t(mesh.colors.size() - 1);
}

void add_face(Mesh& mesh, std::span<const Corner> corners) {
  mesh.faces.push_back({std::uint32_t(mesh.corners.size()), std::uint32_t(corners.size())});
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
}

void add_flat_face(Mesh& mesh, std::span<const std::uint32_t> positions, std::uint32_t color,
                   std::span<const std::uint32_t> texcoords) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    corners.push_back({positions[i], kNone, texcoords.empty() ? kNone : texcoords[i], color});
  }
  add_face(mesh, corners);
  const Face face = mesh.faces.back();
  const std::uint32_t normal = add_normal(mesh, newell_vector(mesh, face));
  for (std::uint32_t i = 0; i < face.count; ++i) mesh.corners[face.first + i].normal = normal;
}

void add_rectangle(Mesh& mesh, const std::array<double, 3>& origin, const std::array<double, 3>& u,
                   const std::array<double, 3>& v, double repeat_u, double repeat_v) {
  const auto position = [&](double along_u, double along_v) {
    return add_position(mesh, origin[0] + along_u * u[0] + along_v * v[0],
                        origin[1] + along_u * u[1] + along_v * v[1],
                        origin[2] + along_u * u[2] + along_v * v[2]);
  };
  const std::array<std::uint32_t, 4> positions = {position(0, 0), position(1, 0), position(1, 1),
                                                  position(0, 1)};
  const std::array<std::uint32_t, 4> texcoords = {
      add_texcoord(mesh, 0, repeat_v), add_texcoord(mesh, repeat_u, repeat_v),
      add_texcoord(mesh, repeat_u, 0), add_texcoord(mesh, 0, 0)};
  add_flat_face(mesh, positions, kNone, texcoords);
}

void add_box(Mesh& mesh, const std::array<double, 3>& low, const std::array<double, 3>& high,
             const std::array<std::uint32_t, 6>& colors) {
  // Corner i is at the high end of x if bit 0 of i is set, of y if bit 1 is set, of z if bit 2 is
  // set.
  std::array<std::uint32_t, 8> p;
  for (std::uint32_t i = 0; i < 8; ++i) {
    p[i] = add_position(mesh, (i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
                        (i & 4) != 0 ? high[2] : low[2]);
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{0, 4, 6, 2}, {5, 1, 3, 7}, {0, 1, 5, 4}, {6, 7, 3, 2}, {1, 0, 2, 3}, {4, 5, 7, 6}}};
  const std::array<std::uint32_t, 4> texcoords = {
      add_texcoord(mesh, 0, 1), add_texcoord(mesh, 1, 1), add_texcoord(mesh, 1, 0),
      add_texcoord(mesh, 0, 0)};
  for (std::size_t side = 0; side < 6; ++side) {
    const auto& s = kSides[side];
    const std::array<std::uint32_t, 4> positions = {p[s[0]], p[s[1]], p[s[2]], p[s[3]]};
    add_flat_face(mesh, positions, colors[side], texcoords);
  }
}

void add_cone(Mesh& mesh, double radius, double bottom, double top, int sides) {
  const std::uint32_t tip = add_position(mesh, 0, top, 0);
  const auto first = std::uint32_t(mesh.positions.size());
  const auto first_normal = std::uint32_t(mesh.normals.size());
  // The side has twice as many normals as corners: the normals with even i belong to the corners of
  // the bottom circle, those with odd i to the tip, which has one normal for each triangle.
  for (int i = 0; i < 2 * sides; ++i) {
    const SinCos turn = sin_cos_degrees(180.0 * i / sides);
    if (i % 2 == 0) add_position(mesh, radius * turn.sin, bottom, radius * turn.cos);
    add_normal(mesh, {(top - bottom) * turn.sin, radius, (top - bottom) * turn.cos});
  }
  const auto count = std::uint32_t(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    const std::array<Corner, 3> corners = {{{first + i, first_normal + 2 * i, kNone, kNone},
                                            {first + next, first_normal + 2 * next, kNone, kNone},
                                            {tip, first_normal + 2 * i + 1, kNone, kNone}}};
    add_face(mesh, corners);
  }
  std::vector<std::uint32_t> base;
  for (std::uint32_t i = count; i-- > 0;) base.push_back(first + i);
  add_flat_face(mesh, base);
}

void add_tube(Mesh& mesh, double bottom_radius, double top_radius, double bottom, double top,
              int sides) {
  const auto first = std::uint32_t(mesh.positions.size());
  const auto first_normal = std::uint32_t(mesh.normals.size());
  for (int i = 0; i < sides; ++i) {
    const SinCos turn = sin_cos_degrees(360.0 * i / sides);
    add_position(mesh, bottom_radius * turn.sin, bottom, bottom_radius * turn.cos);
    add_position(mesh, top_radius * turn.sin, top, top_radius * turn.cos);
    add_normal(mesh,
               {(top - bottom) * turn.sin, bottom_radius - top_radius, (top - bottom) * turn.cos});
  }
  const auto count = std::uint32_t(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    const std::array<Corner, 4> corners = {
        {{first + 2 * i, first_normal + i, kNone, kNone},
         {first + 2 * next, first_normal + next, kNone, kNone},
         {first + 2 * next + 1, first_normal + next, kNone, kNone},
         {first + 2 * i + 1, first_normal + i, kNone, kNone}}};
    add_face(mesh, corners);
  }
}

}  // namespace glassbox
