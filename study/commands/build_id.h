// Identifies the build of the program.
#pragma once

#include <string>

namespace glassbox::study {

// "0.1.0, build 3f2a9c01": the version, and a checksum of the program file, which differs between
// builds.
std::string version_and_build();

}  // namespace glassbox::study
