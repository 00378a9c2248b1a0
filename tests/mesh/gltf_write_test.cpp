// Scenes written to glTF and read back: all that is drawn comes back bit by bit.
#include <cstring>
#include <fstream>
#include <limits>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/gltf/write.h>
#include <glassbox/mesh/triangulate.h>

#include "tests/images/temporary_directory.h"
#include "tests/mesh/gltf_builder.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::test;

namespace {

Scene written_and_read(const Scene& scene) {
  const auto bytes = encode_glb(scene);
  INFO((bytes ? std::string() : bytes.error().message()));
  REQUIRE(bytes);
  auto read = load_gltf_memory(*bytes, "");
  INFO(error_of(read));
  REQUIRE(read);
  return std::move(*read);
}

template <class T>
void append_bits(Bytes& bits, const T& value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  bits.insert(bits.end(), bytes.begin(), bytes.end());
}

void append_corner(Bytes& bits, const Mesh& mesh, const Corner& c) {
  const Point<Object>& p = mesh.positions[c.position];
  for (const float f : {p.x, p.y, p.z}) append_bits(bits, f);
  append_bits(bits, c.normal == kNone ? 'f' : 'n');
  if (c.normal != kNone) {
    const Normal<Object>& n = mesh.normals[c.normal];
    for (const float f : {n.x, n.y, n.z}) append_bits(bits, f);
  }
  const TexCoord t = c.texcoord == kNone ? TexCoord{} : mesh.texcoords[c.texcoord];
  const Rgba color = c.color == kNone ? Rgba{} : mesh.colors[c.color];
  for (const float f : {t.u, t.v, color.r, color.g, color.b, color.a}) append_bits(bits, f);
}

// The bits of all that is drawn of one instance, in order.
Bytes drawn_bits(const Mesh& mesh) {
  Bytes bits;
  for (const Triangle& triangle : triangulate(mesh).triangles) {
    for (const std::uint32_t corner : triangle.corners)
      append_corner(bits, mesh, mesh.corners[corner]);
  }
  for (const auto& line : mesh.lines) {
    for (const Corner& c : line) append_corner(bits, mesh, c);
  }
  for (const Corner& c : mesh.points) append_corner(bits, mesh, c);
  return bits;
}

// Each drawn thing as one string of bytes: its position, its material and its corners. Instances
// are joined, since a mesh may come back in parts.
Bytes drawn_bits(const Scene& scene) {
  Bytes bits;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Bytes corners = drawn_bits(mesh);
    bits.insert(bits.end(), corners.begin(), corners.end());
  }
  return bits;
}

void check_same_placement(const Scene& a, const Scene& b) {
  REQUIRE(a.instances.size() == b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    CAPTURE(i);
    CHECK(a.nodes[a.instances[i].node].world_from_node ==
          b.nodes[b.instances[i].node].world_from_node);
    const Mesh& ma = a.meshes[a.instances[i].mesh];
    const Mesh& mb = b.meshes[b.instances[i].mesh];
    CHECK(ma.material == mb.material);
  }
}

void check_same_looks(const Scene& a, const Scene& b) {
  REQUIRE(b.materials.size() >= a.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    const Material& m = a.materials[i];
    const Material& n = b.materials[i];
    CAPTURE(i, m.name);
    CHECK(m.name == n.name);
    CHECK(m.base_color == n.base_color);
    CHECK(m.specular == n.specular);
    CHECK(m.shininess == n.shininess);
    CHECK(m.alpha_mode == n.alpha_mode);
    if (m.alpha_mode == AlphaMode::kMask) CHECK(m.alpha_cutoff == n.alpha_cutoff);
    CHECK(m.double_sided == n.double_sided);
    CHECK(m.unlit == n.unlit);
    REQUIRE(m.texture.has_value() == n.texture.has_value());
    if (m.texture) {
      CHECK(a.textures[*m.texture].sampler == b.textures[*n.texture].sampler);
      CHECK(a.images[a.textures[*m.texture].image] == b.images[b.textures[*n.texture].image]);
    }
  }
  REQUIRE(a.cameras.size() == b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    CHECK(a.cameras[i].name == b.cameras[i].name);
    CHECK(a.cameras[i].world_from_eye == b.cameras[i].world_from_eye);
    REQUIRE(a.cameras[i].lens.index() == b.cameras[i].lens.index());
    if (const auto* lens = std::get_if<PerspectiveLens>(&a.cameras[i].lens)) {
      const auto& other = std::get<PerspectiveLens>(b.cameras[i].lens);
      CHECK((lens->fovy_radians == other.fovy_radians && lens->near == other.near &&
             lens->far == other.far));
    } else if (const auto* parallel = std::get_if<OrthographicLens>(&a.cameras[i].lens)) {
      const auto& other = std::get<OrthographicLens>(b.cameras[i].lens);
      CHECK((parallel->half_height == other.half_height && parallel->near == other.near &&
             parallel->far == other.far));
    }
  }
  REQUIRE(a.lights.size() == b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    const Light& l = a.lights[i];
    const Light& m = b.lights[i];
    CHECK((l.kind == m.kind && l.color == m.color && l.intensity == m.intensity &&
           l.range == m.range));
    if (l.kind != LightKind::kDirectional) CHECK(l.position == m.position);
    if (l.kind != LightKind::kPoint) CHECK(l.direction == m.direction);
    if (l.kind == LightKind::kSpot) {
      CHECK((l.inner_cone_radians == m.inner_cone_radians &&
             l.outer_cone_radians == m.outer_cone_radians));
    }
  }
}

Mesh quad_mesh() {
  Mesh mesh;
  mesh.name = "quad";
  mesh.positions = {{0, 0, 0}, {1, 0, 0.1f}, {1, 1, -0.0f}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}};
  mesh.texcoords = {{0, 0}, {1e30f, -2.5f}};
  mesh.colors = {{0.1f, 0.2f, 0.3f, 0.4f}};
  mesh.corners = {{0, 0, 0, 0},
                  {1, 1, 1, kNone},
                  {2, 0, 0, 0},
                  {3, 1, 1, 0},
                  {0, kNone, kNone, kNone},
                  {2, kNone, kNone, kNone},
                  {1, kNone, kNone, kNone}};
  mesh.faces = {{0, 4}, {4, 3}};
  mesh.lines = {{Corner{0, kNone, kNone, 0}, Corner{1, kNone, kNone, 0}}};
  mesh.points = {Corner{3, kNone, kNone, kNone}};
  return mesh;
}

Scene mixed_scene() {
  Scene scene;
  scene.name = "mixed";
  scene.meshes = {quad_mesh(), quad_mesh()};
  scene.meshes[1].material = 1;
  scene.images = {Image<Rgba8>(2, 1, {1, 2, 3, 4}), Image<Rgba8>(1, 2, {200, 100, 50, 255})};
  scene.textures = {
      {1,
       {Wrap::kMirroredRepeat, Wrap::kClampToEdge, Filter::kNearest, Filter::kLinear,
        MipFilter::kNone}},
      {0, {Wrap::kRepeat, Wrap::kRepeat, Filter::kLinear, Filter::kNearest, MipFilter::kLinear}}};
  Material first;
  first.name = "first";
  first.base_color = {0.1f, 0.7f, 1, 0.3f};
  first.texture = 0;
  first.specular = {0.123f, 0.5f, 0.9f};
  first.shininess = 77;
  first.alpha_mode = AlphaMode::kMask;
  first.alpha_cutoff = 0.3f;
  Material second;
  second.texture = 1;
  second.alpha_mode = AlphaMode::kBlend;
  second.double_sided = true;
  second.unlit = true;
  scene.materials = {first, second};
  Node root, child;
  root.name = "root";
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) root.parent_from_node.at(i, j) = 0.1 * (i + 1) - 0.7 / (j + 1);
  }
  root.world_from_node = root.parent_from_node;
  child.parent = 0;
  child.parent_from_node.at(0, 3) = 1.0 / 3;
  child.world_from_node =
      Transform<World, World>(root.world_from_node.columns) * child.parent_from_node;
  scene.nodes = {root, child};
  scene.instances = {{0, 0}, {1, 0}, {0, 1}};
  Camera camera;
  camera.name = "eye";
  camera.lens = PerspectiveLens{1.0 / 3, 0.1, 12.7};
  camera.world_from_eye.at(0, 3) = 0.1;
  scene.cameras = {camera, {"flat", OrthographicLens{0.7, 0.1, 5.5}, {}}};
  Light spot;
  spot.kind = LightKind::kSpot;
  spot.color = {0.1f, 0.2f, 0.9f};
  spot.intensity = 1.0 / 7;
  spot.range = 3.3;
  spot.inner_cone_radians = 0.1;
  spot.outer_cone_radians = 0.7;
  spot.position = {0.1, 0.2, 0.3};
  spot.direction = {-0.6, 0, 0.8};
  Light point;
  point.kind = LightKind::kPoint;
  scene.lights = {spot, point};
  return scene;
}

}  // namespace

TEST_CASE("a scene of every kind of thing comes back bit by bit from a GLB") {
  const Scene scene = mixed_scene();
  const Scene read = written_and_read(scene);
  CHECK(drawn_bits(scene) == drawn_bits(read));
  CHECK(read.name == "mixed");
  check_same_looks(scene, read);
  // Each mesh comes back in four parts: faces with normals, faces without, lines, points.
  REQUIRE(read.instances.size() == 12);
  CHECK(read.nodes[read.instances[4].node].world_from_node == scene.nodes[0].world_from_node);
  CHECK(read.nodes[read.instances[8].node].world_from_node == scene.nodes[1].world_from_node);
  CHECK(read.meshes[read.instances[4].mesh].material == 1);
}

TEST_CASE("instances keep their order where it does not follow the hierarchy") {
  Scene scene = mixed_scene();
  scene.instances = {{0, 1}, {1, 0}};
  const Scene read = written_and_read(scene);
  CHECK(drawn_bits(scene) == drawn_bits(read));
  CHECK(read.nodes[read.instances[0].node].world_from_node == scene.nodes[1].world_from_node);
}

TEST_CASE("every built-in scene comes back bit by bit from a GLB") {
  for (const char* name : {"teapot", "cube", "sphere", "forest", "room", "checker", "thicket",
                           "f-glyph", "depth-ladder"}) {
    INFO(name);
    const auto scene = load_scene(name);
    REQUIRE(scene);
    const Scene read = written_and_read(*scene);
    CHECK(drawn_bits(*scene) == drawn_bits(read));
    check_same_placement(*scene, read);
    check_same_looks(*scene, read);
  }
}

TEST_CASE("what glTF cannot hold is an error, and no file is written") {
  const TemporaryDirectory temporary;
  const std::string path = temporary.file("out.glb");
  Scene scene = mixed_scene();
  scene.cameras[0].lens = FrustumLens{};
  auto done = write_glb(scene, path);
  REQUIRE_FALSE(done);
  CHECK(mentions(done.error().message(),
                 "out.glb: camera 0 'eye': is given by the sides of a window"));
  scene = mixed_scene();
  scene.meshes[0].corners[4].normal = 0;
  done = write_glb(scene, path);
  REQUIRE_FALSE(done);
  CHECK(mentions(done.error().message(),
                 "mesh 'quad', face 1: has normals on some of its corners only"));
  scene = mixed_scene();
  scene.meshes[0].positions[0].x = std::numeric_limits<float>::infinity();
  CHECK_FALSE(write_glb(scene, path));
  scene = mixed_scene();
  scene.lights[0].direction = {0, 0, 0};
  done = write_glb(scene, path);
  REQUIRE_FALSE(done);
  CHECK(mentions(done.error().message(), "light 0: has numbers that are not finite"));
  scene = mixed_scene();
  scene.meshes.resize(1);
  scene.meshes[0].faces.clear();
  scene.meshes[0].lines.clear();
  scene.meshes[0].points.clear();
  scene.instances = {{0, 0}};
  CHECK(mentions(write_glb(scene, path).error().message(), "nothing to draw"));
  CHECK(temporary.names().empty());
  CHECK(write_glb(mixed_scene(), path));
  CHECK(load_gltf(path));
}
