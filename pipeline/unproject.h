// The way back, from a pixel and its depth to the world (S3-03, C-20), in double.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The world point that is drawn at (x, y) pixels with the depth z of NDC. Solves the projection's own equations, whose
// zeros are known, rather than inverting a 4x4 matrix. An error if no finite point has that depth (the depth of
// infinity, or beyond it).
Result<Point<World, double>> unproject(const View& view, const Point<Screen, double>& screen);

// How far the distance along the gaze moves for a change of 1 in depth, at that distance: (A z + B)'s derivative turned
// round. z^2 (f - n)/(f n) for perspective (SPEC C, bound 8), f - n for parallel projections; times the depth's own
// error it is the error of the distance. Float depth near 1 carries up to 2^-25, so a distance z is known to about
// u z/n of itself; reversed depth, whose error shrinks with it, keeps 7 digits everywhere.
double distance_per_depth(const View& view, double distance);

}  // namespace glassbox
