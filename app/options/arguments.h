// Option values: vectors, sizes, pixels, colours. A value that is not understood is refused by CLI11 with the text
// given here.
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

namespace glassbox::app {

struct Size {
  int width = 1280;
  int height = 720;
};

// "a,b," -> "a", "b", "": the parts between separators, empty ones too.
std::vector<std::string> split(const std::string& text, char separator);

// An error where the scene has no triangle of this number; `what` is the option or command that asks for it.
Result<void> check_triangle(const std::string& what, const Scene& scene, std::uint32_t number);

// "1.5,-2,0": exactly N finite numbers. Throws CLI::ValidationError, which names the option, otherwise.
template <std::size_t N>
std::array<double, N> parse_numbers(const std::string& option, const std::string& text);

// "1280x720", each side 1 .. 16384.
Size parse_size(const std::string& text, const std::string& option = "--size");

// "12,34": a pixel, by its column and row from the top left.
PixelAt parse_pixel(const std::string& option, const std::string& text);

// An error where a picture of this size does not have the pixel.
Result<void> check_pixel(const std::string& option, PixelAt pixel, const Size& size);

// "600,300,680,380": the pixels with x0 <= x < x1 and y0 <= y < y1, at least one.
PixelRect parse_rectangle(const std::string& option, const std::string& text);

// An error where the rectangle reaches beyond a picture of this size.
Result<void> check_rectangle(const std::string& option, const PixelRect& rectangle,
                             const Size& size);

// "r,g,b", each in [0, 1]: the colour as displayed, so that 0.5 becomes byte 128.
Rgba8 parse_background(const std::string& text, const std::string& option = "--background");

// A number, which may be "nan" or "inf": what is asked of it is for the camera to say.
double parse_number(const std::string& option, const std::string& text);

// A number that may be "inf".
double parse_distance(const std::string& option, const std::string& text);

}  // namespace glassbox::app
