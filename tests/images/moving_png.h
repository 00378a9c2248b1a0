// Builds animated PNG files (PNG, third edition, 11.3.6).
#pragma once

#include <cstdint>
#include <vector>

#include "tests/images/png_builder.h"

namespace glassbox::test {

// Returns an animation of one grey pixel, whose frames have these values.
inline Bytes moving_png(const std::vector<std::uint8_t>& frames) {
  std::uint32_t sequence = 0;
  const auto frame_control = [&] {
    Bytes control;
    for (const std::uint32_t number : {sequence++, 1u, 1u, 0u, 0u}) put32(control, number);
    control.resize(control.size() + 6);  // delay, disposal and blending
    return control;
  };
  PngParts parts{.colour_type = 0, .rows = {0, frames[0]}};
  Bytes control;
  put32(control, std::uint32_t(frames.size()));
  put32(control, 0);  // repeats without end
  put_chunk(parts.extra, "acTL", control);
  put_chunk(parts.extra, "fcTL", frame_control());
  Bytes png = build_png(parts);
  png.resize(png.size() - 12);  // without IEND
  for (std::size_t i = 1; i < frames.size(); ++i) {
    put_chunk(png, "fcTL", frame_control());
    Bytes data;
    put32(data, sequence++);
    const Bytes pixels = stored({0, frames[i]});
    data.insert(data.end(), pixels.begin(), pixels.end());
    put_chunk(png, "fdAT", data);
  }
  put_chunk(png, "IEND", {});
  return png;
}

}  // namespace glassbox::test
