// The settings of voxel colouring (S1-19, S1-31 to S1-35).
#pragma once

#include <cstdint>
#include <string_view>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The test whether the colours of a voxel in the pictures are taken for one colour. K is the number
// of pixels that see the voxel; s is the standard deviation of their colours, pooled over three
// channels and with K - 1 as the divisor.
enum class Consistency {
  kDeviation,  // s < T, the threshold
  // 3 (K - 1) s^2 / noise^2 is below a quantile of the chi-squared distribution: the number that a
  // fraction `significance` of all voxels that do have one colour exceeds.
  kLikelihood,
  // s < k1 M + k2, where M is the mean over the pictures of the deviation within each picture
  // around the voxel.
  kAdaptive,
};
enum class ColorSpace { kRgb, kLab };
// The pixels of a picture that belong to a voxel: the pixel of its centre; those whose centres are
// in the bounding box of its projection; or those whose centres are in the projection, which is a
// convex hull. The pixel of its centre always belongs to the footprint (C-87).
enum class Footprint { kCentre, kBox, kHull };
// When a coloured voxel begins to hide what is behind it: after its layer, or at once.
enum class OcclusionUpdate { kLayer, kVoxel };
// The decision about a voxel that only one picture sees, so that colours cannot be compared (C-89).
enum class SingleViewPolicy { kReject, kKeep };

std::string_view name_of(Consistency consistency);
std::string_view name_of(ColorSpace space);
std::string_view name_of(Footprint footprint);
std::string_view name_of(OcclusionUpdate update);
std::string_view name_of(SingleViewPolicy alone);

struct ColoringSettings {
  Consistency consistency = Consistency::kDeviation;
  double threshold = 18;  // T, levels of 0 .. 255; for CIELab in its own units
  double noise = 6;       // for kLikelihood, in the units of the threshold
  // For kLikelihood: fraction of the voxels of one colour that are rejected.
  double significance = 0.001;
  double k1 = 0.5, k2 = 8;  // for kAdaptive; k2 in the threshold's units
  ColorSpace space = ColorSpace::kRgb;
  double lightness = 0.5;  // for kLab: the weight of L
  // A voxel at an edge in all pictures is coloured in spite of different colours, if the deviation
  // within each picture is at least this (S1-33); 0: never.
  double edge = 0;
  Footprint sampled = Footprint::kCentre;  // the pixels whose colours are compared
  Footprint hidden = Footprint::kBox;      // the pixels that a coloured voxel hides
  OcclusionUpdate update = OcclusionUpdate::kLayer;
  SingleViewPolicy alone = SingleViewPolicy::kReject;
  Target target = best_target();
  int threads = 0;  // 0: as many as the machine has; the result does not depend on it
};

}  // namespace glassbox::views
