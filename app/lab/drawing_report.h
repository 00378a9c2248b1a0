// What glassbox lab render says of a picture: as text, and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "labs/drawing/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::app {

struct DrawingReport {
  const labs::Lab& lab;
  const labs::LabDrawing& drawing;
  const labs::DrawingResult& result;
  std::string scene;           // as the user gave it
  std::string picture_words;   // the picture's options, as the user gave them
  std::string said;            // what the student's code printed
  double seconds = 0;          // from the command to the pictures, without compiling
  double student_seconds = 0;  // in the student's process
};

std::string drawing_text(const DrawingReport& report);
nlohmann::ordered_json drawing_json(const DrawingReport& report);

// Yours on the left, the reference's on the right; then what the pipeline shows, where the lab draws in another way.
Image<Rgba8> side_by_side(const labs::DrawingResult& result);

// "#8f2311"
std::string colour_text(const Rgba8& colour);

}  // namespace glassbox::app
