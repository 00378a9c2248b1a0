// A selection of the four channels of a colour.
#pragma once

namespace glassbox {

// The channels that may be written. An anaglyph's left eye writes red, its right eye green and blue
// (S0-05).
struct ColorMask {
  bool r = true, g = true, b = true, a = true;
};

}  // namespace glassbox
