// Clouds on a globe: a component becomes the alpha of a shell around a ball.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

#include "views/klt/bands.h"

namespace glassbox::views {

// White pixels, with an alpha of 0 where the component is at most its median and 255 where it is at
// least its 99th percentile. The sign of a component is arbitrary; clouds are taken to be the side
// with the longer tail, because they are rarer than clear sky.
Image<Rgba8> cloud_alpha(const Bands& component);

// A ball of radius 1 with the ground as its texture and a shell of radius 1.015 with the clouds,
// both centred at the world's origin and lit by a sun. Each picture covers the whole planet,
// longitude across.
Scene make_globe(const Image<Rgba8>& ground, const Image<Rgba8>& clouds);

}  // namespace glassbox::views
