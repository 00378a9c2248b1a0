// Which engine draws a picture, and how. This choice does not change a byte of the picture, so it
// is not in a picture's recipe.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox {

// More threads than any machine has; a larger number is probably a typing error.
inline constexpr int kMaxThreads = 1024;

struct EngineOptions {
  EngineKind engine = EngineKind::kTile;
  TileOptions tile;
  std::vector<const CLI::Option*> tile_only_options;  // options that only the tile engine has
};

void add_engine_options(CLI::App& command, EngineOptions& options);

// Adds --target only.
CLI::Option* add_target_option(CLI::App& command, Target& target);

// Refuses options that only the tile engine has, if the staged engine is chosen.
Result<void> check_engine_options(const EngineOptions& options);

Renderer make_renderer(const Scene& scene, const RenderSettings& settings,
                       const EngineOptions& options);

// The engine in words: "the tile engine, 2 threads, avx512", "the staged engine".
std::string engine_text(const EngineOptions& options);
nlohmann::ordered_json engine_json(const EngineOptions& options);

}  // namespace glassbox
