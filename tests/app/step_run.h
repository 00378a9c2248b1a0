// Runs glassbox step --point on matrices of the textbook.
#pragma once

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/text.h"
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace book = textbook;
using book::Rows;
using Json = nlohmann::json;

// Returns the sixteen numbers in the order of rows or of columns, each printed by `format` and
// followed by `after`.
inline std::string numbers(const Rows& m, bool columns, const char* format,
                           const std::string& after = " ") {
  std::string text;
  for (std::size_t i = 0; i < 16; ++i) {
    char number[64];
    const double entry = columns ? m[i % 4][i / 4] : m[i / 4][i % 4];
    std::snprintf(number, sizeof number, format, entry);
    text += number + (i == 15 ? std::string() : after);
    if (i % 4 == 3) text += "\n";
  }
  return text;
}

inline std::string plain_rows(const Rows& m) {
  return numbers(m, false, "%12.9g");
}

// A call of the program whose matrices are in files.
struct Call {
  Rows model = book::identity(), view = book::identity(), projection = book::identity();
  std::string options;
};

inline Outcome step(const WorkingDirectory& here, const Call& call) {
  here.write("model.txt", plain_rows(call.model));
  here.write("view.txt", plain_rows(call.view));
  here.write("proj.txt", plain_rows(call.projection));
  return here.run("step --model model.txt --view view.txt --proj proj.txt " + call.options);
}

inline Json step_json(const WorkingDirectory& here, Call call) {
  call.options += " --json -";
  const Outcome outcome = step(here, call);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

inline std::vector<std::string> findings(const Json& json, const std::string& severity) {
  std::vector<std::string> ids;
  for (const Json& finding : json["findings"]) {
    if (finding["severity"] == severity) ids.push_back(finding["id"]);
  }
  return ids;
}

using Ids = std::vector<std::string>;

inline bool alarms_at(const Json& json, const std::string& id) {
  const Ids alarms = findings(json, "alarm");
  return std::find(alarms.begin(), alarms.end(), id) != alarms.end();
}

// The program's answer to a call: as JSON, and as text without line breaks, with one blank between
// words.
struct Answer {
  Json json;
  std::string text;
};

inline Answer run_step(const WorkingDirectory& here, const Call& call) {
  const Outcome outcome = step(here, call);
  REQUIRE(outcome.exit_code == 0);
  std::istringstream words(outcome.out);
  Answer answer{step_json(here, call), ""};
  for (std::string word; words >> word;) answer.text += word + " ";
  return answer;
}

inline const Rows kView = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
inline const Rows kModel = book::product(book::translation(1, 0, 0.5), book::turn_y(40));
inline const Rows kProjection = book::perspective_gl(book::radians(60), 1.5, 0.1, 100);
inline constexpr const char* kPoints =
    "--point 0.5,0.25,-0.5 --point -1,0.5,0 --point 0.25,-0.5,1 ";

}  // namespace glassbox::test
