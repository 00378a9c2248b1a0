// Object space to clip space, once for each entry of the tables; and what lighting needs in eye space.
#pragma once

#include <vector>

#include <glassbox/pipeline/stages.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/observer.h>

namespace glassbox {

// Tables parallel to the mesh's own.
struct VertexTables {
  std::vector<Point<Clip>> clip;    // by position
  std::vector<Point<Eye>> eye;      // by position; empty where nothing is lit
  std::vector<Normal<Eye>> normal;  // by normal, unit length; empty where nothing is lit
  std::vector<Normal<Eye>>
      face_normal;  // by face, unit length; empty where every corner has its own
};

// True where the draw's colour depends on normals: lit shading of a lit material, or a picture of the normals.
bool needs_normals(const Draw& draw, const RenderSettings& settings);

VertexTables transform_vertices(const Draw& draw, const RenderSettings& settings,
                                Observer* observer = nullptr);

// The clip positions of a stereo pair's other eye, from those of the first one. The skew moves x alone (S0-03): y, z and
// w are taken over, and equal what transforming anew would give.
std::vector<Point<Clip>> transform_other_eye(const Draw& other_eye,
                                             const std::vector<Point<Clip>>& first_eye,
                                             Observer* observer = nullptr);

}  // namespace glassbox
