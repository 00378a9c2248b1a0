// Draws the pictures of a ring of cameras.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>

#include "views/rings/picture_set.h"
#include "views/rings/ring.h"

namespace glassbox::views {

// Which pixels belong to the matte: those whose centre shows a surface (depth), those of whose
// samples at least half do (alpha), or no matte at all.
enum class Matte { kDepth, kAlpha, kNone };

// Draws one picture after the other and passes each to `take`; an error from `take` ends the
// drawing. The pictures are opaque. `report_progress` is called with the name of each picture
// before it is drawn.
Result<void> draw_each(const Scene& scene, const std::vector<RingView>& ring,
                       RenderSettings settings, Matte matte,
                       const std::function<Result<void>(CalibratedPicture)>& take,
                       const std::function<void(const std::string&)>& report_progress = {});

// All pictures of the ring, together with the scene's box.
PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring,
                     const RenderSettings& settings, Matte matte);

}  // namespace glassbox::views
