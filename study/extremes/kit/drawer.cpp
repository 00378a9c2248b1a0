#include "study/extremes/kit/drawer.h"

namespace glassbox::study {

Drawer tile_engine(const std::string& name, const TileOptions& options) {
  return {name, [options](const Scene& scene, const View& view, const RenderSettings& settings) {
            return render_tiled(scene, view, settings, options);
          }};
}

namespace {

std::vector<Drawer> all_drawers() {
  std::vector<Drawer> all{
      {"staged", [](const Scene& scene, const View& view, const RenderSettings& settings) {
         return render_staged(scene, view, settings);
       }}};
  for (const Target target : available_targets()) {
    all.push_back(
        tile_engine("tile, " + std::string(name_of(target)), {.threads = 2, .target = target}));
  }
  all.push_back(tile_engine("tile, no plan", {.threads = 1, .plan = false}));
  return all;
}

}  // namespace

const std::vector<Drawer>& drawers() {
  static const std::vector<Drawer> all = all_drawers();
  return all;
}

}  // namespace glassbox::study
