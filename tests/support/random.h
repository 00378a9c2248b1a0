// Numbers for property tests: the same on every machine, from a seed that a failure prints.
#pragma once

#include "study/random.h"

namespace glassbox::test {

using study::Random;

}  // namespace glassbox::test
