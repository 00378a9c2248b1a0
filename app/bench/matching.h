// Dense matching beside OpenCV's: `glassbox bench --against opencv`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/arguments.h"
#include "views/matching/evaluate.h"
#include "views/matching/settings.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

class Progress;

struct MatchingQuestion {
  // Built-in scenes and files, which are drawn for two eyes 0.2 apart, and directories with Middlebury's im2.ppm, im6.ppm, disp2.pgm and
  // disp6.pgm, four to a pixel of disparity. Empty: room, forest, and the pairs beside the checkout.
  std::vector<std::string> pairs;
  Size size{640, 480};  // of what is drawn
  std::vector<int> threads;
  int frames = 9;
  Target target = best_target();
};

struct Matcher {
  std::string name;                // "glassbox fast"
  double cpu_ms = 0, wall_ms = 0;  // medians; of the processors together, and on the clock
  views::DisparityErrors visible;  // of what both pictures show
};
struct MatchedPair {
  std::string about;
  int threads = 0, disparities = 0;
  std::vector<Matcher> matchers;
};
struct MatchingReport {
  std::string machine, compiler, target, peer;  // "OpenCV 4.6.0", empty where there is none
  int frames = 0;
  std::vector<MatchedPair> pairs;
  std::vector<std::string> notes;  // a sentence each
};

Result<MatchingReport> measure_matching(const MatchingQuestion& question, Progress& progress);
std::string matching_text(const MatchingReport& report);
nlohmann::ordered_json matching_json(const MatchingReport& report);

}  // namespace glassbox::app
