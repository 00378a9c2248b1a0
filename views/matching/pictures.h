// What the costs are made of: colours and their grey, as planes, and census words.
#pragma once

#include <cstdint>

#include <glassbox/base/line_memory.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

// Of 8-bit pictures, as stored: the costs compare codes, not light. Alpha is left out.
struct Planes {
  int width = 0, height = 0;  // px
  LineVector<std::uint8_t> r, g, b;
  LineVector<std::uint8_t> grey;  // (77 r + 150 g + 29 b + 128) / 256
};
Planes planes_of(const Image<Rgba8>& image);

// One bit for each of 32 neighbours, those of a window of 7 by 5 but for the two at the ends of its own row: whether it is darker than the centre. Beyond the edge the picture's
// last
// row and column go on. Gain and offset of the grey do not change a word (C-110), but where they clip.
LineVector<std::uint32_t> census_words(const Planes& picture);

}  // namespace glassbox::views
