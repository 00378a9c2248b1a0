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
#include "app/step/printed_matrix.h"
#include "cli/report/text_layout.h"
#include "tests/fuzz/promises.h"

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

PointStepOptions chosen_options(std::uint8_t byte) {
  PointStepOptions o;
  if ((byte & 1) != 0) o.order = (byte & 2) != 0 ? NumberOrder::kColumns : NumberOrder::kRows;
  if ((byte & 4) != 0) o.world = (byte & 8) != 0 ? Handedness::kLeft : Handedness::kRight;
  const std::size_t dialect = std::size_t(byte) >> 5;
  if (dialect < api_dialects().size()) o.dialect = &api_dialects()[dialect];
  if ((byte & 16) != 0) {
    o.bits = true;
    o.window = {10, 400, 600, -400};
    o.expected = {{320, 200}};
  }
  o.points = {{0, 0, 0, 1}, {1, -2, -30, 1}, {-3e38, 1e-40, 3e38, -0.5}};
  return o;
}

void check_report(const PointStepOptions& options) {
  const auto step = step_points(options);
  require(step.has_value(), "matrices that were read are stepped through");
  std::istringstream lines(point_step_text(*step));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > kTextWidth) std::fprintf(stderr, "%s\n", line.c_str());
    require(line.size() <= kTextWidth, "lines that fit a terminal");
  }
  static_cast<void>(point_step_json(*step).dump());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  PointStepOptions options = chosen_options(data[0]);
  std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  for (std::optional<std::string>* source : {&options.projection, &options.view, &options.model}) {
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
    *source = printed(*matrix);
    if (!options.order) options.order = matrix->order;
    if (last) break;
    text = text.substr(0, split);
  }
  check_report(options);
  return 0;
}
