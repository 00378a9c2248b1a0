// The report of `glassbox lab render` on a picture, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "labs/drawing/draw_and_compare.h"
#include "labs/framework/lab.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct DrawingReport {
  const labs::Lab& lab;
  const labs::LabDrawing& drawing;
  const labs::DrawingResult& result;
  std::string scene;           // as the user gave it
  std::string picture_words;   // the picture's options, as the user gave them
  std::string printed;         // what the student's code printed
  double seconds = 0;          // from the start of the command to the pictures, without compilation
  double student_seconds = 0;  // the part of `seconds` in the student's process
};

std::string drawing_text(const DrawingReport& report);
nlohmann::ordered_json drawing_json(const DrawingReport& report);

// The student's picture on the left and the reference's on the right, then the pipeline's own
// picture if the lab has one to compare with.
Image<Rgba8> side_by_side(const labs::DrawingResult& result);

// The colour in hexadecimal: "#8f2311"
std::string colour_text(const Rgba8& colour);

// The inspector page of a run that used a student's functions.

// Makes the page. `words` are the picture's options, as the user gave them. In lab 9 the page shows
// the left eye's run.
Result<std::string> lab_drawing_page(const DrawingReport& report, const labs::DrawingInput& drawn,
                                     const labs::ComparedPictures& both,
                                     const std::vector<std::string>& words);

}  // namespace glassbox::labs
