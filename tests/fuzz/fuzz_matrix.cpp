// Reads any bytes as matrices that a user's program printed, and checks what `glassbox step
// --point` reports about them. The first byte chooses the options. Lines "%%" separate the model,
// the view and the projection matrix; with fewer than three parts the first ones are missing.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/step/point_step.h"
#include "cli/report/text_layout.h"
#include "tests/fuzz/promises.h"

#include <glassbox/matrices/printed_matrix.h>
#include <glassbox/matrices/view_of_matrices.h>

namespace {

using namespace glassbox;
using namespace glassbox::app;
using fuzz::check_error;
using fuzz::require;

void check_numbers(const MatrixText& matrix) {
  for (std::size_t i = 0; i < 16; ++i) {
    const double number = matrix.numbers[i];
    require(!std::isfinite(number) || std::isfinite(float(number)),
            "numbers that a float can hold");
    require(!std::isfinite(number) || matrix.uncertainty[i] >= 0, "an uncertainty");
    require(!std::isfinite(number) || std::isfinite(matrix.uncertainty[i]), "a finite uncertainty");
  }
}

// Prints the numbers without loss and checks that they are read back as the same numbers.
std::string printed(const MatrixText& matrix) {
  std::string text;
  for (const double number : matrix.numbers) text += fmt::format("{} ", number);
  const auto again = parse_matrix_text(text, "printed");
  require(again.has_value(), "printed numbers are a matrix");
  for (std::size_t i = 0; i < 16; ++i) {
    const double before = matrix.numbers[i], after = again->numbers[i];
    require(before == after || (std::isnan(before) && std::isnan(after)), "the same numbers again");
  }
  return text;
}

std::optional<NumberOrder> chosen_order(std::uint8_t byte) {
  if ((byte & 1) == 0) return std::nullopt;
  return (byte & 2) != 0 ? NumberOrder::kColumns : NumberOrder::kRows;
}

OwnMatrices chosen_conventions(std::uint8_t byte) {
  OwnMatrices own;
  if ((byte & 4) != 0) own.world = (byte & 8) != 0 ? Handedness::kLeft : Handedness::kRight;
  const std::size_t dialect = std::size_t(byte) >> 5;
  if (dialect < api_dialects().size()) own.dialect = &api_dialects()[dialect];
  return own;
}

PointStepOptions chosen_points(std::uint8_t byte) {
  PointStepOptions o;
  if ((byte & 16) != 0) {
    o.bits = true;
    o.window = {10, 400, 600, -400};
    o.expected = {{320, 200}};
  }
  o.points = {{0, 0, 0, 1}, {1, -2, -30, 1}, {-3e38, 1e-40, 3e38, -0.5}};
  return o;
}

void check_report(const PointStepOptions& options, const OwnMatrices& matrices) {
  const auto step = step_points(options, matrices);
  require(step.has_value(), "matrices that were read are stepped through");
  std::istringstream lines(point_step_text(*step));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > kTextWidth) std::fprintf(stderr, "%s\n", line.c_str());
    require(line.size() <= kTextWidth, "lines that fit a terminal");
  }
  static_cast<void>(point_step_json(*step).dump());
}

// A picture with these matrices is refused with a reason, or has matrices that a float can hold.
void check_view(const OwnMatrices& matrices) {
  const auto made = view_of_matrices(setup_of(matrices).setup, 640, 360, DepthRange::kStandard);
  if (!made) {
    check_error(made.error());
    return;
  }
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      require(std::isfinite(float(made->view.clip_from_eye.at(row, column))),
              "a finite projection");
      require(std::isfinite(float(made->view.eye_from_world.at(row, column))), "a finite view");
    }
  }
  require(made->view.near > 0 || !made->view.perspective, "a near plane in front of the eye");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  OwnMatrices matrices = chosen_conventions(data[0]);
  std::optional<NumberOrder> order = chosen_order(data[0]);
  std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  for (GivenMatrix* given : {&matrices.projection, &matrices.view, &matrices.model}) {
    constexpr std::string_view kSeparator = "%%\n";
    const std::size_t split = text.rfind(kSeparator);
    const bool last = split == std::string_view::npos;
    const auto matrix =
        parse_matrix_text(last ? text : text.substr(split + kSeparator.size()), "m");
    if (!matrix) {
      check_error(matrix.error());
      return 0;
    }
    check_numbers(*matrix);
    if (!order) order = matrix->order;
    const auto again = read_given_matrix("m", printed(*matrix), order);
    require(again.has_value(), "printed numbers are a matrix");
    *given = *again;
    if (last) break;
    text = text.substr(0, split);
  }
  check_report(chosen_points(data[0]), matrices);
  check_view(matrices);
  return 0;
}
