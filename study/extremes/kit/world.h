// Short names of what cases about cameras and matrices are full of.
#pragma once

#include <cmath>

#include <glassbox/base/error.h>
#include <glassbox/base/spaces.h>

namespace glassbox::study {

using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;
using EyeFromWorld = Transform<Eye, World>;
using WorldMap = Transform<World, World>;

template <class Space>
double length(const Vector<Space, double>& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace glassbox::study
