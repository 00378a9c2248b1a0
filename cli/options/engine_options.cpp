#include "cli/options/engine_options.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox {

namespace {

const char* const kGroup = "Engine";

constexpr std::size_t kLongWord = 100;

std::string names_of(const std::vector<Target>& targets, const char* separator) {
  std::string names;
  for (const Target target : targets) {
    names += (names.empty() ? "" : separator) + std::string(name_of(target));
  }
  return names;
}

int parse_threads(const std::string& text) {
  const double threads = parse_number("--threads", text);
  if (!(threads >= 1 && threads <= kMaxThreads) || threads != std::floor(threads)) {
    throw CLI::ValidationError(
        "--threads", fmt::format("needs a whole number from 1 to {}, not '{}'", kMaxThreads,
                                 printable(text, kLongWord)));
  }
  return int(threads);
}

// Sets the number of threads for the whole program, because other work, such as the compression of
// pictures, uses threads too.
void set_threads(const std::string& text, EngineOptions& options) {
  using Control = oneapi::tbb::global_control;
  // The object is never destroyed: to lift the limit when the program ends would wake a thread.
  static auto& most = *new std::optional<Control>;
  options.tile.threads = parse_threads(text);
  most.emplace(Control::max_allowed_parallelism, std::size_t(options.tile.threads));
}

Target parse_target(const std::string& text) {
  const std::vector<Target> available = available_targets();
  const auto target = target_named(CLI::detail::to_lower(text));
  if (!target) {
    throw CLI::ValidationError("--target",
                               fmt::format("needs one of {}, not '{}'", names_of(available, "|"),
                                           printable(text, kLongWord)));
  }
  if (std::ranges::find(available, *target) == available.end()) {
    throw CLI::ValidationError(
        "--target", fmt::format("{} is not available here; use one of {}", name_of(*target),
                                names_of(available, ", ")));
  }
  return *target;
}

int threads_of(const EngineOptions& options) {
  return options.tile.threads > 0 ? options.tile.threads : default_threads();
}

}  // namespace

CLI::Option* add_target_option(CLI::App& command, Target& target) {
  return command
      .add_option_function<std::string>(
          "--target", [&target](const std::string& text) { target = parse_target(text); },
          fmt::format("processor instructions to use [{}]", name_of(best_target())))
      ->type_name(names_of(available_targets(), "|"))
      ->group(kGroup);
}

void add_engine_options(CLI::App& command, EngineOptions& options) {
  add_choice(command, "--engine", options.engine,
             choices_of({EngineKind::kTile, EngineKind::kStaged}),
             "the engine that draws: tile is fast, staged is the reference; both give the same "
             "bytes [tile]")
      ->group(kGroup);
  options.tile_only_options = {
      command
          .add_option_function<std::string>(
              "--threads", [&options](const std::string& text) { set_threads(text, options); },
              "threads of the tile engine and of all other work [one for each processor]")
          ->type_name("N")
          ->group(kGroup),
      add_target_option(command, options.tile.target),
      command
          .add_flag_callback(
              "--no-plan", [&options] { options.tile.plan = false; },
              "do all the work, even what this scene does not need")
          ->group(kGroup)};
}

Result<void> check_engine_options(const EngineOptions& options) {
  if (options.engine == EngineKind::kTile) return {};
  for (const CLI::Option* option : options.tile_only_options) {
    if (option->count() == 0) continue;
    return fail(option->get_name(),
                "this is an option of the tile engine, but --engine staged is given",
                "leave one of the two out");
  }
  return {};
}

Renderer make_renderer(const Scene& scene, const RenderSettings& settings,
                       const EngineOptions& options) {
  return {scene, settings.transfer, options.engine, options.tile};
}

std::string engine_text(const EngineOptions& options) {
  if (options.engine == EngineKind::kStaged) return "the staged engine";
  return fmt::format("the tile engine, {}, {}", counted(threads_of(options), "thread"),
                     name_of(options.tile.target));
}

nlohmann::ordered_json engine_json(const EngineOptions& options) {
  if (options.engine == EngineKind::kStaged) return {{"name", name_of(options.engine)}};
  return {{"name", name_of(options.engine)},
          {"threads", threads_of(options)},
          {"target", name_of(options.tile.target)},
          {"plan", options.tile.plan}};
}

}  // namespace glassbox
