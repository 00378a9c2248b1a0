// The camera options of the command line, and the camera that results from them and the scene.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>

namespace glassbox {

struct CameraOptions {
  std::optional<std::string> camera;  // name or index; "none": do not use the scene's cameras
  std::optional<std::array<double, 3>> eye;
  std::optional<std::array<double, 3>> look_at;
  std::optional<std::array<double, 3>> up;
  std::optional<double> fov_degrees;
  std::optional<double> ortho_height;
  std::optional<std::array<double, 4>> frustum;
  std::optional<double> near;
  std::optional<double> far;  // may be infinite
  Formulation formulation;    // how the view and projection matrices are computed
};

void add_camera_options(CLI::App& app, CameraOptions& options);

// Chooses the camera.
//
// Its pose is the first of these that is given: the scene's camera named by --camera; --eye,
// --look-at and --up; the scene's first camera; automatic framing. With --up alone, the scene is
// framed automatically with that up vector. The lens is the scene's camera's own, or the one given
// by --fov, --ortho or --frustum. The near and far planes are those given, else the scene's
// camera's, else such that they enclose the scene. If `eye_from_world` is given, the pose is its
// inverse, and no option of the pose may be given.
Result<Camera> choose_camera(const Scene& scene, const CameraOptions& options, double aspect,
                             const std::optional<Transform<Eye, World>>& eye_from_world = {});

}  // namespace glassbox
