// Carries one vertex through every space and keeps all results: each number with its error bound,
// each decision with its distance.
//
// The matrices may be anything, so positions keep their w everywhere. The arithmetic is that of the
// stages themselves (spaces.h, clip.h, divide.h, viewport.h), in float.
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
  // The bound of each entry's error, beyond its rounding to float: 0 where these floats are the
  // intended matrix.
  glm::dmat4 world_from_object_bound{0}, eye_from_world_bound{0}, clip_from_eye_bound{0};
};

// after = matrix * before.
struct TransformStep {
  glm::mat4 matrix{1};
  glm::vec4 before{0, 0, 0, 1}, after{0, 0, 0, 1};
  glm::dvec4 bound{0};      // of `after`; it counts the object's coordinates as exact
  glm::dvec4 magnitude{0};  // |matrix| ... |matrices before|| |object|
};

// On which side of a clip plane the vertex is.
struct PlaneStep {
  ClipPlane plane;
  double distance = 0;  // in clip units: negative outside
  double bound = 0;     // of the distance
  bool is_outside() const { return distance < 0; }
  // Whether rounding cannot have decided the side. A coordinate exactly on the plane, without
  // error, is sure.
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
  Point<Clip> clip;                     // to_clip.after
  Point<Clip> clip_by_composed_matrix;  // composed in double and rounded once, as in `render`
  std::array<PlaneStep, 6> planes;
  VertexVerdict verdict = VertexVerdict::kVisible;
  // For kOutside: the plane that the vertex is furthest outside of, measured after the divide.
  int deciding_plane = -1;
  std::optional<DivideStep> divide;  // where w is finite and not 0, also behind the eye
  std::optional<ScreenStep> screen;
  std::optional<RoundTrip> round_trip;  // of points with w = 1 that are not behind the eye
};

VertexChain make_vertex_chain(const glm::vec4& object, const ChainMatrices& matrices,
                              const ApiDialect& dialect, const Viewport& viewport);

// Each row times the vector, summed from left to right, the order of transform_row. w is multiplied
// too, which changes no bit where it is 1.
glm::vec4 transform_by_rows(const glm::mat4& m, const glm::vec4& v);

}  // namespace glassbox
