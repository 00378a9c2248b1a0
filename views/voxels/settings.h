// How voxels are coloured (S1-19, S1-31 to S1-35).
#pragma once

#include <cstdint>
#include <string_view>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// When the colours that pictures have where a voxel would be are called one colour. s: their standard deviation, pooled over three
// channels, with K - 1 below the sum of squares; K: how many pixels see it.
enum class Consistency {
  kDeviation,   // s < T
  kLikelihood,  // 3 (K - 1) s^2 / noise^2 below the quantile of its chi-squared law: it would be that much in `significance` of all
                // voxels that have one colour
  kAdaptive,  // s < k1 M + k2: M is the mean over the pictures of the deviation within each around the voxel
};
enum class ColorSpace { kRgb, kLab };
// Which pixels of a picture are a voxel's: that of its centre; those whose centres are in the box around its projection; those whose
// centres are in the projection, which is a convex hull. The pixel of its centre belongs to all three (C-87).
enum class Footprint { kCentre, kBox, kHull };
// When what has been coloured hides what is behind it: after its layer, or at once.
enum class Update { kLayer, kVoxel };
// What becomes of a voxel that one picture alone sees, about which nothing can be said (C-89).
enum class Alone { kReject, kKeep };

std::string_view name_of(Consistency consistency);
std::string_view name_of(ColorSpace space);
std::string_view name_of(Footprint footprint);
std::string_view name_of(Update update);
std::string_view name_of(Alone alone);

struct ColoringSettings {
  Consistency consistency = Consistency::kDeviation;
  double threshold = 18;        // T, levels of 0 .. 255; of CIELab its own units
  double noise = 6;             // of kLikelihood, the same units
  double significance = 0.001;  // of kLikelihood
  double k1 = 0.5, k2 = 8;      // of kAdaptive; k2 as the threshold
  ColorSpace space = ColorSpace::kRgb;
  double lightness = 0.5;  // of kLab: the weight of L
  // A voxel that shows an edge in all pictures is coloured whatever its colours are, if the deviation within each of them is at
  // least so much (S1-33); 0: never.
  double edge = 0;
  Footprint sampled = Footprint::kCentre;  // whose colours are compared
  Footprint hidden = Footprint::kBox;      // what a coloured voxel hides
  Update update = Update::kLayer;
  Alone alone = Alone::kReject;
  Target target = best_target();
  int threads = 0;  // 0: all; no byte depends on it
};

}  // namespace glassbox::views
