// Dense stereo matching compared with OpenCV's: `glassbox bench --against opencv`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/arguments.h"
#include "cli/report/progress.h"
#include "views/matching/evaluate.h"
#include "views/matching/settings.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

struct MatchingQuestion {
  // Built-in scenes and files, which are drawn for two eyes 0.2 world units apart, and directories
  // with Middlebury's im2.ppm, im6.ppm, disp2.pgm and disp6.pgm, in which a grey value is four
  // times the disparity in pixels. Empty: room, forest, and the pairs next to the repository.
  std::vector<std::string> pairs;
  Size size{640, 480};  // of the drawn pictures
  std::vector<int> threads;
  int frames = 9;
  Target target = best_target();
};

struct Matcher {
  std::string name;                // "glassbox fast"
  double cpu_ms = 0, wall_ms = 0;  // medians: time of all processors together, and elapsed time
  views::DisparityErrors visible;  // for the points that both pictures show
};
struct MatchedPair {
  std::string about;
  int threads = 0, disparities = 0;
  std::vector<Matcher> matchers;
};
struct MatchingReport {
  std::string machine, compiler, target, peer;  // peer: "OpenCV 4.6.0", empty if there is none
  int frames = 0;
  std::vector<MatchedPair> pairs;
  std::vector<std::string> notes;  // one sentence each
};

Result<MatchingReport> measure_matching(const MatchingQuestion& question, Progress& progress);
std::string matching_text(const MatchingReport& report);
nlohmann::ordered_json matching_json(const MatchingReport& report);

}  // namespace glassbox::study
