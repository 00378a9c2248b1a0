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
  // The fields that are read for every draw come first, so that few cache lines are read: this
  // saves time in scenes of many draws.
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  const Triangulation* triangulation = nullptr;
  const PreparedMesh* prepared = nullptr;
  std::uint32_t instance = 0;
  std::uint32_t first_number = 0;  // number of the draw's first triangle in the whole scene
  // Front faces run clockwise on the screen: the model matrix has a negative determinant, or the
  // view takes clockwise faces for front faces, but not both.
  bool mirrored = false;

  const LazyMipChain* texture = nullptr;  // null: the draw has no texture
  const Sampler* sampler = nullptr;
  // The material's emission. It is 0 if the emission has a texture but the mesh has no texture
  // coordinates: without the texture the whole surface would emit light.
  std::array<float, 3> emission{};
  // The texture of the emission; null if there is none, or if the material emits nothing.
  const LazyMipChain* emission_texture = nullptr;
  const Sampler* emission_sampler = nullptr;
  bool emits() const { return emission[0] != 0 || emission[1] != 0 || emission[2] != 0; }

  // A point near the mesh that is subtracted from positions before they are transformed in float
  // (see anchor_for). Without it, the vertices of a mesh that is modelled far from its origin would
  // shake.
  Vector<Object> anchor;
  Transform<Eye, Object> eye_from_object;  // for positions as modelled, in double
  Transform<Clip, Object, float> clip_from_anchored;
  Transform<Eye, Object, float> eye_from_anchored;
  NormalTransform<Eye, Object> eye_normal_from_object;
  // The distance of the box's centre from the eye along the gaze; blended draws are sorted by it.
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
  const InstanceGroups* groups = nullptr;  // the scene's groups of instances; null if it has none
  Lighting lighting;
  std::uint32_t triangle_count = 0;  // how many triangle numbers are in use
  // The following counts are the totals of all draws.
  std::uint64_t degenerate = 0;  // triangles without area
  std::uint64_t lines = 0, points = 0;
};

DrawList make_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view);

// Does the same as make_draw_list, but writes to an existing list and reuses its memory.
void fill_draw_list(const Scene& scene, const PreparedScene& prepared, const View& view,
                    DrawList& list);

// Makes one list for each eye: for one eye, or for the two eyes of a stereo pair. The views of a
// pair differ only in the x row of clip_from_eye.
void fill_draw_lists(const Scene& scene, const PreparedScene& prepared,
                     std::span<const View* const> eyes, std::vector<DrawList>& lists);

// Returns the draws for another eye, whose view has the same eye_from_world: only
// clip_from_anchored differs.
std::vector<Draw> draws_of_other_eye(const std::vector<Draw>& draws, const View& other_eye);

// Chooses the anchor of a mesh, axis by axis. If the mesh's box is further from the origin along an
// axis than eight times the mesh's size, the anchor is near the box: subtracting it from a float
// position of the mesh is exact, and the difference is small. Otherwise the anchor's coordinate is
// zero, and the subtraction changes nothing.
Vector<Object> anchor_for(const Box<Object>& bounds);

}  // namespace glassbox
