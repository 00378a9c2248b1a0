// Which features of two pictures show the same point.
#pragma once

#include <limits>
#include <vector>

#include "views/features/features.h"
#include "views/two_view/match.h"

namespace glassbox::views {

struct MatchRules {
  // The ratio test (Lowe 2004, section 7.1): the distance to the nearest descriptor is at most this
  // many times the distance to the second nearest, which is at another place. 1: no test.
  double ratio = 0.8;
  // The left feature is also the nearest of the right one.
  bool cross_check = true;
  // The largest difference of x, and of y, between the two positions, px.
  double search = std::numeric_limits<double>::infinity();
};

struct FeatureMatch {
  int left = 0, right = 0;  // numbers of the features
  double distance = 0;      // of the descriptors, in their own unit
  double ratio = 0;         // to the second nearest; 0 if there is no second one
};

// Two features are at one place if their positions differ by at most kSamePlace pixels of the
// coarser one's level, in x and in y: one corner is found at several scales.
inline constexpr double kSamePlace = 3;

// The matches in the order of the left features. If the features of several matches are at one
// place in both pictures, the match of the finest left feature is kept, and the one of least
// distance if there are several of these. Both sets must have the same kind of descriptor. All
// pairs are compared: the time is proportional to the product of the numbers of features.
std::vector<FeatureMatch> match_features(const FeatureSet& left, const FeatureSet& right,
                                         const MatchRules& rules);

// The positions of the matches, px from the pictures' top left corners.
Matches positions_of(const FeatureSet& left, const FeatureSet& right,
                     const std::vector<FeatureMatch>& matches);

}  // namespace glassbox::views
