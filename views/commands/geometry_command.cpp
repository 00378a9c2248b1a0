// glassbox views geometry: computes the cameras of two pictures from the matches between them
// (S2-02 to S2-12).
#include <algorithm>
#include <cmath>
#include <filesystem>
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
#include "cli/options/builtin_help.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/geometry.h"
#include "views/commands/rectified_pair.h"
#include "views/files/match_file.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::views {

class ViewsGeometryCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  void add_request_options(CLI::App& command);
  void add_output_options(CLI::App& command);
  bool finds_matches() const { return files_.has_pair() && !files_.matches; }
  Result<void> check_sources() const;
  Result<void> check_request() const;
  Result<void> check_outputs() const;
  Result<GeometryInput> input(Progress& progress);
  Result<GeometryInput> files_input(Progress& progress);
  Result<void> write_scene(const SceneGeometry& made) const;
  std::string command_line() const;
  Result<std::optional<RectifiedPair>> rectified_pair(const GeometryInput& input,
                                                      const GeometryReport& report) const;
  Result<void> write_report(const GeometryInput& input, const GeometryReport& report,
                            const std::optional<RectifiedPair>& rectified) const;
  int run();

  GeometryFiles files_;
  GeometryMatching matching_;
  GeometryScene scene_;
  GeometryRequest request_;
  bool sigma_given_ = false;
  std::pair<std::string, std::string> pair_output_, rectified_output_;
  std::optional<std::string> matches_output_, cameras_output_, page_, json_output_;
  std::vector<const CLI::Option*> options_;  // options to repeat in the report's command line
};

namespace {

// The least sigma, px. Even exact matches differ slightly from the geometry, because positions of
// up to some thousand pixels are rounded to float; with a sigma of 0 they would be taken for
// outliers.
constexpr double kMinSigma = 0.05;

using PairOfNames = std::pair<std::string, std::string>;

CLI::Option* add_pair_of_files(CLI::App& command, const std::string& name, PairOfNames& names,
                               const std::string& help) {
  return command.add_option(name, names, help)->type_name("FILE FILE");
}

CLI::Option* add_real(CLI::App& command, const std::string& name, const std::string& type,
                      const std::function<void(double)>& set, const std::string& help) {
  return command
      .add_option_function<std::string>(
          name, [name, set](const std::string& text) { set(parse_number(name, text)); }, help)
      ->type_name(type);
}

}  // namespace

void ViewsGeometryCommand::add_request_options(CLI::App& command) {
  const std::string group = "Estimation";
  add_choice<std::optional<Estimator>>(
      command, "--estimator", request_.estimator,
      {{"8", Estimator::kEightPoint}, {"7", Estimator::kSevenPoint}, {"5", Estimator::kFivePoint}},
      "number of matches in a random sample [5 if the matrices K are known by --cameras or "
      "--scene, else 8]")
      ->group(group);
  add_real(
      command, "--sigma", "PX",
      [this](double value) {
        request_.sigma = value;
        sigma_given_ = true;
      },
      fmt::format("standard deviation of a match's coordinates (px) [{:g}; for a scene --noise, "
                  "but at least {:g}]",
                  request_.sigma, kMinSigma))
      ->group(group);
  add_real(
      command, "--threshold", "PX", [this](double value) { request_.threshold = value; },
      "largest Sampson distance of an inlier (px) [2 x --sigma]")
      ->group(group);
  add_real(
      command, "--confidence", "P", [this](double value) { request_.confidence = value; },
      fmt::format("least probability that one of the samples has no outlier, 0 < P < 1 [{:g}]",
                  request_.confidence))
      ->group(group);
  command
      .add_option(
          "--seed", request_.seed,
          fmt::format("seed of the random samples, the noise and the outliers [{}]", request_.seed))
      ->type_name("N")
      ->group(group);
}

void ViewsGeometryCommand::add_output_options(CLI::App& command) {
  const std::string outputs = "Other outputs";
  command
      .add_option("--draw,--html", page_,
                  "a page with both pictures, each point's epipolar line in the other picture, and "
                  "the matches coloured by residual")
      ->type_name("FILE")
      ->group(outputs);
  add_pair_of_files(command, "--rectified-out", rectified_output_,
                    "both pictures rectified by the cameras that were found, so that epipolar "
                    "lines are scan lines: .png, transparent where they show nothing")
      ->group(outputs);
  add_json_output(command, json_output_)->group(outputs);
  command
      .add_option("--matches-out", matches_output_,
                  "the matches of a scene, or those that were found, as --matches reads them; - is "
                  "standard output")
      ->type_name("FILE|-")
      ->group(outputs);
  const std::string of_scene = "Outputs of a scene";
  command.add_option("--cameras-out", cameras_output_, "both cameras, as --cameras reads them")
      ->type_name("FILE")
      ->group(of_scene);
  add_pair_of_files(command, "--pair-out", pair_output_, "both pictures, .png or .ppm")
      ->group(of_scene);
}

void ViewsGeometryCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand(
      "geometry",
      "find two cameras from matching points of their pictures: fundamental matrix F, essential "
      "matrix E, rotation R, translation T, epipolar lines");
  command.footer(
      "Examples:\n"
      "  glassbox views geometry --scene room --eye-separation 0.3\n"
      "  glassbox views geometry --scene room --move 0.5,0,0.2 --turn -10,0,0 --noise 0.5 "
      "--outliers 0.3\n"
      "  glassbox views geometry --pair left.png right.png --matches-out m.csv --draw page.html\n"
      "  glassbox views geometry --pair left.png right.png --matches m.csv --cameras c.txt\n"
      "  glassbox views geometry --scene room --move 0.5,0,0 --turn -10,0,0 --rectified-out l.png "
      "r.png\n\n"
      "Without --matches, the corners of the two pictures are matched.\n"
      "A file of matches has lines of x and y in the left picture, then in the right one, in "
      "pixels\n"
      "from the top left corner. A file of cameras has the form of vision.middlebury.edu/mview: "
      "their\n"
      "number, then lines of a picture's name, the intrinsic matrix K, the rotation R and the\n"
      "translation t by rows; a point X is at the pixel K (R X + t). Without cameras only F is "
      "found.\n\n" +
      builtin_help());
  const std::string group = "Pair from files";
  add_pair_of_files(command, "--pair", files_.pair, "the pictures")->group(group);
  options_.push_back(
      command.add_option("--matches", files_.matches, "the matching points of the pictures")
          ->type_name("FILE")
          ->group(group));
  options_.push_back(command
                         .add_option("--cameras", files_.cameras,
                                     "a file with the cameras of the pictures: their matrices K "
                                     "are used, and the result is compared with their R and t")
                         ->type_name("FILE")
                         ->group(group));
  add_matching_options(command, matching_);
  add_geometry_scene_options(command, scene_);
  const std::size_t before = command.get_options().size();
  add_request_options(command);
  const auto all = command.get_options();
  options_.insert(options_.end(), all.begin() + std::ptrdiff_t(before), all.end());
  add_output_options(command);
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsGeometryCommand::check_sources() const {
  const bool from_files = files_.matches || files_.cameras || files_.has_pair();
  if (scene_.scene && from_files) {
    return fail("--scene", "this option draws the pair, but the pair is given as files too",
                "leave out --pair, --matches and --cameras, or --scene");
  }
  if (!finds_matches()) {
    if (const auto words = option_words(matching_.options); !words.empty()) {
      return fail(words.front(), "it is only for matches that are found in the pictures of --pair",
                  scene_.scene
                      ? "leave this option out, or write the pair with --pair-out and read "
                        "it with --pair"
                      : "give --pair without --matches, or leave this option out");
    }
  }
  if (scene_.scene) return check_geometry_scene(scene_);
  if (!files_.matches && !files_.has_pair()) {
    return fail("--matches", "the matching points of the pictures are not given",
                "give the pictures with --pair, a file of matches, or draw a pair with --scene");
  }
  std::vector<std::string> words = option_words(scene_.options);
  std::ranges::copy(given_option_words(scene_.picture), std::back_inserter(words));
  if (matches_output_ && !finds_matches()) {
    return fail("--matches-out", "the matches are in a file already",
                "leave this option out, or --matches to find them in --pair");
  }
  for (const auto& [word, is_given] : {std::pair{"--cameras-out", cameras_output_.has_value()},
                                       std::pair{"--pair-out", !pair_output_.first.empty()}}) {
    if (is_given) words.emplace_back(word);
  }
  if (!words.empty())
    return fail(words.front(), "it is only for a pair that --scene draws",
                "add --scene, or leave this option out");
  return {};
}

Result<void> ViewsGeometryCommand::check_request() const {
  constexpr double kMost = 1000;
  if (!(request_.sigma > 0 && request_.sigma <= kMost)) {
    return fail("--sigma",
                fmt::format("{:g} px is not possible as a standard deviation", request_.sigma),
                fmt::format("give more than 0, and at most {:g}", kMost));
  }
  if (const double threshold = request_.threshold.value_or(1);
      !(threshold > 0 && threshold <= kMost)) {
    return fail("--threshold",
                fmt::format("{:g} px is not possible as the distance of an inlier", threshold),
                fmt::format("give more than 0, and at most {:g}", kMost));
  }
  if (!(request_.confidence > 0 && request_.confidence < 1)) {
    return fail("--confidence",
                fmt::format("{:g} is not a probability between 0 and 1", request_.confidence),
                "give 0 < P < 1, such as 0.99");
  }
  return {};
}

Result<void> ViewsGeometryCommand::check_outputs() const {
  if (matches_output_ == "-" && json_output_ == "-") {
    return fail("--matches-out", "--json goes to standard output already",
                "name a file for one of them");
  }
  if (page_) {
    if (const auto legal = check_extension(*page_, ".html"); !legal) return legal;
    if (!scene_.scene && !files_.has_pair())
      return fail("--draw", "the page needs the two pictures, but they are not given",
                  "add --pair");
  }
  if (!rectified_output_.first.empty() && !scene_.scene && !files_.has_pair()) {
    return fail("--rectified-out",
                "the two pictures are needed to rectify them, but they are not given",
                "add --pair");
  }
  Outputs outputs;
  outputs.data(matches_output_).file(cameras_output_).data(json_output_).file(page_);
  if (!pair_output_.first.empty()) {
    outputs.picture(pair_output_.first).picture(pair_output_.second);
  }
  return outputs.files(rectified_output_, ".png").check();
}

Result<void> ViewsGeometryCommand::write_scene(const SceneGeometry& made) const {
  Result<void> written;
  if (matches_output_)
    written = write_text(*matches_output_, views::matches_text(made.input.matches));
  if (written && cameras_output_) {
    const auto name = [](const std::string& path, const char* otherwise) {
      return path.empty() ? otherwise : std::filesystem::path(path).filename().string();
    };
    written =
        write_text(*cameras_output_,
                   views::cameras_text({{name(pair_output_.first, "left"), made.cameras[0]},
                                        {name(pair_output_.second, "right"), made.cameras[1]}}));
  }
  if (written && !pair_output_.first.empty()) {
    written = write_image(pair_output_.first, (*made.input.pictures)[0]);
    if (written) written = write_image(pair_output_.second, (*made.input.pictures)[1]);
  }
  return written;
}

Result<GeometryInput> ViewsGeometryCommand::files_input(Progress& progress) {
  progress.phase("reading the pair");
  auto input = read_geometry_files(files_);
  if (!input || !finds_matches()) return input;
  progress.phase("matching corners");
  auto done = find_matches(matching_, *input);
  if (done && matches_output_) done = write_text(*matches_output_, matches_text(input->matches));
  if (!done) return tl::unexpected(done.error());
  return input;
}

Result<GeometryInput> ViewsGeometryCommand::input(Progress& progress) {
  if (!scene_.scene) return files_input(progress);
  if (!sigma_given_) request_.sigma = std::max(scene_.sampling.noise, kMinSigma);
  scene_.sampling.seed = request_.seed;
  auto made = draw_geometry_scene(scene_, progress);
  if (!made) return tl::unexpected(made.error());
  if (const auto written = write_scene(*made); !written) return tl::unexpected(written.error());
  return std::move(made->input);
}

// The command line that makes this report again.
std::string ViewsGeometryCommand::command_line() const {
  std::vector<std::string> files, page;
  if (files_.has_pair()) files = {"--pair", files_.pair.first, files_.pair.second};
  if (page_) page = {"--draw", *page_};
  return shell_line({{"views", "geometry"},
                     files,
                     option_words(options_),
                     option_words(matching_.options),
                     option_words(scene_.options),
                     given_option_words(scene_.picture),
                     page});
}

// Rectifies the pair by the pose that was found, whose translation T has length 1.
Result<std::optional<RectifiedPair>> ViewsGeometryCommand::rectified_pair(
    const GeometryInput& input, const GeometryReport& report) const {
  if (rectified_output_.first.empty()) return std::nullopt;
  const auto& pose = report.analysis.pose;
  if (!pose || !input.intrinsics) {
    return fail(
        "--rectified-out", "the cameras were not found, so the pictures cannot be rectified",
        input.intrinsics ? "leave this option out; the report says why no cameras were found"
                         : "give --cameras, or leave this option out");
  }
  const auto& pictures = *input.pictures;
  auto pair =
      rectify(pictures[0], pictures[1], {(*input.intrinsics)[0], (*input.intrinsics)[1], *pose});
  if (!pair) return tl::unexpected(pair.error());
  return std::move(*pair);
}

Result<void> ViewsGeometryCommand::write_report(
    const GeometryInput& input, const GeometryReport& report,
    const std::optional<RectifiedPair>& rectified) const {
  nlohmann::ordered_json json = geometry_json(input, report);
  if (rectified) {
    json["rectification"] = rectification_json(rectified->rectification);
    if (const auto written = write_rectified(rectified_output_, *rectified); !written) {
      return written;
    }
  }
  if (page_) {
    const auto written = write_text_result(
        *page_, make_geometry_page(input, json, {"glassbox " GLASSBOX_VERSION, command_line()}));
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, json) : Result<void>();
}

int ViewsGeometryCommand::run() {
  for (const auto& legal :
       {check_sources(), check_matching(matching_), check_request(), check_outputs()}) {
    if (!legal) return refuse(legal.error());
  }
  Progress progress;
  const Result<GeometryInput> pair = input(progress);
  if (!pair) return refuse(pair.error());
  progress.phase("estimating the cameras");
  const Result<GeometryReport> report = report_geometry(*pair, request_);
  if (!report) {
    Error error = report.error();
    if (files_.matches && error.place == "the matches") error.file = *files_.matches;
    return refuse(error);
  }
  const auto rectified = rectified_pair(*pair, *report);
  if (!rectified) return refuse(rectified.error());
  if (const auto written = write_report(*pair, *report, *rectified); !written) {
    return refuse(written.error());
  }
  progress.done();
  if (json_output_ == "-" || matches_output_ == "-") return kSuccess;
  fmt::print("{}", geometry_text(*pair, *report));
  if (*rectified) fmt::print("\n{}", rectification_text((*rectified)->rectification));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongPath));
  return kSuccess;
}

void add_geometry_command(CLI::App& views, int& exit_code) {
  add_command<ViewsGeometryCommand>(views, exit_code);
}

}  // namespace glassbox::views
