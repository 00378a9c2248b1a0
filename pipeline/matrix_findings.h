// What is wrong with three matrices that claim to be model, view and projection: each on its own, and what they say to one
// another. A finding is an alarm only where no correct set of matrices for the dialect looks so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glassbox/pipeline/api_dialects.h>
#include <glassbox/pipeline/matrix_check.h>
#include <glassbox/pipeline/projection_check.h>

namespace glassbox {

enum class Hand { kRight, kLeft };

// What the user's program has, and what is known about it.
struct MatrixSetup {
  GivenMatrix model, view, projection;
  ApiDialect dialect;
  std::optional<Hand> world;          // the world's handedness, if the user knows it
  std::optional<glm::ivec2> picture;  // width and height in pixels, if the user gave them
};

// kNote: worth knowing. kHint: legal, but often a slip. kAlarm: contradicts what the matrix claims to be.
enum class Severity { kNote, kHint, kAlarm };

struct Finding {
  Severity severity = Severity::kNote;
  const char* id = "";      // stable: "transposed", "depth-lost"
  const char* matrix = "";  // "model", "view", "projection", or empty for what concerns all
  std::string cause, remedy;
};

std::vector<Finding> check_matrices(const MatrixSetup& setup);

// Which worlds these matrices draw as they are; the other hand comes out mirrored left to right. Nothing where the matrices
// are not a view and a projection.
std::optional<Hand> world_drawn(const MatrixSetup& setup);

}  // namespace glassbox
