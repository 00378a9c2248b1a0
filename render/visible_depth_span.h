// The smallest and largest distance of what a camera sees. parallax_budget.h chooses the
// separation of the eyes by it.
#pragma once

#include <optional>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox {

// Returns the smallest and the largest finite distance in a framebuffer's distance image; nothing
// if nothing was drawn.
std::optional<DepthSpan> depth_span(const Image<float>& distances);

// Returns the same for a picture that is drawn for this purpose: it has the view's shape and is at
// most 256 pixels wide and high. Surfaces thinner than such a pixel may be missed, and so may
// surfaces that only the eyes see at the sides, outside the picture of the camera between them.
std::optional<DepthSpan> visible_depth_span(Renderer& renderer, const View& centre,
                                            const RenderSettings& settings);

}  // namespace glassbox
