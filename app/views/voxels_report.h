// What `glassbox views voxels` finds, and says of it.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/rings/picture_set.h"
#include "views/voxels/coloring.h"
#include "views/voxels/draw.h"
#include "views/voxels/truth.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

class Progress;

struct VoxelsInput {
  views::PictureSet set;                             // those that shape is made from
  std::optional<views::CalibratedPicture> left_out;  // and the one that judges it
  std::optional<Scene> truth;
};

struct VoxelsReport {
  views::Coloring coloring;
  std::uint64_t bytes = 0;  // that all of it was expected to take
  // Of coarse to fine, against all voxels: those of either that the other has not.
  struct AgainstFull {
    std::int64_t full = 0, lost = 0, added = 0;
    double milliseconds = 0;
    double iou() const { return double(full - lost) / double(full + added); }
  };
  std::optional<AgainstFull> against_full;
  std::optional<views::VoxelPicture> drawn;  // for the picture that was left out
  std::optional<views::PictureErrors> left_out;
  // Voxels that are not proved empty against those that are inside; the surface.
  struct AgainstTruth {
    std::int64_t inside = 0, not_empty = 0;
    double iou = 0;
    views::SurfaceErrors surface;
  };
  std::optional<AgainstTruth> truth;
  std::vector<views::Verdict> verdicts;  // of all voxels, x first, where they were asked for
};

struct VoxelsQuestion {
  bool against_full = false;
  bool wants_verdicts = false;
};

Result<VoxelsReport> report_voxels(const VoxelsInput& input, const views::ColoringRequest& request,
                                   const VoxelsQuestion& question, Progress& progress);

std::string voxels_text(const VoxelsInput& input, const views::ColoringRequest& request,
                        const VoxelsReport& report);
nlohmann::ordered_json voxels_json(const VoxelsInput& input, const views::ColoringRequest& request,
                                   const VoxelsReport& report);

}  // namespace glassbox::app
