#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

namespace {

TestedEngine make_tested_engine(const std::string& name, EngineKind kind,
                                const TileOptions& options) {
  const auto renderer = [=](const Scene& scene, Transfer transfer) {
    return Renderer(scene, transfer, kind, options);
  };
  return {name,
          [=](const Scene& scene, const View& view, const RenderSettings& settings) {
            return renderer(scene, settings.transfer).render(view, settings);
          },
          renderer};
}

std::vector<TestedEngine> all_engines() {
  std::vector<TestedEngine> all{make_tested_engine("staged", EngineKind::kStaged, {})};
  for (const Target target : available_targets()) {
    all.push_back(
        tile_engine("tile, " + std::string(name_of(target)), {.threads = 2, .target = target}));
  }
  all.push_back(tile_engine("tile, no plan", {.threads = 1, .plan = false}));
  return all;
}

}  // namespace

TestedEngine tile_engine(const std::string& name, const TileOptions& options) {
  return make_tested_engine(name, EngineKind::kTile, options);
}

const std::vector<TestedEngine>& tested_engines() {
  static const std::vector<TestedEngine> all = all_engines();
  return all;
}

}  // namespace glassbox::study
