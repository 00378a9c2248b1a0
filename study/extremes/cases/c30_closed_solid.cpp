#include <glassbox/mesh/builtin/sphere.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/staged.h>

#include "study/extremes/common/camera_types.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/ray_cast.h"
#include "study/naive/normals.h"

namespace glassbox::study {
namespace c30 {

// Culls by a given rule instead of the sign of the snapped area.
class CullBy : public Observer {
public:
  using Rule = bool (*)(std::span<const Point<Object>> face, const WorldPoint& eye,
                        const WorldVector& gaze);
  CullBy(Rule rule, const WorldPoint& eye, const WorldVector& gaze)
      : rule_(rule), eye_(eye), gaze_(gaze) {}

  void draw(const Draw& draw) override { mesh_ = draw.mesh; }
  void clipped(const PrimitiveStage&, const Triangle& triangle, const std::array<ClipVertex, 3>&,
               ClipPolygon&) override {
    std::array<Point<Object>, 3> face;
    for (std::size_t k = 0; k < 3; ++k) {
      face[k] = mesh_->positions[mesh_->corners[triangle.corners[k]].position];
    }
    culls_ = rule_(face, eye_, gaze_);
  }
  void facing_tested(const TriangleSetup&, bool, bool& culled) override { culled = culls_; }

private:
  Rule rule_;
  WorldPoint eye_;
  WorldVector gaze_;
  const Mesh* mesh_ = nullptr;
  bool culls_ = false;
};

Outcome measure_error(CullBy::Rule rule) {
  const Scene ball = make_sphere(8);
  int different = 0, covered = 0;
  // If the eye is beside the ball, many lines of sight differ much from the gaze, because the
  // picture is 108 degrees wide.
  const std::pair<WorldPoint, WorldVector> views[] = {{{0, 0, 1.3}, {1, 0, -0.3}},
                                                      {{0, 0, 1.3}, {0, 0, -1}},
                                                      {{1.2, 0.7, 0.9}, {-1, 0.5, -0.2}},
                                                      {{-2, 3, 1}, {1, -1, 0.3}}};
  for (const auto& [eye, gaze] : views) {
    Camera camera;
    camera.lens = PerspectiveLens{1.6, 0.05, 10};
    camera.world_from_eye = camera_pose(eye, gaze, {0, 1, 0.1}).value();
    const View view = make_view(camera, 128, 96).value();
    RenderSettings settings;
    settings.shading = Shading::kUnlit;
    settings.cull = Cull::kNone;
    const Rendering whole = render_staged(ball, view, settings);
    CullBy observer(rule, eye, gaze);
    if (rule == nullptr) settings.cull = Cull::kBack;
    const Rendering culled = render_staged(ball, view, settings, rule ? &observer : nullptr);
    for (std::size_t i = 0; i < whole.buffers.depth.pixels.size(); ++i) {
      const bool before = whole.buffers.depth.pixels[i] != kEmptyDepth;
      const bool after = culled.buffers.depth.pixels[i] != kEmptyDepth;
      different += before != after;
      covered += before;
    }
  }
  return wrong_count_outcome(different, covered, "covered pixels are lost by culling");
}

// The test of the slide with the camera's gaze instead of the line of sight: it is right only for
// parallel projections.
bool by_gaze(std::span<const Point<Object>> face, const WorldPoint&, const WorldVector& gaze) {
  const auto m = naive::first_corner(face);
  return m.x * gaze.x + m.y * gaze.y + m.z * gaze.z > 0;
}
// The right test, but it culls a little before a face is edge-on.
bool before_edge_on(std::span<const Point<Object>> face, const WorldPoint& eye,
                    const WorldVector&) {
  const auto m = naive::first_corner(face);
  const WorldVector sight{double(face[0].x) - eye.x, double(face[0].y) - eye.y,
                          double(face[0].z) - eye.z};
  return m.x * sight.x + m.y * sight.y + m.z * sight.z >
         -0.1 * std::sqrt(dot(m, m)) * length(sight);
}

// The ball from the same places as in measure_error. With back faces culled, exactly the near layer
// is visible; with front faces culled, exactly the far layer. Faces are culled on the screen, or in
// object space where the result is certain.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const std::vector<RayCastReference> balls = [] {
    std::vector<RayCastReference> all;
    for (const Cull cull : {Cull::kBack, Cull::kFront, Cull::kNone}) {
      for (const WorldPoint& eye : {WorldPoint{0, 0, 1.3}, {1.2, 0.7, 0.9}, {-2, 3, 1}}) {
        Camera camera = camera_at(eye, {0.2 - eye.x, -eye.y, -eye.z});
        camera.lens = PerspectiveLens{1.6, 0.05, 10.0};
        RayScene ray_scene = make_ray_scene(make_sphere(8), camera, 64, 48);
        ray_scene.settings.cull = cull;
        all.emplace_back(ray_scene);
        ray_scene.settings.cull_stage = CullStage::kObject;
        all.emplace_back(std::move(ray_scene));
      }
    }
    return all;
  }();
  return worst_of(balls, engine);
}

}  // namespace c30

ExtremeCase c30_closed_solid() {
  using namespace c30;
  return {
      .id = "C-30",
      .name = "A closed solid, culled",
      .construction =
          "a ball of 8 rows of faces, seen from four places near it, with the gaze towards it and "
          "past it, 128 x 96 px",
      .stage = "back faces",
      .right_answer = "the same pixels are covered with and without culling",
      .unit = "pixels",
      .oracle = Oracle::kProperty,
      .ours = {"the sign of the snapped area", [] { return measure_error(nullptr); }},
      .naive = {"the normal is compared with the direction of the camera's gaze",
                [] { return measure_error(by_gaze); }},
      .mutants = {{"faces within six degrees of edge-on are culled too",
                   [] { return measure_error(before_edge_on); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
