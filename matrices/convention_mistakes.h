// Mistakes of convention that make points invisible. Each is given as the change of a setup that
// undoes it.
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
  kRadians,      // the other way round
  kClearCorner,  // [3][3] = 0
  kDepthRange,   // clips at -w <= z instead of 0 <= z, or the other way round
  kEyeHand,      // negates the eye's z, between view and projection
  kTurnRound,    // negates the eye's x and z, in the view
  kInvertView,
  kViewFactors,       // changes T R to R T
  kViewFactorsBack,   // changes R T to T R
  kViewOffsetSign,    // negates the eye's position
  kModelFactors,      // changes T R to R T
  kModelFactorsBack,  // changes R T to T R
  kInvertModel,
  kFlipX,  // the last two only if the user gave the expected pixel
  kFlipY,
};

struct ConventionMistake {
  SetupChange change;
  const char* id;      // does not change between versions: "eye-hand"
  const char* what;    // "transpose every matrix"
  const char* remedy;  // what to look for in the user's program
  // Undoes the mistake. Returns false if that makes no sense, for example if the matrix was not
  // given.
  bool (*undo)(MatrixSetup& setup);
};

// All mistakes, the commonest first. Reports keep this order if nothing else decides.
std::span<const ConventionMistake> convention_mistakes();

}  // namespace glassbox
