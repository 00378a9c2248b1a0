// What `glassbox views polygons` finds, and says of it.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/views/picture_choice.h"
#include "views/polygons/coloring.h"
#include "views/polygons/mesh_check.h"
#include "views/texture/textured_surface.h"
#include "views/voxels/coloring.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

class Progress;

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
  std::uint64_t bytes = 0;  // that all of it was expected to take
  views::PolygonColoring coloring;
  views::MeshCheck check;
  double voxel_milliseconds = 0;
  std::size_t colored_voxels = 0;
  Scene scene;
  std::optional<views::TexturedPicture> drawn;  // by the engine, for the picture that was left out
  std::optional<views::TextureErrors> left_out;
  std::optional<double> iou_before, iou;  // of the solid with what is inside the true scene
};

Result<PolygonsReport> report_polygons(const PolygonsInput& input, const PolygonsRequest& request,
                                       Progress& progress);

std::string polygons_text(const PolygonsInput& input, const PolygonsReport& report);
nlohmann::ordered_json polygons_json(const PolygonsInput& input, const PolygonsReport& report);

}  // namespace glassbox::app
