// Projections as beginners first write them, and depth that is rounded too often.
#pragma once

#include <cmath>

#include <glassbox/pipeline/projection.h>

namespace glassbox::study::naive {

// gluPerspective as in the manual page, in float and unchecked: n = f divides by zero, f = infinity
// gives NaN.
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

// Computes depth with the standard matrix or with OpenGL's, both in float, and reverses it
// afterwards.
inline float depth_reversed_afterwards(const Point<Clip>& standard) {
  return 1 - standard.z / standard.w;
}
inline float depth_through_gl_remap(const Point<Clip>& reversed) {
  const float z_gl = (2 * reversed.z - reversed.w) / reversed.w;
  return (z_gl + 1) / 2;
}

}  // namespace glassbox::study::naive
