// The scene prepared for one view: what is drawn, in which order, with which matrices.
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

// One instance of a mesh. The pointers refer to the scene and to what was prepared from it; both
// must outlive the draw.
struct Draw {
  // The fields that are read for every draw come first: in scenes of many draws, each cache line
  // counts.
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  const Triangulation* triangulation = nullptr;
  const PreparedMesh* prepared = nullptr;
  std::uint32_t instance = 0;
  std::uint32_t first_number = 0;  // of the draw's first triangle, in the whole scene
  bool mirrored = false;           // the determinant is negative: front faces run clockwise

  const LazyMipChain* texture = nullptr;  // null: none
  const Sampler* sampler = nullptr;
  // The material's emission, or 0 where its texture has no coordinates: without the texture the
  // whole surface would emit.
  std::array<float, 3> emission{};
  // Null: no texture, or the material emits nothing.
  const LazyMipChain* emission_texture = nullptr;
  const Sampler* emission_sampler = nullptr;
  bool emits() const { return emission[0] != 0 || emission[1] != 0 || emission[2] != 0; }

  // Positions are taken relative to the anchor, a point near the mesh (see anchor_for). Otherwise
  // meshes modelled far from their origin would shake.
  Vector<Object> anchor;
  Transform<Eye, Object> eye_from_object;  // for positions as modelled, in double
  Transform<Clip, Object, float> clip_from_anchored;
  Transform<Eye, Object, float> eye_from_anchored;
  NormalTransform<Eye, Object> eye_normal_from_object;
  // The distance of the box's centre along the gaze: gives the order of blended draws.
  double distance_of_centre = 0;
};

// Whether a triangle of the draw is culled. `front`: the viewer sees its front, otherwise its back.
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
  const InstanceGroups* groups = nullptr;  // of the scene; null: it has no groups
  Lighting lighting;
  std::uint32_t triangle_count = 0;  // how many triangle numbers are in use
  // Totals of all draws:
  std::uint64_t degenerate = 0;  // triangles without area
  std::uint64_t lines = 0, points = 0;
};

DrawList make_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view);

// The same, written to an existing list whose memory is used again.
void fill_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view,
                    DrawList& list);

// Makes one list for each eye, one eye or the two of a pair. The views differ only in the x row of
// clip_from_eye.
void fill_draw_lists(const Scene& scene, const PreparedScene& prepared,
                     std::span<const View* const> eyes, std::vector<DrawList>& lists);

// Returns the same draws for another eye whose view shares eye_from_world: only clip_from_anchored
// differs.
std::vector<Draw> draws_of_other_eye(const std::vector<Draw>& draws, const View& other_eye);

// Chooses the anchor of a mesh. If the mesh's box is further from its origin than eight times its
// size, the anchor is a point near the box, chosen per axis: subtracting it from a float position
// of the mesh is exact, and the difference is small. Otherwise it is zero, and the subtraction
// changes nothing.
Vector<Object> anchor_for(const Box<Object>& bounds);

}  // namespace glassbox
