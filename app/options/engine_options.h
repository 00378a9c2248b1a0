// Which engine draws a picture, and how. No byte of the picture depends on it, so that a picture's recipe does not say it.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

// More than any machine has: beyond it, it is a slip of the finger.
inline constexpr int kMostThreads = 1024;

struct EngineOptions {
  EngineKind engine = EngineKind::kTile;
  TileOptions tile;
  std::vector<const CLI::Option*> of_tiles;  // those that only the tile engine has
};

void add_engine_options(CLI::App& command, EngineOptions& options);

// --target alone.
CLI::Option* add_target_option(CLI::App& command, Target& target);

// Options of the one engine with the other.
Result<void> check_engine_options(const EngineOptions& options);

Renderer make_renderer(const Scene& scene, const RenderSettings& settings,
                       const EngineOptions& options);

// "the tile engine, 2 threads, avx512", "the staged engine".
std::string engine_text(const EngineOptions& options);
nlohmann::ordered_json engine_json(const EngineOptions& options);

}  // namespace glassbox::app
