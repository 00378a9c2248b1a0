// glassbox views ring: draws calibrated pictures of a scene from all around it.
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "views/commands/commands.h"
#include "views/rings/draw_ring.h"
#include "views/rings/ring.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/render/engine/setting_names.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::views {

class ViewsRingCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  int run();

  std::string scene_, output_;
  Size size_{320, 320};
  views::RingOptions ring_;
  views::Matte matte_ = views::Matte::kDepth;
  std::optional<Shading> shading_;
  int samples_ = 1;
  Rgba8 background_{0, 0, 0, 255};
  std::optional<std::string> json_output_;
};

namespace {

using Json = nlohmann::ordered_json;

views::Vector3d vector_of(const std::string& option, const std::string& text) {
  const auto [x, y, z] = parse_numbers<3>(option, text);
  return {x, y, z};
}

std::vector<std::string> names_of(const std::vector<views::RingView>& ring) {
  std::vector<std::string> names;
  for (const views::RingView& view : ring) names.push_back(view.named.picture);
  return names;
}

}  // namespace

void ViewsRingCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command =
      *views.add_subcommand("ring", "draw calibrated pictures of a scene from all around it");
  command.footer(
      "Examples:\n"
      "  glassbox views ring teapot -o ring\n"
      "  glassbox views ring cube -o arc --views 9 --arc 90 --elevation 30\n"
      "  glassbox views ring teapot -o pairs --views 5 --pairs 0.2\n\n"
      "The folder has a picture and a mask for each camera, ring_par.txt with each camera's "
      "intrinsic\n"
      "matrix K, rotation R and translation t in the form of the Middlebury multi-view pictures, "
      "and\n"
      "box.txt with the scene's box. A scene without lights is drawn unlit: its default lamp is at "
      "the\n"
      "camera, so the colour of a surface would change from picture to picture.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command.add_option("-o,--output", output_, "the folder")->type_name("DIR")->required();
  command.add_option("--views", ring_.views, "cameras on each circle [21]")->type_name("N");
  command
      .add_option_function<std::string>(
          "--elevation",
          [this](const std::string& text) {
            ring_.elevations.clear();
            for (const std::string& part : split(text, ','))
              ring_.elevations.push_back(parse_number("--elevation", part));
          },
          "degrees above the target; several values give a circle each [20]")
      ->type_name("DEG[,DEG...]");
  command.add_option("--arc", ring_.arc_degrees, "degrees from the first camera to the last [360]")
      ->type_name("DEG");
  command
      .add_option("--start", ring_.start_degrees,
                  "angle of the first camera, from +z towards +x [0]")
      ->type_name("DEG");
  command
      .add_option_function<double>(
          "--distance", [this](const double& value) { ring_.distance = value; },
          "distance of the cameras from the target [so that every picture shows the whole scene]")
      ->type_name("D");
  command.add_option("--fov", ring_.fov_degrees, "full vertical angle of view, degrees [30]")
      ->type_name("DEG");
  command
      .add_option_function<std::string>(
          "--look-at",
          [this](const std::string& text) { ring_.target = vector_of("--look-at", text); },
          "the target that all cameras look at [the centre of the scene]")
      ->type_name("X,Y,Z");
  command
      .add_option_function<std::string>(
          "--up", [this](const std::string& text) { ring_.up = vector_of("--up", text); },
          "the axis of the circles [0,1,0]")
      ->type_name("X,Y,Z");
  command
      .add_option_function<double>(
          "--pairs", [this](const double& value) { ring_.pair_separation = value; },
          "put two cameras in each place, this far apart")
      ->type_name("D");
  command
      .add_option_function<std::string>(
          "--size", [this](const std::string& text) { size_ = parse_size(text); },
          "size of the pictures in pixels [320x320]")
      ->type_name("WxH");
  add_choice<views::Matte>(command, "--matte", matte_,
                           {{"depth", views::Matte::kDepth},
                            {"alpha", views::Matte::kAlpha},
                            {"none", views::Matte::kNone}},
                           "pixels of a mask: those whose centre shows a surface (depth), or those "
                           "that are half covered (alpha) [depth]");
  add_choice<std::optional<Shading>>(
      command, "--shade", shading_,
      choices_of({Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}),
      "where lighting is computed [phong for scenes with lights, else unlit]");
  add_choice<int>(command, "--samples", samples_,
                  {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}},
                  "samples per pixel, whose mean is the pixel's colour [1]");
  command
      .add_option_function<std::string>(
          "--background", [this](const std::string& text) { background_ = parse_background(text); },
          "background colour as displayed, each channel 0 .. 1 [0,0,0]")
      ->type_name("R,G,B");
  add_json_output(command, json_output_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int ViewsRingCommand::run() {
  if (json_output_ && *json_output_ != "-") {
    if (const auto good = check_outputs({*json_output_}); !good) return refuse(good.error());
  }
  Progress progress;
  const auto scene = load_scene_argument(scene_, progress);
  if (!scene) return refuse(scene.error());
  ring_.width = size_.width;
  ring_.height = size_.height;
  const auto ring = views::ring_views(*scene, ring_);
  if (!ring) return refuse(ring.error());
  if (json_output_ && *json_output_ != "-") {
    std::vector<std::string> files = views::files_of_set(output_, names_of(*ring));
    files.push_back(*json_output_);
    if (const auto good = check_distinct(files); !good) return refuse(good.error());
  }

  RenderSettings settings;
  const bool is_unlit = !shading_ && scene->lights.empty();
  settings.shading = shading_.value_or(is_unlit ? Shading::kUnlit : Shading::kPhong);
  settings.samples = samples_;
  settings.background = background_;
  auto writer = views::PictureSetWriter::open(output_);
  if (!writer) return refuse(writer.error());
  const auto drawn = views::draw_each(
      *scene, *ring, settings, matte_,
      [&](const views::CalibratedPicture& picture) { return writer->add(picture); },
      [&](const std::string& name) { progress.phase("drawing " + name); });
  if (!drawn) return refuse(drawn.error());
  const views::WorldBox box = views::box_of(*scene);
  if (const auto written = writer->close(box); !written) return refuse(written.error());
  progress.done();

  const views::PinholeCamera& first = ring->front().named.camera;
  const views::Vector3d target = ring_.target.value_or((box.low + box.high) / 2);
  const double distance = (first.centre - target).norm();
  if (json_output_) {
    const auto numbers = [](const views::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
    const Json json{{"folder", output_},
                    {"scene", scene_},
                    {"pictures", ring->size()},
                    {"width", size_.width},
                    {"height", size_.height},
                    {"target", numbers(target)},
                    {"distance", distance},
                    {"focal_px", first.intrinsic(0, 0)},
                    {"box", {numbers(box.low), numbers(box.high)}},
                    {"unlit", settings.shading == Shading::kUnlit}};
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}: {} of {} x {}, {:.6g} from the target, f = {:.6g} px\n",
             printable(output_, kLongestMessage), counted(ring->size(), "picture"), size_.width,
             size_.height, distance, first.intrinsic(0, 0));
  if (is_unlit)
    fmt::print(
        "  Left out: lighting. The scene has no lights, and a lamp at the camera would change "
        "colours\n"
        "  from picture to picture (--shade).\n");
  if (matte_ == views::Matte::kNone) fmt::print("  Left out: masks (--matte).\n");
  return kSuccess;
}

void add_ring_command(CLI::App& views, int& exit_code) {
  add_command<ViewsRingCommand>(views, exit_code);
}

}  // namespace glassbox::views
