#include "study/curve/renderer_cache.h"

#include <utility>

namespace glassbox::study {

RendererCache::RendererCache(const Scene& scene, ViewOf view, const std::map<int, Scene>* at_levels)
    : scene_(scene), view_(std::move(view)), at_levels_(at_levels) {}

const Scene& RendererCache::scene_of(const RenderVariant& variant) {
  if (variant.level) return at_levels_->at(*variant.level);
  if (!variant.filter) return scene_;
  const auto found = filtered_.find(*variant.filter);
  if (found != filtered_.end()) return found->second;
  return filtered_.emplace(*variant.filter, with_filter(scene_, *variant.filter)).first->second;
}

Renderer& RendererCache::renderer_of(const RenderVariant& variant) {
  const Key key{variant.level.value_or(0),
                variant.filter ? 1 + int(*variant.filter) : 0,
                variant.engine,
                variant.tile.target,
                variant.tile.threads,
                variant.tile.plan};
  std::unique_ptr<Renderer>& renderer = renderers_[key];
  if (renderer == nullptr) {
    renderer = std::make_unique<Renderer>(scene_of(variant), variant.settings.transfer,
                                          variant.engine, variant.tile);
  }
  return *renderer;
}

Result<View> RendererCache::view_of(const RenderVariant& variant) {
  const auto found = views_.find(variant.settings.depth);
  if (found != views_.end()) return found->second;
  return view_(variant.settings, 1).map([&](const View& view) {
    return views_.emplace(variant.settings.depth, view).first->second;
  });
}

Image<Rgba8> RendererCache::draw(const RenderVariant& variant) {
  return std::move(renderer_of(variant).render(*view_of(variant), variant.settings).buffers.color);
}

std::vector<Timed> frame_times(RendererCache& renderer_cache,
                               const std::vector<RenderVariant>& variants, int repetitions) {
  std::vector<TimedWork> works;
  for (const RenderVariant& variant : variants) {
    works.push_back(
        {[&renderer_cache, &variant] { renderer_cache.draw(variant); }, 1, variant.threads()});
  }
  return time_in_turn(works, repetitions);
}

}  // namespace glassbox::study
