// Which way to look: the camera options of the command line, and the camera that they and the scene give.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>

namespace glassbox::app {

struct CameraOptions {
  std::optional<std::string> camera;  // name or index; "none" ignores those of the scene
  std::optional<std::array<double, 3>> eye;
  std::optional<std::array<double, 3>> look_at;
  std::optional<std::array<double, 3>> up;
  std::optional<double> fov_degrees;
  std::optional<double> ortho_height;
  std::optional<std::array<double, 4>> frustum;
  std::optional<double> near;
  std::optional<double> far;  // may be infinite
  Formulation formulation;    // how the camera's two matrices are made
};

void add_camera_options(CLI::App& app, CameraOptions& options);

// The pose: --camera, else --eye/--look-at/--up, else the scene's first camera, else automatic framing; with --up alone,
// framing for that direction. The lens: that
// camera's own or, with --fov, --ortho or --frustum, the one asked for. Near and far planes: as asked for, else the
// camera's, else such that they enclose the scene.
Result<Camera> choose_camera(const Scene& scene, const CameraOptions& options, double aspect);

}  // namespace glassbox::app
