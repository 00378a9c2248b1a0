#include <glassbox/render/visible_depth_span.h>

#include <algorithm>
#include <cmath>

namespace glassbox {

namespace {

constexpr float kProbePixels = 256;

View smaller(const View& view) {
  const float width = view.viewport.width(), height = view.viewport.height();
  const float share = std::min(1.0f, kProbePixels / std::max(width, height));
  View probe = view;
  probe.viewport = {0, 0, std::max(1.0f, std::floor(width * share)),
                    std::max(1.0f, std::floor(height * share))};
  return probe;
}

}  // namespace

std::optional<DepthSpan> depth_span(const Image<float>& distances) {
  std::optional<DepthSpan> span;
  for (const float distance : distances.pixels) {
    if (std::isinf(distance)) continue;
    if (!span) span = DepthSpan{double(distance), double(distance)};
    span->nearest = std::min(span->nearest, double(distance));
    span->farthest = std::max(span->farthest, double(distance));
  }
  return span;
}

std::optional<DepthSpan> visible_depth_span(Renderer& renderer, const View& centre,
                                            const RenderSettings& settings) {
  RenderSettings probe = with_one_sample(settings);
  probe.shading = Shading::kUnlit;
  probe.show = Show::kColor;
  probe.want_distance = true;
  probe.want_id = false;
  return depth_span(renderer.render(smaller(centre), probe).buffers.distance);
}

}  // namespace glassbox
