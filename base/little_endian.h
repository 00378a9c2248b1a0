// Compilation fails on machines that store the highest byte of a number first (big-endian).
//
// glTF's buffers, .ldi files, the tables in HTML pages and PLY files store numbers with the lowest
// byte first, and are read and written as they are in memory; the vector code in raster/lanes takes
// a colour's four bytes as one number whose lowest byte is red. A big-endian machine would draw
// wrong pictures without an error. Every file that relies on the byte order includes this header.
#pragma once

#include <bit>

namespace glassbox {

static_assert(std::endian::native == std::endian::little,
              "Glassbox needs a little-endian processor, such as x86-64 or ARM64: it takes the "
              "numbers of files and the bytes of colours as they lie in memory. Build it for "
              "one of these (docs/building.md).");

}  // namespace glassbox
