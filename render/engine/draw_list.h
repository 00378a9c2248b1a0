// The scene made ready for one view: what is drawn, in which order, with which matrices.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/base/box.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/normal_transform.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/prepared_scene.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// One instance of a mesh. Pointers lead into the scene and what was prepared from it, which must outlive it.
struct Draw {
  // What is asked of every draw comes first: in scenes of many, each line of the cache counts.
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  const Triangulation* triangulation = nullptr;
  const PreparedMesh* prepared = nullptr;
  std::uint32_t instance = 0;
  std::uint32_t first_number = 0;  // of its first triangle, in the whole scene
  bool mirrored = false;           // the determinant is negative: front faces run clockwise

  const LazyMipChain* texture = nullptr;  // null: none
  const Sampler* sampler = nullptr;
  // The material's, or 0 where its texture lacks coordinates: without it all of the surface would shine.
  std::array<float, 3> emission{};
  const LazyMipChain* emission_texture = nullptr;  // null: none, or it emits nothing
  const Sampler* emission_sampler = nullptr;
  bool emits() const { return emission[0] != 0 || emission[1] != 0 || emission[2] != 0; }

  // Positions are taken relative to the anchor, a point near the mesh (see anchor_for), so that meshes modelled far
  // from their origin do not shake.
  Vector<Object> anchor;
  Transform<Eye, Object> eye_from_object;  // of positions as modelled, in double
  Transform<Clip, Object, float> clip_from_anchored;
  Transform<Eye, Object, float> eye_from_anchored;
  NormalTransform<Eye, Object> eye_normal_from_object;
  double distance_of_centre = 0;  // of the box, along the gaze: the order of blended draws
};

// Whether a triangle of the draw that shows its front, or its back, is thrown away.
inline bool is_culled(const Draw& draw, Cull cull, bool front) {
  switch (cull) {
    case Cull::kMaterial:
      return !front && !draw.material->double_sided;
    case Cull::kBack:
      return !front;
    case Cull::kFront:
      return front;
    case Cull::kNone:
      break;
  }
  return false;
}

struct DrawList {
  std::vector<Draw> draws;  // opaque and masked in file order, then blended far to near
  const InstanceGroups* groups = nullptr;  // of the scene; null: it has none
  Lighting lighting;
  std::uint32_t triangle_count = 0;  // numbers given out
  // Of all draws:
  std::uint64_t degenerate = 0;  // of these triangles, those without area
  std::uint64_t lines = 0, points = 0;
};

DrawList make_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view);

// The same into a list whose memory is used again.
void fill_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view,
                    DrawList& list);

// One for each of the eyes, one or the two of a pair, whose views differ in the row of x of clip_from_eye alone.
void fill_draw_lists(const Scene& scene, const PreparedScene& prepared,
                     std::span<const View* const> eyes, std::vector<DrawList>& lists);

// The same draws for another eye, whose view shares eye_from_world: only clip_from_anchored differs.
std::vector<Draw> draws_of_other_eye(const std::vector<Draw>& draws, const View& other_eye);

// A mesh whose box lies further from its origin than eight times its size is carried relative to a point near the box,
// per axis: subtracting it from a float position there is exact, and what is left is small. Otherwise zero, and the
// subtraction changes nothing.
Vector<Object> anchor_for(const Box<Object>& bounds);

}  // namespace glassbox
