// What study scene says: the ways to draw a scene, for programs, spreadsheets, people and browsers.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/options/arguments.h"
#include "study/curve/curve.h"
#include "study/experiment/results.h"
#include "views/layers/second_eye_error.h"

#include <glassbox/base/error.h>

namespace glassbox::app {

// For two eyes, as glassbox render --stereo places them: the right one drawn, or warped from the left one's layers.
struct SecondEyes {
  StereoPair pair;
  std::vector<views::SecondEyeError> warped;  // of 1 layer, then of 2
  std::string left_out;                       // why there are none; empty where there are
};

struct CurveReport {
  std::string scene;  // as it was given
  Size size;
  std::vector<std::string> words;  // that all ways share
  study::Origin origin;
  std::string command;  // measures it again
  study::Curve curve;
  SecondEyes second_eyes;
};

// Draws the point's picture, in the time that was measured.
std::string command_of(const CurveReport& report, const study::CurvePoint& point);

// docs/study.md has the fields.
nlohmann::ordered_json curve_json(const CurveReport& report);

// A line for each point, after one with the names of the columns.
std::string curve_csv(const CurveReport& report);

// Each knob turned alone, and the front.
std::string curve_text(const CurveReport& report);

// Error against time, with the picture of each point and what differs.
Result<std::string> curve_page(const CurveReport& report);

}  // namespace glassbox::app
