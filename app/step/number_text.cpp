#include "app/step/number_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "cli/report/text_layout.h"

#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

std::string sentence(const std::string& text) {
  return wrapped(kIndent, text);
}

std::string bound_text(double bound) {
  if (bound == 0) return "exact";
  if (!std::isfinite(bound)) return "+- unknown";
  return fmt::format("+- {:.1e}", bound);
}

std::string bits_text(float value) {
  return fmt::format("{:08x}", std::bit_cast<std::uint32_t>(value));
}

std::string bits_text(double value) {
  return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value));
}

std::string number_line(const char* name, float value, double bound, bool bits) {
  return fmt::format("{:<4} {:>16}  {:<12}{}", name, short_number(double(value), 9),
                     bound_text(bound), bits ? bits_text(value) : "");
}

std::string number_line(const char* name, double value, double bound, bool bits) {
  return fmt::format("{:<4} {:>24}  {:<12}{}", name, short_number(value, 17), bound_text(bound),
                     bits ? bits_text(value) : "");
}

std::array<std::string, 4> entry_rows(const glm::dmat4& m, int digits) {
  std::array<std::string, 4> rows;
  for (int column = 0; column < 4; ++column) {
    std::vector<std::string> entries;
    for (int row = 0; row < 4; ++row) entries.push_back(short_number(m[column][row], digits));
    std::size_t width = 0;
    for (const std::string& entry : entries) width = std::max(width, entry.size());
    for (std::size_t row = 0; row < 4; ++row) {
      if (column > 0) rows[row] += digits > 3 ? "  " : " ";
      rows[row] += fmt::format("{:>{}}", entries[row], width);
    }
  }
  return rows;
}

std::string matrix_rows(const glm::dmat4& m, const std::string& indent, int digits) {
  std::string text;
  for (const std::string& row : entry_rows(m, digits)) text += indent + "[ " + row + " ]\n";
  return text;
}

std::vector<std::string> round_trip_lines(const RoundTrip& trip, bool bits) {
  if (!trip.is_bounded())
    return {
        "the position cannot be computed back from the three numbers: no error bound is finite"};
  const double back[] = {trip.object.x, trip.object.y, trip.object.z};
  std::vector<std::string> lines;
  for (int i = 0; i < 3; ++i) {
    lines.push_back(fmt::format(
        "{}{}{}", number_line(kAxes[i], back[i], trip.bound[i], bits), bits ? "  " : "",
        trip.error[i] == 0 ? "as it was" : fmt::format("off by {:.1e}", trip.error[i])));
  }
  return lines;
}

}  // namespace glassbox::app
