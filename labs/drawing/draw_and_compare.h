// Draws a picture with the student's functions and with the pipeline's own (the reference), and
// finds where the two differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "labs/drawing/drawing.h"

#include <glassbox/images/image.h>

namespace glassbox::labs {

struct WrongRecord {
  std::size_t stage = 0;   // index into DrawingResult::stages
  std::size_t record = 0;  // its index among the records (inputs) of that stage
  std::uint32_t triangle = kNone;
  WrongNumber number;
  std::string input;  // in words
};

// An input that is kept for display, with the first numbers of the student's answer and of the
// reference's.
struct KeptRecord {
  std::size_t stage = 0, record = 0;
  std::uint32_t triangle = kNone;
  Numbers yours, reference;
  std::optional<WrongNumber> wrong;
};

struct JudgedStage {
  std::string name, stage, functions;  // as in DrawnStage
  std::uint64_t records = 0, wrong = 0;
};

struct WrongPixel {
  int x = 0, y = 0;
  Rgba8 yours, reference;
  // The triangles that are visible at the pixel in the two pictures; empty: the background.
  std::optional<std::uint32_t> your_triangle, reference_triangle;
};

struct DrawingResult {
  Image<Rgba8> yours, reference;
  std::optional<Image<Rgba8>> truth;  // LabDrawing::truth, if it has one
  std::vector<JudgedStage> stages;    // in the order of the pipeline
  // the wrong records of each stage, at most the first kMaxWrong; in the order of the stages
  std::vector<WrongRecord> wrong;
  std::vector<KeptRecord> kept;  // wrong records, and right ones while there is room
  std::uint64_t differing_pixels = 0;
  std::optional<WrongPixel> first_pixel;  // the first that differs, row by row from the top
  // The index of the first wrong record of the first stage that has any; and the index of the first
  // one that concerns the triangles of first_pixel.
  std::optional<std::size_t> first_record, record_of_pixel;

  bool right() const { return wrong.empty(); }
};
inline constexpr std::size_t kMaxWrong = 2000;
inline constexpr std::size_t kKeptNumbers = 300'000;  // how many numbers of right records are kept

// What the student's functions and the reference made, so that it can be drawn again.
struct ComparedPictures {
  DrawingResult result;
  PictureSetup yours, reference;
};

// Draws the picture with the student's functions and with the reference. An error says what
// prevented it; if it comes from the student's code, `student` has the details.
Result<ComparedPictures> draw_and_compare(const LabDrawing& lab, const DrawingInput& input,
                                          AnswerSource& student);

}  // namespace glassbox::labs
