// glassbox views voxels: reconstructs a shape as voxels from calibrated pictures.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/options/engine_options.h"
#include "cli/options/ignored_options.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/picture_choice.h"
#include "views/commands/voxels_report.h"
#include "views/rings/picture_set.h"
#include "views/voxels/coloring.h"
#include "views/voxels/voxel_file.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::views {

class ViewsVoxelsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_input_options(CLI::App& command);
  void add_coloring_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  int run();
  Result<void> check_options() const;
  Result<void> check_outputs() const;
  void print_unused_options() const;
  Result<VoxelsInput> read(Progress& progress) const;
  Result<void> complete_request(const views::PictureSet& set);
  Result<void> write_outputs(const VoxelsInput& input, const VoxelsReport& report) const;
  std::string command_line() const;

  PictureChoice choice_;
  std::optional<std::string> truth_;
  BoxOption box_;
  std::optional<double> voxel_size_, total_;
  std::optional<int> resolution_;
  bool against_full_ = false;
  views::ColoringRequest request_;
  std::optional<std::string> output_, left_out_output_, json_output_, page_;
  views::VoxelShape shape_ = views::VoxelShape::kCubes;
  const CLI::App* command_ = nullptr;
  std::vector<const CLI::Option*> options_;
};

namespace {

std::array<int, 2> parse_direction(const std::string& text) {
  const bool is_back = !text.empty() && text.front() == '-';
  const std::string axis = is_back ? text.substr(1) : text;
  if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z')
    throw CLI::ValidationError("--direction", "needs x, -x, y, -y, z or -z, not '" + text + "'");
  return {axis[0] - 'x', is_back ? -1 : 1};
}

}  // namespace

void ViewsVoxelsCommand::add_input_options(CLI::App& command) {
  add_picture_choice(command, choice_);
  command.add_option("--truth", truth_, "the true scene, with which the result is compared")
      ->type_name("SCENE")
      ->group("Pictures");
}

void ViewsVoxelsCommand::add_coloring_options(CLI::App& command) {
  views::ColoringSettings& settings = request_.settings;
  std::string group = "Voxels";
  add_box(command, box_);
  command.add_option("--resolution", resolution_, "voxels along the box's longest side [96]")
      ->type_name("N")
      ->check(CLI::Range(1, views::kMaxVoxelsAlong))
      ->group(group);
  command.add_option("--voxel", voxel_size_, "edge of a voxel, in world units")
      ->type_name("D")
      ->group(group);
  command.add_option("--total", total_, "approximate number of voxels")
      ->type_name("N")
      ->group(group);
  add_choice(command, "--order", request_.order,
             choices_of({views::ColoringOrder::kAuto, views::ColoringOrder::kSweep,
                         views::ColoringOrder::kCarve}),
             "sweep: one sweep away from all cameras; carve: sweeps from all sides [sweep if the "
             "cameras allow it]")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--direction",
          [this](const std::string& text) { request_.direction = parse_direction(text); },
          "direction of the sweep: x, -x, y, -y, z, -z [away from the cameras]")
      ->type_name("AXIS")
      ->group(group);
  command
      .add_option("--levels", request_.levels,
                  "number of coarser levels that are carved first; voxels are twice as large in "
                  "each coarser level, 0 to 6 [0]")
      ->type_name("N")
      ->group(group);
  command
      .add_option("--slack", request_.slack,
                  "factor by which the threshold of the test is larger at coarser levels [2]")
      ->type_name("F")
      ->group(group);
  command
      .add_flag(
          "--against-full", against_full_,
          "also colour all voxels without coarser levels, and count the voxels that --levels loses")
      ->group(group);

  group = "Consistency";
  add_choice(
      command, "--test", settings.consistency,
      choices_of({Consistency::kDeviation, Consistency::kLikelihood, Consistency::kAdaptive}),
      "test of whether a voxel's pixels show one colour: sigma < T, a likelihood ratio, or sigma < "
      "k1 M + k2 [sigma]")
      ->group(group);
  const auto add_value = [&](const char* name, double& value, const char* type, const char* help) {
    command.add_option(name, value, help)->type_name(type)->group(group);
  };
  add_value("--threshold", settings.threshold, "T",
            "T: largest standard deviation (sigma) of a voxel's colours, in levels of 0 .. 255; "
            "inf: accept all [18]");
  add_value("--noise", settings.noise, "S",
            "standard deviation of the pictures' noise for the likelihood ratio, in levels of 0 .. "
            "255 [6]");
  add_value("--significance", settings.significance, "P",
            "share of voxels of one colour that the likelihood ratio may reject by chance [0.001]");
  add_value("--k1", settings.k1, "F",
            "k1 for --test adaptive: factor of M, the mean of the standard deviations within "
            "pictures [0.5]");
  add_value("--k2", settings.k2, "T", "k2 for --test adaptive, in levels of 0 .. 255 [8]");
  add_value("--edges", settings.edge, "S",
            "a voxel whose colours have at least this standard deviation within every picture "
            "passes the test too, because it is at an edge; 0: no such voxels [0]");
  add_choice(command, "--space", settings.space,
             choices_of({views::ColorSpace::kRgb, views::ColorSpace::kLab}),
             "colour space of the comparison; lab: CIELab, with T in its units [rgb]")
      ->group(group);
  add_value("--lightness", settings.lightness, "F",
            "weight of the lightness L for --space lab, 0 to 2 [0.5]");
  add_choice(command, "--footprint", settings.sampled,
             choices_of({Footprint::kCentre, Footprint::kBox, Footprint::kHull}),
             "which pixels of a voxel are compared: that of its centre, those of the box around "
             "it, or those of its outline [centre]")
      ->group(group);
  add_choice(command, "--hides", settings.hidden,
             choices_of({Footprint::kCentre, Footprint::kBox, Footprint::kHull}),
             "which pixels a coloured voxel hides: that of its centre, those of the box around it, "
             "or those of its outline [box]")
      ->group(group);
  add_choice(command, "--update", settings.update,
             choices_of({views::OcclusionUpdate::kLayer, views::OcclusionUpdate::kVoxel}),
             "when a coloured voxel begins to hide pixels: after its layer, or at once [layer]")
      ->group(group);
  add_choice(command, "--alone", settings.alone,
             choices_of({views::SingleViewPolicy::kReject, views::SingleViewPolicy::kKeep}),
             "what happens to voxels that fewer than two pictures see [reject]")
      ->group(group);

  add_target_option(command, settings.target)->group("Engine");
  command
      .add_option("--threads", settings.threads,
                  "number of threads; the result is always the same [one for each processor]")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads))
      ->group("Engine");
}

void ViewsVoxelsCommand::add_output_options(CLI::App& command) {
  const std::string group = "Outputs";
  command.add_option("-o,--output", output_, "the coloured voxels, .ply")
      ->type_name("FILE")
      ->group(group);
  add_choice(command, "--shape", shape_,
             {{"cubes", views::VoxelShape::kCubes}, {"points", views::VoxelShape::kPoints}},
             "contents of the file; render draws cubes [cubes]")
      ->group(group);
  command
      .add_option("--left-out-output", left_out_output_,
                  "the picture that was left out, drawn from the voxels: .png or .ppm")
      ->type_name("FILE")
      ->group(group);
  add_json_output(command, json_output_)->group(group);
  add_html_output(
      command, page_,
      "a page with the voxels in 3D, which you can turn, and the reason why each voxel was kept")
      ->group(group);
}

void ViewsVoxelsCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "voxels", "find the shape of an object from calibrated pictures (voxel colouring)");
  command.footer(
      "Examples:\n"
      "  glassbox views ring teapot -o ring\n"
      "  glassbox views voxels ring -o teapot.ply\n"
      "  glassbox views voxels ring --truth teapot --leave-out 4 --json -\n"
      "  glassbox views voxels ring --resolution 200 --levels 2 --against-full\n"
      "  glassbox render teapot.ply --shade unlit -o again.png\n\n"
      "A voxel is coloured if the pictures that see it show one colour there. Which pictures see "
      "it\n"
      "depends on the voxels in front of it, so voxels are visited away from all cameras if there "
      "is\n"
      "such a direction, and carved from all sides if there is none. docs/voxels.md has more.");
  command_ = &command;
  const std::size_t before = command.get_options().size();
  add_input_options(command);
  add_coloring_options(command);
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before) + 1, all.end());
  add_output_options(command);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsVoxelsCommand::check_options() const {
  const views::ColoringSettings& settings = request_.settings;
  if (int(resolution_.has_value()) + int(voxel_size_.has_value()) + int(total_.has_value()) > 1)
    return fail("--voxel", "the size of voxels is given twice",
                "give one of --resolution, --voxel and --total");
  if (total_ && !(*total_ >= 1 && std::isfinite(*total_)))
    return fail("--total", "there must be at least one voxel", "give a number such as 7e6");
  const std::pair<const char*, double> levels[] = {{"--threshold", settings.threshold},
                                                   {"--k1", settings.k1},
                                                   {"--k2", settings.k2},
                                                   {"--edges", settings.edge}};
  for (const auto& [option, value] : levels) {
    if (!(value >= 0))
      return fail(option, "it must be at least 0",
                  "give a number of levels of 0 .. 255, or for --k1 a factor");
  }
  if (!(request_.slack >= 1))
    return fail("--slack", "the factor must be at least 1",
                "give a factor such as 2, because coarse voxels mix more colours");
  if (!(settings.noise > 0 && std::isfinite(settings.noise)))
    return fail("--noise", "the noise must be above 0 and finite",
                "give its standard deviation in levels");
  if (!(settings.significance > 0 && settings.significance < 1))
    return fail("--significance", "it must be between 0 and 1", "give a share such as 0.001");
  if (!(settings.lightness >= 0 && settings.lightness <= 2))
    return fail("--lightness", "it must be between 0 and 2", "give a weight such as 0.5");
  if (left_out_output_ && !choice_.leave_out)
    return fail("--left-out-output", "no picture is left out", "add --leave-out N");
  if (against_full_ && request_.levels == 0)
    return fail("--against-full",
                "without --levels there is nothing to compare, because all voxels are tested",
                "add --levels 2");
  return check_choice(choice_);
}

Result<void> ViewsVoxelsCommand::check_outputs() const {
  return Outputs()
      .file(output_, ".ply")
      .picture(left_out_output_)
      .file(page_, ".html")
      .data(json_output_)
      .check();
}

void ViewsVoxelsCommand::print_unused_options() const {
  const views::ColoringSettings& settings = request_.settings;
  const Consistency test = settings.consistency;
  const std::string another = "--test " + std::string(name_of(test)) + " does not use it";
  print_ignored_options(
      *command_,
      {{test != Consistency::kDeviation, {"--threshold"}, another},
       {test != Consistency::kLikelihood, {"--noise", "--significance"}, another},
       {test != Consistency::kAdaptive, {"--k1", "--k2"}, another},
       {settings.space != views::ColorSpace::kLab, {"--lightness"}, "it is only for --space lab"},
       {request_.levels == 0, {"--slack"}, "there are no coarser levels without --levels"},
       {!output_, {"--shape"}, "no file of voxels is written without -o"}});
}

Result<VoxelsInput> ViewsVoxelsCommand::read(Progress& progress) const {
  auto pictures = read_pictures(choice_, progress);
  if (!pictures) return tl::unexpected(pictures.error());
  VoxelsInput input;
  input.set = std::move(pictures->set);
  input.left_out = std::move(pictures->left_out);
  if (truth_) {
    auto scene = load_scene_argument(*truth_, progress);
    if (!scene) return tl::unexpected(scene.error());
    input.truth = std::move(*scene);
  }
  return input;
}

Result<void> ViewsVoxelsCommand::complete_request(const views::PictureSet& set) {
  const auto box = box_of(box_, set);
  if (!box) return tl::unexpected(box.error());
  request_.box = *box;
  constexpr int kResolution = 96;
  request_.voxel_size = voxel_size_ ? *voxel_size_
                        : total_    ? views::size_for_total(request_.box, *total_)
                                 : views::size_for(request_.box, resolution_.value_or(kResolution));
  request_.size_option = voxel_size_ ? "--voxel" : total_ ? "--total" : "--resolution";
  request_.most_bytes = choice_.most_bytes();
  return {};
}

// The command line that makes this report again.
std::string ViewsVoxelsCommand::command_line() const {
  std::vector<std::string> page;
  if (page_) page = {"--html", *page_};
  return shell_line({{"views", "voxels", choice_.path}, option_words(options_), page});
}

Result<void> ViewsVoxelsCommand::write_outputs(const VoxelsInput& input,
                                               const VoxelsReport& report) const {
  if (output_) {
    const std::string ply = views::voxels_ply(report.coloring.grid, report.coloring.voxels, shape_);
    if (const auto written = write_text(*output_, ply); !written) return written;
  }
  if (left_out_output_) {
    if (const auto written = write_image(*left_out_output_, report.drawn->color); !written)
      return written;
  }
  const nlohmann::ordered_json json = voxels_json(input, request_, report);
  if (page_) {
    const auto written =
        write_text_result(*page_, make_voxels_page(input, request_, report, json,
                                                   {"glassbox " GLASSBOX_VERSION, command_line()}));
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, json) : Result<void>();
}

int ViewsVoxelsCommand::run() {
  for (const auto& legal : {check_options(), check_outputs()}) {
    if (!legal) return refuse(legal.error());
  }
  print_unused_options();
  Progress progress;
  const Result<VoxelsInput> input = read(progress);
  if (!input) return refuse(input.error());
  if (const auto legal = complete_request(input->set); !legal) return refuse(legal.error());
  const Result<VoxelsReport> report =
      report_voxels(*input, request_, {against_full_, page_.has_value()}, progress);
  if (!report) return refuse(report.error());
  progress.phase("writing");
  if (const auto written = write_outputs(*input, *report); !written) return refuse(written.error());
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}", voxels_text(*input, request_, *report));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return kSuccess;
}

void add_voxels_command(CLI::App& views, int& exit_code) {
  add_command<ViewsVoxelsCommand>(views, exit_code);
}

}  // namespace glassbox::views
