// The slips of convention that bring points out of the picture, each as the change of a setup that undoes it.
#pragma once

#include <span>

#include "app/step/matrices/matrix_setup.h"

namespace glassbox {

enum class Change {
  kTransposeAll,
  kTransposeModel,
  kTransposeView,
  kTransposeProjection,
  kExchangeViewProjection,
  kExchangeModelView,
  kDegrees,      // the angle of view in degrees, where it was taken for radians
  kRadians,      // the other way round
  kClearCorner,  // [3][3] = 0
  kDepthRange,   // clipped at -w <= z instead of 0 <= z, or the other way round
  kEyeHand,      // z of the eye negated, between view and projection
  kTurnRound,    // x and z of the eye negated, in the view
  kInvertView,
  kViewFactors,       // T R became R T
  kViewFactorsBack,   // R T became T R
  kViewOffsetSign,    // the eye's position with its minus
  kModelFactors,      // T R became R T
  kModelFactorsBack,  // R T became T R
  kInvertModel,
  kFlipX,  // the last two only where it is known which pixel was expected
  kFlipY,
};

struct Slip {
  Change change;
  const char* id;      // stable: "eye-hand"
  const char* what;    // "transpose every matrix"
  const char* remedy;  // what to look for in one's own program
  // Undoes it; false where that makes no sense here, as for a matrix that was not given.
  bool (*undo)(MatrixSetup& setup);
};

// In the order in which they are named where nothing else tells them apart: the commonest first.
std::span<const Slip> slips();

}  // namespace glassbox
