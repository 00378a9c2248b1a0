// Undoes the filters of a PNG (PNG, third edition, 9.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glassbox {

// `bytes` holds `rows` rows of a filter byte and `row_bytes` filtered bytes each. Afterwards its
// front holds the rows themselves, without filter bytes. `pixel_bytes` is the number of bytes from
// a sample to the same one of the next pixel: 1 to 4, 6 or 8. Returns false, with `bytes` in any
// state, if a filter byte is not one of the five that PNG has.
bool undo_png_filters(std::span<std::uint8_t> bytes, std::size_t rows, std::size_t row_bytes,
                      std::size_t pixel_bytes);

}  // namespace glassbox
