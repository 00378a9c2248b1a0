// glassbox views triangulate: computes the points that matches of two known cameras show (S2-05,
// S2-13).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/geometry.h"
#include "views/commands/triangulate_report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>

namespace glassbox::views {

class ViewsTriangulateCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_point_options(CLI::App& command);
  Result<void> check_sources() const;
  Result<void> check_request() const;
  Result<void> check_outputs() const;
  Result<TriangulationInput> input(Progress& progress);
  std::string command_line() const;
  Result<void> write_report(const TriangulationInput& input,
                            const TriangulationReport& report) const;
  int run();

  GeometryFiles files_;
  GeometryScene scene_;
  Triangulator how_ = Triangulator::kMidpoint;
  std::optional<double> sigma_;
  std::uint32_t seed_ = 1;
  std::uint32_t rows_ = 10;
  std::optional<std::uint32_t> in_full_;
  std::optional<std::string> points_output_, page_, json_output_;
  std::vector<const CLI::Option*> options_;  // options to repeat in the page's command line
};

namespace {

constexpr double kUsualSigma = 0.5;  // px
// The least sigma of a scene, px: its exact matches are rounded to float.
constexpr double kLeastSigma = 0.05;
// Larger pixel coordinates, focal lengths and distances would overflow in products of six of them.
constexpr double kLargest = 1e9;

bool has_extension(const std::string& path, const char* extension) {
  return check_extension(path, extension).has_value();
}

// An error if there is no match, or if a coordinate is too large.
Result<void> check_coordinates(const Matches& matches) {
  if (matches.empty()) {
    return fail("the matches", "there are none, but one is needed",
                "write x and y of the left picture, then of the right one, into a line");
  }
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Match& match = matches[i];
    const double largest =
        std::max(match.left.cwiseAbs().maxCoeff(), match.right.cwiseAbs().maxCoeff());
    if (!(largest <= kLargest)) {
      return fail(fmt::format("match {}", i + 1),
                  fmt::format("{:g} px is not possible as a coordinate", largest),
                  fmt::format("give at most {:g}", kLargest));
    }
  }
  return {};
}

Result<void> check_cameras(const std::array<PinholeCamera, 2>& cameras) {
  for (const PinholeCamera& camera : cameras) {
    const char* name = &camera == cameras.data() ? "the left camera" : "the right camera";
    const Matrix3d& k = camera.intrinsic;
    const double least = std::min(k(0, 0), k(1, 1)), largest = k.cwiseAbs().maxCoeff();
    if (!(least >= 1 / kLargest && largest <= kLargest)) {
      return fail(name,
                  fmt::format("its matrix K has a number of {:g} px",
                              largest <= kLargest ? least : largest),
                  fmt::format("give numbers up to {:g}, and focal lengths above {:g}", kLargest,
                              1 / kLargest));
    }
    if (const double away = camera.centre.cwiseAbs().maxCoeff(); !(away <= kLargest * kLargest)) {
      return fail(name, fmt::format("its centre has a coordinate of {:g}", away),
                  fmt::format("give at most {:g}", kLargest * kLargest));
    }
  }
  if (!are_in_one_place(cameras)) return {};
  return fail("the cameras",
              "both are in one place, so their pictures do not show how far away anything is",
              "give two cameras whose centres differ");
}

}  // namespace

void ViewsTriangulateCommand::add_point_options(CLI::App& command) {
  const std::string group = "Points";
  add_choice<Triangulator>(command, "--method", how_,
                           {{"midpoint", Triangulator::kMidpoint},
                            {"linear", Triangulator::kLinear},
                            {"optimal", Triangulator::kHartleySturm}},
                           "half way between the rays; the null vector of the equations in pixels; "
                           "or the least change of the pixels so that the rays meet [midpoint]")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--sigma", [this](const std::string& text) { sigma_ = parse_number("--sigma", text); },
          fmt::format("standard deviation of each coordinate of a match (px), for the ellipsoids "
                      "[{:g}; for a scene --noise, but at least {:g}]",
                      kUsualSigma, kLeastSigma))
      ->type_name("PX")
      ->group(group);
  command.add_option("--seed", seed_, "seed of a scene's noise and outliers [1]")
      ->type_name("N")
      ->group(group);
  command.add_option("--rows", rows_, fmt::format("matches in the printed table [{}]", rows_))
      ->type_name("N")
      ->group(group);
  command.add_option("--match", in_full_, "print this match with all its numbers, from 1")
      ->type_name("N")
      ->group(group);
}

void ViewsTriangulateCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "triangulate",
      "find the points that matches of two known cameras show: rays, gaps, error ellipsoids");
  command.footer(
      "Examples:\n"
      "  glassbox views triangulate --scene room --eye-separation 0.3 --noise 0.5\n"
      "  glassbox views triangulate --matches m.csv --cameras c.txt --method optimal --sigma 0.3\n"
      "  glassbox views triangulate --matches m.csv --cameras c.txt --match 1 --points-out "
      "p.ply\n\n"
      "The files are those that views geometry reads and writes (--matches-out, --cameras-out):\n"
      "matches in lines of x and y in the left picture, then in the right one, and cameras as in\n"
      "vision.middlebury.edu/mview. Points are in the world of the cameras. A point behind a "
      "camera,\n"
      "at infinity or of nearly parallel rays is named and counted (docs/views.md).\n\n" +
      builtin_help());
  const std::string group = "Pair from files";
  const std::size_t before = command.get_options().size();
  command.add_option("--matches", files_.matches, "the matching points of the pictures")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--cameras", files_.cameras, "the cameras of the pictures: K, R and t")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--pair", files_.pair,
                  "the pictures: their names choose the cameras of a file of many, and the left "
                  "one has the colours of --points-out FILE.ply")
      ->type_name("FILE FILE")
      ->group(group);
  const auto of_files = command.get_options();
  add_geometry_scene_options(command, scene_);
  const std::size_t middle = command.get_options().size();
  add_point_options(command);
  const auto all = command.get_options();
  options_.assign(of_files.begin() + std::ptrdiff_t(before), of_files.end());
  options_.insert(options_.end(), all.begin() + std::ptrdiff_t(middle), all.end());
  command
      .add_option("--points-out", points_output_,
                  "the points: .ply has those in front of both cameras, .csv has every match")
      ->type_name("FILE")
      ->group("Other outputs");
  add_html_output(command, page_, "a page with both cameras, the rays and the points in space")
      ->group("Other outputs");
  add_json_output(command, json_output_, "every match with its rays, point and ellipsoid")
      ->group("Other outputs");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsTriangulateCommand::check_sources() const {
  const bool from_files = files_.matches || files_.cameras || files_.has_pair();
  if (scene_.scene && from_files) {
    return fail("--scene", "this option draws the pair, but the pair is given as files too",
                "leave out --pair, --matches and --cameras, or --scene");
  }
  if (scene_.scene) return check_geometry_scene(scene_);
  if (!files_.matches) {
    return fail("--matches", "the matching points of the pictures are not given",
                "give a file of matches, or draw a pair with --scene");
  }
  if (!files_.cameras) {
    return fail("--cameras", "without the cameras there are no rays",
                "give a file of cameras, such as views geometry --cameras-out writes");
  }
  std::vector<std::string> words = option_words(scene_.options);
  std::ranges::copy(given_option_words(scene_.picture), std::back_inserter(words));
  if (!words.empty())
    return fail(words.front(), "it is only for a pair that --scene draws",
                "add --scene, or leave this option out");
  return {};
}

Result<void> ViewsTriangulateCommand::check_request() const {
  constexpr double kMost = 1000;
  const double sigma = sigma_.value_or(kUsualSigma);
  if (!(sigma > 0 && sigma <= kMost)) {
    return fail("--sigma", fmt::format("{:g} px is not possible as a standard deviation", sigma),
                fmt::format("give more than 0, and at most {:g}", kMost));
  }
  return {};
}

Result<void> ViewsTriangulateCommand::check_outputs() const {
  if (points_output_ && !has_extension(*points_output_, ".ply") &&
      !has_extension(*points_output_, ".csv")) {
    return fail(*points_output_, "the file's name ends neither in .ply nor in .csv",
                "name a .ply or a .csv file");
  }
  Outputs outputs;
  outputs.file(points_output_).file(page_, ".html").data(json_output_);
  if (const auto legal = outputs.check(); !legal) return legal;
  return check_distinct(outputs.paths(), {files_.matches.value_or(""), files_.cameras.value_or(""),
                                          files_.pair.first, files_.pair.second});
}

Result<TriangulationInput> ViewsTriangulateCommand::input(Progress& progress) {
  TriangulationInput input;
  input.how = how_;
  input.sigma = sigma_.value_or(kUsualSigma);
  if (scene_.scene) {
    scene_.sampling.seed = seed_;
    auto made = draw_geometry_scene(scene_, progress);
    if (!made) return tl::unexpected(made.error());
    input.pair = std::move(made->input);
    input.cameras = made->cameras;
    if (!sigma_) input.sigma = std::max(scene_.sampling.noise, kLeastSigma);
  } else {
    progress.phase("reading the pair");
    auto pair = read_geometry_files(files_);
    if (!pair) return tl::unexpected(pair.error());
    const auto cameras = read_pair_cameras(files_);
    if (!cameras) return tl::unexpected(cameras.error());
    input.pair = std::move(*pair);
    input.cameras = *cameras;
  }
  const auto with_file = [](Result<void> legal, const std::optional<std::string>& file) {
    if (!legal && file) legal.error().file = *file;
    return legal;
  };
  for (const auto& legal : {with_file(check_coordinates(input.pair.matches), files_.matches),
                            with_file(check_cameras(input.cameras), files_.cameras)}) {
    if (!legal) return tl::unexpected(legal.error());
  }
  const std::size_t count = input.pair.matches.size();
  if (in_full_ && (*in_full_ < 1 || *in_full_ > count)) {
    return fail("--match", fmt::format("there is no match {}", *in_full_),
                fmt::format("give 1 to {}", count));
  }
  return input;
}

// The command line that makes this page again.
std::string ViewsTriangulateCommand::command_line() const {
  std::vector<std::string> page;
  if (page_) page = {"--html", *page_};
  return shell_line({{"views", "triangulate"},
                     option_words(options_),
                     option_words(scene_.options),
                     given_option_words(scene_.picture),
                     page});
}

Result<void> ViewsTriangulateCommand::write_report(const TriangulationInput& input,
                                                   const TriangulationReport& report) const {
  if (points_output_) {
    const auto written = write_text(*points_output_, has_extension(*points_output_, ".ply")
                                                         ? triangulation_ply(input, report)
                                                         : triangulation_csv(input, report));
    if (!written) return written;
  }
  if (page_) {
    const auto written = write_text(*page_, triangulation_page(input, report, command_line()));
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, triangulation_json(input, report))
                      : Result<void>();
}

int ViewsTriangulateCommand::run() {
  for (const auto& legal : {check_sources(), check_request(), check_outputs()}) {
    if (!legal) return refuse(legal.error());
  }
  Progress progress;
  const Result<TriangulationInput> asked = input(progress);
  if (!asked) return refuse(asked.error());
  progress.phase("triangulating");
  const TriangulationReport report = triangulation_report(*asked);
  if (const auto written = write_report(*asked, report); !written) return refuse(written.error());
  progress.done();
  if (json_output_ == "-") return kSuccess;
  fmt::print("{}", triangulation_text(*asked, report, rows_, in_full_));
  if (points_output_) {
    const bool is_ply = has_extension(*points_output_, ".ply");
    fmt::print("\n{}: {} of {}\n", printable(*points_output_, kLongPath),
               is_ply ? report.count(PointState::kInFront) : report.points.size(),
               counted(report.points.size(), "match", "matches"));
  }
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongPath));
  return kSuccess;
}

void add_triangulate_command(CLI::App& views, int& exit_code) {
  add_command<ViewsTriangulateCommand>(views, exit_code);
}

}  // namespace glassbox::views
