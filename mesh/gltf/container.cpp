#include <glassbox/mesh/gltf/container.h>

#include <cstdint>
#include <cstring>

namespace glassbox::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;   // "glTF"
constexpr std::uint32_t kJson = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinary = 0x004e4942;  // "BIN\0"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr const char* kCopyAgain = "the file is damaged or cut short: copy or export it again";

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

std::string_view text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

tl::unexpected<Error> damaged(std::string place, std::string cause) {
  return fail(std::move(place), std::move(cause), kCopyAgain);
}

}  // namespace

Result<Container> open_container(std::span<const std::byte> bytes) {
  Container container;
  if (bytes.empty()) return damaged("", "the file is empty");
  if (bytes.size() < 4 || little_endian(bytes, 0) != kMagic) {
    container.json = text(bytes);
    return container;
  }
  if (bytes.size() < kHeaderBytes)
    return damaged("GLB header", "ends after " + std::to_string(bytes.size()) + " of 12 bytes");
  const std::uint32_t version = little_endian(bytes, 4);
  if (version != 2) {
    return fail("GLB header", "says version " + std::to_string(version),
                "only version 2 can be read: convert the file to glTF 2");
  }
  const std::size_t length = little_endian(bytes, 8);
  if (length > bytes.size()) {
    return damaged("GLB header", "says that the file has " + std::to_string(length) +
                                     " bytes, but it has only " + std::to_string(bytes.size()));
  }
  if (length < bytes.size())
    container.warnings.push_back("bytes after the end of the GLB were ignored");

  bool has_json = false;
  std::size_t number = 0;
  for (std::size_t at = kHeaderBytes; at < length; ++number) {
    const std::string place = "GLB chunk " + std::to_string(number);
    if (length - at < kChunkHeaderBytes) return damaged(place, "its header is cut short");
    const std::size_t size = little_endian(bytes, at);
    const std::uint32_t type = little_endian(bytes, at + 4);
    at += kChunkHeaderBytes;
    if (size > length - at) {
      return damaged(place, "says that it has " + std::to_string(size) + " bytes, but only " +
                                std::to_string(length - at) + " are left");
    }
    const std::span<const std::byte> data = bytes.subspan(at, size);
    if (number == 0) {
      if (type != kJson) return damaged(place, "is not JSON, which must come first");
      container.json = text(data);
      has_json = true;
    } else if (type == kJson) {
      return damaged(place, "is a second JSON chunk");
    } else if (type == kBinary && number == 1) {
      container.binary = data;
    } else if (type == kBinary) {
      return damaged(place, "is binary data, which may only be the second chunk");
    }
    // Chunks of other types are skipped, as the specification says.
    at += size;
  }
  if (!has_json) return damaged("GLB header", "no chunk with data follows");
  return container;
}

}  // namespace glassbox::gltf
