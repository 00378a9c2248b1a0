// Object space to clip space, once for each entry of the mesh's tables; and what lighting needs in eye space.
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

// What one eye sees of the mesh's positions, by position.
struct ClipTable {
  std::vector<Point<Clip>> positions;
  std::vector<Outcode> outcodes;  // with respect to render_planes of the eye's view
};

// Entry `index` of the mesh's positions.
Point<Clip> project_vertex(const Draw& draw, std::uint32_t index);
float project_x(const Draw& draw, std::uint32_t index);

template <class Watch = Nobody>
ClipTable project_vertices(const Draw& draw, const View& view, const Watch& watch = {}) {
  const auto planes = render_planes(view);
  const std::vector<Point<Object>>& positions = draw.mesh->positions;
  ClipTable table;
  table.positions.reserve(positions.size());
  table.outcodes.reserve(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    Point<Clip> clip = project_vertex(draw, i);
    watch.tell(&Observer::projected, draw, i, clip);
    table.positions.push_back(clip);
    table.outcodes.push_back(outcode(clip, planes));
  }
  return table;
}

// The same for a stereo pair's other eye, from what the first one sees. The skew moves x alone (S0-03): y, z and w are
// taken over, and equal what projecting anew would give.
template <class Watch = Nobody>
ClipTable project_other_eye(const Draw& other_eye, const View& other_view, ClipTable table,
                            const Watch& watch = {}) {
  const auto planes = render_planes(other_view);
  for (std::uint32_t i = 0; i < table.positions.size(); ++i) {
    Point<Clip>& clip = table.positions[i];
    clip.x = project_x(other_eye, i);
    watch.tell(&Observer::projected, other_eye, i, clip);
    table.outcodes[i] = outcode(clip, planes);
  }
  return table;
}

// What lighting needs, the same for both eyes of a pair. Empty where nothing is lit.
struct EyeSpaceTables {
  std::vector<Point<Eye>> positions;  // by position
  std::vector<Normal<Eye>> normals;   // by normal, unit length
  // By face, unit length; empty where every corner has its own.
  std::vector<Normal<Eye>> face_normals;
};

// The same without saying where the tables are kept; entries of tables that nobody needs may be missing.
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

// What the vertex stage makes of a draw.
struct DrawTables {
  ClipTable clip;            // of one eye
  EyeSpaceTables eye_space;  // of all eyes
};

// True where the draw's colour depends on normals: lit shading of a lit material, or a picture of the normals.
bool needs_normals(const Draw& draw, const RenderSettings& settings);

// True where the picture shows light: what the surface reflects, and what it emits.
bool shows_light(const Draw& draw, const RenderSettings& settings);

// True where light is computed with the normals of faces: flat shading, and corners without a normal of their own.
bool needs_face_normals(const Draw& draw, const RenderSettings& settings);

// Unit normals in eye space of all faces of the mesh, appended.
void append_face_normals(const Draw& draw, std::vector<Normal<Eye>>& normals);

EyeSpaceTables make_eye_space_tables(const Draw& draw, const RenderSettings& settings);

}  // namespace glassbox
