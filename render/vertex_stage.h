// Object space to clip space, once for each entry of the mesh's tables; and what lighting needs in eye space.
#pragma once

#include <vector>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/observer.h>

namespace glassbox {

// What one eye sees of the mesh's positions, by position.
struct ClipTable {
  std::vector<Point<Clip>> positions;
  std::vector<Outcode> outcodes;  // with respect to render_planes of the eye's view
};

ClipTable project_vertices(const Draw& draw, const View& view, Observer* observer = nullptr);

// The same for a stereo pair's other eye, from what the first one sees. The skew moves x alone (S0-03): y, z and w are
// taken over, and equal what projecting anew would give.
ClipTable project_other_eye(const Draw& other_eye, const View& other_view,
                            const ClipTable& first_eye, Observer* observer = nullptr);

// What lighting needs, the same for both eyes of a pair. Empty where nothing is lit.
struct EyeSpaceTables {
  std::vector<Point<Eye>> positions;  // by position
  std::vector<Normal<Eye>> normals;   // by normal, unit length
  std::vector<Normal<Eye>>
      face_normals;  // by face, unit length; empty where every corner has its own
};

// True where the draw's colour depends on normals: lit shading of a lit material, or a picture of the normals.
bool needs_normals(const Draw& draw, const RenderSettings& settings);

EyeSpaceTables make_eye_space_tables(const Draw& draw, const RenderSettings& settings);

}  // namespace glassbox
