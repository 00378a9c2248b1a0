#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/render/staged/staged.h>

#include <glassbox/base/random.h>
#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/normals_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/transform.h"

namespace glassbox::study {
namespace c17 {

Vector<World, double> axis_from(Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  return {x, y, random.between(0.1, 1)};
}

// Culls as if the model were not mirrored.
class IgnoreMirror : public Observer {
  void facing_tested(const TriangleSetup&, bool front, bool& culled) override { culled = front; }
};

// Counts the pixels of a mirrored cube whose depth is not that of the nearest face, which is a
// front face.
int wrong_faces_seen(Observer* observer) {
  Scene cube = make_cube();
  for (Node& node : cube.nodes) {
    node.world_from_node = scale<World>(-1, 1, 1) * node.world_from_node;
  }
  Camera camera;
  camera.lens = PerspectiveLens{1, 0.5, 20};
  camera.world_from_eye =
      camera_pose(Point<World, double>(3, 2, 4), Point<World, double>(0, 0, 0), {0, 1, 0}).value();
  const View view = make_view(camera, 64, 48).value();
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.cull = Cull::kNone;
  const auto nearest = render_staged(cube, view, settings).buffers.depth;
  settings.cull = Cull::kBack;
  const auto seen = render_staged(cube, view, settings, observer).buffers.depth;
  int wrong = 0;
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) wrong += seen.pixels[i] != nearest.pixels[i];
  return wrong;
}

// After any map, the outward normals of the cube must point away from the centre of the result.
Outcome measure_error(TransformNormal transform, Observer* observer = nullptr) {
  Random random(717);
  int inward = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    const auto factor = [&] {
      const double sign = random.integer(0, 1) == 0 ? -1 : 1;
      return sign * random.between(0.1, 3);
    };
    const Vector<World, double> about = axis_from(random);
    const auto turn = rotate_degrees<World>(about, random.between(0, 360)).value();
    const double x = factor(), y = factor(), z = factor();
    const auto map = turn * scale<World, Object>(x, y, z);
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        const Normal<Object> n(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0);
        const Normal<World> outward = transform(map, n);
        const Vector<World, double> centre = map * Vector<Object, double>(n.x, n.y, n.z);
        const double along = double(outward.x) * centre.x + double(outward.y) * centre.y +
                             double(outward.z) * centre.z;
        inward += !(along > 0);
        ++all;
      }
    }
  }
  const int wrong_faces = wrong_faces_seen(observer);
  Outcome outcome = wrong_count_outcome(inward, all, "normals point inwards");
  outcome.error += wrong_faces;
  outcome.summary += "; " + std::to_string(wrong_faces) + " pixels show a back face";
  return outcome;
}

Outcome measure_error_without_mirror() {
  IgnoreMirror observer;
  return measure_error(by_cofactors, &observer);
}

// The cross product of two edges in world space, as beginners compute it: a mirror reverses the
// order of the vertices.
Normal<World> by_edges(const Transform<World, Object>& m, const Normal<Object>& n) {
  const Vector<Object, double> normal(n.x, n.y, n.z);
  // u is perpendicular to the normal if the normal is an axis; v is perpendicular to both.
  const Vector<Object, double> u(normal.y, normal.z, normal.x);
  const Vector<Object, double> v = cross(normal, u);
  const Vector<World, double> crossed = cross(m * u, m * v);
  return {float(crossed.x), float(crossed.y), float(crossed.z)};
}

// A mirrored cube with back-face culling must show exactly one layer everywhere, which is the layer
// of the front faces.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> cubes = [] {
    std::vector<RayCastReference> all;
    for (const auto& [x, y, z] :
         {std::array{-1.0, 1.0, 1.0}, {1.0, -2.0, 1.0}, {-1.0, -1.0, -0.5}, {-1.0, 1.0, -1.0}}) {
      Scene cube = make_cube();
      for (Node& node : cube.nodes) {
        node.world_from_node = scale<World>(x, y, z) * node.world_from_node;
      }
      RayScene ray_scene = make_ray_scene(cube, camera_at({3, 2, 4}, {-3, -2, -4}), 64, 48);
      ray_scene.settings.cull = Cull::kBack;
      all.emplace_back(std::move(ray_scene));
    }
    // Two instances of the same mesh side by side, one of them mirrored.
    Scene both = make_cube();
    const Node node = both.nodes[0];
    both.nodes.clear();
    both.instances.clear();
    for (const double x : {-1.0, 1.0, -0.5, 0.5}) {
      Node& copy = both.nodes.emplace_back(node);
      copy.world_from_node = translate<World>(WorldVector{2 * x, x, 0}) *
                             scale<World>(x / 2, 0.5, 0.5) * node.world_from_node;
      both.instances.push_back({0, std::uint32_t(both.nodes.size() - 1)});
    }
    RayScene ray_scene = make_ray_scene(both, camera_at({3, 2, 4}, {-3, -2, -4}), 64, 48);
    ray_scene.settings.cull = Cull::kBack;
    all.emplace_back(std::move(ray_scene));
    return all;
  }();
  return worst_of(cubes, engine);
}

}  // namespace c17

ExtremeCase c17_mirrored_model() {
  using namespace c17;
  return {
      .id = "C-17",
      .name = "A mirrored model",
      .construction =
          "cubes under 200 rotations and scales by -3 .. 3 of each axis, half of them mirrors",
      .stage = "normals",
      .right_answer =
          "every outward normal stays outward, and front faces stay front faces, because normals "
          "and winding follow the sign of the determinant",
      .unit = "normals and pixels",
      .oracle = Oracle::kProperty,
      .ours = {"normal_transform", [] { return measure_error(by_cofactors); }},
      .naive = {"the cross product of the transformed edges",
                [] { return measure_error(by_edges); }},
      .mutants = {{"the sign of the determinant is ignored",
                   [] { return measure_error(naive::normal_without_sign); }},
                  {"the winding is not reversed for a mirror", measure_error_without_mirror}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
