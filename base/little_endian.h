// Refuses to be compiled where numbers lie in memory with their highest byte first.
//
// glTF's buffers, .ldi files, pages' tables and PLY files hold numbers with the lowest byte first,
// and are read and written as they lie in memory; the lanes take a colour's four bytes for one
// number whose lowest byte is red. A big-endian machine would draw wrong pictures without a word.
// Whoever relies on the order includes this.
#pragma once

#include <bit>

namespace glassbox {

static_assert(std::endian::native == std::endian::little,
              "Glassbox needs a little-endian processor, such as x86-64 or ARM64: it takes the "
              "numbers of files and the bytes of colours as they lie in memory. Build it for "
              "one of these (docs/building.md).");

}  // namespace glassbox
