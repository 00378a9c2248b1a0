// The results of `glassbox views voxels`, and their reports.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/report/progress.h"
#include "views/rings/picture_set.h"
#include "views/voxels/coloring.h"
#include "views/voxels/draw_voxels.h"
#include "views/voxels/truth.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::views {

struct VoxelsInput {
  views::PictureSet set;                             // the pictures that the shape is made from
  std::optional<views::CalibratedPicture> left_out;  // the result is compared with this picture
  std::optional<Scene> truth;
};

struct VoxelsReport {
  views::Coloring coloring;
  std::uint64_t bytes = 0;  // expected memory for everything
  // The comparison of coarse-to-fine colouring with that of all voxels: `lost` voxels are found
  // only if all are coloured, `added` voxels only from coarse to fine.
  struct FullComparison {
    std::int64_t full = 0, lost = 0, added = 0;
    double milliseconds = 0;
    double iou() const { return double(full - lost) / double(full + added); }
  };
  std::optional<FullComparison> against_full;
  std::optional<views::VoxelPicture> drawn;  // drawn for the left-out picture's camera
  std::optional<views::PictureErrors> left_out;
  // The comparison with the true shape: voxels not proved empty against voxels that are inside, and
  // the errors of the surface.
  struct TruthComparison {
    std::int64_t inside = 0, not_empty = 0;
    double iou = 0;
    views::SurfaceErrors surface;
  };
  std::optional<TruthComparison> truth;
  std::vector<views::Verdict> verdicts;  // of all voxels, x varying fastest; only if asked for
};

struct VoxelsReportOptions {
  bool against_full = false;
  bool wants_verdicts = false;
};

Result<VoxelsReport> report_voxels(const VoxelsInput& input, const views::ColoringRequest& request,
                                   const VoxelsReportOptions& options, Progress& progress);

std::string voxels_text(const VoxelsInput& input, const views::ColoringRequest& request,
                        const VoxelsReport& report);
nlohmann::ordered_json voxels_json(const VoxelsInput& input, const views::ColoringRequest& request,
                                   const VoxelsReport& report);

// The voxels as one HTML page that needs no other file. The reader can turn and slice them, and ask
// for each voxel why it is there.
struct VoxelsPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// Makes the page. `json` is the JSON of voxels_json. The report must have the verdicts. An error if
// there are too many voxels, pictures or pixels for a browser.
Result<std::string> make_voxels_page(const VoxelsInput& input,
                                     const views::ColoringRequest& request,
                                     const VoxelsReport& report, const nlohmann::ordered_json& json,
                                     const VoxelsPageOrigin& origin);

}  // namespace glassbox::views
