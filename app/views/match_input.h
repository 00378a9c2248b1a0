// The pair of `glassbox views match`: two files, or a scene drawn twice, and what is known of its disparities.
#pragma once

#include <optional>
#include <string>

#include "app/options/picture_options.h"
#include "views/matching/calibration.h"
#include "views/matching/evaluate.h"
#include "views/matching/settings.h"
#include "views/two_view/rectification.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

class Progress;

struct MatchSources {
  std::optional<std::string> left, right;         // files
  std::optional<std::string> truth, truth_right;  // files
  std::optional<double> truth_scale;              // what is stored for a pixel of disparity
  std::optional<std::string> cameras;             // file: of pictures that are not rectified
  std::optional<std::string> scene;
  PictureOptions picture;  // of the scene
};

struct MatchInput {
  std::string about;  // "cones/im2.ppm, cones/im6.ppm, 450 x 375"
  Image<Rgba8> left, right;
  std::optional<views::StereoTruth> truth;
  std::optional<Image<std::uint8_t>> is_textured;  // of a rendered pair
  std::optional<views::Calibration> calibration;   // of a rendered pair, or one that was rectified
  std::optional<views::Rectification> rectification;  // where the pictures were turned
  std::string visible_by;                             // how the visible pixels were found, in words
};

// Either the files or the scene are given, as checked by the command.
Result<MatchInput> read_match_input(const MatchSources& sources, Progress& progress);

// The whole disparities that hold those of the truth, and a pixel more on either side; the default's where nothing is known.
views::DisparityRange range_of(const views::StereoTruth& truth);

}  // namespace glassbox::app
