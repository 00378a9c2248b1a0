// A picture with the student's functions beside the reference's: where they part.
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
  std::size_t record = 0;  // of those that the stage was asked
  std::uint32_t triangle = kNone;
  WrongNumber number;
  Numbers given;  // the first numbers of the question
};

// A record for whoever wants to look at it: the first numbers of both answers.
struct KeptRecord {
  std::size_t stage = 0, record = 0;
  std::uint32_t triangle = kNone;
  Numbers yours, reference;
  std::optional<WrongNumber> wrong;
};

struct JudgedStage {
  std::string name, stage, functions;  // as DrawnStage has them
  std::uint64_t records = 0, wrong = 0;
};

struct WrongPixel {
  int x = 0, y = 0;
  Rgba8 yours, reference;
  // The triangles that are seen there; none: the background.
  std::optional<std::uint32_t> your_triangle, reference_triangle;
};

struct DrawingResult {
  Image<Rgba8> yours, reference;
  std::optional<Image<Rgba8>> truth;  // LabDrawing::truth, if it has one
  std::vector<JudgedStage> stages;    // in the order of the pipeline
  std::vector<WrongRecord> wrong;     // by stage; of each the first kMostWrong
  std::vector<KeptRecord> kept;       // the wrong ones, and others as far as there is room
  std::uint64_t differing_pixels = 0;
  std::optional<WrongPixel> first_pixel;  // row by row from the top
  // Among the wrong records the first of the first stage; and the same of those that concern the triangles of first_pixel.
  std::optional<std::size_t> first_record, record_of_pixel;

  bool right() const { return wrong.empty(); }
};
inline constexpr std::size_t kMostWrong = 2000;
inline constexpr std::size_t kKeptNumbers = 300'000;  // of records that are right

// What the student's functions made, for whoever wants to draw it again.
struct DrawnBoth {
  DrawingResult result;
  StandIn yours, reference;
};

// An error is what kept it from being drawn; if it comes from the student's code, `student` knows.
Result<DrawnBoth> draw_both(const LabDrawing& lab, const Drawn& drawn, Answering& student);

}  // namespace glassbox::labs
