// Describes in words where two framebuffers differ.
#pragma once

#include <bit>
#include <cstring>
#include <sstream>
#include <string>

#include <glassbox/base/arithmetic.h>
#include <glassbox/render/engine/framebuffer.h>

namespace glassbox::test {

inline std::string in_words(const Rgba8& c) {
  std::ostringstream text;
  text << int(c.r) << " " << int(c.g) << " " << int(c.b) << " " << int(c.a);
  return text.str();
}
template <Arithmetic T>
std::string in_words(T value) {
  std::ostringstream text;
  text.precision(9);
  text << value;
  return text.str();
}

// Empty if the planes have the same bytes.
template <class Pixel>
std::string plane_differs(const char* name, const Image<Pixel>& expected,
                          const Image<Pixel>& actual) {
  std::ostringstream text;
  if (expected.width != actual.width || expected.height != actual.height) {
    text << name << ": " << actual.width << " x " << actual.height << " instead of "
         << expected.width << " x " << expected.height << "; ";
    return text.str();
  }
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    if (std::memcmp(&expected.pixels[i], &actual.pixels[i], sizeof(Pixel)) == 0) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return "";
  const auto width = std::size_t(expected.width);
  text << name << ": " << count << " pixels, first (" << first % width << ", " << first / width
       << "): " << in_words(actual.pixels[first]) << " instead of "
       << in_words(expected.pixels[first]) << "; ";
  return text.str();
}

// The staged reference always writes depths; those of the tile engine are compared if `want_depth`
// is set.
inline std::string planes_differ(const Framebuffer& staged, const Framebuffer& tiled,
                                 bool want_depth) {
  return plane_differs("color", staged.color, tiled.color) +
         (want_depth ? plane_differs("depth", staged.depth, tiled.depth) : "") +
         plane_differs("distance", staged.distance, tiled.distance) +
         plane_differs("id", staged.id, tiled.id) +
         plane_differs("writes", staged.writes, tiled.writes);
}

}  // namespace glassbox::test
