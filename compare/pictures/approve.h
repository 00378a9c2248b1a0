// A new picture taken as the reference.
#pragma once

#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// Whether the environment variable CI is set, as continuous-integration servers do: what runs there has nobody to look at
// the picture.
bool on_ci_server();

// Copies the file `test` over `reference`, wholly or not at all, making its folder where there is none. Refused on a CI
// server, for a test that cannot be decoded, and where the two names end differently.
Result<void> approve(const std::string& reference, const std::string& test);

}  // namespace glassbox
