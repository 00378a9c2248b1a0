#include <glassbox/mesh/gltf/primitive.h>

#include <cmath>
#include <limits>
#include <string>

#include <glassbox/mesh/gltf/accessors.h>
#include <glassbox/mesh/gltf/attributes.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

// Normals are kept bit by bit if their length differs from 1 by no more than rounding to float can
// cause. Each component has a relative error of at most 2^-24, so |n|^2 has one of 2^-23; the
// tolerance is four times as large.
constexpr double kUnitTolerance = 0x1p-21;

std::string place_of(const Asset& asset, PrimitiveId id) {
  const std::string& name = asset.model.meshes[id.mesh].name;
  std::string place = entry("mesh", id.mesh);
  if (!name.empty()) place.append(" ").append(in_quotes(name));
  return place.append(", ").append(entry("primitive", id.primitive));
}

std::string mesh_name(const tinygltf::Mesh& mesh, PrimitiveId id) {
  const std::string name = mesh.name.empty() ? entry("mesh", id.mesh) : printable(mesh.name);
  if (mesh.primitives.size() == 1) return name;
  return std::string(name).append("[").append(std::to_string(id.primitive)).append("]");
}

// Every accessor that is read to draw the primitive; the first is that of the positions.
std::vector<std::size_t> accessors_of(const tinygltf::Primitive& primitive) {
  std::vector<std::size_t> accessors{std::size_t(primitive.attributes.at("POSITION"))};
  for (const auto& [name, accessor] : primitive.attributes)
    accessors.push_back(std::size_t(accessor));
  if (primitive.indices >= 0) accessors.push_back(std::size_t(primitive.indices));
  for (const auto& target : primitive.targets) {
    for (const auto& [name, accessor] : target) accessors.push_back(std::size_t(accessor));
  }
  return accessors;
}

bool is_compressed(const Asset& asset, PrimitiveId id) {
  const nlohmann::json& primitive = asset.document["meshes"][id.mesh]["primitives"][id.primitive];
  return find(primitive, {"extensions", "KHR_draco_mesh_compression"}) != nullptr;
}

// ---- vertices ----

// Reads the positions and normals, with morph targets and skin applied, before they are rounded to
// float.
Result<Vertices> read_vertices(Asset& asset, const tinygltf::Primitive& primitive,
                               const Attributes& attributes, const std::string& place,
                               std::size_t count, const std::vector<bool>& used, const Pose& pose,
                               Budget& budget) {
  auto positions = attributes.read("POSITION", Semantic::kPosition);
  if (!positions) return tl::unexpected(positions.error());
  auto normals = attributes.read("NORMAL", Semantic::kNormal);
  if (!normals) return tl::unexpected(normals.error());
  Vertices vertices;
  vertices.positions = std::move((*positions)->numbers);
  if (*normals) vertices.normals = std::move((*normals)->numbers);

  for (std::size_t i = 0; i < pose.weights.size() && i < primitive.targets.size(); ++i) {
    if (pose.weights[i] == 0) continue;
    if (!budget.take(count)) {
      return fail(place,
                  "its morph targets move too many vertices for a file of " +
                      std::to_string(asset.bytes) + " bytes",
                  "apply the morph targets to the mesh and export it without them");
    }
    const Attributes deltas(asset, primitive.targets[i], place + ", target " + std::to_string(i),
                            count, used);
    const auto moved = deltas.read("POSITION", Semantic::kPositionDelta);
    if (!moved) return tl::unexpected(moved.error());
    if (*moved) add_target(vertices.positions, (*moved)->numbers, pose.weights[i]);
    const auto turned = deltas.read("NORMAL", Semantic::kNormalDelta);
    if (!turned) return tl::unexpected(turned.error());
    if (*turned && !vertices.normals.empty())
      add_target(vertices.normals, (*turned)->numbers, pose.weights[i]);
  }

  if (!pose.joints) return vertices;
  std::vector<Influences> sets;
  for (std::size_t set = 0;; ++set) {
    const std::string joints_name = "JOINTS_" + std::to_string(set);
    const std::string weights_name = "WEIGHTS_" + std::to_string(set);
    if (!attributes.has(joints_name) || !attributes.has(weights_name)) break;
    auto joints = attributes.read(joints_name, Semantic::kJoints);
    if (!joints) return tl::unexpected(joints.error());
    auto weights = attributes.read(weights_name, Semantic::kWeights);
    if (!weights) return tl::unexpected(weights.error());
    sets.push_back({std::move((*joints)->numbers), std::move((*weights)->numbers)});
  }
  if (sets.empty())
    return fail(place, "is skinned but has no joints and weights", "export the skin again");
  if (const auto skinned = apply_skin(vertices, sets, *pose.joints); !skinned)
    return fail_inside(place, skinned.error());
  return vertices;
}

Result<void> set_positions(Mesh& mesh, const Vertices& vertices, const std::string& place) {
  mesh.positions.reserve(vertices.count());
  for (std::size_t i = 0; i < vertices.count(); ++i) {
    const double* p = vertices.positions.data() + i * 3;
    const Point<Object> position{float(p[0]), float(p[1]), float(p[2])};
    if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
      return fail(place + ", vertex " + std::to_string(i),
                  "its position in this pose is beyond what a float can hold",
                  "check the morph weights and the skin");
    }
    mesh.positions.push_back(position);
  }
  return {};
}

// Sets the mesh's unit normals. Returns for each one whether it is usable: a normal without
// direction gets an entry that is not used, and its corners are shaded flat.
std::vector<bool> set_normals(Asset& asset, Mesh& mesh, const Vertices& vertices,
                              const std::string& place) {
  std::vector<bool> usable;
  std::size_t without_direction = 0;
  mesh.normals.reserve(vertices.normals.size() / 3);
  for (std::size_t i = 0; i < vertices.normals.size() / 3; ++i) {
    const double* n = vertices.normals.data() + i * 3;
    const double squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    // The squares of the file's floats neither overflow nor vanish in double, but those of morphed
    // or skinned normals could.
    const bool good = squared > 0x1p-1000 && std::isfinite(squared);
    const double length = std::abs(squared - 1) <= kUnitTolerance ? 1 : std::sqrt(squared);
    usable.push_back(good);
    without_direction += good ? 0 : 1;
    mesh.normals.push_back(
        good ? Normal<Object>(float(n[0] / length), float(n[1] / length), float(n[2] / length))
             : Normal<Object>(0, 0, 1));
  }
  if (without_direction > 0) {
    asset.warn_at(place,
                  "normals of length zero were left out ({}); corners with them are shaded flat",
                  without_direction);
  }
  return usable;
}

Result<void> set_texcoords(Asset& asset, Mesh& mesh, const Attributes& attributes,
                           const TexCoordSource& source, const std::string& place) {
  const std::string name = "TEXCOORD_" + std::to_string(source.set);
  const auto read = attributes.read(name, Semantic::kTexCoord);
  if (!read) return tl::unexpected(read.error());
  if (!*read) {
    if (source.textured)
      asset.warn_at(place, "has a texture but no " + name + ", so that the texture is left out");
    return {};
  }
  const std::vector<double>& numbers = (*read)->numbers;
  mesh.texcoords.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i < numbers.size() / 2; ++i) {
    double u = numbers[i * 2], v = numbers[i * 2 + 1];
    if (source.transform) {
      const auto& m = source.transform->matrix;
      const double u0 = u, v0 = v;
      u = m[0][0] * u0 + m[0][1] * v0 + m[0][2];
      v = m[1][0] * u0 + m[1][1] * v0 + m[1][2];
    }
    const TexCoord texcoord{float(u), float(v)};
    if (!std::isfinite(texcoord.u) || !std::isfinite(texcoord.v)) {
      return fail(place + ", " + name + ", element " + std::to_string(i),
                  "is beyond what a float can hold after its transform",
                  "correct KHR_texture_transform");
    }
    mesh.texcoords.push_back(texcoord);
  }
  return {};
}

Result<void> set_colors(Mesh& mesh, const Attributes& attributes) {
  const auto read = attributes.read("COLOR_0", Semantic::kColor);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return {};
  const std::size_t width = (*read)->width;
  const std::vector<double>& numbers = (*read)->numbers;
  mesh.colors.reserve(numbers.size() / width);
  for (std::size_t i = 0; i < numbers.size(); i += width) {
    mesh.colors.push_back({float(numbers[i]), float(numbers[i + 1]), float(numbers[i + 2]),
                           width == 4 ? float(numbers[i + 3]) : 1.0f});
  }
  return {};
}

// ---- connectivity ----

Result<std::vector<std::uint32_t>> vertex_order(const Asset& asset,
                                                const tinygltf::Primitive& primitive,
                                                const std::string& place, std::size_t count) {
  std::vector<std::uint32_t> order;
  if (primitive.indices < 0) {
    for (std::size_t i = 0; i < count; ++i) order.push_back(std::uint32_t(i));
    return order;
  }
  const std::size_t index = std::size_t(primitive.indices);
  const std::string where = place + ", indices, " + entry("accessor", index);
  const auto read = read_indices(asset, index);
  if (!read) return fail_inside(place + ", indices", read.error());
  const int type = asset.model.accessors[index].componentType;
  const std::uint32_t restart = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 0xffu
                                : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 0xffffu
                                                                                 : 0xffffffffu;
  for (std::size_t i = 0; i < read->size(); ++i) {
    const std::uint32_t vertex = (*read)[i];
    if (vertex == restart) {
      return fail(where + ", element " + std::to_string(i),
                  "is " + std::to_string(vertex) +
                      ", which means a primitive restart and is forbidden in glTF",
                  "write separate primitives");
    }
    if (vertex >= count) {
      return fail(where + ", element " + std::to_string(i),
                  "names vertex " + std::to_string(vertex) + ", but the primitive has only " +
                      std::to_string(count) + " (numbers start at 0)",
                  "export the file again");
    }
  }
  return *read;
}

// Which vertices the indices name; an empty list if there are no indices, and all are used.
std::vector<bool> used_vertices(const tinygltf::Primitive& primitive,
                                const std::vector<std::uint32_t>& order, std::size_t count) {
  if (primitive.indices < 0) return {};
  std::vector<bool> used(count, false);
  for (const std::uint32_t vertex : order) used[vertex] = true;
  return used;
}

// Connects vertices to triangles, lines or points (glTF 2.0, section 3.7.2.1). corner(i) returns
// the corner of the i-th of the `n` vertices in drawing order.
template <class CornerOf>
void connect(Asset& asset, Mesh& mesh, int mode, std::size_t n, const CornerOf& corner,
             const std::string& place) {
  const auto leftover = [&](std::size_t per_shape) {
    if (n % per_shape != 0)
      asset.warn_at(place,
                    "vertices at its end were left out ({}), because they are too few for one more "
                    "triangle or line",
                    n % per_shape);
  };
  const auto add_line = [&](std::size_t a, std::size_t b) {
    mesh.lines.push_back({corner(a), corner(b)});
  };
  const auto reserve_faces = [&](std::size_t count) {
    mesh.faces.reserve(count);
    mesh.corners.reserve(3 * count);
  };
  const auto add_face = [&](std::size_t a, std::size_t b, std::size_t c) {
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
    for (const std::size_t i : {a, b, c}) mesh.corners.push_back(corner(i));
  };
  switch (mode) {
    case TINYGLTF_MODE_POINTS:
      for (std::size_t i = 0; i < n; ++i) mesh.points.push_back(corner(i));
      break;
    case TINYGLTF_MODE_LINE:
      leftover(2);
      for (std::size_t i = 0; i + 1 < n; i += 2) add_line(i, i + 1);
      break;
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP:
      for (std::size_t i = 0; i + 1 < n; ++i) add_line(i, i + 1);
      if (mode == TINYGLTF_MODE_LINE_LOOP && n >= 2) add_line(n - 1, 0);
      break;
    case TINYGLTF_MODE_TRIANGLES:
      leftover(3);
      reserve_faces(n / 3);
      for (std::size_t i = 0; i + 2 < n; i += 3) add_face(i, i + 1, i + 2);
      break;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      reserve_faces(n);
      // The corners of every second triangle of a strip are exchanged, so that all triangles have
      // the same winding.
      for (std::size_t i = 0; i + 2 < n; ++i) add_face(i, i + 1 + i % 2, i + 2 - i % 2);
      break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
      reserve_faces(n);
      for (std::size_t i = 0; i + 2 < n; ++i) add_face(i + 1, i + 2, 0);
      break;
    default:
      break;  // schema.h allows no other mode
  }
}

}  // namespace

Result<std::optional<Mesh>> convert_primitive(Asset& asset, PrimitiveId id, const Pose& pose,
                                              const TexCoordSource& texcoords, Budget& budget) {
  const tinygltf::Mesh& described = asset.model.meshes[id.mesh];
  const tinygltf::Primitive& primitive = described.primitives[id.primitive];
  const std::string place = place_of(asset, id);
  const auto skip = [&](const std::string& why) {
    asset.warn_at(place, why + ", so that it is not drawn");
    return std::optional<Mesh>();
  };
  if (!primitive.attributes.contains("POSITION")) return skip("has no positions");
  const std::vector<std::size_t> accessors = accessors_of(primitive);
  if (is_compressed(asset, id) && asset.model.accessors[accessors[0]].bufferView < 0) {
    return fail(place,
                "is compressed with KHR_draco_mesh_compression, which is not supported, and has no "
                "other data",
                "export it without this extension");
  }
  for (const std::size_t accessor : accessors) {
    if (!has_data(asset, accessor)) return skip("reads a buffer that has no data");
  }
  if (primitive.indices >= 0) {
    if (auto form = check_form(asset, std::size_t(primitive.indices), Semantic::kIndices); !form)
      return fail_inside(place + ", indices", form.error());
  }

  const std::size_t count = asset.model.accessors[accessors[0]].count;
  const std::size_t drawn =
      primitive.indices < 0 ? count : asset.model.accessors[std::size_t(primitive.indices)].count;
  // Each vertex of a strip, fan or loop makes up to three corners.
  const std::uint64_t corners_per_vertex =
      primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_POINTS ? 1 : 3;
  if (!budget.take(count + corners_per_vertex * drawn)) {
    return fail(place,
                "the meshes use their data so often that they have more than " +
                    std::to_string(budget.size()) +
                    " vertices and corners, too many for a file of " + std::to_string(asset.bytes) +
                    " bytes",
                "let several nodes draw one mesh instead of several meshes use one accessor");
  }
  const auto order = vertex_order(asset, primitive, place, count);
  if (!order) return tl::unexpected(order.error());
  const std::vector<bool> used = used_vertices(primitive, *order, count);
  const Attributes attributes(asset, primitive.attributes, place, count, used);
  auto vertices = read_vertices(asset, primitive, attributes, place, count, used, pose, budget);
  if (!vertices) return tl::unexpected(vertices.error());

  Mesh mesh;
  mesh.name = mesh_name(described, id);
  if (auto done = set_positions(mesh, *vertices, place); !done) return tl::unexpected(done.error());
  const std::vector<bool> has_normal = set_normals(asset, mesh, *vertices, place);
  // Frees memory: these doubles are twice as large as the mesh's own table.
  *vertices = {};
  if (auto done = set_texcoords(asset, mesh, attributes, texcoords, place); !done)
    return tl::unexpected(done.error());
  if (auto done = set_colors(mesh, attributes); !done) return tl::unexpected(done.error());

  const auto corner = [&](std::size_t i) {
    const std::uint32_t vertex = (*order)[i];
    return Corner{vertex, !has_normal.empty() && has_normal[vertex] ? vertex : kNone,
                  mesh.texcoords.empty() ? kNone : vertex, mesh.colors.empty() ? kNone : vertex};
  };
  connect(asset, mesh, primitive.mode, order->size(), corner, place);
  if (mesh.faces.empty() && mesh.lines.empty() && mesh.points.empty())
    return skip("has too few vertices");
  return mesh;
}

}  // namespace glassbox::gltf
