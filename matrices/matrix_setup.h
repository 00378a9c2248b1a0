// Three matrices given as model, view and projection, and what is known about the program that uses
// them.
#pragma once

#include <optional>
#include <string>

#include <glassbox/matrices/matrix_facts.h>
#include <glassbox/pipeline/api_dialects.h>

namespace glassbox {

enum class Handedness { kRight, kLeft };

// Which faces a graphics API takes for front faces: by the direction in which their corners run on
// the screen. (OpenGL and WebGPU take counter-clockwise ones by default, Direct3D and Metal
// clockwise ones. Vulkan has no default.)
enum class FrontFaces { kCounterClockwise, kClockwise };

struct MatrixSetup {
  GivenMatrix model, view, projection;
  ApiDialect dialect;
  std::optional<Handedness> world;    // the world's handedness, if the user knows it
  std::optional<glm::ivec2> picture;  // width and height in pixels, if the user gave them
  // Absent: the faces that are counter-clockwise in the model, even if the matrices mirror.
  std::optional<FrontFaces> front{};
};

// The matrices that a user gives, and what the user says about the program that uses them.
struct OwnMatrices {
  GivenMatrix model, view, projection;
  const ApiDialect* dialect = nullptr;  // nullptr: guess it
  std::optional<Handedness> world;
  std::optional<FrontFaces> front;

  bool replace_camera() const { return view.given || projection.given; }
  bool any() const { return model.given || replace_camera(); }
};

// The same as a setup, and where its dialect comes from: "as given", "guessed: ...".
struct NamedSetup {
  MatrixSetup setup;
  std::string dialect_reason;
};
NamedSetup setup_of(const OwnMatrices& matrices);

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
