// Points, vectors, colours and rectangles as JSON arrays, matrices as arrays of rows. Numbers that
// are not finite become null.
#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>
#include <glassbox/raster/stages.h>

namespace glassbox {

// The number, or null if it is infinite or NaN, which JSON cannot represent.
inline nlohmann::ordered_json finite_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

// A number that may be infinite, such as the distance of the far plane; then it becomes the string
// "inf" or "-inf". NaN becomes null.
inline nlohmann::ordered_json finite_or_inf(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return finite_json(value);
}

template <int N, class T>
nlohmann::ordered_json numbers_json(const glm::vec<N, T>& v) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (int i = 0; i < N; ++i) json.push_back(v[i]);
  return json;
}

template <class T>
concept HasCoordinates = requires(const T& point) {
  typename T;
  to_glm(point);
};
template <HasCoordinates Coordinates>
nlohmann::ordered_json numbers_json(const Coordinates& point) {
  return numbers_json(to_glm(point));
}

template <class T>
concept HasChannels = requires(const T& color) {
  color.r;
  color.a;
};
template <HasChannels Color>
nlohmann::ordered_json numbers_json(const Color& c) {
  return {c.r, c.g, c.b, c.a};
}

inline nlohmann::ordered_json numbers_json(const PixelRect& r) {
  return {r.x0, r.y0, r.x1, r.y1};
}

template <class T>
nlohmann::ordered_json rows_json(const glm::mat<4, 4, T>& m) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  }
  return rows;
}

}  // namespace glassbox
