// Three matrices given as model, view and projection, and what is known about the program that uses
// them.
#pragma once

#include <optional>
#include <string>

#include <glassbox/matrices/matrix_facts.h>
#include <glassbox/pipeline/api_dialects.h>

namespace glassbox {

enum class Handedness { kRight, kLeft };

struct MatrixSetup {
  GivenMatrix model, view, projection;
  ApiDialect dialect;
  std::optional<Handedness> world;    // the world's handedness, if the user knows it
  std::optional<glm::ivec2> picture;  // width and height in pixels, if the user gave them
};

// The handedness of worlds that these matrices draw correctly; worlds of the other handedness
// appear mirrored left to right. Nothing if the matrices are not a view and a projection.
std::optional<Handedness> drawn_handedness(const MatrixSetup& setup);

// The dialect (graphics API) whose conventions a projection follows, as far as can be told, with
// the reason. OpenGL if nothing can be told.
struct GuessedDialect {
  const ApiDialect* dialect;
  std::string reason;
};
GuessedDialect guess_dialect(const GivenMatrix& projection);

}  // namespace glassbox
