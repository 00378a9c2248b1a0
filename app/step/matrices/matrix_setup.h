// Three matrices that claim to be model, view and projection, and what is known about the program that has them.
#pragma once

#include <optional>
#include <string>

#include <glassbox/pipeline/api_dialects.h>

#include "app/step/matrices/matrix_facts.h"

namespace glassbox {

enum class Hand { kRight, kLeft };

struct MatrixSetup {
  GivenMatrix model, view, projection;
  ApiDialect dialect;
  std::optional<Hand> world;          // the world's handedness, if the user knows it
  std::optional<glm::ivec2> picture;  // width and height in pixels, if the user gave them
};

// Which worlds these matrices draw as they are; the other hand comes out mirrored left to right. Nothing where the matrices
// are not a view and a projection.
std::optional<Hand> world_drawn(const MatrixSetup& setup);

// The dialect whose conventions a projection follows, as far as can be told, and why. OpenGL where nothing can be told.
struct GuessedDialect {
  const ApiDialect* dialect;
  std::string reason;
};
GuessedDialect guess_dialect(const GivenMatrix& projection);

}  // namespace glassbox
