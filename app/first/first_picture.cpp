#include "app/first/first_picture.h"

#include <chrono>
#include <string>

#include <fmt/format.h>

#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/shell_line.h"
#include "cli/report/stage_report.h"

#include <glassbox/base/elapsed.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/tile/tile_engine.h>

namespace glassbox::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kScene = "teapot";
constexpr const char* kFile = "teapot.png";
constexpr int kWidth = 1280, kHeight = 720;

std::string next_steps() {
  const std::string program = program_name();
  const auto line = [&](const std::string& arguments, const std::string& purpose) {
    return fmt::format("  {:<56}{}\n", program + " " + arguments, purpose);
  };
  return "try next:\n" + line("render teapot --shade flat -o flat.png", "one colour per face") +
         line("render forest --show depth -o depth.png", "the distance of each surface") +
         line("render YOUR.glb --stats", "your own scene (glTF, GLB, OBJ or PLY)") +
         line("info YOUR.glb", "what is in this scene, and which mistakes it has") +
         line("render --help", "cameras, shading, depth formats, outputs");
}

Result<View> framed_view(const Scene& scene) {
  return framing_camera(scene, double(kWidth) / kHeight).and_then([](const Camera& camera) {
    return make_view(camera, kWidth, kHeight, DepthRange::kStandard);
  });
}

// Draws and writes the picture that `glassbox render teapot` makes.
Result<Rendering> render_and_write() {
  const Result<Scene> scene = make_builtin(kScene);
  if (!scene) return tl::unexpected(scene.error());
  const Result<View> view = framed_view(*scene);
  if (!view) return tl::unexpected(view.error());
  Rendering rendering = render_tiled(*scene, *view, {});
  const Recipe recipe{kScene, {}, GLASSBOX_VERSION};
  return write_image(kFile, rendering.buffers.color, to_text(recipe)).map([&] {
    return std::move(rendering);
  });
}

}  // namespace

int draw_first_picture() {
  const Clock::time_point start = Clock::now();
  const Result<Rendering> rendering = render_and_write();
  if (!rendering) return refuse(rendering.error());
  const Statistics& statistics = rendering->statistics;
  const double total_ms = elapsed_ms(start);
  fmt::print("{}\n{}\n", stage_table(statistics, EngineKind::kTile), time_table(statistics));
  fmt::print("{} ({} x {}): {} triangles, {:.0f} ms\n\n{}", kFile, kWidth, kHeight,
             statistics.triangles, total_ms, next_steps());
  return kSuccess;
}

}  // namespace glassbox::app
