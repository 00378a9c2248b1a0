#include "study/curve/drawers.h"

#include <utility>

namespace glassbox::study {

Drawers::Drawers(const Scene& scene, ViewOf view, const std::map<int, Scene>* at_levels)
    : scene_(scene), view_(std::move(view)), at_levels_(at_levels) {}

const Scene& Drawers::scene_of(const Way& way) {
  if (way.level) return at_levels_->at(*way.level);
  if (!way.filter) return scene_;
  const auto found = filtered_.find(*way.filter);
  if (found != filtered_.end()) return found->second;
  return filtered_.emplace(*way.filter, with_filter(scene_, *way.filter)).first->second;
}

Renderer& Drawers::renderer_of(const Way& way) {
  const Key key{way.level.value_or(0),
                way.filter ? 1 + int(*way.filter) : 0,
                way.engine,
                way.tile.target,
                way.tile.threads,
                way.tile.plan};
  std::unique_ptr<Renderer>& renderer = renderers_[key];
  if (renderer == nullptr) {
    renderer =
        std::make_unique<Renderer>(scene_of(way), way.settings.transfer, way.engine, way.tile);
  }
  return *renderer;
}

Result<View> Drawers::view_of(const Way& way) {
  const auto found = views_.find(way.settings.depth);
  if (found != views_.end()) return found->second;
  return view_(way.settings, 1).map([&](const View& view) {
    return views_.emplace(way.settings.depth, view).first->second;
  });
}

Image<Rgba8> Drawers::draw(const Way& way) {
  return std::move(renderer_of(way).render(*view_of(way), way.settings).buffers.color);
}

std::vector<Timed> frame_times(Drawers& drawers, const std::vector<Way>& ways, int repetitions) {
  std::vector<TimedWork> works;
  for (const Way& way : ways) {
    works.push_back({[&drawers, &way] { drawers.draw(way); }, 1, way.threads()});
  }
  return time_in_turn(works, repetitions);
}

}  // namespace glassbox::study
