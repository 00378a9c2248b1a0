#include <glassbox/render/engine/draw_list.h>

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include <glassbox/pipeline/affine.h>

namespace glassbox {

namespace {

float anchor_coordinate(double low, double high, double size) {
  // A mesh gets an anchor only if it is further from the origin than kFar times its size. If it is
  // nearer, the cancellation between position and translation costs at most 4 bits of accuracy.
  constexpr double kFar = 8;
  const double nearest = low > 0 ? low : high < 0 ? -high : 0;
  if (!(nearest > kFar * size)) return 0.0f;
  // The anchor is a multiple of `spacing`, a power of two that is no smaller than the mesh. So the
  // difference of a position and the anchor is exact and small. The anchor itself has few bits, so
  // the product of the matrix and the anchor is as exact as the matrix.
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

Transform<Eye, Object> eye_from_anchored_of(const Draw& draw) {
  return draw.eye_from_object * translate<Object, Object>(in_double(draw.anchor));
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

// Makes a draw with the fields that all instances of a mesh have in common.
Draw make_draw_of_mesh(const Scene& scene, const PreparedScene& prepared, std::uint32_t mesh) {
  Draw draw;
  draw.mesh = &scene.meshes[mesh];
  draw.material = &scene.materials[draw.mesh->material];
  draw.prepared = &prepared.meshes[mesh];
  draw.triangulation = &draw.prepared->triangulation;
  draw.anchor = anchor_for(draw.prepared->bounds);
  const bool has_texcoords = !draw.mesh->texcoords.empty();
  if (emits_light(*draw.material) && (has_texcoords || !draw.material->emission_texture)) {
    draw.emission = draw.material->emission;
  }
  if (has_texcoords) choose_textures(scene, prepared, draw);
  return draw;
}

void place_draw(const Scene& scene, const View& view, std::uint32_t instance, Draw& draw) {
  const Transform<World, Object>& world_from_object =
      scene.nodes[scene.instances[instance].node].world_from_node;
  draw.instance = instance;
  draw.eye_from_object = view.eye_from_world * world_from_object;
  const Transform<Eye, Object> eye_from_anchored = eye_from_anchored_of(draw);
  draw.eye_from_anchored = round_to_float(eye_from_anchored);
  draw.clip_from_anchored = round_to_float(view.clip_from_eye * eye_from_anchored);
  draw.eye_normal_from_object = normal_transform(draw.eye_from_object);
  const bool mirrors = glm::determinant(glm::dmat3(world_from_object.columns)) < 0;
  draw.mirrored = mirrors != view.front_clockwise;
  const Box<Object>& box = draw.prepared->bounds;
  if (!box.empty()) draw.distance_of_centre = -(draw.eye_from_object * box.center()).z;
}

// Changes draws of one eye of a stereo pair to those of `eye`, whose view has the same
// eye_from_world.
void set_clip_from_anchored(const View& eye, std::span<Draw> draws) {
  for (Draw& draw : draws) {
    draw.clip_from_anchored = round_to_float(eye.clip_from_eye * eye_from_anchored_of(draw));
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
  fill_draw_list(scene, prepared, view, list);
  return list;
}

void fill_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view,
                    DrawList& list) {
  list.groups = prepared.groups.get();
  list.lighting = light_scene(scene, view);
  std::vector<Draw> of_meshes;
  of_meshes.reserve(scene.meshes.size());
  for (std::uint32_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    of_meshes.push_back(make_draw_of_mesh(scene, prepared, mesh));
  }
  list.triangle_count = 0;
  list.degenerate = list.lines = list.points = 0;
  list.draws.resize(scene.instances.size());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    Draw& draw = list.draws[i];
    draw = of_meshes[scene.instances[i].mesh];
    place_draw(scene, view, i, draw);
    draw.first_number = list.triangle_count;
    list.triangle_count += draw.triangulation->numbered;
    list.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
    list.lines += draw.mesh->lines.size();
    list.points += draw.mesh->points.size();
  }
  sort_blended(list.draws);
}

void fill_draw_lists(const Scene& scene, const PreparedScene& prepared,
                     std::span<const View* const> eyes, std::vector<DrawList>& lists) {
  lists.resize(eyes.size());
  fill_draw_list(scene, prepared, *eyes.front(), lists.front());
  for (std::size_t eye = 1; eye < eyes.size(); ++eye) {
    lists[eye] = lists.front();
    set_clip_from_anchored(*eyes[eye], lists[eye].draws);
  }
}

std::vector<Draw> draws_of_other_eye(const std::vector<Draw>& draws, const View& other_eye) {
  std::vector<Draw> others = draws;
  set_clip_from_anchored(other_eye, others);
  return others;
}

}  // namespace glassbox
