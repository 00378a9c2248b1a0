// An object of any shape and surface, of which pictures can be taken from all around.
#pragma once

#include <cstdint>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/placement.h>

#include "tests/render/scenes.h"

namespace glassbox::test {

// Roughly one closed surface of radius 1 to 1.5 around the origin, whose corners have their own
// colours. It often has a texture, parts of which are masked or translucent, and often a larger
// surface around it that is translucent or has holes.
inline Scene generate_object(std::uint64_t seed) {
  Random random(0x0b1ec7 + seed);
  const auto one_in = [&](int n) { return random.integer(1, n) == 1; };
  const auto any_color = [&] {
    const float r = float(random.unit()), g = float(random.unit()), b = float(random.unit());
    return Rgba{r, g, b, float(random.between(0.2, 1))};
  };
  Scene scene;
  scene.name = "any object";
  const int width = int(random.integer(1, 9)), height = int(random.integer(1, 9));
  Image<Rgba8> picture(width, height);
  for (Rgba8& pixel : picture.pixels) {
    const std::uint64_t bits = random.bits();
    pixel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
             std::uint8_t(one_in(3) ? bits >> 24 : 255)};
  }
  const std::uint32_t texture = add_texture(scene, std::move(picture));
  const bool has_shell = one_in(2);
  for (int shell = 0; shell <= int(has_shell); ++shell) {
    const int n = int(random.integer(2, 6));
    Mesh mesh = star_shaped_surface(n, random.between(0, 0.5), random);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      mesh.colors.push_back(any_color());
      const float u = float(random.between(-1, 2)), v = float(random.between(-1, 2));
      mesh.texcoords.push_back({u, v});
    }
    const bool has_texture = !one_in(3);
    for (Corner& corner : mesh.corners) {
      corner.color = corner.position;
      if (has_texture) corner.texcoord = corner.position;
    }
    mesh.material = add_material(scene, "any", any_color());
    Material& material = scene.materials[mesh.material];
    if (has_texture) material.texture = texture;
    material.unlit = one_in(2);
    material.double_sided = one_in(3);
    const bool may_vanish = shell == 1 || one_in(4);
    if (may_vanish) material.alpha_mode = one_in(2) ? AlphaMode::kBlend : AlphaMode::kMask;
    material.alpha_cutoff = 0.5f;
    const double size = shell == 0 ? 1 : 1.2;
    add_object(scene, std::move(mesh),
               placement_transform({0, 0, 0}, random.between(0, 360), {size, size, size}));
  }
  return scene;
}

}  // namespace glassbox::test
