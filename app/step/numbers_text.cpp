#include "app/step/numbers_text.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "app/step/matrices/decimal.h"

namespace glassbox::app {

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
  return fmt::format("{:<4} {:>16}  {:<12}{}", name, brief(double(value), 9), bound_text(bound),
                     bits ? bits_text(value) : "");
}

std::string number_line(const char* name, double value, double bound, bool bits) {
  return fmt::format("{:<4} {:>24}  {:<12}{}", name, brief(value, 17), bound_text(bound),
                     bits ? bits_text(value) : "");
}

}  // namespace glassbox::app
