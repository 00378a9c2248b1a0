#include <glassbox/mesh/builtin/thicket.h>

#include <cstdlib>
#include <string>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {
namespace {

constexpr int kLeafSide = 64;  // px
constexpr int kLeaves = 40, kTwigs = 240;

// Makes the image of a leaf, which is green even where it is transparent, so that filtering cannot
// mix another colour into the outline. d is the distance from the midrib in half pixels, and
// t/whole goes from 0 at the leaf's tip to 1; the leaf reaches 0.9 * 4 t/whole (1 - t/whole) of
// half the image's width.
Image<Rgba8> make_leaf() {
  Image<Rgba8> image(kLeafSide, kLeafSide);
  for (int y = 0; y < kLeafSide; ++y) {
    for (int x = 0; x < kLeafSide; ++x) {
      const int d = std::abs(2 * x + 1 - kLeafSide);
      const int t = 2 * y + 1, whole = 2 * kLeafSide;
      const bool inside = 10 * d * whole * whole < 9 * 4 * kLeafSide * t * (whole - t);
      const bool vein = d < 4 || (d + y) % 12 < 2;
      const auto green = std::uint8_t(vein ? 170 : 128 + scramble(std::uint64_t(64 * y + x)) % 16);
      image.at(x, y) = {std::uint8_t(green / 2), green, 40, std::uint8_t(inside ? 255 : 0)};
    }
  }
  return image;
}

// Returns a number in -1 .. 1.
double random_side(std::uint64_t seed, std::uint64_t index) {
  return 2 * random_unit(seed, index) - 1;
}

// Makes leaves around a stem of length 1, each with a different slant.
Mesh make_twig(std::uint32_t material) {
  Mesh mesh;
  mesh.name = "twig";
  mesh.material = material;
  for (std::uint64_t i = 0; i < kLeaves; ++i) {
    const double x = 0.3 * random_side(1, i), z = 0.3 * random_side(2, i);
    const double y = double(i) / kLeaves;
    const double across = 0.06 + 0.04 * random_unit(3, i);
    const double slant = 0.06 * random_side(4, i), turn = random_side(5, i);
    add_rectangle(mesh, {x, y, z}, {across, 0.5 * slant, across * turn},
                  {slant, 0.2, 0.1 * random_side(6, i)});
  }
  return mesh;
}

}  // namespace

Scene make_thicket() {
  Scene scene;
  scene.name = "thicket";
  const std::uint32_t leaves = add_material(scene, "leaves", {1, 1, 1, 1});
  Material& leaf = scene.materials[leaves];
  leaf.texture = add_texture(scene, make_leaf());
  leaf.alpha_mode = AlphaMode::kMask;
  leaf.double_sided = true;
  Sampler& sampler = scene.textures[*leaf.texture].sampler;
  sampler.wrap_u = sampler.wrap_v = Wrap::kClampToEdge;
  const std::uint32_t moss = add_material(scene, "ground", {0.2f, 0.16f, 0.09f, 1});

  Mesh ground;
  ground.name = "ground";
  ground.material = moss;
  add_rectangle(ground, {-64, 0, 32}, {128, 0, 0}, {0, 0, -96});
  add_object(scene, std::move(ground));

  const auto twig = std::uint32_t(scene.meshes.size());
  scene.meshes.push_back(make_twig(leaves));
  for (int i = 0; i < kTwigs; ++i) {
    const auto number = std::uint64_t(i);
    const double distance = 2.5 + 13.5 * random_unit(7, number);
    const double side = 0.75 * distance * random_side(8, number);
    const double height = 1.2 + random_unit(9, number);
    const double girth = 1.5 + random_unit(10, number);
    add_instance(scene, twig, "twig " + std::to_string(i),
                 placement_transform({side, 0.4 * height * random_unit(11, number), -distance},
                                     360 * random_unit(12, number), {girth, height, girth}));
  }

  add_perspective(scene, "path", 45, 0.25, look_at_pose({0, 1.4, 0}, {0, 1.3, -8}));
  add_directional(scene, "sun", {-0.6, -1, -0.7}, 2.8, {1, 0.95f, 0.85f});
  add_directional(scene, "sky", {0.4, -0.8, 0.3}, 0.6, {0.7f, 0.85f, 1});
  return scene;
}

}  // namespace glassbox
