// Accessors: typed arrays in the bytes of a buffer, strided or sparse; every read is checked in
// advance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>

namespace glassbox::gltf {

// Checks all accessors of the file, used or not: offsets, strides and counts against the buffer
// views, and counts of accessors without data (which are all zeros) against the size of the file,
// so that a short file cannot request much memory.
Result<void> check_accessors(const Asset& asset);

// The number of components per element: 3 for VEC3.
std::size_t components(const tinygltf::Accessor& accessor);

// Returns the elements one after the other as double, which represents every component type
// exactly. Normalised integers c become c / max, at least -1, where max is the type's largest
// number (glTF 2.0, section 3.6.2.2). Sparse accessors are resolved. Do not use it for matrices of
// bytes or shorts, whose columns are padded.
Result<std::vector<double>> read_numbers(const Asset& asset, std::size_t accessor);

// Returns the elements of an accessor of unsigned integers.
Result<std::vector<std::uint32_t>> read_indices(const Asset& asset, std::size_t accessor);

}  // namespace glassbox::gltf
