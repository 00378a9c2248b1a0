// Which convention would make a point visible? Each likely slip is undone, one at a time, and the points are sent through
// again; what brings them into the picture is reported, the likeliest first, with what speaks for it.
//
// Nothing here can know what was meant: several changes may do, and all that do are listed. Changes that would spoil a matrix
// which is sound as it stands (transposing a rigid view, say) are only counted.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/step/matrices/slips.h"

namespace glassbox {

struct CheckedPoint {
  glm::dvec4 object{0, 0, 0, 1};
  std::optional<glm::dvec2> expected;  // window coordinates where it should appear
};

// An expected place is met within this many pixels in x and y: one, and the half between a pixel's corner and its centre.
inline constexpr double kExpectedWithinPx = 1.5;

struct Alternative {
  Change change;
  std::optional<Change> second;  // of two together
  const char* id = "";           // of `change`: stable
  const char* second_id = "";
  std::string what, remedy;          // "transpose every matrix"
  std::vector<std::string> reasons;  // what speaks for it, besides that it works
  int points = 0;                    // how many land where they should
  double score = 0;                  // what the reasons weigh; only the order means something
  std::optional<glm::dvec2> window;  // where the first of the points lands
};

struct ConventionsReport {
  int points = 0;
  int visible = 0;                        // as given; with `expected`, at their places
  int behind_eye = 0;                     // as given: w < 0
  std::vector<Alternative> alternatives;  // those that improve on `visible`, the likeliest first
  int spoiling = 0;                       // changes that would do, too, but spoil a sound matrix
};

// Two changes together are tried where no point is visible and no single one brings them all into the picture; those that
// bring more of them than any single one are reported.
ConventionsReport check_conventions(const MatrixSetup& setup, const Viewport& viewport,
                                    std::span<const CheckedPoint> points);

}  // namespace glassbox
