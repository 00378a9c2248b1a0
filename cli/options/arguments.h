// Parses the values of options: vectors, sizes, pixels, colours. For a value that cannot be parsed,
// CLI11 prints the error text given here.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

struct Size {
  int width = 1280;
  int height = 720;
};

// The parts between separators, including empty ones: "a,b," gives "a", "b", "".
std::vector<std::string> split(const std::string& text, char separator);

// An error if the scene has no triangle with this number. `what` is the option or command that asks
// for it.
Result<void> check_triangle(const std::string& what, const Scene& scene, std::uint32_t number);

// Parses exactly N finite numbers: "1.5,-2,0". Otherwise throws CLI::ValidationError, which names
// the option.
template <std::size_t N>
std::array<double, N> parse_numbers(const std::string& option, const std::string& text);

// Parses a size: "1280x720", each side from 1 to 16384.
Size parse_size(const std::string& text, const std::string& option = "--size");

// Parses a pixel, its column and row from the top left: "12,34".
PixelPosition parse_pixel(const std::string& option, const std::string& text);

// An error if a picture of this size does not have the pixel.
Result<void> check_pixel(const std::string& option, PixelPosition pixel, const Size& size);

// Parses a rectangle: "600,300,680,380" means the pixels with x0 <= x < x1 and y0 <= y < y1, at
// least one.
PixelRect parse_rectangle(const std::string& option, const std::string& text);

// An error if the rectangle is not inside a picture of this size.
Result<void> check_rectangle(const std::string& option, const PixelRect& rectangle,
                             const Size& size);

// Parses a colour "r,g,b", each in [0, 1]. It is the displayed colour, so 0.5 becomes byte 128.
Rgba8 parse_background(const std::string& text, const std::string& option = "--background");

// Parses a number, which may be "nan" or "inf": the camera decides whether to accept it.
double parse_number(const std::string& option, const std::string& text);

// Parses a number that may be "inf".
double parse_distance(const std::string& option, const std::string& text);

}  // namespace glassbox
