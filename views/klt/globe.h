// Clouds on a globe: a component becomes the alpha of a shell around a ball.
#pragma once

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

#include "views/klt/bands.h"

namespace glassbox::views {

// A picture of clouds: white pixels whose alpha grows from 0 at the component's median to 255 at
// its 99th percentile (or at its 1st percentile, if that is further from the median). The sign of a
// component is arbitrary; clouds are taken to be the side with the longer tail, because they are
// rarer than clear sky.
Image<Rgba8> cloud_alpha(const Bands& component);

// A ball of radius 1 with the ground as its texture and a shell of radius 1.015 with the clouds,
// both centred at the world's origin and lit by a sun. Each picture covers the whole planet,
// longitude across.
Scene make_globe(const Image<Rgba8>& ground, const Image<Rgba8>& clouds);

}  // namespace glassbox::views
