// Writes arrays in NumPy's .npz format: a zip archive with one .npy file for each
// (numpy.lib.format, version 1.0).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/render/trace/arrays.h>

namespace glassbox::app {

// An archive of the wanted arrays, and of `about` as an array of bytes with this name. The bytes
// are moved out of `arrays`.
Result<std::vector<std::byte>> make_npz(TraceArrays& arrays, const std::string& about);

}  // namespace glassbox::app
