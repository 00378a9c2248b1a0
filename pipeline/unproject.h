// From a pixel and its depth back to the world (S3-03, C-20), in double.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

// The world point that is drawn at (x, y) pixels with the NDC depth z. It solves the projection's
// own equations, whose zero entries are known, instead of inverting a 4x4 matrix. It is an error if
// no finite point has that depth (the depth of infinity, or beyond it).
Result<Point<World, double>> unproject(const View& view, const Point<Screen, double>& screen);

// How much the distance along the gaze changes for a change of 1 in depth, at that distance: the
// reciprocal of the depth's derivative. With the distance z and the near and far planes n and f it
// is z^2 (f - n)/(f n) for perspective (docs/references.md, bound 8) and f - n for parallel
// projections. Multiplied by the error of the depth, it is the error of the distance. Float depth
// near 1 has an error of up to 2^-25, so a distance z is known to a relative error of about u z/n
// (u is the unit roundoff, 2^-24). Reversed depth is near 0 for distant points, where floats are
// finer, so it keeps 7 digits everywhere.
double distance_per_depth(const View& view, double distance);

}  // namespace glassbox
