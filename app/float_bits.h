// A float's bits as programs show them: "3f800000" for 1.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace glassbox::app {

inline std::string bits_text(float value) {
  return fmt::format("{:08x}", std::bit_cast<std::uint32_t>(value));
}

}  // namespace glassbox::app
