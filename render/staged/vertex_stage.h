// The transform from object space to clip space, once for each entry of the mesh's tables, and the
// tables in eye space that lighting needs.
#pragma once

#include <span>
#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/staged/watch.h>

namespace glassbox {

// The mesh's positions in the clip space of one eye, by index of the position.
struct ClipTable {
  std::vector<Point<Clip>> positions;
  std::vector<Outcode> outcodes;  // for the planes render_planes(view)
};

// Transforms entry `index` of the mesh's positions to clip space; project_x() computes only x.
Point<Clip> project_vertex(const Draw& draw, std::uint32_t index);
float project_x(const Draw& draw, std::uint32_t index);

template <class Watch = NullWatch>
ClipTable project_vertices(const Draw& draw, const View& view, const Watch& watch = {}) {
  const auto planes = render_planes(view);
  const std::vector<Point<Object>>& positions = draw.mesh->positions;
  ClipTable table;
  table.positions.reserve(positions.size());
  table.outcodes.reserve(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    Point<Clip> clip = project_vertex(draw, i);
    watch.notify(&Observer::projected, draw, i, clip);
    table.positions.push_back(clip);
    table.outcodes.push_back(outcode(clip, planes));
  }
  return table;
}

// Does the same for a stereo pair's other eye, starting from the first eye's table. The eyes'
// frustums are skewed, which changes x alone (S0-03): y, z and w are kept, and equal the result of
// projecting again.
template <class Watch = NullWatch>
ClipTable project_other_eye(const Draw& other_eye, const View& other_view, ClipTable table,
                            const Watch& watch = {}) {
  const auto planes = render_planes(other_view);
  for (std::uint32_t i = 0; i < table.positions.size(); ++i) {
    Point<Clip>& clip = table.positions[i];
    clip.x = project_x(other_eye, i);
    watch.notify(&Observer::projected, other_eye, i, clip);
    table.outcodes[i] = outcode(clip, planes);
  }
  return table;
}

// The tables in eye space that lighting needs, the same for both eyes of a pair. They are empty
// where nothing is lit.
struct EyeSpaceTables {
  std::vector<Point<Eye>> positions;  // one for each position of the mesh
  std::vector<Normal<Eye>> normals;   // one for each normal of the mesh, unit length
  // One for each face of the mesh, unit length; empty if none is needed (needs_face_normals).
  std::vector<Normal<Eye>> face_normals;
};

// References to the same tables, stored anywhere. Entries that are not needed may be missing.
struct EyeSpace {
  bool lit = false;
  std::span<const Point<Eye>> positions;
  std::span<const Normal<Eye>> normals, face_normals;

  EyeSpace() = default;
  EyeSpace(const EyeSpaceTables& tables)
      : lit(!tables.positions.empty()),
        positions(tables.positions),
        normals(tables.normals),
        face_normals(tables.face_normals) {}
};

// The results of the vertex stage for a draw.
struct DrawTables {
  ClipTable clip;            // for one eye
  EyeSpaceTables eye_space;  // the same for all eyes
};

// Whether the draw's colour depends on normals: lit shading of a lit material, or a picture of the
// normals.
bool needs_normals(const Draw& draw, const RenderSettings& settings);

// Whether the picture shows light: what the surface reflects, and what it emits.
bool shows_light(const Draw& draw, const RenderSettings& settings);

// Whether light is computed with the normals of faces: flat shading, or corners that have no
// normal.
bool needs_face_normals(const Draw& draw, const RenderSettings& settings);

// Appends the unit normals in eye space of all faces of the mesh.
void append_face_normals(const Draw& draw, std::vector<Normal<Eye>>& normals);

EyeSpaceTables make_eye_space_tables(const Draw& draw, const RenderSettings& settings);

}  // namespace glassbox
