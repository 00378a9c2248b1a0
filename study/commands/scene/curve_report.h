// The report of `glassbox study scene` on the ways to draw a scene, as JSON, CSV, text and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/arguments.h"
#include "study/curve/curve.h"
#include "study/experiment/results.h"
#include "views/layers/second_eye_error.h"

#include <glassbox/base/error.h>

namespace glassbox::study {

// Results for two eyes placed as in glassbox render --stereo. The right eye's picture is drawn, or
// warped from the layers of the left eye's picture.
struct SecondEyes {
  StereoPair pair;
  std::vector<views::SecondEyeError> warped;  // for 1 layer, then for 2 layers
  std::string left_out;                       // the reason if there are no results; else empty
};

struct CurveReport {
  std::string scene;  // as the user gave it
  Size size;
  std::vector<std::string> words;  // options that all measured ways of drawing share
  study::Origin origin;
  std::string command;  // the command line that makes the measurement again
  study::Curve curve;
  SecondEyes second_eyes;
};

// The command line that draws the point's picture with the settings that were measured.
std::string command_of(const CurveReport& report, const study::CurvePoint& point);

// The report as JSON. docs/study.md describes the fields.
nlohmann::ordered_json curve_json(const CurveReport& report);

// CSV: a line of column names, then a line for each point.
std::string curve_csv(const CurveReport& report);

// The report as text: the points at which only one setting (knob) is changed, and the Pareto front.
std::string curve_text(const CurveReport& report);

// A chart of error against time, with the picture of each point and its difference from the
// reference.
Result<std::string> curve_page(const CurveReport& report);

}  // namespace glassbox::study
