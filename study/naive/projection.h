// Projections as beginners first write them, and depth that is rounded too often.
#pragma once

#include <cmath>

#include <glassbox/pipeline/projection.h>

namespace glassbox::study::naive {

// The matrix of gluPerspective as in its manual page, in float and without checks: near = far
// divides by zero, and far = infinity gives NaN.
inline Transform<Clip, Eye> unchecked_perspective(float fovy_degrees, float aspect, float near,
                                                  float far) {
  const float scale = 1 / std::tan(fovy_degrees * 3.14159265f / 360);
  Transform<Clip, Eye> m;
  m.at(0, 0) = scale / aspect;
  m.at(1, 1) = scale;
  m.at(2, 2) = -far / (far - near);
  m.at(2, 3) = -near * far / (far - near);
  m.at(3, 2) = -1;
  m.at(3, 3) = 0;
  return m;
}

// Computes depth from a point of the standard matrix, in float, and reverses it afterwards.
inline float depth_reversed_afterwards(const Point<Clip>& standard) {
  return 1 - standard.z / standard.w;
}
// Computes depth in the range -1 .. 1 of OpenGL, in float, and maps it to 0 .. 1 afterwards.
inline float depth_through_gl_remap(const Point<Clip>& reversed) {
  const float z_gl = (2 * reversed.z - reversed.w) / reversed.w;
  return (z_gl + 1) / 2;
}

}  // namespace glassbox::study::naive
