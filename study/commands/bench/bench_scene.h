// Which scene is measured, and how it is drawn: the same options for the program and for the other
// renderer (the peer).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/arguments.h"
#include "cli/options/cli_fwd.h"
#include "study/scenes/scenes.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

struct BenchDrawing {
  Size size{1920, 1080};
  std::optional<int> samples;  // absent: the scene's own number
  bool anaglyph = false;
};

// Adds --size, --samples and --stereo.
void add_bench_drawing(CLI::App& command, BenchDrawing& drawing);

// The options as words of a command line. After the scene's name, these words draw the same
// picture.
std::vector<std::string> words_of(const BenchDrawing& drawing);

// Loads a scene of the benchmark (S1, R1), a built-in one, or a file.
Result<study::BenchScene> load_bench_scene(const std::string& name, const BenchDrawing& drawing);

// The names of the scenes that are measured if the command line names no scene.
std::vector<std::string> all_bench_scenes();

// The path of the mesh file that a scene of the benchmark needs, if that file is missing.
std::optional<std::string> missing_asset(const std::string& name);

std::string bench_scene_help();

}  // namespace glassbox::study
