// Transforms one vertex through every space and keeps all results: each number with its error
// bound, each clipping decision with the vertex's distance from the plane.
//
// The matrices may be any 4x4 matrices, so positions keep their w everywhere. The arithmetic is
// that of the stages that draw (spaces.h, clip.h, divide.h, viewport.h), in float.
#pragma once

#include <array>
#include <optional>

#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/bounds.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/round_trip.h>
#include <glassbox/pipeline/stages.h>

namespace glassbox {

struct ChainMatrices {
  Transform<World, Object, float> world_from_object;
  Transform<Eye, World, float> eye_from_world;
  Transform<Clip, Eye, float> clip_from_eye;
  // The bound of each entry's error compared with the matrix that was meant; 0 if that is exactly
  // this matrix of floats.
  glm::dmat4 world_from_object_bound{0}, eye_from_world_bound{0}, clip_from_eye_bound{0};
};

// after = matrix * before.
struct TransformStep {
  glm::mat4 matrix{1};
  glm::vec4 before{0, 0, 0, 1}, after{0, 0, 0, 1};
  glm::dvec4 bound{0};      // of `after`'s error, if the object's coordinates are exact
  glm::dvec4 magnitude{0};  // |matrix| |previous matrices| |object|
};

// On which side of a clip plane the vertex is.
struct PlaneStep {
  ClipPlane plane;
  double distance = 0;  // of the vertex from the plane, clip units; negative: outside
  double bound = 0;     // of the error of `distance`
  bool is_outside() const { return distance < 0; }
  // Whether the vertex is on this side of the plane in spite of the rounding errors. A vertex
  // exactly on the plane is certain if its bound is 0.
  bool is_certain() const { return distance < 0 ? -distance > bound : distance >= bound; }
};

enum class VertexVerdict { kVisible, kNotFinite, kInEyePlane, kBehindEye, kOutside };

struct DivideStep {
  NdcVertex ndc;
  DivideBound bound;
  glm::dvec3 condition{0};
};

struct ScreenStep {
  ScreenVertex screen;
  glm::dvec3 bound{0};  // pixels, pixels, depth of NDC
  double depth = 0;     // as the depth buffer of the dialect stores it
  SnapStability snap_x, snap_y;
};

struct VertexChain {
  glm::vec4 object{0, 0, 0, 1};
  TransformStep to_world, to_eye, to_clip;
  Point<Clip> clip;  // equal to to_clip.after
  // By one matrix, composed in double and rounded once, as in `render`.
  Point<Clip> clip_by_composed_matrix;
  std::array<PlaneStep, 6> planes;
  VertexVerdict verdict = VertexVerdict::kVisible;
  // For kOutside: the plane that the vertex is furthest outside of, measured after the divide.
  int deciding_plane = -1;
  std::optional<DivideStep> divide;  // set if w is finite and not 0, also behind the eye
  std::optional<ScreenStep> screen;
  std::optional<RoundTrip> round_trip;  // set for points with w = 1 that are not behind the eye
};

VertexChain make_vertex_chain(const glm::vec4& object, const ChainMatrices& matrices,
                              const ApiDialect& dialect, const Viewport& viewport);

// Each row times the vector, summed from left to right, the order of transform_row. The last column
// is multiplied by w, which changes no bit if w is 1.
glm::vec4 transform_by_rows(const glm::mat4& m, const glm::vec4& v);

}  // namespace glassbox
