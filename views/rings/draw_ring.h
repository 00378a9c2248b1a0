// The pictures of a ring, drawn.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "views/rings/picture_set.h"
#include "views/rings/ring.h"

namespace glassbox::views {

// What a matte has: pixels whose centre shows a surface, or those of whose samples at least half do.
enum class Matte { kDepth, kAlpha, kNone };

// Draws one after the other and hands each to `take`, which ends it with an error. The pictures are opaque. `tell` is called with the
// name of each before it is drawn.
Result<void> draw_each(const Scene& scene, const std::vector<RingView>& ring,
                       RenderSettings settings, Matte matte,
                       const std::function<Result<void>(CalibratedPicture)>& take,
                       const std::function<void(const std::string&)>& tell = {});

// All of them, and the scene's box.
PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring,
                     const RenderSettings& settings, Matte matte);

}  // namespace glassbox::views
