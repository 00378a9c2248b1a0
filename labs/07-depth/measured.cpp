// Measures lab 7 for the chart of the experiment on depth formats (D-6): how far apart two surfaces
// must be for the student's codes to tell which is in front.
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "labs/measuring/measuring.h"
#include "study/experiments/d06_ladder.h"

namespace glassbox::labs {

namespace lab_07_measured {

using namespace study::d06;

constexpr int kRungs = 2048;  // as in a quick run of the experiment

struct LabFormat {
  int number;  // its value in lab_07::Format
  const char* name;
};
constexpr LabFormat kLabFormats[] = {{0, "u16"}, {1, "u24"}, {2, "float"}, {3, "float, reversed"}};

// One question for each window of the ladder, the distances from z to z (1 + window). Each window
// is twice as large as the one before, until one reaches the far plane.
std::vector<Numbers> questions(int format, double z) {
  std::vector<Numbers> all;
  for (double window = 0x1p-18;; window *= 2) {
    Numbers& question = all.emplace_back(Numbers{0, double(format), kNear, kFar});
    for (const float distance : rungs(z, window, kRungs)) question.push_back(double(distance));
    if (z * (1 + window) > kFar) return all;
  }
}

Result<double> measure_ladder_error(const Ask& ask, int format, double z) {
  const auto answers = ask(questions(format, z));
  if (!answers) return tl::unexpected(answers.error());
  std::size_t window = 0;
  bool complete = true;
  const auto codes = [&](const std::vector<float>& distances) {
    const Numbers& answer = (*answers)[window++];
    std::vector<std::uint32_t> all;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double code = number_of(answer, i);
      complete = complete && code >= 0 && code < 0x1p32;
      all.push_back(complete ? std::uint32_t(code) : 0);
    }
    return all;
  };
  const double error = ladder_error(codes, z, kRungs);
  return complete ? error : number_of({}, 0);
}

Numbers timed_fragments(int format) {
  Numbers question{1, double(format)};
  for (const float depth : make_fragments(kFragments).depth) question.push_back(double(depth));
  return question;
}

// Whether the student's function, which is timed, finds the only fragment of each pixel.
Result<bool> keeps_all_fragments(const Ask& ask, const Numbers& timed) {
  const auto answers = ask({timed});
  if (!answers) return tl::unexpected(answers.error());
  bool all = answers->front().size() == kFragments;
  for (std::size_t i = 0; i < kFragments; ++i)
    all = all && number_of(answers->front(), i) == double(i);
  return all;
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const LabFormat& format : kLabFormats) {
    const Numbers timed = timed_fragments(format.number);
    const auto works = std::make_shared<std::optional<bool>>();
    const auto error = [=](const Ask& ask, double z) -> Result<double> {
      if (!*works) {
        const auto found = keeps_all_fragments(ask, timed);
        if (!found) return tl::unexpected(found.error());
        *works = *found;
      }
      return **works ? measure_ladder_error(ask, format.number, z)
                     : Result<double>(number_of({}, 0));
    };
    for (const double z : {0.2, 1.0, 10.0, 100.0, 1000.0, 9000.0})
      all.push_back({fmt::format("yours, {}", format.name), z, "ladder", "",
                     [=](const Ask& ask) { return error(ask, z); }, timed, double(kFragments)});
  }
  return all;
}

}  // namespace lab_07_measured

LabMeasure measured_07() {
  using namespace lab_07_measured;
  return {"D-6", "depth_row, depth_code, visible", measured_points};
}

}  // namespace glassbox::labs
