// glassbox views polygons: reconstructs the surface of a shape from calibrated pictures.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/polygons_report.h"
#include "views/commands/surface_page.h"
#include "views/polygons/mesh_scene.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::views {

class ViewsPolygonsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_input_options(CLI::App& command);
  void add_surface_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_options() const;
  Result<void> check_outputs() const;
  Result<void> complete_request(const views::PictureSet& set);
  Result<void> write_outputs(const PolygonsInput& input, const PolygonsReport& report) const;
  std::string command_line() const;

  PictureChoice choice_;
  std::optional<std::string> truth_;
  BoxOption box_;
  int resolution_ = 64;
  PolygonsRequest request_;
  std::optional<std::string> output_, left_out_output_, json_output_, page_;
  std::vector<const CLI::Option*> options_;
};

void ViewsPolygonsCommand::add_input_options(CLI::App& command) {
  add_picture_choice(command, choice_);
  command.add_option("--truth", truth_, "the true scene, with which the result is compared")
      ->type_name("SCENE")
      ->group("Pictures");
}

void ViewsPolygonsCommand::add_surface_options(CLI::App& command) {
  std::string group = "Voxels";
  add_box(command, box_);
  command
      .add_option("--resolution", resolution_,
                  fmt::format("voxels along the box's longest side [{}]", resolution_))
      ->type_name("N")
      ->check(CLI::Range(1, views::kMaxVoxelsAlong))
      ->group(group);
  command
      .add_option("--threshold", request_.voxels.settings.threshold,
                  "largest deviation (sigma) of a voxel's colours, in levels of 0 .. 255 [18]")
      ->type_name("T")
      ->group(group);
  add_choice(command, "--order", request_.voxels.order,
             choices_of({views::ColoringOrder::kAuto, views::ColoringOrder::kSweep,
                         views::ColoringOrder::kCarve}),
             "sweep: one sweep away from all cameras; carve: sweeps from all sides [sweep if the "
             "cameras allow it]")
      ->group(group);

  group = "Polygons";
  command
      .add_option("--polygon-threshold", request_.polygons.threshold,
                  fmt::format("largest deviation (sigma) of a polygon's colours, in levels of 0 .. "
                              "255; inf: carve by the background only [{}]",
                              request_.polygons.threshold))
      ->type_name("T")
      ->group(group);
  command
      .add_flag_callback(
          "--no-carving", [this] { request_.polygons.carves = false; },
          "keep the voxels' surface as it is")
      ->group(group);
  command
      .add_flag_callback(
          "--half-way", [this] { request_.polygons.is_smooth = false; },
          "put corners half way between voxels instead of where their surroundings are half full")
      ->group(group);

  command
      .add_option_function<int>(
          "--threads",
          [this](const int& threads) {
            request_.voxels.settings.threads = request_.polygons.threads = threads;
          },
          "number of threads; the result is always the same [one for each processor]")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads))
      ->group("Engine");
}

void ViewsPolygonsCommand::add_output_options(CLI::App& command) {
  const std::string group = "Outputs";
  command.add_option("-o,--output", output_, "the coloured surface: .glb or .ply")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--left-out-output", left_out_output_,
                  "the picture that was left out, drawn from the polygons: .png or .ppm")
      ->type_name("FILE")
      ->group(group);
  add_json_output(command, json_output_)->group(group);
  add_html_output(
      command, page_,
      "a page with the surface in 3D, which you can turn, and the picture that was left out")
      ->group(group);
}

void ViewsPolygonsCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "polygons", "make a closed surface from calibrated pictures (polygon colouring)");
  command.footer(
      "Examples:\n"
      "  glassbox views ring teapot -o ring\n"
      "  glassbox views polygons ring -o teapot.glb\n"
      "  glassbox views polygons ring --leave-out 4 --truth teapot --html teapot.html\n"
      "  glassbox render teapot.glb -o again.png\n\n"
      "Voxels are coloured as by `glassbox views voxels`, and a surface is put around those that "
      "are\n"
      "not empty. Each polygon gets the mean colour of the pixels that show it. The voxel behind "
      "it is\n"
      "removed if these pixels show several colours and the pictures are explained better without "
      "it,\n"
      "or if it is outside the object. docs/polygons.md has more.");
  const std::size_t before = command.get_options().size();
  add_input_options(command);
  add_surface_options(command);
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before) + 1, all.end());
  add_output_options(command);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsPolygonsCommand::check_options() const {
  for (const auto& [option, threshold] :
       {std::pair{"--threshold", request_.voxels.settings.threshold},
        {"--polygon-threshold", request_.polygons.threshold}}) {
    if (!(threshold >= 0))
      return fail(option, "a threshold must be at least 0", "give levels of 0 .. 255, or inf");
  }
  if (left_out_output_ && !choice_.leave_out)
    return fail("--left-out-output", "no picture is left out", "add --leave-out N");
  return check_choice(choice_);
}

Result<void> ViewsPolygonsCommand::check_outputs() const {
  if (output_ && !check_extension(*output_, ".glb") && !check_extension(*output_, ".ply"))
    return fail(printable(*output_, kLongestMessage),
                "the file's name ends neither in .glb nor in .ply",
                "give a name such as surface.glb");
  return Outputs()
      .file(output_)
      .picture(left_out_output_)
      .file(page_, ".html")
      .data(json_output_)
      .check();
}

Result<void> ViewsPolygonsCommand::complete_request(const views::PictureSet& set) {
  views::ColoringRequest& voxels = request_.voxels;
  const auto box = box_of(box_, set);
  if (!box) return tl::unexpected(box.error());
  voxels.box = *box;
  voxels.voxel_size = views::size_for(voxels.box, resolution_);
  voxels.size_option = "--resolution";
  request_.writes_glb = output_ && check_extension(*output_, ".glb");
  voxels.most_bytes = choice_.most_bytes();
  return {};
}

std::string ViewsPolygonsCommand::command_line() const {
  std::vector<std::string> page;
  if (page_) page = {"--html", *page_};
  return shell_line({{"views", "polygons", choice_.path}, option_words(options_), page});
}

Result<void> ViewsPolygonsCommand::write_outputs(const PolygonsInput& input,
                                                 const PolygonsReport& report) const {
  // All outputs are made before the first file is written, so that an error in making them leaves
  // no file.
  const nlohmann::ordered_json json = polygons_json(input, report);
  Result<std::string> text;
  if (page_) {
    SurfacePage page;
    page.verb = "polygons";
    page.title = input.pictures.set.source;
    page.summary = fmt::format("{} polygons from {} pictures", report.coloring.mesh.polygons.size(),
                               input.pictures.set.pictures.size());
    page.text = polygons_text(input, report);
    page.command = command_line();
    page.scene = &report.scene;
    for (const views::PolygonColor& color : report.coloring.colors)
      page.views.push_back(std::uint8_t(std::min<int>(color.views, 255)));
    if (report.drawn) {
      page.left_out = &*input.pictures.left_out;
      page.drawn = &report.drawn->color;
    }
    text = make_surface_page(page);
    if (!text) return tl::unexpected(text.error());
  }
  if (output_ && check_extension(*output_, ".glb")) {
    if (const auto written = write_glb(report.scene, *output_); !written) return written;
  } else if (output_) {
    const auto ply = views::polygons_ply(report.coloring);
    if (!ply) return tl::unexpected(ply.error());
    if (const auto written = write_text(*output_, *ply); !written) return written;
  }
  if (left_out_output_) {
    if (const auto written = write_image(*left_out_output_, report.drawn->color); !written)
      return written;
  }
  if (page_) {
    if (const auto written = write_text(*page_, *text); !written) return written;
  }
  return json_output_ ? write_json(*json_output_, json) : Result<void>();
}

int ViewsPolygonsCommand::run() {
  for (const auto& legal : {check_options(), check_outputs()}) {
    if (!legal) return refuse(legal.error());
  }
  Progress progress;
  auto pictures = read_pictures(choice_, progress);
  if (!pictures) return refuse(pictures.error());
  PolygonsInput input{std::move(*pictures), {}};
  if (const auto legal = complete_request(input.pictures.set); !legal) return refuse(legal.error());
  if (truth_) {
    auto scene = load_scene_argument(*truth_, progress);
    if (!scene) return refuse(scene.error());
    input.truth = std::move(*scene);
  }
  const Result<PolygonsReport> report = report_polygons(input, request_, progress);
  if (!report) return refuse(report.error());
  progress.phase("writing");
  if (const auto written = write_outputs(input, *report); !written) return refuse(written.error());
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}", polygons_text(input, *report));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return kSuccess;
}

void add_polygons_command(CLI::App& views, int& exit_code) {
  add_command<ViewsPolygonsCommand>(views, exit_code);
}

}  // namespace glassbox::views
