// The scenes of the vertex-stage experiment (D-1): an object four units in front of a camera, both
// far from the origin and turned at random.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/viewport.h>

#include "exact/matrix.h"
#include "exact/number.h"

namespace glassbox::study {

inline constexpr int kVertexSceneWidth = 1920, kVertexSceneHeight = 1080;
inline constexpr double kVertexSceneDistance = 4;  // distance of the object's centre along the gaze
// The focal length in px, for a vertical angle of view of 90 degrees.
inline constexpr double kVertexSceneFocal = kVertexSceneHeight / 2.0;

struct VertexScene {
  exact::PythagoreanRotation world_from_object, eye_from_world;
  Vector<World, double> object, eye;  // exact positions of object and eye
  // in the unit ball; multiples of 2^-20, so that floats hold them exactly
  std::vector<Point<Object, double>> points;
  DepthPlanes planes;
};

template <class Space>
Vector<Space, double> random_direction(Random& random) {
  while (true) {
    // The three random numbers must be drawn in this order on every compiler. Braces ensure it; the
    // arguments of a call in parentheses are evaluated in any order.
    const Vector<Space, double> v{random.between(-1, 1), random.between(-1, 1),
                                  random.between(-1, 1)};
    const double squared = dot(v, v);
    if (squared > 0.01 && squared <= 1) return v * (1 / std::sqrt(squared));
  }
}

inline glm::dmat3 rounded(const exact::PythagoreanRotation& r) {
  glm::dmat3 m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      m[column][row] =
          double(r.numerator[std::size_t(row)][std::size_t(column)]) / double(r.denominator);
  }
  return m;
}

inline Point<Object, double> random_point(Random& random) {
  const auto coordinate = [&] { return double(random.integer(-(1 << 20), 1 << 20)) * 0x1p-20; };
  while (true) {
    const Point<Object, double> p{coordinate(), coordinate(), coordinate()};
    if (p.x * p.x + p.y * p.y + p.z * p.z <= 1) return p;
  }
}

inline VertexScene make_vertex_scene(std::uint64_t seed, double offset, int points,
                                     const DepthPlanes& planes = {}) {
  Random random(seed);
  VertexScene scene;
  scene.planes = planes;
  scene.world_from_object = exact::pythagorean_rotation(random);
  scene.eye_from_world = exact::pythagorean_rotation(random);
  scene.eye = random_direction<World>(random) * offset;
  const glm::dvec3 in_eye{random.between(-1, 1), random.between(-1, 1), -kVertexSceneDistance};
  const glm::dvec3 from_eye = glm::transpose(rounded(scene.eye_from_world)) * in_eye;
  scene.object = scene.eye + Vector<World, double>(from_eye);
  for (int i = 0; i < points; ++i) scene.points.push_back(random_point(random));
  return scene;
}

inline Transform<Clip, Eye> projection_of(const VertexScene& scene) {
  return *perspective_degrees(90, double(kVertexSceneWidth) / kVertexSceneHeight, scene.planes);
}
inline Viewport vertex_scene_viewport() {
  return {0, 0, float(kVertexSceneWidth), float(kVertexSceneHeight)};
}

template <class Target, class Source>
Transform<Target, Source> placed(const exact::PythagoreanRotation& rotation,
                                 const Vector<Target, double>& offset) {
  Transform<Target, Source> m{glm::dmat4(rounded(rotation))};
  m.at(0, 3) = offset.x, m.at(1, 3) = offset.y, m.at(2, 3) = offset.z;
  return m;
}

// The view matrix [R, -R e] for the camera's rotation R and the eye e, computed as look_at does it.
inline Transform<Eye, World> view_of(const VertexScene& scene) {
  const glm::dvec3 moved = rounded(scene.eye_from_world) * to_glm(scene.eye);
  return placed<Eye, World>(scene.eye_from_world, Vector<Eye, double>(-moved));
}

// Computes with 50 digits where the points of a scene are seen.
class ExactVertexScene {
public:
  using Decimal = exact::Decimal;

  explicit ExactVertexScene(const VertexScene& scene)
      : world_from_object_(exact::exactly<Decimal>(scene.world_from_object)),
        eye_from_world_(exact::exactly<Decimal>(scene.eye_from_world)),
        clip_from_eye_(exact::exactly<Decimal>(projection_of(scene))) {
    from_eye_ = {Decimal(scene.object.x) - Decimal(scene.eye.x),
                 Decimal(scene.object.y) - Decimal(scene.eye.y),
                 Decimal(scene.object.z) - Decimal(scene.eye.z), Decimal(0)};
  }

  struct ScreenPosition {
    Decimal x, y;  // in px
    Decimal depth, distance;
  };

  ScreenPosition screen(const Point<Object, double>& p) const {
    auto relative = world_from_object_ * exact::exactly<Decimal>(p);
    for (std::size_t i = 0; i < 3; ++i) relative[i] += from_eye_[i];
    const auto clip = clip_from_eye_ * (eye_from_world_ * relative);
    const Decimal half_width(kVertexSceneWidth / 2), half_height(kVertexSceneHeight / 2);
    return {half_width + half_width * clip[0] / clip[3],
            half_height - half_height * clip[1] / clip[3], clip[2] / clip[3], clip[3]};
  }

private:
  exact::Matrix4<Decimal> world_from_object_, eye_from_world_, clip_from_eye_;
  exact::Vector4<Decimal> from_eye_;
};

}  // namespace glassbox::study
