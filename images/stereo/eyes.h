// Two pictures, one for each eye.
#pragma once

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Refuses eyes of different sizes; `place` names what needed them.
Result<void> check_eyes(std::string place, const Image<Rgba8>& left, const Image<Rgba8>& right);

}  // namespace glassbox
