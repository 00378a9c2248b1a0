// Random cameras for property tests.
#pragma once

#include <glassbox/base/random.h>

#include <cmath>

#include <glassbox/base/spaces.h>

namespace glassbox::test {

struct LookAtCase {
  Point<World, double> eye, target;
  Vector<World, double> up;
  double up_sine = 1;  // sine of the angle between up and the gaze
};

inline double length(const Vector<World, double>& v) {
  return std::sqrt(dot(v, v));
}

// A random camera: the eye is within 100 of the origin and the target within 10 on each axis; up
// has any direction that is at least 3 degrees from the gaze.
inline LookAtCase random_look_at(Random& random) {
  LookAtCase c;
  do {
    c.eye = {random.between(-100, 100), random.between(-100, 100), random.between(-100, 100)};
    c.target = {random.between(-10, 10), random.between(-10, 10), random.between(-10, 10)};
    c.up = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Vector<World, double> gaze = c.target - c.eye;
    c.up_sine = length(cross(gaze, c.up)) / (length(gaze) * length(c.up));
  } while (!(c.up_sine > 0.05));
  return c;
}

struct LensCase {
  double fovy_degrees = 45, aspect = 1, near = 0.1, far = 100;
};

inline LensCase random_lens(Random& random) {
  LensCase c;
  c.fovy_degrees = random.between(1, 175);
  c.aspect = random.scaled(1, 2, -3, 2);
  c.near = random.scaled(1, 2, -10, 3);
  c.far = c.near * random.scaled(1, 2, 1, 20);
  return c;
}

}  // namespace glassbox::test
