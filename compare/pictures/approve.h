// Accepts a new picture as the reference.
#pragma once

#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// Whether the environment variable CI is set, as on continuous-integration servers, where no person
// looks at the picture.
bool on_ci_server();

// Copies the file `test` over `reference`, completely or not at all, and makes its folder if there
// is none. Refused on a CI server, for a test that cannot be decoded, and where the two names have
// different extensions.
Result<void> approve_picture(const std::string& reference, const std::string& test);

}  // namespace glassbox
