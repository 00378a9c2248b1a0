// Mistakes of convention that make points invisible. Each is described by the change that undoes
// it.
#pragma once

#include <span>

#include <glassbox/matrices/matrix_setup.h>

namespace glassbox {

enum class SetupChange {
  kTransposeAll,
  kTransposeModel,
  kTransposeView,
  kTransposeProjection,
  kExchangeViewProjection,
  kExchangeModelView,
  kDegrees,      // reads the angle of view as degrees, if it was taken for radians
  kRadians,      // reads the angle of view as radians, if it was taken for degrees
  kClearCorner,  // sets [3][3] of the projection to 0
  kDepthRange,   // clips at -w <= z instead of 0 <= z, or the other way round
  kEyeHand,      // negates the eye's z, between view and projection
  kTurnRound,    // negates the eye's x and z, in the view
  kInvertView,
  kViewScale,         // removes one scale of all axes from the view
  kViewFactors,       // changes T R to R T, with a translation T and a rotation R
  kViewFactorsBack,   // changes R T to T R
  kViewOffsetSign,    // negates the eye's position
  kSwapLookAt,        // turns the eye round and moves it away from the point where it stood
  kModelFactors,      // changes T R to R T, as for the view
  kModelFactorsBack,  // changes R T to T R, as for the view
  kInvertModel,
  // kFlipX and kFlipY are tried only if the user gave the expected pixel.
  kFlipX,
  kFlipY,
};

struct ConventionMistake {
  SetupChange change;
  const char* id;      // does not change between versions: "eye-hand"
  const char* what;    // "transpose every matrix"
  const char* remedy;  // what to look for in the user's program
  // Undoes the mistake in `setup`. `points` are the points in object space that should be visible.
  // Returns false if the setup cannot contain the mistake, for example because the matrix was not
  // given.
  bool (*undo)(MatrixSetup& setup, std::span<const glm::dvec4> points);
};

// All mistakes, the commonest first. This is also the order of reports if all else is equal.
std::span<const ConventionMistake> convention_mistakes();

}  // namespace glassbox
