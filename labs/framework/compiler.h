// The compiler for programs made from students' files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glassbox::labs {

// The environment variable CXX, or the compiler that glassbox was built with, or c++.
std::string compiler();

// The files that a compiler's dependency rule "out.o: a.cpp b.h \ c\ d.h" names, the source file
// first.
std::vector<std::filesystem::path> dependencies_of(const std::string& rule);

}  // namespace glassbox::labs
