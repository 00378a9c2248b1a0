// The compiler that makes programs of students' files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glassbox::labs {

// CXX of the environment, or the compiler that glassbox was built with, or c++.
std::string compiler();

// What was read to make the output of a compiler's rule "out.o: a.cpp b.h \ c\ d.h", the source first.
std::vector<std::filesystem::path> dependencies_of(const std::string& rule);

}  // namespace glassbox::labs
