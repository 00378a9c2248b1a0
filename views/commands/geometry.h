// The input for the geometry of two views: the matches, and what is known about the pictures and
// the cameras.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "cli/report/progress.h"
#include "views/features/match_features.h"
#include "views/files/camera_file.h"
#include "views/two_view/analysis.h"
#include "views/two_view/camera.h"
#include "views/two_view/match.h"
#include "views/two_view/truth.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

// How many of the left picture's pixels show a point that the right picture shows, too (seen), and
// how many do not, by the reason (S2-03).
struct PixelVisibility {
  std::uint64_t seen = 0, hidden = 0, outside = 0, missing = 0, nothing = 0;
};

// Matches that were found in the pictures, and how.
struct FoundMatches {
  views::FeatureSettings settings;
  views::MatchRules rules;
  std::array<int, 2> corners{};              // left, right
  std::vector<views::FeatureMatch> matches;  // in the order of the input's matches
};

struct GeometryInput {
  std::string description;       // "room, 640 x 480", "matches.csv"
  std::string pair_description;  // one line on how pair and matches were made; empty for files
  views::Matches matches;        // positions in pixels from the pictures' top left corners
  std::optional<std::array<views::Matrix3d, 2>> intrinsics;  // left, right
  std::optional<views::RelativePose> truth;                  // its translation T is in world units
  std::vector<bool> is_outlier;  // for each match, if it is known; else empty
  std::optional<FoundMatches> found;
  std::optional<PixelVisibility> visibility;
  std::optional<std::array<Image<Rgba8>, 2>> pictures;
  std::array<std::string, 2> picture_names{"left", "right"};
};

// The report on the geometry of two views: the analysis of the pair, what follows from it, its
// errors if the truth is known, and what is left out.

// The parameters of the analysis.
struct GeometryRequest {
  std::optional<views::Estimator> estimator;  // absent: five points if K is known, else eight
  double sigma = 0.5;                         // px: standard deviation of a coordinate of a match
  std::optional<double> threshold;            // px, of an inlier; absent: 2 sigma
  double confidence = 0.99;                   // probability that a sample without outliers is drawn
  std::uint32_t seed = 1;                     // for the random samples, the noise and the outliers
};

// Statistics of the inliers' residuals, px.
struct ResidualFacts {
  double rms = 0, median = 0, largest = 0;
};

// One of the four poses that the essential matrix E allows (C-105).
struct PoseCandidate {
  views::RelativePose pose;
  int in_front = 0;  // inliers in front of both cameras
  bool is_chosen = false;
};

struct PoseErrors {
  double rotation_degrees = 0;
  std::optional<double> direction_degrees;  // absent: both cameras are at the same position
};

// A comparison with matches that are known to be outliers.
struct OutlierFacts {
  int planted = 0;
  int kept = 0;  // outliers taken for inliers, because they are near their epipolar line by chance
  int lost = 0;  // true matches that are not taken for inliers
};

// The model that the cameras were computed with, and the reasons with their numbers, in sentences.
struct ModelChoice {
  std::string name;  // "plane" or "general"
  std::string why;   // why this model
  // If the matches of a plane were used: which of its two poses was chosen, and why.
  std::string poses;
};

struct OmittedItem {
  std::string what, why;
};

struct GeometryReport {
  views::PairRequest request;
  views::PairAnalysis analysis;
  double samples_wanted = 0;  // by RANSAC's formula (law_text), from the inliers found

  // The essential matrix in two forms: R S with S = [T]x, and, as in other textbooks, [t]x R with t
  // = -R T. Here [v]x is the matrix of the cross product with v.
  std::optional<views::Matrix3d> essential, essential_of_shift;
  std::optional<std::array<views::Vector3d, 2>> epipoles;  // left, right; homogeneous
  // For each match, the mean distance of its two points from their epipolar lines, px.
  std::vector<double> epipolar_distances;
  ResidualFacts sampson, epipolar;
  std::vector<PoseCandidate> candidates;  // empty if no pose was found
  std::optional<ModelChoice> model;       // only if there is a geometry
  // The second pose for a plane, if the matches do not decide between the two.
  std::optional<views::RelativePose> second_pose;
  std::optional<PoseErrors> errors, second_errors;
  std::optional<OutlierFacts> outliers;
  std::vector<OmittedItem> left_out;

  bool has_geometry() const { return analysis.fundamental.has_value(); }
};

// Analyses the pair. Errors: fewer than 8 distinct matches, an estimator that needs cameras that
// are not known, and errors of `analyse`.
Result<GeometryReport> report_geometry(const GeometryInput& input, const GeometryRequest& request);

// Draws a pair with the rasterizer, for cameras of all three arrangements (S2-02), and computes the
// true matches: where each point is in the other picture (S2-03).
enum class Arrangement { kParallel, kConverging, kArbitrary };
const char* name_of(Arrangement arrangement);

struct GeometryScene {
  std::optional<std::string> scene;
  PictureOptions picture;
  std::optional<Arrangement> arrangement;     // absent: arbitrary with move or turn, else parallel
  std::optional<std::array<double, 3>> move;  // right, up, forward; world units
  std::optional<std::array<double, 3>> turn;  // right, up, clockwise; degrees
  views::MatchSampling sampling;              // with the command's seed
  // The options that add_geometry_scene_options has added.
  std::vector<const CLI::Option*> options;

  Arrangement chosen() const;
};

void add_geometry_scene_options(CLI::App& command, GeometryScene& scene);

// The checks that are possible before anything is drawn.
Result<void> check_geometry_scene(const GeometryScene& scene);

// The pair of pictures drawn from the scene, and its two cameras as they can be written to a file.
struct SceneGeometry {
  GeometryInput input;
  std::array<views::PinholeCamera, 2> cameras;
};
Result<SceneGeometry> draw_geometry_scene(const GeometryScene& scene, Progress& progress);

// Reads the pictures, matches and cameras of a pair from files.
struct GeometryFiles {
  std::pair<std::string, std::string> pair;  // the pictures; empty: none
  std::optional<std::string> matches, cameras;

  bool has_pair() const { return !pair.first.empty(); }
};

// Reads the two cameras of a pair from the file of cameras: those with the names of the pictures.
// If the file has two cameras with other names, the first is the left one.
Result<std::array<views::PinholeCamera, 2>> read_pair_cameras(const GeometryFiles& files);

// Reads a pair, with the cameras as in read_pair_cameras. Without a file of matches the pictures
// must be opaque, because their matches will be found. Errors: pictures of different sizes, and
// files that the readers of views/files refuse.
Result<GeometryInput> read_geometry_files(const GeometryFiles& files);

// How the matches of two pictures are found if no file has them.
struct GeometryMatching {
  views::FeatureSettings settings;
  views::MatchRules rules;
  std::optional<double> search;             // px; absent: a quarter of the width for kNcc
  std::vector<const CLI::Option*> options;  // those that add_matching_options has added
};

void add_matching_options(CLI::App& command, GeometryMatching& matching);
Result<void> check_matching(const GeometryMatching& matching);

// Adds the matches of the input's pictures to the input. Errors: pictures that are too small or
// have no corners, and fewer than 8 matches.
Result<void> find_matches(const GeometryMatching& matching, GeometryInput& input);

// The matches as a command line asks for them: "sift, ratio at most 0.8, cross-checked".
std::string matching_text(const FoundMatches& found);

// The report in lines of at most 100 columns.
std::string geometry_text(const GeometryInput& input, const GeometryReport& report);

// One line that says which kind of pair it is, and what that means. The page shows it too.
std::string kind_sentence(views::PairKind kind);
// The formula log(1 - confidence)/log(1 - inliers^size) for the number of samples, with its
// numbers.
std::string law_text(const GeometryReport& report);

// Matrices are written by rows. Names say which numbers are px or degrees. What was not found is
// null. "second_pose" is the other pose for a plane, if nothing decides between the two.
nlohmann::ordered_json geometry_json(const GeometryInput& input, const GeometryReport& report);

// The report on two views as one HTML page that needs no other file: it shows both pictures, and
// for a point in one picture its epipolar line in the other picture.
struct GeometryPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// Makes the page. `report` is the JSON of geometry_json. The page has the first 2000 matches.
// Errors: an input without pictures, and pictures that are too large for a browser.
Result<std::string> make_geometry_page(const GeometryInput& input,
                                       const nlohmann::ordered_json& report,
                                       const GeometryPageOrigin& origin);

}  // namespace glassbox::views
