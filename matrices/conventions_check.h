// Finds the convention that would make a point visible. Each likely mistake is
// undone, one at a time,
// and the points are transformed again. Changes that bring points into the picture are reported,
// the likeliest first, with the evidence for them.
//
// The check cannot know what the user meant: several changes may work, and all of them are listed.
// Changes that would spoil a matrix which is sound as given (such as transposing a rigid view) are
// only counted.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glassbox/matrices/convention_mistakes.h>

namespace glassbox {

struct CheckedPoint {
  glm::dvec4 object{0, 0, 0, 1};
  std::optional<glm::dvec2> expected;  // window coordinates where the point should appear
};

// The tolerance for an expected position, in px, in x and y: one pixel, plus the half between a
// pixel's corner and its centre.
inline constexpr double kExpectedWithinPx = 1.5;

struct Alternative {
  SetupChange change;
  std::optional<SetupChange> second;  // of two changes made together
  const char* id = "";                // of `change`; does not change between versions
  const char* second_id = "";
  std::string what, remedy;          // "transpose every matrix"
  std::vector<std::string> reasons;  // the evidence for it, besides that it works
  int points = 0;                    // number of points that are where they should be
  double score = 0;                  // sum of the reasons' weights; used for ordering only
  std::optional<glm::dvec2> window;  // window position of the first of the points
};

struct ConventionsReport {
  int points = 0;
  // with the matrices as given; with `expected`, only points at their positions
  int visible = 0;
  int behind_eye = 0;  // w < 0 with the matrices as given
  // changes that show more points than `visible`, likeliest first
  std::vector<Alternative> alternatives;
  // number of changes that would work too, but spoil a sound matrix
  int spoiling = 0;
};

// Checks the setup. Two changes together are tried only if no point is visible and no single change
// makes all visible. Those that make more points visible than any single change are reported.
ConventionsReport check_conventions(const MatrixSetup& setup, const Viewport& viewport,
                                    std::span<const CheckedPoint> points);

}  // namespace glassbox
