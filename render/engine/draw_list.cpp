#include <glassbox/render/engine/draw_list.h>

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include <glassbox/pipeline/affine.h>

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

Vector<Object, double> in_double(const Vector<Object>& v) {
  return {v.x, v.y, v.z};
}

Transform<Eye, Object> eye_from_anchored_of(const Scene& scene, const View& view,
                                            const Draw& draw) {
  const Transform<World, Object>& world_from_object =
      scene.nodes[scene.instances[draw.instance].node].world_from_node;
  return view.eye_from_world * world_from_object *
         translate<Object, Object>(in_double(draw.anchor));
}

Draw make_draw(const Scene& scene, const View& view, std::uint32_t instance,
               const Box<Object>& box) {
  const Instance& placed = scene.instances[instance];
  const Transform<World, Object>& world_from_object = scene.nodes[placed.node].world_from_node;
  const Transform<Eye, Object> eye_from_object = view.eye_from_world * world_from_object;

  Draw draw;
  draw.mesh = &scene.meshes[placed.mesh];
  draw.material = &scene.materials[draw.mesh->material];
  draw.instance = instance;
  draw.anchor = anchor_for(box);
  draw.eye_from_object = eye_from_object;
  const Transform<Eye, Object> eye_from_anchored = eye_from_anchored_of(scene, view, draw);
  draw.eye_from_anchored = round_to_float(eye_from_anchored);
  draw.clip_from_anchored = round_to_float(view.clip_from_eye * eye_from_anchored);
  draw.eye_normal_from_object = normal_transform(eye_from_object);
  draw.mirrored = glm::determinant(glm::dmat3(world_from_object.columns)) < 0;
  if (!box.empty()) draw.distance_of_centre = -(eye_from_object * box.center()).z;
  return draw;
}

void choose_textures(const Scene& scene, const PreparedScene& prepared, Draw& draw) {
  if (const auto& texture = draw.material->texture) {
    draw.texture = prepared.textures[*texture].get();
    draw.sampler = &scene.textures[*texture].sampler;
  }
  if (const auto& texture = draw.material->emission_texture; texture && draw.emits()) {
    draw.emission_texture = prepared.textures[*texture].get();
    draw.emission_sampler = &scene.textures[*texture].sampler;
  }
}

void sort_blended(std::vector<Draw>& draws) {
  const auto first_blended = std::stable_partition(
      draws.begin(), draws.end(),
      [](const Draw& draw) { return draw.material->alpha_mode != AlphaMode::kBlend; });
  std::stable_sort(first_blended, draws.end(), [](const Draw& a, const Draw& b) {
    return a.distance_of_centre > b.distance_of_centre;
  });
}

}  // namespace

Vector<Object> anchor_for(const Box<Object>& box) {
  if (box.empty()) return {};
  const double size = size_of(box);
  return {anchor_coordinate(box.low.x, box.high.x, size),
          anchor_coordinate(box.low.y, box.high.y, size),
          anchor_coordinate(box.low.z, box.high.z, size)};
}

DrawList make_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view) {
  DrawList list;
  list.lighting = light_scene(scene, view);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const PreparedMesh& mesh = prepared.meshes[scene.instances[i].mesh];
    Draw draw = make_draw(scene, view, i, mesh.bounds);
    draw.triangulation = &mesh.triangulation;
    draw.prepared = &mesh;
    draw.first_number = list.triangle_count;
    list.triangle_count += draw.triangulation->numbered;
    const bool has_texcoords = !draw.mesh->texcoords.empty();
    if (emits_light(*draw.material) && (has_texcoords || !draw.material->emission_texture)) {
      draw.emission = draw.material->emission;
    }
    if (has_texcoords) choose_textures(scene, prepared, draw);
    list.draws.push_back(draw);
  }
  sort_blended(list.draws);
  return list;
}

std::vector<DrawList> make_draw_lists(const Scene& scene, const PreparedScene& prepared,
                                      std::span<const View* const> eyes) {
  std::vector<DrawList> lists{make_draw_list(scene, prepared, *eyes.front())};
  for (const View* eye : eyes.subspan(1)) {
    const DrawList& first = lists.front();
    lists.push_back(
        {draws_of_other_eye(first.draws, scene, *eye), first.lighting, first.triangle_count});
  }
  return lists;
}

std::vector<Draw> draws_of_other_eye(const std::vector<Draw>& draws, const Scene& scene,
                                     const View& other_eye) {
  std::vector<Draw> others = draws;
  for (Draw& draw : others) {
    draw.clip_from_anchored =
        round_to_float(other_eye.clip_from_eye * eye_from_anchored_of(scene, other_eye, draw));
  }
  return others;
}

}  // namespace glassbox
