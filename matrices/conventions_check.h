// Finds the convention that would make a point visible. Each likely mistake is undone, one at a
// time, and the points are transformed again. Changes that bring points into the picture are
// reported, the likeliest first, with the evidence for each.
//
// The check cannot know what the user meant: several changes may work, and all of them are listed.
// Changes that would spoil a matrix which looks right as given (such as transposing a rigid view)
// are only counted.
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

// The tolerance in x and y for an expected position, in px: one pixel, plus the half pixel between
// the corner and the centre of a pixel.
inline constexpr double kExpectedWithinPx = 1.5;

struct Alternative {
  SetupChange change;
  std::optional<SetupChange> second;  // if two changes are made together, the second
  const char* id = "";                // of `change`; does not change between versions
  const char* second_id = "";
  std::string what, remedy;          // "transpose every matrix"
  std::vector<std::string> reasons;  // the evidence for it, besides that it works
  int points = 0;                    // the number of points that are where they should be
  double score = 0;                  // sum of the reasons' weights; used for ordering only
  std::optional<glm::dvec2> window;  // window position of the first of the points
};

struct ConventionsReport {
  int points = 0;
  // The number of points visible with the matrices as given; with `expected`, only points at their
  // expected positions.
  int visible = 0;
  int behind_eye = 0;  // the number of points with w < 0 with the matrices as given
  // The changes that make more points visible than `visible`, likeliest first.
  std::vector<Alternative> alternatives;
  // The number of changes that would work, too, but spoil a matrix which looks right as given.
  int spoiling = 0;
};

// Checks the setup. Pairs of changes are tried only if no point is visible and no single change
// makes all points visible. A pair is reported if it makes more points visible than any single
// change.
ConventionsReport check_conventions(const MatrixSetup& setup, const Viewport& viewport,
                                    std::span<const CheckedPoint> points);

}  // namespace glassbox
