// glassbox views glyphs: finds walls of coloured discs in pictures, and computes the camera from
// them.
#include <array>
#include <cmath>
#include <filesystem>
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
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/glyphs_report.h"
#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/pose.h"
#include "views/glyphs/sweep.h"
#include "views/glyphs/wall.h"
#include "views/layers/layer_sources.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::views {

class ViewsGlyphsCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_layout(CLI::App& command);
  void add_rules(CLI::App& command);
  // Switches a rule off, so that regions need not fulfil it.
  void leave_out(const std::string& name);
  int sheet();
  int find();
  int sweep();

  views::WallLayout layout_;
  std::optional<int> panel_;
  std::optional<double> dpi_, fov_;
  std::string output_, picture_;
  std::optional<std::string> against_, page_, json_output_;
  views::KnownIntrinsics known_ = views::KnownIntrinsics::kCentre;
  views::FindSettings settings_;
  views::SweepVariable what_ = views::SweepVariable::kSize;
  std::vector<const CLI::Option*> options_;
};

namespace {

using Json = nlohmann::ordered_json;

Result<std::optional<views::PinholeCamera>> camera_in(const std::string& path,
                                                      const std::string& picture) {
  const auto cameras = views::read_cameras(path);
  if (!cameras) return tl::unexpected(cameras.error());
  const std::string name = std::filesystem::path(picture).filename().string();
  for (const views::NamedCamera& camera : *cameras) {
    if (camera.picture == name) return camera.camera;
  }
  return fail(printable(path), "has no camera for the picture " + printable(name),
              "give the file of cameras that was written with the picture");
}

Json wall_json(const views::Wall& wall) {
  Json json{{"panels", wall.layout.panels},
            {"columns", wall.layout.columns},
            {"rows", wall.layout.rows},
            {"pitch_mm", 1000 * wall.layout.pitch},
            {"diameter_mm", 1000 * wall.layout.diameter},
            {"glyphs", Json::array()}};
  for (const views::WallGlyph& glyph : wall.glyphs) {
    json["glyphs"].push_back(
        {{"identity", glyph.identity},
         {"code", views::code_of(glyph.identity)},
         {"panel", glyph.panel + 1},
         {"centre_m", {glyph.centre.x(), glyph.centre.y(), glyph.centre.z()}}});
  }
  return json;
}

std::string rule_names() {
  std::string names;
  for (int rule = 0; rule < views::kGlyphRules; ++rule)
    names += (rule == 0 ? "" : ", ") + std::string(views::name_of(views::GlyphRule(rule)));
  return names;
}

}  // namespace

void ViewsGlyphsCommand::leave_out(const std::string& name) {
  for (int rule = 0; rule < views::kGlyphRules; ++rule) {
    if (name != views::name_of(views::GlyphRule(rule))) continue;
    settings_.enabled_rules[std::size_t(rule)] = false;
    return;
  }
  throw CLI::ValidationError("--without", "needs one of " + rule_names() + ", not '" + name + "'");
}

void ViewsGlyphsCommand::add_layout(CLI::App& command) {
  const std::string group = "The wall";
  command
      .add_option("--panels", layout_.panels, "number of panels: 1, or 2 that meet in a corner [2]")
      ->type_name("N")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--grid",
          [this](const std::string& text) {
            const Size size = parse_size(text, "--grid");
            layout_.columns = size.width;
            layout_.rows = size.height;
          },
          "columns and rows of a panel [6x10]")
      ->type_name("CxR")
      ->group(group);
  command
      .add_option("--first", layout_.first, "the number of the first glyph; the others follow [0]")
      ->type_name("N")
      ->group(group);
  const auto in_metres = [&](const char* name, double& target, const char* help) {
    command
        .add_option_function<double>(
            name, [&target](const double& millimetres) { target = millimetres / 1000; }, help)
        ->type_name("MM")
        ->group(group);
  };
  in_metres("--pitch", layout_.pitch, "distance from glyph to glyph, in mm [120]");
  in_metres("--diameter", layout_.diameter, "diameter of a glyph, in mm [90]");
}

void ViewsGlyphsCommand::add_rules(CLI::App& command) {
  command
      .add_option_function<float>(
          "--threshold", [this](const float& value) { settings_.threshold = value; },
          "largest distance of a colour from one of the six colours of glyphs, as a fraction of "
          "that colour's distance to the nearest other one [0.4]")
      ->type_name("T");
  command
      .add_option_function<std::vector<std::string>>(
          "--without",
          [this](const std::vector<std::string>& names) {
            for (const std::string& name : names) leave_out(name);
          },
          "rules that a glyph need not fulfil: " + rule_names())
      ->delimiter(',')
      ->type_name("RULE[,RULE...]");
  command.add_flag_callback(
      "--no-balance", [this] { settings_.balances = false; },
      "use colours as they are, without correcting them by the white paper around each glyph");
}

void ViewsGlyphsCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "glyphs", "make walls of coloured discs, and find the camera from a picture of one");
  command.footer(
      "Examples:\n"
      "  glassbox views glyphs sheet -o wall.glb\n"
      "  glassbox views ring wall.glb -o shots --views 3 --arc 30 --start -15 --distance 2 --size "
      "800x600\n"
      "  glassbox views glyphs find shots/view000.png --against shots/ring_par.txt\n"
      "  glassbox views glyphs sweep blur\n\n"
      "A glyph is three discs in three of six colours: 120 of them can be told apart. "
      "docs/glyphs.md has more.");
  command.require_subcommand(1);

  CLI::App& sheet = *command.add_subcommand(
      "sheet", "make a wall: a scene for render, or the picture of a panel to print");
  sheet.footer(
      "Examples:\n"
      "  glassbox views glyphs sheet -o wall.glb\n"
      "  glassbox views glyphs sheet -o sheet.png --pitch 28 --diameter 21 --panel 2\n\n"
      "A picture has 300 px per inch, a scene's textures have 50. --json has the position of every "
      "glyph.");
  sheet.add_option("-o,--output", output_, "a scene, .glb, or a panel's picture")
      ->type_name("FILE")
      ->required();
  sheet.add_option("--panel", panel_, "the panel of a picture, counted from 1 [1]")->type_name("N");
  sheet.add_option("--dpi", dpi_, "pixels per inch [300, for scenes 50]")->type_name("R");
  add_layout(sheet);
  add_json_output(sheet, json_output_, "the table of glyphs");
  sheet.callback([this, &exit_code] { exit_code = this->sheet(); });

  CLI::App& find =
      *command.add_subcommand("find", "find the glyphs in a picture, and the picture's camera");
  find.footer(
      "Examples:\n"
      "  glassbox views glyphs find photo.png\n"
      "  glassbox views glyphs find photo.jpg --fov 40 --pitch 28 --diameter 21 --html found.html\n"
      "  glassbox views glyphs find shots/view000.png --against shots/ring_par.txt --json -\n\n"
      "Without --fov the focal length is found too, which needs glyphs of both panels. --against\n"
      "compares with the camera that a file *_par.txt has for the picture. Exit code 1: no camera "
      "found.");
  find.add_option("PICTURE", picture_, "a picture of the wall")->required();
  const std::size_t before = find.get_options().size();
  find.add_option("--fov", fov_, "the full vertical angle of view, degrees [found]")
      ->type_name("DEG");
  add_choice<KnownIntrinsics>(
      find, "--lens", known_,
      {{"centre", KnownIntrinsics::kCentre}, {"square", KnownIntrinsics::kSquare}},
      "what is assumed about the lens if --fov is not given: centre: its axis meets the middle of "
      "the picture; square: only that pixels are square [centre]");
  find.add_option("--against", against_,
                  "compare the camera that is found with the true one in this file of cameras")
      ->type_name("FILE");
  add_rules(find);
  add_layout(find);
  const auto all = find.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before), all.end());
  add_html_output(find, page_,
                  "a page with the picture, the glyphs that were found in it, and why other "
                  "regions were left out");
  add_json_output(find, json_output_);
  find.callback([this, &exit_code] { exit_code = this->find(); });

  CLI::App& sweep =
      *command.add_subcommand("sweep", "measure how well glyphs are found as pictures get worse");
  sweep.footer(
      "Examples:\n"
      "  glassbox views glyphs sweep rules\n"
      "  glassbox views glyphs sweep blur\n\n"
      "rules: shapes that break one rule each, with that rule switched off. All others: pictures "
      "of the\n"
      "default wall from 2 m; camera: with the noise, the colour filters and the lens of a "
      "camera.");
  add_choice<SweepVariable>(
      sweep, "WHAT", what_,
      choices_of({SweepVariable::kSize, SweepVariable::kBlur, SweepVariable::kOcclusion,
                  SweepVariable::kTilt, SweepVariable::kJpeg, SweepVariable::kBalance,
                  SweepVariable::kCamera, SweepVariable::kThreshold, SweepVariable::kRules}),
      "what makes the pictures worse, step by step")
      ->required();
  add_rules(sweep);
  add_json_output(sweep, json_output_);
  sweep.callback([this, &exit_code] { exit_code = this->sweep(); });
}

int ViewsGlyphsCommand::sheet() {
  const bool is_scene = static_cast<bool>(check_extension(output_, ".glb"));
  if (!is_scene) {
    if (const auto good = check_image_path(output_); !good)
      return refuse({output_,
                     {},
                     "is neither the name of a .glb scene nor that of a .png picture",
                     "name it .glb or .png"});
  }
  if (const auto good = Outputs().file(output_).data(json_output_).check(); !good)
    return refuse(good.error());
  const auto wall = views::make_wall(layout_);
  if (!wall) return refuse(wall.error());
  const int panel_number = panel_.value_or(1);
  if (panel_number < 1 || panel_number > layout_.panels)
    return refuse({{},
                   "--panel",
                   fmt::format("the wall has {} of these panels", layout_.panels),
                   "give a number from 1 to the number of panels"});
  const double dpi = dpi_.value_or(is_scene ? 50 : 300), per_metre = dpi / views::kMetresOfInch;
  if (const auto good = views::check_panel_picture(*wall, per_metre); !good)
    return refuse(good.error());
  if (panel_ && is_scene)
    fmt::print(stderr, "glassbox: note: --panel is ignored: a scene has all panels\n");
  Progress progress;
  progress.phase("drawing the wall");
  const auto written =
      is_scene ? write_glb(views::wall_scene(*wall, per_metre), output_)
               : write_image(output_, views::draw_panel(*wall, panel_number - 1, per_metre));
  if (!written) return refuse(written.error());
  progress.done();
  if (json_output_) {
    if (const auto good = write_json(*json_output_, wall_json(*wall)); !good)
      return refuse(good.error());
  }
  if (json_output_ == "-") return kSuccess;
  const views::WallPanel& panel = wall->panels.front();
  fmt::print(
      "{}: {} glyphs with a diameter of {:.6g} mm, {} of {:.6g} x {:.6g} mm, {:.6g} px per inch\n",
      printable(output_, kLongestMessage),
      is_scene ? wall->glyphs.size() : std::size_t(layout_.columns * layout_.rows),
      1000 * layout_.diameter,
      is_scene ? fmt::format("{} panels", layout_.panels) : fmt::format("panel {}", panel_number),
      1000 * panel.width, 1000 * panel.height, dpi);
  return kSuccess;
}

int ViewsGlyphsCommand::find() {
  if (const auto good = check_report_outputs(page_, json_output_); !good)
    return refuse(good.error());
  if (fov_ && !(*fov_ > 0 && *fov_ < 180))
    return refuse({{},
                   "--fov",
                   "the angle of view must be between 0 and 180 degrees",
                   "give an angle such as 40"});
  if (!(settings_.threshold > 0))
    return refuse(
        {{}, "--threshold", "the threshold must be above 0", "give a threshold such as 0.4"});
  const auto wall = views::make_wall(layout_);
  if (!wall) return refuse(wall.error());
  Progress progress;
  progress.phase("reading " + printable(picture_));
  const auto picture = read_image(picture_);
  if (!picture) return refuse(picture.error());
  if (page_) {
    if (const auto good = check_glyphs_page(*picture); !good) return refuse(good.error());
  }
  GlyphsReport report;
  report.picture = picture_;
  report.width = picture->width;
  report.height = picture->height;
  if (against_) {
    const auto truth = camera_in(*against_, picture_);
    if (!truth) return refuse(truth.error());
    report.truth = *truth;
  }
  progress.phase("finding glyphs");
  report.found = views::find_glyphs(*picture, settings_, wall->identities());
  report.points = views::points_of(report.found, *wall);
  progress.phase("finding the camera");
  views::PoseRequest request;
  request.known = report.known = fov_ ? KnownIntrinsics::kAll : known_;
  request.width = report.width;
  request.height = report.height;
  if (fov_) {
    const double focal = report.height / 2.0 / tan_half_degrees(*fov_);
    request.intrinsic << focal, 0, report.width / 2.0, 0, focal, report.height / 2.0, 0, 0, 1;
  }
  auto pose = views::find_pose(report.points.points, request);
  if (pose) {
    report.pose = std::move(*pose);
  } else {
    report.no_pose = Error{{}, {}, pose.error().cause, pose.error().remedy}.message();
  }
  if (report.truth) {
    report.score = views::glyph_score(
        report.found, *wall, *report.truth,
        views::visible_glyphs(*wall, *report.truth, report.width, report.height));
    if (report.pose) report.error = views::pose_error(report.pose->camera, *report.truth);
  }
  progress.done();
  const Json json = glyphs_json(report, *wall);
  if (page_) {
    const auto written = write_text_result(
        *page_, make_glyphs_page(*picture, report, json,
                                 shell_line({{"views", "glyphs", "find", picture_},
                                             option_words(options_),
                                             {"--html", *page_}})));
    if (!written) return refuse(written.error());
  }
  if (json_output_) {
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  const int exit = report.pose ? kSuccess : kFailure;
  if (json_output_ == "-") return exit;
  fmt::print("{}", glyphs_text(report));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return exit;
}

int ViewsGlyphsCommand::sweep() {
  if (json_output_ && *json_output_ != "-") {
    if (const auto good = check_outputs({*json_output_}); !good) return refuse(good.error());
  }
  if (!(settings_.threshold > 0))
    return refuse(
        {{}, "--threshold", "the threshold must be above 0", "give a threshold such as 0.4"});
  Progress progress;
  const auto rows = views::sweep_glyphs(what_, settings_,
                                        [&](const std::string& level) { progress.phase(level); });
  progress.done();
  const bool has_poses = what_ != SweepVariable::kRules;
  if (json_output_) {
    Json json{{"sweep", views::name_of(what_)}, {"levels", Json::array()}};
    for (const views::SweepRow& row : rows) {
      Json one{{"level", row.level},
               {"visible", row.score.visible},
               {"right", row.score.right},
               {"wrong", row.score.wrong},
               {"precision", row.score.precision()},
               {"recall", row.score.recall()}};
      if (has_poses) {
        one["degrees"] = std::isfinite(row.degrees) ? Json(row.degrees) : Json();
        one["millimetres"] = std::isfinite(row.millimetres) ? Json(row.millimetres) : Json();
      }
      json["levels"].push_back(std::move(one));
    }
    if (const auto written = write_json(*json_output_, json); !written)
      return refuse(written.error());
  }
  if (json_output_ == "-") return kSuccess;
  fmt::print("{:<28}{:>8}{:>7}{:>7}{:>9}{}\n", views::name_of(what_), "visible", "right", "wrong",
             "recall", has_poses ? "   degrees        mm" : "");
  for (const views::SweepRow& row : rows) {
    fmt::print("{:<28}{:>8}{:>7}{:>7}{:>7.1f} %", row.level, row.score.visible, row.score.right,
               row.score.wrong, 100 * row.score.recall());
    if (has_poses && std::isfinite(row.degrees))
      fmt::print("{:>10.4f}{:>10.3f}", row.degrees, row.millimetres);
    else if (has_poses)
      fmt::print("{:>10}{:>10}", "-", "-");
    fmt::print("\n");
  }
  return kSuccess;
}

void add_glyphs_command(CLI::App& views, int& exit_code) {
  add_command<ViewsGlyphsCommand>(views, exit_code);
}

}  // namespace glassbox::views
