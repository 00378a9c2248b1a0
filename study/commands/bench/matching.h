// Dense stereo matching compared with OpenCV's: `glassbox bench --against opencv`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/arguments.h"
#include "cli/report/progress.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/settings.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::study {

struct MatchingBenchOptions {
  // Built-in scenes and files, which are drawn for two eyes 0.2 world units apart, and directories
  // with Middlebury's im2.ppm, im6.ppm, disp2.pgm and disp6.pgm, in which a grey value is four
  // times the disparity in pixels. Empty: room, forest, and the pairs next to the repository.
  std::vector<std::string> pairs;
  Size size{640, 480};  // of the drawn pictures
  std::vector<int> threads;
  int frames = 9;
  Target target = best_target();
};

struct MatcherResult {
  std::string name;                // "glassbox fast"
  double cpu_ms = 0, wall_ms = 0;  // medians: time of all processors together, and elapsed time
  views::DisparityErrors visible;  // errors at the points that both pictures show
};
struct MatchedPair {
  std::string description;
  int threads = 0, disparities = 0;
  std::vector<MatcherResult> matchers;
};
struct MatchingReport {
  std::string machine, compiler, target, peer;  // peer: "OpenCV 4.6.0", empty if there is none
  int frames = 0;
  std::vector<MatchedPair> pairs;
  std::vector<std::string> notes;  // one sentence each
};

Result<MatchingReport> measure_matching(const MatchingBenchOptions& options, Progress& progress);
std::string matching_text(const MatchingReport& report);
nlohmann::ordered_json matching_json(const MatchingReport& report);

// OpenCV's semi-global matcher from Debian's python3-opencv, run as a separate process.
struct PeerMatch {
  std::string version;                  // "4.6.0"
  std::vector<double> cpu_ms, wall_ms;  // of each repetition
  // px; a hole has the smaller one of the disparities on its left and right
  Image<float> disparity;
};

enum class PeerPaths { kThree, kEight };
inline const char* name_of(PeerPaths paths) {
  return paths == PeerPaths::kThree ? "OpenCV, 3 paths" : "OpenCV, 8 paths";
}

// Parameters of StereoSGBM: the side of its blocks in px, and its two smoothness penalties.
inline constexpr int kPeerBlock = 3, kPeerP1 = 216, kPeerP2 = 864;
// The cause of the error if OpenCV is not installed.
inline constexpr const char* kPeerIsMissing = "it is not installed for /usr/bin/python3";

// Runs StereoSGBM with its left-right check: one repetition that is not measured, then `frames`
// measured ones. `scratch` is a directory for the files exchanged with the process. An error if
// OpenCV is not installed.
Result<PeerMatch> match_with_opencv(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const views::DisparityRange& range, PeerPaths paths,
                                    int threads, int frames, const std::filesystem::path& scratch);

}  // namespace glassbox::study
