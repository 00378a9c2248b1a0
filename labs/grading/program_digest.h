// Which program this is.
#pragma once

#include <string>

namespace glassbox::labs::grading {

// A digest of the program's own file, which another build does not have; empty where it cannot be read.
std::string program_digest();

}  // namespace glassbox::labs::grading
