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

// Which pixels belong to the matte, the mask of the object. kDepth: those whose centre shows a
// surface; kAlpha: those in which at least half of the samples show one; kNone: there is no matte.
enum class Matte { kDepth, kAlpha, kNone };

// Draws one picture after the other and passes each to `take`; an error from `take` ends the
// drawing. The pictures are opaque. `report_progress` is called with the name of each picture
// before it is drawn.
Result<void> draw_each(const Scene& scene, const std::vector<RingView>& ring,
                       RenderSettings settings, Matte matte,
                       const std::function<Result<void>(CalibratedPicture)>& take,
                       const std::function<void(const std::string&)>& report_progress = {});

// Draws all pictures of the ring; the set also has the scene's box.
PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring,
                     const RenderSettings& settings, Matte matte);

}  // namespace glassbox::views
