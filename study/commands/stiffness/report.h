// The report on a scene's condition numbers, as text, as JSON and as a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/camera_options.h"

#include <glassbox/mesh/scene.h>

#include "study/stiffness/stiffness.h"

namespace glassbox::study {

struct StiffnessReport {
  std::string scene;                 // as the user gave it
  std::vector<std::string> picture;  // the picture options as words
  int width = 0, height = 0;
  study::Stiffness found;
};

// The up vector with which these options set up the view; none if a camera of the scene gives the
// pose.
std::optional<Vector<World, double>> up_of(const Scene& scene, const CameraOptions& options);

std::string stiffness_text(const Scene& scene, const StiffnessReport& report);
// Schema "glassbox-stiffness/1" (docs/exactness.md).
nlohmann::ordered_json stiffness_json(const Scene& scene, const StiffnessReport& report);
// `command` is the command line that makes the page again.
std::string stiffness_page(const Scene& scene, const StiffnessReport& report,
                           const std::string& command);

// Warnings, one line for each number whose error bound exceeds a pixel: the reason, the place, and
// what to do.
std::vector<std::string> stiffness_warnings(const Scene& scene, const study::Stiffness& found);

}  // namespace glassbox::study
