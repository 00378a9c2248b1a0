// The features of a picture: corners at several scales, with their descriptors.
#pragma once

#include <variant>
#include <vector>

#include "views/features/bit_descriptor.h"
#include "views/features/corner_response.h"
#include "views/features/feature.h"
#include "views/features/gradient_descriptor.h"
#include "views/features/window_descriptor.h"

namespace glassbox::views {

struct FeatureSettings {
  Detector detector = Detector::kHarris;
  Description description = Description::kSift;
  int count = 2000;  // corners of a picture, at most
};

// At most so many scales are searched, and no scale where a picture is smaller than
// 2 kFeatureMargin + 1 pixels. Windows for correlation are found at scale 1 only, because they are
// meant for pictures of the same scale.
inline constexpr int kMostLevels = 8;

using Descriptors = std::variant<std::vector<WindowDescriptor>, std::vector<BitDescriptor>,
                                 std::vector<GradientDescriptor>>;

struct FeatureSet {
  int corners = 0;  // a corner with two directions gives two features
  std::vector<Feature> features;
  Descriptors descriptors;  // one for each feature
};

// The features, from the finest scale to the coarsest. Each scale's share of the corners is
// proportional to its number of pixels; corners that one scale lacks are taken from the next ones.
// None in a picture that is smaller than 2 kFeatureMargin + 1 pixels.
FeatureSet features_of(const Image<Rgba8>& picture, const FeatureSettings& settings);

}  // namespace glassbox::views
