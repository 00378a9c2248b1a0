// A matrix in a report: as three lines of text, or as rows in JSON.
#pragma once

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

// Three lines of text, one for each row of the matrix. The first line begins with the name, padded
// to eight characters, and ends with `what`, a description of the matrix. The function `number`
// writes each number.
inline std::string matrix_lines(const std::string& name, const views::Matrix3d& matrix,
                                const std::string& what, std::string (*number)(double)) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("  {:<8}", row == 0 ? name : "");
    for (int column = 0; column < 3; ++column) text += number(matrix(row, column));
    text += row == 0 && !what.empty() ? "   " + what + "\n" : "\n";
  }
  return text;
}

inline nlohmann::ordered_json matrix_json(const views::Matrix3d& matrix) {
  auto rows = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(
        {finite_json(matrix(row, 0)), finite_json(matrix(row, 1)), finite_json(matrix(row, 2))});
  }
  return rows;
}

}  // namespace glassbox::views
