// The labs, one folder each.
#pragma once

#include "labs/framework/lab.h"

namespace glassbox::labs {}  // namespace glassbox::labs
