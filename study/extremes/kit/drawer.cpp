#include "study/extremes/kit/drawer.h"

namespace glassbox::study {

namespace {

Drawer drawer_of(const std::string& name, EngineKind kind, const TileOptions& options) {
  const auto renderer = [=](const Scene& scene, Transfer transfer) {
    return Renderer(scene, transfer, kind, options);
  };
  return {name,
          [=](const Scene& scene, const View& view, const RenderSettings& settings) {
            return renderer(scene, settings.transfer).render(view, settings);
          },
          renderer};
}

std::vector<Drawer> all_drawers() {
  std::vector<Drawer> all{drawer_of("staged", EngineKind::kStaged, {})};
  for (const Target target : available_targets()) {
    all.push_back(
        tile_engine("tile, " + std::string(name_of(target)), {.threads = 2, .target = target}));
  }
  all.push_back(tile_engine("tile, no plan", {.threads = 1, .plan = false}));
  return all;
}

}  // namespace

Drawer tile_engine(const std::string& name, const TileOptions& options) {
  return drawer_of(name, EngineKind::kTile, options);
}

const std::vector<Drawer>& drawers() {
  static const std::vector<Drawer> all = all_drawers();
  return all;
}

}  // namespace glassbox::study
