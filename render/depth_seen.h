// How near and how far what a camera sees is: what comfort.h chooses the separation by.
#pragma once

#include <optional>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/stereo/comfort.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox {

// The least and the greatest finite distance of a framebuffer's distance plane; none where nothing was drawn.
std::optional<DepthSpan> depth_span(const Image<float>& distances);

// The same from a run of its own, in a picture of the view's shape and at most 256 pixels wide and high. What is thinner
// than such a pixel may be missed, and what only the eyes see, beside the picture of the camera between them.
std::optional<DepthSpan> depth_seen(Renderer& renderer, const View& centre,
                                    const RenderSettings& settings);

}  // namespace glassbox
