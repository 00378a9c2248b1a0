#include "labs/measuring/measuring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "labs/framework/digest.h"
#include "study/experiment/timing.h"

namespace glassbox::labs {

#define ENTRY(number) LabMeasure measured_##number();
#include <measured.inc>  // ENTRY(01) and so on, for each lab that is measured (CMakeLists.txt)
#undef ENTRY

namespace {

struct Entry {
  const char* lab;
  LabMeasure (*make)();
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
#define ENTRY(number) {#number, measured_##number},
#include <measured.inc>
#undef ENTRY
  };
  return all;
}

// The stage that timed.cpp defines.
DrawnStage stage_of(const LabMeasure& lab) {
  return {"measured", "", lab.functions, {}, {}, in_words({{"number", 1, kAllThatFollow}})};
}

Ask ask_function(const DrawnStage& stage, StudentAnswers& student) {
  return [&stage, &student](const std::vector<Numbers>& questions) {
    std::vector<Question> asked;
    asked.reserve(questions.size());
    for (const Numbers& each : questions) asked.push_back({each});
    return student.ask(stage, asked);
  };
}

// A digest of all answers that `measure` asks for; nothing if the student's code fails.
std::optional<std::string> answers_digest(const Ask& ask,
                                          const std::function<void(const Ask& recorded)>& measure) {
  Digest digest;
  bool failed = false;
  measure([&](const std::vector<Numbers>& questions) {
    auto answers = ask(questions);
    failed = failed || !answers;
    if (!answers) return answers;
    for (const Numbers& each : *answers)
      digest.add({reinterpret_cast<const char*>(each.data()), each.size() * sizeof(double)});
    return answers;
  });
  if (failed) return std::nullopt;
  return digest.text();
}

// Summarises the times of all rounds as the experiments do with their own
// (study/experiment/timing.h): the time of a round is the thread's processor time, and the round
// counts as disturbed if the thread had to wait for more than a twentieth of that time.
Result<study::Timing> timing_of(const Numbers& taken, double items) {
  study::Timing timing;
  timing.repetitions = int(taken.size() / 2);
  std::vector<double> ns;
  for (std::size_t i = 0; i + 1 < taken.size(); i += 2) {
    const double processor = taken[i], wall = taken[i + 1];
    if (!(processor >= 0 && processor < 1e18 && wall >= 0))
      return fail("student.cpp",
                  "the program that runs your functions wrote something other than a time", "");
    ns.push_back(processor / items);
    timing.disturbed += wall > (1 + study::kMaxWaiting) * processor;
  }
  timing.ns = study::quartiles(std::move(ns));
  return timing;
}

// Gives each point without times those of another point of the same series and scene at the same
// parameter.
void share_times(std::vector<study::ConfigurationResult>& all) {
  const auto timed = all;
  for (study::ConfigurationResult& each : all) {
    if (!each.timings.empty()) continue;
    const auto same = std::find_if(timed.begin(), timed.end(), [&](const auto& other) {
      return !other.timings.empty() && other.series == each.series && other.scene == each.scene &&
             other.parameter == each.parameter;
    });
    if (same != timed.end()) each.timings = same->timings;
  }
}

}  // namespace

std::optional<LabMeasure> measure_of(int lab) {
  for (const Entry& entry : entries()) {
    if (fmt::format("{:02}", lab) == entry.lab) return entry.make();
  }
  return std::nullopt;
}

Result<std::vector<study::ConfigurationResult>> measure_points(
    const LabMeasure& lab, StudentAnswers& student, int rounds,
    const std::function<void(const std::string&)>& phase) {
  const DrawnStage stage = stage_of(lab);
  const Ask ask = ask_function(stage, student);
  const std::vector<MeasuredPoint> points = lab.points();
  std::vector<study::ConfigurationResult> all;
  for (const MeasuredPoint& point : points) {
    phase(fmt::format("{}: measuring the error of your functions, {} of {}", lab.experiment,
                      all.size() + 1, points.size()));
    study::ConfigurationResult result;
    result.series = point.series;
    result.parameter = point.parameter;
    result.scene = point.scene;
    result.measure = point.measure;
    const auto error = point.error(ask);
    if (!error) return tl::unexpected(error.error());
    result.error = *error;
    all.push_back(std::move(result));
  }
  for (std::size_t i = 0; i < points.size() && rounds > 0; ++i) {
    if (points[i].timed.empty()) continue;
    // The times of a question that has been timed before are used again.
    const auto same = std::find_if(
        points.begin(), points.begin() + std::ptrdiff_t(i), [&](const MeasuredPoint& other) {
          return other.timed == points[i].timed && other.items == points[i].items;
        });
    if (const auto j = std::size_t(same - points.begin()); j < i) {
      all[i].timings = all[j].timings;
      continue;
    }
    phase(fmt::format("{}: measuring the time of your functions, {} of {}", lab.experiment, i + 1,
                      points.size()));
    const auto taken = student.time(stage, {points[i].timed}, rounds);
    if (!taken) return tl::unexpected(taken.error());
    const auto timing = timing_of(*taken, points[i].items);
    if (!timing) return tl::unexpected(timing.error());
    all[i].timings.push_back(*timing);
  }
  share_times(all);
  return all;
}

Result<std::vector<std::string>> untouched_series(
    const LabMeasure& lab, StudentAnswers& student, StudentAnswers& starter,
    const std::function<void(const std::string&)>& phase) {
  phase(fmt::format("{}: finding out which of your functions are written", lab.experiment));
  const DrawnStage measured = stage_of(lab);
  // a series, and whether the student has written it
  std::vector<std::pair<std::string, bool>> all;
  // The starter's functions may throw because nothing is written yet; the student's functions are
  // as in the starter if they throw the same.
  const auto breaks_alike = [&] {
    return student.failure() && student.failure() == starter.failure();
  };
  const auto answers_of = [&](const MeasuredPoint& point, StudentAnswers& whose) {
    return answers_digest(ask_function(measured, whose),
                          [&](const Ask& ask) { static_cast<void>(point.error(ask)); });
  };
  // A point may store its answers, so the student and the starter each get points of their own. One
  // answer that differs from the starter's is enough.
  const std::vector<MeasuredPoint> points = lab.points(), starters = lab.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const MeasuredPoint& point = points[i];
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const auto& each) { return each.first == point.series; });
    if (found == all.end()) found = all.insert(all.end(), {point.series, false});
    if (!found->second) {
      const auto mine = answers_of(point, student);
      const auto starters_own = answers_of(starters[i], starter);
      if (!mine && !breaks_alike())
        return fail("student.cpp", student.failure().value_or("gave no answer"), "");
      found->second = mine && mine != starters_own;
    }
  }
  std::vector<std::string> untouched;
  for (const auto& [series, written] : all) {
    if (!written) untouched.push_back(series);
  }
  return untouched;
}

double number_of(const Numbers& answer, std::size_t index) {
  return index < answer.size() ? answer[index] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace glassbox::labs
