// Collects the bytes of a GLB file and assembles them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::gltf {

// Little-endian data whose parts begin at multiples of four bytes.
class BinaryChunk {
public:
  void append(std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes_.push_back(std::byte(word >> (8 * i) & 0xff));
  }
  void append(float number) { append(std::bit_cast<std::uint32_t>(number)); }
  void append(std::span<const std::byte> data) {
    bytes_.insert(bytes_.end(), data.begin(), data.end());
    while (bytes_.size() % 4 != 0) bytes_.push_back(std::byte(0));
  }
  std::size_t size() const { return bytes_.size(); }
  const std::vector<std::byte>& bytes() const { return bytes_; }

private:
  std::vector<std::byte> bytes_;
};

// Assembles header, JSON and binary chunk. Doubles are printed with the fewest digits that are read
// back as the same double.
inline Result<std::vector<std::byte>> assemble_glb(const nlohmann::json& document,
                                                   const BinaryChunk& binary) {
  std::string text = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  while (text.size() % 4 != 0) text += ' ';
  const std::uint64_t length = 12 + 8 + text.size() + (binary.size() > 0 ? 8 + binary.size() : 0);
  if (length > 0xffffffffu) {
    return fail("", "the scene needs more than the 4 GB that a GLB file can have",
                "write fewer meshes or smaller textures");
  }
  BinaryChunk file;
  for (const std::uint32_t word : {0x46546c67u, 2u, std::uint32_t(length)}) file.append(word);
  file.append(std::uint32_t(text.size()));
  file.append(0x4e4f534au);
  file.append(std::as_bytes(std::span(text)));
  if (binary.size() > 0) {
    file.append(std::uint32_t(binary.size()));
    file.append(0x004e4942u);
    file.append(std::span(binary.bytes()));
  }
  return file.bytes();
}

}  // namespace glassbox::gltf
