#include "cli/options/arguments.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <glassbox/base/counted.h>
#include <glassbox/images/srgb.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/trace/numbering.h>

namespace glassbox {

namespace {

// Reads all of `text` as one number. Returns false if it is not one.
bool read_number(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

// N whole numbers from 0 that fit into an int; nothing if the text is anything else.
template <std::size_t N>
std::optional<std::array<int, N>> read_whole_numbers(const std::string& text, char separator) {
  const std::vector<std::string> parts = split(text, separator);
  if (parts.size() != N) return std::nullopt;
  std::array<int, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    double number = 0;
    if (!read_number(parts[i], number)) return std::nullopt;
    if (!(number >= 0 && number <= std::numeric_limits<int>::max())) return std::nullopt;
    if (number != std::floor(number)) return std::nullopt;
    numbers[i] = int(number);
  }
  return numbers;
}

}  // namespace

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

template <std::size_t N>
std::array<double, N> parse_numbers(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  std::array<double, N> numbers{};
  bool good = parts.size() == N;
  for (std::size_t i = 0; good && i < N; ++i) {
    good = read_number(parts[i], numbers[i]) && std::isfinite(numbers[i]);
  }
  if (!good) {
    throw CLI::ValidationError(
        option, fmt::format("needs {} finite numbers separated by commas, not '{}'", N, text));
  }
  return numbers;
}

template std::array<double, 2> parse_numbers<2>(const std::string&, const std::string&);
template std::array<double, 3> parse_numbers<3>(const std::string&, const std::string&);
template std::array<double, 4> parse_numbers<4>(const std::string&, const std::string&);
template std::array<double, 6> parse_numbers<6>(const std::string&, const std::string&);

Size parse_size(const std::string& text, const std::string& option) {
  const auto legal = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  const auto sides = read_whole_numbers<2>(text, 'x');
  if (!sides || !legal((*sides)[0]) || !legal((*sides)[1])) {
    throw CLI::ValidationError(
        option,
        fmt::format("needs WxH with whole numbers from 1 to {}, not '{}'", kMaxImageSide, text));
  }
  return {(*sides)[0], (*sides)[1]};
}

PixelPosition parse_pixel(const std::string& option, const std::string& text) {
  const auto place = read_whole_numbers<2>(text, ',');
  if (!place) {
    throw CLI::ValidationError(
        option,
        fmt::format("needs X,Y in whole pixels, counted from the top left corner, not '{}'", text));
  }
  return {(*place)[0], (*place)[1]};
}

Result<void> check_triangle(const std::string& what, const Scene& scene, std::uint32_t number) {
  if (find_triangle(scene, number)) return {};
  return fail(fmt::format("{} {}", what, number),
              "the scene has " + counted(count_triangles(scene), "triangle"),
              "they are numbered from 0");
}

Result<void> check_pixel(const std::string& option, PixelPosition pixel, const Size& size) {
  if (pixel.x < size.width && pixel.y < size.height) return {};
  return fail(fmt::format("{} {},{}", option, pixel.x, pixel.y),
              fmt::format("the picture has {} x {} pixels, and columns and rows are counted from 0",
                          size.width, size.height),
              "name a pixel in it, or another --size");
}

PixelRect parse_rectangle(const std::string& option, const std::string& text) {
  const auto sides = read_whole_numbers<4>(text, ',');
  if (sides) {
    const auto [x0, y0, x1, y1] = *sides;
    if (x0 < x1 && y0 < y1) return {x0, y0, x1, y1};
  }
  throw CLI::ValidationError(option, fmt::format("needs X0,Y0,X1,Y1 in whole pixels from the top "
                                                 "left corner, with X0 < X1 and Y0 < Y1, not '{}'",
                                                 text));
}

Result<void> check_rectangle(const std::string& option, const PixelRect& rectangle,
                             const Size& size) {
  if (rectangle.x1 <= size.width && rectangle.y1 <= size.height) return {};
  return fail(option, fmt::format("the picture has {} x {} pixels", size.width, size.height),
              "name a part of it, or another --size");
}

Rgba8 parse_background(const std::string& text, const std::string& option) {
  const std::array<double, 3> rgb = parse_numbers<3>(option, text);
  for (const double channel : rgb) {
    if (!(channel >= 0 && channel <= 1)) {
      throw CLI::ValidationError(
          option,
          fmt::format("needs three numbers from 0 to 1, not '{}'; divide values of 0 to 255 by 255",
                      text));
    }
  }
  return {encode_unorm8(float(rgb[0])), encode_unorm8(float(rgb[1])), encode_unorm8(float(rgb[2])),
          255};
}

double parse_number(const std::string& option, const std::string& text) {
  double value = 0;
  if (!read_number(text, value)) {
    throw CLI::ValidationError(option, fmt::format("needs a number, not '{}'", text));
  }
  return value;
}

double parse_distance(const std::string& option, const std::string& text) {
  double value = 0;
  if (!read_number(text, value) || std::isnan(value)) {
    throw CLI::ValidationError(option, fmt::format("needs a number or 'inf', not '{}'", text));
  }
  return value;
}

}  // namespace glassbox
