#include "views/klt/globe.h"

#include <algorithm>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/sphere.h>

namespace glassbox::views {

namespace {

constexpr int kGlobeLevel = 48;

std::uint32_t add_textured_material(Scene& scene, const std::string& name,
                                    const Image<Rgba8>& image) {
  const std::uint32_t material = add_material(scene, name, {1, 1, 1, 1});
  const std::uint32_t texture = add_texture(scene, image);
  scene.materials[material].texture = texture;
  scene.textures[texture].sampler.wrap_v = Wrap::kClampToEdge;
  return material;
}

}  // namespace

Image<Rgba8> cloud_alpha(const Bands& component) {
  const std::vector<double>& samples = component.bands.front().samples;
  std::vector<double> sorted = samples;
  std::ranges::sort(sorted);
  const auto at = [&](double share) {
    return sorted[std::size_t(share * double(sorted.size() - 1))];
  };
  const double middle = at(0.5);
  const bool is_up = at(0.99) - middle >= middle - at(0.01);
  const double full = is_up ? at(0.99) : at(0.01);
  Image<Rgba8> image(component.width, component.height, {255, 255, 255, 0});
  if (full == middle) return image;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = std::clamp((samples[i] - middle) / (full - middle), 0.0, 1.0);
    image.pixels[i].a = std::uint8_t(255 * share + 0.5);
  }
  return image;
}

Scene make_globe(const Image<Rgba8>& ground, const Image<Rgba8>& clouds) {
  Scene scene;
  scene.name = "globe";
  Mesh ball = make_sphere(kGlobeLevel).meshes.front();
  Mesh shell = ball;
  ball.name = "ground";
  ball.material = add_textured_material(scene, "ground", ground);
  shell.name = "clouds";
  shell.material = add_textured_material(scene, "clouds", clouds);
  scene.materials[shell.material].alpha_mode = AlphaMode::kBlend;
  add_object(scene, std::move(ball));
  constexpr double kShell = 1.015;
  add_object(scene, std::move(shell), placement_transform({0, 0, 0}, 0, {kShell, kShell, kShell}));
  add_directional(scene, "sun", {-1, -0.5, -1}, 3);
  add_perspective(scene, "from space", 35, 0.1, look_at_pose({1.2, 1.2, 3.4}, {0, 0, 0}));
  return scene;
}

}  // namespace glassbox::views
