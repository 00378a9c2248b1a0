// Two pictures, one for each eye.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Refuses eyes of different sizes; `place` names what needed them.
Result<void> check_eyes(std::string place, const Image<Rgba8>& left, const Image<Rgba8>& right);

// Refuses a disparity map that is not of the picture's size.
Result<void> check_disparity(const Image<Rgba8>& picture, const Image<float>& disparity);

}  // namespace glassbox
