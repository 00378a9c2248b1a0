#include "cli/options/camera_options.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>

namespace glassbox {

namespace {

constexpr double kDefaultFovDegrees = 45;

template <std::size_t N>
CLI::Option* add_numbers(CLI::App& app, const std::string& name,
                         std::optional<std::array<double, N>>& value, const std::string& form,
                         const std::string& help) {
  return app
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_numbers<N>(name, text); },
          help)
      ->type_name(form);
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value,
                        const std::string& form, const std::string& help) {
  return app
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_number(name, text); }, help)
      ->type_name(form);
}

CLI::Option* add_distance(CLI::App& app, const std::string& name, std::optional<double>& value,
                          const std::string& form, const std::string& help) {
  return app
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_distance(name, text); },
          help)
      ->type_name(form);
}

bool has_pose(const CameraOptions& options) {
  return options.eye || options.look_at || options.up;
}

// Whether the scene is framed automatically: no option gives the camera's position or direction
// (--up may still be given).
bool is_framed(const CameraOptions& options) {
  return !options.eye && !options.look_at;
}

Point<World, double> world_point(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

// ---- which camera ----

// The camera of this name or index, which may be one that cannot be used.
Result<Camera> find_camera(const Scene& scene, const std::string& name) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
  }
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    if (std::to_string(i) == name) return scene.cameras[i];
  }
  if (scene.cameras.empty()) {
    return fail("--camera " + name, "the scene has no cameras",
                "leave this option out, or use --eye");
  }
  std::string known;
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    known += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, scene.cameras[i].name);
  }
  return fail("--camera " + name, "no camera has this name or index", "the scene has " + known);
}

Result<Camera> named_camera(const Scene& scene, const std::string& name) {
  Result<Camera> camera = find_camera(scene, name);
  if (camera && !camera->fault.empty()) {
    return fail("--camera " + name, "this camera cannot be used: " + camera->fault,
                "choose another camera, or correct this one in the file");
  }
  return camera;
}

// The first camera that can be used; none if the scene has no such camera.
const Camera* first_camera(const Scene& scene) {
  const auto first =
      std::ranges::find_if(scene.cameras, [](const Camera& c) { return c.fault.empty(); });
  return first == scene.cameras.end() ? nullptr : &*first;
}

// Options for the automatic camera, with the up vector and the angle of view from the command line.
FramingOptions asked_framing(const CameraOptions& options) {
  FramingOptions framing;
  framing.fovy_degrees = kDefaultFovDegrees;
  const bool legal_fov =
      options.fov_degrees && *options.fov_degrees > 0 && *options.fov_degrees < 180;
  if (legal_fov && is_framed(options)) framing.fovy_degrees = *options.fov_degrees;
  if (options.up) framing.up = {(*options.up)[0], (*options.up)[1], (*options.up)[2]};
  return framing;
}

// The pose from --eye, --look-at and --up. A missing eye is replaced by the automatic camera's, a
// missing target by the scene's centre.
Result<Camera> posed_camera(const CameraOptions& options, const Camera& automatic,
                            const Box<World>& bounds) {
  const auto& m = automatic.world_from_eye;
  const Point<World, double> eye = options.eye
                                       ? world_point(*options.eye)
                                       : Point<World, double>{m.at(0, 3), m.at(1, 3), m.at(2, 3)};
  const Point<World, double> target =
      options.look_at ? world_point(*options.look_at) : bounds.center();
  const std::array<double, 3> up = options.up.value_or(std::array<double, 3>{0, 1, 0});
  const auto eye_from_world = look_at(eye, target, {up[0], up[1], up[2]});
  if (!eye_from_world) return tl::unexpected(eye_from_world.error());

  Camera camera;
  camera.name = "command line";
  camera.lens = PerspectiveLens{radians_from_degrees(kDefaultFovDegrees), 0, {}};
  camera.world_from_eye = inverse_rigid(*eye_from_world);
  return camera;
}

// The camera that a view matrix describes. make_view() checks that its inverse is a pose.
Camera camera_of(const Transform<Eye, World>& eye_from_world) {
  Camera camera;
  camera.name = "your view matrix";
  camera.lens = PerspectiveLens{radians_from_degrees(kDefaultFovDegrees), 0, {}};
  camera.world_from_eye = Transform<World, Eye>(glm::inverse(eye_from_world.columns));
  return camera;
}

// ---- which lens ----

bool is_parallel(const Lens& lens) {
  return std::holds_alternative<OrthographicLens>(lens);
}

Result<Lens> asked_lens(const CameraOptions& options, const Lens& own) {
  const int asked = int(options.fov_degrees.has_value()) + int(options.ortho_height.has_value()) +
                    int(options.frustum.has_value());
  if (asked > 1) {
    return fail("--fov, --ortho, --frustum", "each of them describes the whole lens",
                "give one of them");
  }
  if (options.fov_degrees) {
    const double degrees = *options.fov_degrees;
    if (!(degrees > 0 && degrees < 180)) {
      return fail("--fov", fmt::format("the full vertical angle is {} degrees", degrees),
                  "give an angle between 0 and 180 degrees");
    }
    return PerspectiveLens{radians_from_degrees(degrees), 0, {}};
  }
  if (options.ortho_height) return OrthographicLens{*options.ortho_height / 2, 0, 0};
  if (options.frustum) {
    const auto& [left, right, bottom, top] = *options.frustum;
    return FrustumLens{left, right, bottom, top, 0, {}};
  }
  return own;
}

struct Planes {
  double near = 0;
  std::optional<double> far;
};

Planes planes_of(const Lens& lens) {
  if (const auto* ortho = std::get_if<OrthographicLens>(&lens)) return {ortho->near, ortho->far};
  if (const auto* frustum = std::get_if<FrustumLens>(&lens)) return {frustum->near, frustum->far};
  const auto& perspective = std::get<PerspectiveLens>(lens);
  return {perspective.near, perspective.far};
}

void set_planes(Lens& lens, const Planes& planes) {
  if (auto* ortho = std::get_if<OrthographicLens>(&lens)) {
    ortho->near = planes.near;
    ortho->far = planes.far.value_or(std::numeric_limits<double>::infinity());
  } else if (auto* frustum = std::get_if<FrustumLens>(&lens)) {
    frustum->near = planes.near;
    frustum->far = planes.far;
  } else {
    auto& perspective = std::get<PerspectiveLens>(lens);
    perspective.near = planes.near;
    perspective.far = planes.far;
  }
}

Result<Planes> enclosing_planes(const Camera& camera, const Box<World>& bounds) {
  const auto planes = is_parallel(camera.lens)
                          ? parallel_near_far_for(camera.world_from_eye, bounds)
                          : near_far_for(camera.world_from_eye, bounds);
  if (!planes) return tl::unexpected(planes.error());
  return Planes{planes->near, planes->far};
}

// If only one of the two planes is given, the automatic one is moved where it would be on the wrong
// side of the given one. An invalid plane is kept, for make_view to refuse.
Planes asked_planes(const CameraOptions& options, Planes found, bool parallel) {
  constexpr double kMaxRatio = 1000;
  const double extent = found.far.value_or(0) - found.near;
  if (options.far) {
    found.far = std::isinf(*options.far) && *options.far > 0 ? std::nullopt : options.far;
    if (!options.near && found.far && !(found.near < *found.far)) {
      if (parallel) found.near = *found.far - extent;
      if (!parallel && *found.far > 0) found.near = *found.far / kMaxRatio;
    }
  }
  if (options.near) {
    found.near = *options.near;
    if (!options.far && found.far && !(found.near < *found.far)) {
      found.far = parallel ? found.near + extent : found.near * kMaxRatio;
    }
  }
  return found;
}

}  // namespace

void add_camera_options(CLI::App& app, CameraOptions& options) {
  const std::string group = "Camera";
  app.add_option("--camera", options.camera,
                 "name or index of one of the scene's cameras [the first]; with none, or without "
                 "cameras in the scene, the whole scene is in view")
      ->type_name("NAME|INDEX|none")
      ->group(group);
  add_numbers(app, "--eye", options.eye, "X,Y,Z", "where the camera stands (world units)")
      ->group(group);
  add_numbers(app, "--look-at", options.look_at, "X,Y,Z",
              "the point it looks at [the scene's centre]")
      ->group(group);
  add_numbers(app, "--up", options.up, "X,Y,Z",
              "the direction that points up in the picture; without --eye and --look-at the whole "
              "scene is in view too [0,1,0]")
      ->group(group);
  add_number(app, "--fov", options.fov_degrees, "DEGREES",
             "full vertical angle of a perspective view [45]")
      ->group(group);
  add_number(app, "--ortho", options.ortho_height, "HEIGHT",
             "use a parallel projection; the view has this full height (world units)")
      ->group(group);
  add_numbers(app, "--frustum", options.frustum, "L,R,B,T",
              "left, right, bottom and top edge of the window on the near plane (see --near), as "
              "for glFrustum")
      ->group(group);
  add_distance(app, "--near", options.near, "N", "distance of the near plane")->group(group);
  add_distance(app, "--far", options.far, "F|inf", "distance of the far plane")->group(group);
  add_choice(app, "--view-from", options.formulation.view,
             {{"uvn", ViewForm::kUvn}, {"axis-angle", ViewForm::kAxisAngle}},
             "how the view matrix eye_from_world is made: from the camera's axes, or by turning "
             "the gaze to -z and then rolling [uvn]")
      ->group(group);
  add_choice(app, "--projection", options.formulation.projection,
             {{"perspective", ProjectionForm::kPerspective},
              {"frustum", ProjectionForm::kFrustum},
              {"t_pers", ProjectionForm::kTPers},
              {"alpha_beta", ProjectionForm::kAlphaBeta}},
             "formula of the projection; results differ by rounding [perspective]")
      ->group(group);
}

Result<Camera> choose_camera(const Scene& scene, const CameraOptions& options, double aspect,
                             const std::optional<Transform<Eye, World>>& eye_from_world) {
  const bool no_camera = options.camera == "none";
  if (options.camera && !no_camera && has_pose(options)) {
    return fail("--camera", "the camera's pose is also given by --eye, --look-at or --up",
                "give one of them");
  }
  const Box<World> box = bounds(scene);
  const Result<Camera> automatic = framing_camera(scene, aspect, asked_framing(options));
  if (!automatic) return automatic;

  Result<Camera> camera = automatic;
  if (eye_from_world) {
    camera = camera_of(*eye_from_world);
  } else if (options.camera && !no_camera) {
    camera = named_camera(scene, *options.camera);
  } else if (!is_framed(options)) {
    camera = posed_camera(options, *automatic, box);
  } else if (const Camera* first = first_camera(scene); first && !options.up && !no_camera) {
    camera = *first;
  }
  if (!camera) return camera;

  const Lens own = camera->lens;
  const Result<Lens> lens = asked_lens(options, own);
  if (!lens) return tl::unexpected(lens.error());
  camera->lens = *lens;

  const bool own_planes =
      is_framed(options) && !eye_from_world && is_parallel(own) == is_parallel(*lens);
  Planes found = planes_of(own);
  if (!own_planes) {
    const Result<Planes> enclosing = enclosing_planes(*camera, box);
    if (!enclosing) return tl::unexpected(enclosing.error());
    found = *enclosing;
  }
  set_planes(camera->lens, asked_planes(options, found, is_parallel(*lens)));
  return camera;
}

}  // namespace glassbox
