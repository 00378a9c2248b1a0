// Checks of two pictures, one for each eye.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Refuses pictures of different sizes; the error names `place`.
Result<void> check_eyes(std::string place, const Image<Rgba8>& left, const Image<Rgba8>& right);

// Refuses a disparity map whose size differs from the picture's.
Result<void> check_disparity(const Image<Rgba8>& picture, const Image<float>& disparity);

}  // namespace glassbox
