// The staged reference: every stage in order, one primitive at a time. The picture it makes is the definition of the
// right picture.
#pragma once

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/framebuffer.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox {

struct Rendering {
  Framebuffer buffers;
  Statistics statistics;
};

// An image of the viewport's size. The view comes from make_view (which checks the camera), with
// DepthRange::kReversed if and only if the settings' depth format is reversed. `observer` (none: nullptr) is called at every
// stage.
Rendering render_staged(const Scene& scene, const View& view, const RenderSettings& settings,
                        Observer* observer = nullptr);

}  // namespace glassbox
