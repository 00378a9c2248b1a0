#include "app/arguments.h"

#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <glassbox/images/srgb.h>

namespace glassbox::app {

namespace {

// The whole of `text` as a number, or nothing.
bool read_number(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

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

}  // namespace

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

Size parse_size(const std::string& text) {
  constexpr int kMaxSide = 16384;
  const std::vector<std::string> parts = split(text, 'x');
  double width = 0;
  double height = 0;
  const auto legal = [](double side) {
    return side >= 1 && side <= kMaxSide && side == std::floor(side);
  };
  if (parts.size() != 2 || !read_number(parts[0], width) || !read_number(parts[1], height) ||
      !legal(width) || !legal(height)) {
    throw CLI::ValidationError(
        "--size",
        fmt::format("needs WxH with whole numbers from 1 to {}, not '{}'", kMaxSide, text));
  }
  return {int(width), int(height)};
}

Rgba8 parse_background(const std::string& text) {
  const std::array<double, 3> rgb = parse_numbers<3>("--background", text);
  for (const double channel : rgb) {
    if (!(channel >= 0 && channel <= 1)) {
      throw CLI::ValidationError(
          "--background",
          fmt::format("needs three numbers from 0 to 1, not '{}'; divide bytes by 255", text));
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

}  // namespace glassbox::app
