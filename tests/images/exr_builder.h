// Builds OpenEXR files byte by byte: uncompressed scan lines, and headers of any kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/images/png_builder.h"

namespace glassbox::test {

struct ExrChannelParts {
  std::string name;
  std::uint32_t type = 1;  // 0 integers, 1 halves, 2 floats
  std::uint8_t perceptual = 0;
  std::uint32_t step_x = 1, step_y = 1;
};

struct ExrParts {
  std::vector<ExrChannelParts> channels = {{"Y"}};
  std::vector<std::uint32_t> data = {0, 0, 0, 0};  // left, top, right, bottom: both ends included
  std::vector<std::uint32_t> display = {0, 0, 0, 0};  // as data
  std::uint8_t compression = 0;
  std::uint32_t version = 2;
  std::vector<std::uint8_t> tiles = {};   // the value of the attribute, left out when empty
  std::vector<Bytes> rows = {{0, 0x3c}};  // the samples of each row: the half 1
};

inline void put_number(Bytes& bytes, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(std::uint8_t(value >> 8 * i));
}
inline void put_name(Bytes& bytes, const std::string& name) {
  bytes.insert(bytes.end(), name.begin(), name.end());
  bytes.push_back(0);
}
inline void put_attribute(Bytes& bytes, const std::string& name, const std::string& type,
                          const Bytes& value) {
  put_name(bytes, name);
  put_name(bytes, type);
  put_number(bytes, value.size(), 4);
  bytes.insert(bytes.end(), value.begin(), value.end());
}

inline Bytes exr_channels(const std::vector<ExrChannelParts>& channels) {
  Bytes bytes;
  for (const ExrChannelParts& channel : channels) {
    put_name(bytes, channel.name);
    put_number(bytes, channel.type, 4);
    put_number(bytes, channel.perceptual, 4);
    put_number(bytes, channel.step_x, 4);
    put_number(bytes, channel.step_y, 4);
  }
  bytes.push_back(0);
  return bytes;
}

inline Bytes build_exr(const ExrParts& parts) {
  const auto window = [](const std::vector<std::uint32_t>& numbers) {
    Bytes bytes;
    for (const std::uint32_t number : numbers) put_number(bytes, number, 4);
    return bytes;
  };
  Bytes file{0x76, 0x2f, 0x31, 0x01};
  put_number(file, parts.version, 4);
  put_attribute(file, "channels", "chlist", exr_channels(parts.channels));
  put_attribute(file, "compression", "compression", {parts.compression});
  put_attribute(file, "dataWindow", "box2i", window(parts.data));
  put_attribute(file, "displayWindow", "box2i", window(parts.display));
  put_attribute(file, "lineOrder", "lineOrder", {0});
  put_attribute(file, "pixelAspectRatio", "float", {0, 0, 0x80, 0x3f});
  put_attribute(file, "screenWindowCenter", "v2f", Bytes(8));
  put_attribute(file, "screenWindowWidth", "float", {0, 0, 0x80, 0x3f});
  if (!parts.tiles.empty()) put_attribute(file, "tiles", "tiledesc", parts.tiles);
  file.push_back(0);
  std::size_t offset = file.size() + 8 * parts.rows.size();
  for (const Bytes& row : parts.rows) {
    put_number(file, offset, 8);
    offset += 8 + row.size();
  }
  for (std::size_t y = 0; y < parts.rows.size(); ++y) {
    put_number(file, parts.data[1] + y, 4);
    put_number(file, parts.rows[y].size(), 4);
    file.insert(file.end(), parts.rows[y].begin(), parts.rows[y].end());
  }
  return file;
}

}  // namespace glassbox::test
