#include <glassbox/render/draw_list.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glassbox/base/box.h>
#include <glassbox/mesh/bounds.h>

namespace glassbox {

namespace {

float anchor_coordinate(double low, double high, double size) {
  constexpr double kFar = 8;  // sizes away: closer than that, the cancellation costs at most 4 bits
  const double nearest = low > 0 ? low : high < 0 ? -high : 0;
  if (!(nearest > kFar * size)) return 0.0f;
  // A multiple of a power of two no smaller than the mesh: every difference is then exact and small, and the anchor
  // itself has few bits, so that the matrix it is multiplied into stays exact where it was.
  int exponent = 0;
  std::frexp(std::max(std::abs(low), std::abs(high)), &exponent);
  const double spacing_of_floats = std::ldexp(1.0, exponent - 24);
  std::frexp(size, &exponent);
  const double spacing = std::max(spacing_of_floats, size > 0 ? std::ldexp(1.0, exponent) : 0.0);
  return float(std::floor((low * 0.5 + high * 0.5) / spacing + 0.5) * spacing);
}

double size_of(const Box<Object>& box) {
  return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

Transform<Object, Object> translation(const Vector<Object>& by) {
  Transform<Object, Object> moved;
  moved.at(0, 3) = double(by.x);
  moved.at(1, 3) = double(by.y);
  moved.at(2, 3) = double(by.z);
  return moved;
}

double determinant3(const Transform<World, Object>& m) {
  return m.at(0, 0) * (m.at(1, 1) * m.at(2, 2) - m.at(1, 2) * m.at(2, 1)) -
         m.at(0, 1) * (m.at(1, 0) * m.at(2, 2) - m.at(1, 2) * m.at(2, 0)) +
         m.at(0, 2) * (m.at(1, 0) * m.at(2, 1) - m.at(1, 1) * m.at(2, 0));
}

Draw make_draw(const Scene& scene, const View& view, std::uint32_t instance) {
  const Instance& placed = scene.instances[instance];
  const Transform<World, Object>& world_from_object = scene.nodes[placed.node].world_from_node;
  const Transform<Eye, Object> eye_from_object = view.eye_from_world * world_from_object;

  Draw draw;
  draw.mesh = &scene.meshes[placed.mesh];
  draw.material = &scene.materials[draw.mesh->material];
  draw.instance = instance;
  draw.anchor = anchor_for(*draw.mesh);
  const Transform<Eye, Object> eye_from_anchored = eye_from_object * translation(draw.anchor);
  draw.eye_from_anchored = round_to_float(eye_from_anchored);
  draw.clip_from_anchored = round_to_float(view.clip_from_eye * eye_from_anchored);
  draw.eye_normal_from_object = normal_transform(eye_from_object);
  draw.mirrored = determinant3(world_from_object) < 0;
  return draw;
}

// How far along the gaze the centre of the draw's box lies.
double distance_of_centre(const Draw& draw, const Scene& scene, const View& view) {
  const Point<Object, double> centre = bounds(*draw.mesh).center();
  const Transform<World, Object>& world_from_object =
      scene.nodes[scene.instances[draw.instance].node].world_from_node;
  return -(view.eye_from_world * (world_from_object * centre)).z;
}

void sort_blended(std::vector<Draw>& draws, const Scene& scene, const View& view) {
  const auto first_blended = std::stable_partition(
      draws.begin(), draws.end(),
      [](const Draw& draw) { return draw.material->alpha_mode != AlphaMode::kBlend; });
  std::stable_sort(first_blended, draws.end(), [&](const Draw& a, const Draw& b) {
    return distance_of_centre(a, scene, view) > distance_of_centre(b, scene, view);
  });
}

}  // namespace

Vector<Object> anchor_for(const Mesh& mesh) {
  const Box<Object> box = bounds(mesh);
  if (box.empty()) return {};
  const double size = size_of(box);
  return {anchor_coordinate(box.low.x, box.high.x, size),
          anchor_coordinate(box.low.y, box.high.y, size),
          anchor_coordinate(box.low.z, box.high.z, size)};
}

DrawList make_draw_list(const Scene& scene, const View& view, const RenderSettings& settings) {
  DrawList list;
  list.lighting = light_scene(scene, view);
  list.triangulations.reserve(scene.meshes.size());
  for (const Mesh& mesh : scene.meshes) list.triangulations.push_back(triangulate(mesh));
  list.textures.reserve(scene.textures.size());
  for (const Texture& texture : scene.textures) {
    list.textures.push_back(make_mip_chain(scene.images[texture.image], settings.transfer,
                                           texture.sampler.mip == MipFilter::kNone));
  }

  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    Draw draw = make_draw(scene, view, i);
    draw.triangulation = &list.triangulations[scene.instances[i].mesh];
    draw.first_number = list.triangle_count;
    list.triangle_count += draw.triangulation->numbered;
    if (draw.material->texture && !draw.mesh->texcoords.empty()) {
      draw.texture = &list.textures[*draw.material->texture];
      draw.sampler = &scene.textures[*draw.material->texture].sampler;
    }
    list.draws.push_back(draw);
  }
  sort_blended(list.draws, scene, view);
  return list;
}

}  // namespace glassbox
