// Arrays as NumPy's .npz: a zip archive with a .npy file for each (numpy.lib.format, version 1.0).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/render/trace/arrays.h>

namespace glassbox::app {

// The wanted arrays, and `about` as the bytes of an array of that name. The arrays' own bytes are gone then.
Result<std::vector<std::byte>> make_npz(TraceArrays& arrays, const std::string& about);

}  // namespace glassbox::app
