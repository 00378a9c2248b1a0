// The results of `glassbox views polygons`, and their reports.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/report/progress.h"
#include "views/commands/picture_choice.h"
#include "views/polygons/coloring.h"
#include "views/polygons/mesh_check.h"
#include "views/texture/textured_surface.h"
#include "views/voxels/coloring.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::views {

struct PolygonsInput {
  ChosenPictures pictures;
  std::optional<Scene> truth;
};

struct PolygonsRequest {
  views::ColoringRequest voxels;
  views::PolygonColoringSettings polygons;
  bool writes_glb = false;
};

struct PolygonsReport {
  std::uint64_t bytes = 0;  // expected memory for everything
  views::PolygonColoring coloring;
  views::MeshCheck check;
  double voxel_milliseconds = 0;
  std::size_t colored_voxels = 0;
  Scene scene;
  // drawn by the engine for the left-out picture's camera
  std::optional<views::TexturedPicture> drawn;
  std::optional<views::TextureErrors> left_out;
  // Intersection over union of the solid and the true scene's inside, before and after carving.
  std::optional<double> iou_before, iou;
};

Result<PolygonsReport> report_polygons(const PolygonsInput& input, const PolygonsRequest& request,
                                       Progress& progress);

std::string polygons_text(const PolygonsInput& input, const PolygonsReport& report);
nlohmann::ordered_json polygons_json(const PolygonsInput& input, const PolygonsReport& report);

}  // namespace glassbox::views
