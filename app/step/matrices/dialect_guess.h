// Which interface a projection was made for.
#pragma once

#include <string>

#include "app/step/matrices/projection_facts.h"

namespace glassbox {

// The dialect whose conventions a projection follows, as far as can be told, and why. OpenGL where nothing can be told.
struct GuessedDialect {
  const ApiDialect* dialect;
  std::string reason;
};
GuessedDialect guess_dialect(const GivenMatrix& projection);

}  // namespace glassbox
