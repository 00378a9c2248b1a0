// Which scene is measured, and how it is drawn: the same words for the program and for the peer beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/arguments.h"
#include "app/options/cli_fwd.h"
#include "study/scenes/scenes.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

struct BenchDrawing {
  Size size{1920, 1080};
  std::optional<int> samples;  // absent: as the scene has them
  bool anaglyph = false;
};

// --size, --samples and --stereo.
void add_bench_drawing(CLI::App& command, BenchDrawing& drawing);

// Whoever gives these words after the scene's name draws the same.
std::vector<std::string> words_of(const BenchDrawing& drawing);

// A scene of the benchmark (S1, R1), a built-in one, or a file.
Result<study::BenchScene> load_bench_scene(const std::string& name, const BenchDrawing& drawing);

// The names of those that are measured if none is named.
std::vector<std::string> all_bench_scenes();

// The file that a scene of the benchmark shows and that is not there.
std::optional<std::string> missing_asset(const std::string& name);

std::string bench_scene_help();

}  // namespace glassbox::app
