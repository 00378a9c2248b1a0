#include "views/features/features.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "views/features/corners.h"
#include "views/features/scale_level.h"
#include "views/features/spread.h"

namespace glassbox::views {

namespace {

// How a level is described: which directions its corners have, and the descriptor for one of them.

struct WindowDescriber {
  explicit WindowDescriber(const Image<float>& level) : grey(level) {}
  std::vector<double> angles(const PictureCorner&) const { return {0}; }
  WindowDescriptor descriptor(const PictureCorner& at, double) const {
    return window_descriptor(grey, at.x, at.y);
  }
  const Image<float>& grey;
};

struct BitDescriber {
  explicit BitDescriber(const Image<float>& level) : grey(smoothed(level, kComparedSigma)) {}
  std::vector<double> angles(const PictureCorner& at) const {
    return {centroid_angle(grey, at.x, at.y)};
  }
  BitDescriptor descriptor(const PictureCorner& at, double angle) const {
    return bit_descriptor(grey, at.x, at.y, angle);
  }
  Image<float> grey;
};

struct GradientDescriber {
  explicit GradientDescriber(const Image<float>& level) : grey(level) {}
  std::vector<double> angles(const PictureCorner& at) const {
    return gradient_angles(grey, at.x, at.y);
  }
  GradientDescriptor descriptor(const PictureCorner& at, double angle) const {
    return gradient_descriptor(grey, at.x, at.y, angle);
  }
  const Image<float>& grey;
};

template <class Describer, class Descriptor>
void describe(const ScaleLevel& level, const std::vector<PictureCorner>& corners,
              std::vector<Feature>& features, std::vector<Descriptor>& descriptors) {
  const Describer describer(level.grey);
  std::vector<std::vector<std::pair<double, Descriptor>>> found(corners.size());
  tbb::parallel_for(std::size_t(0), corners.size(), [&](std::size_t i) {
    for (const double angle : describer.angles(corners[i])) {
      found[i].emplace_back(angle, describer.descriptor(corners[i], angle));
    }
  });
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PictureCorner& at = corners[i];
    for (const auto& [angle, descriptor] : found[i]) {
      features.push_back({at.x * level.scale, at.y * level.scale, level.scale, angle, at.strength});
      descriptors.push_back(descriptor);
    }
  }
}

bool is_large_enough(const Image<float>& grey) {
  return std::min(grey.width, grey.height) > 2 * kFeatureMargin;
}

// The share of a level among it and the `levels` - 1 coarser ones, by their numbers of pixels.
double share_of_first(int levels) {
  double sum = 0, pixels = 1;
  for (int i = 0; i < levels; ++i, pixels /= kScaleStep * kScaleStep) sum += pixels;
  return 1 / sum;
}

int levels_of(const Image<Rgba8>& picture, Description description) {
  if (description == Description::kNcc) return 1;
  int levels = 1;
  double side = std::min(picture.width, picture.height) / kScaleStep;
  for (; levels < kMostLevels && side > 2 * kFeatureMargin; ++levels) side /= kScaleStep;
  return levels;
}

template <class Describer, class Descriptor>
FeatureSet features_with(const Image<Rgba8>& picture, const FeatureSettings& settings) {
  FeatureSet set;
  std::vector<Descriptor> descriptors;
  ScaleLevel level = finest_level(picture);
  for (int left = levels_of(picture, settings.description); left > 0 && is_large_enough(level.grey);
       --left) {
    const int wanted = int(std::lround((settings.count - set.corners) * share_of_first(left)));
    const auto corners = spread_out(
        corners_of(response_map(level.grey, settings.detector), settings.detector, kFeatureMargin),
        wanted, level.grey.width, level.grey.height);
    set.corners += int(corners.size());
    describe<Describer>(level, corners, set.features, descriptors);
    if (left > 1) level = coarser_level(level);
  }
  set.descriptors = std::move(descriptors);
  return set;
}

}  // namespace

const char* name_of(Description description) {
  switch (description) {
    case Description::kNcc:
      return "ncc";
    case Description::kOrb:
      return "orb";
    case Description::kSift:
      break;
  }
  return "sift";
}

FeatureSet features_of(const Image<Rgba8>& picture, const FeatureSettings& settings) {
  switch (settings.description) {
    case Description::kNcc:
      return features_with<WindowDescriber, WindowDescriptor>(picture, settings);
    case Description::kOrb:
      return features_with<BitDescriber, BitDescriptor>(picture, settings);
    case Description::kSift:
      break;
  }
  return features_with<GradientDescriber, GradientDescriptor>(picture, settings);
}

}  // namespace glassbox::views
