// What a scene's condition numbers say, for people, for machines and as a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/camera_options.h"

#include <glassbox/mesh/scene.h>

#include "study/stiffness/stiffness.h"

namespace glassbox::app {

struct StiffnessReport {
  std::string scene;                 // as it was given
  std::vector<std::string> picture;  // the words of its options
  int width = 0, height = 0;
  study::Stiffness found;
};

// What the view of these options was made upright by; none where a camera of the scene gives the pose.
std::optional<Vector<World, double>> up_of(const Scene& scene, const CameraOptions& options);

std::string stiffness_text(const Scene& scene, const StiffnessReport& report);
// Schema "glassbox-stiffness/1" (docs/exactness.md).
nlohmann::ordered_json stiffness_json(const Scene& scene, const StiffnessReport& report);
// `command` makes the page again.
std::string stiffness_page(const Scene& scene, const StiffnessReport& report,
                           const std::string& command);

// One line for each number whose bound passes a pixel: the reason, the place and what to do.
std::vector<std::string> stiffness_warnings(const Scene& scene, const study::Stiffness& found);

}  // namespace glassbox::app
