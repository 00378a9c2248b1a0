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

// `tell` is called with the name of each picture before it is drawn. The pictures are opaque.
PictureSet draw_ring(const Scene& scene, const std::vector<RingView>& ring, RenderSettings settings,
                     Matte matte, const std::function<void(const std::string&)>& tell = {});

}  // namespace glassbox::views
