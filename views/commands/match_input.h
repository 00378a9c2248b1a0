// The input of `glassbox views match`: two files, or a scene drawn twice, and what is known of the
// disparities.
#pragma once

#include <optional>
#include <string>

#include "cli/options/picture_options.h"
#include "cli/report/progress.h"
#include "views/matching/calibration.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/settings.h"
#include "views/two_view/rectification.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

struct MatchSources {
  std::optional<std::string> left, right;         // file names
  std::optional<std::string> truth, truth_right;  // file names
  std::optional<double> truth_scale;              // value stored in the files for 1 px of disparity
  std::optional<std::string> cameras;             // a file, for pictures that are not rectified
  std::optional<std::string> scene;
  PictureOptions picture;  // options for `scene`
};

struct MatchInput {
  std::string description;  // "cones/im2.ppm, cones/im6.ppm, 450 x 375"
  Image<Rgba8> left, right;
  std::optional<views::StereoTruth> truth;
  std::optional<Image<std::uint8_t>> is_textured;  // only for a rendered pair
  // Only for a rendered pair, or a pair that was rectified.
  std::optional<views::Calibration> calibration;
  std::optional<views::Rectification> rectification;  // set if the pictures were rectified
  // The method by which the visible pixels were found, in words.
  std::string visible_by;
};

// Reads the files or draws the scene. The command has checked that either files or a scene is
// given.
Result<MatchInput> read_match_input(const MatchSources& sources, Progress& progress);

// The range of whole disparities that contains the true ones, and one more on either side; the
// default range if no true disparity is known.
views::DisparityRange range_of(const views::StereoTruth& truth);

}  // namespace glassbox::views
