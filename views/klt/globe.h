// Clouds on a globe: a component as the alpha of a shell around a ball.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

#include "views/klt/bands.h"

namespace glassbox::views {

// White, with an alpha of 0 where the component is at most its median, 255 where at least its 99th percentile. The side that is up is the
// one with the longer tail: clouds are rarer than clear sky.
Image<Rgba8> cloud_alpha(const Bands& component);

// A ball of radius 1 with the ground as its texture and a shell of radius 1.015 with the clouds, both around the world's origin, lit by a
// sun. Pictures are a whole planet each, longitude across.
Scene make_globe(const Image<Rgba8>& ground, const Image<Rgba8>& clouds);

}  // namespace glassbox::views
