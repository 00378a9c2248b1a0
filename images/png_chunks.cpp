#include <glassbox/images/png_chunks.h>

#include <string>

#include <glassbox/images/byte_order.h>
#include <glassbox/images/png_read.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

// The parts of a chunk are its length, its type, its data, and a CRC of type and data.
constexpr std::size_t kSignatureBytes = 8, kLengthBytes = 4, kTypeBytes = 4, kCrcBytes = 4;

std::string_view characters_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

tl::unexpected<Error> not_whole(const std::string& cause) {
  return fail("PNG", cause, "save the image again");
}

}  // namespace

Bytes png_chunks(Bytes bytes) {
  return is_png(bytes) ? bytes.subspan(kSignatureBytes) : Bytes();
}

Result<PngChunk> take_png_chunk(Bytes& rest) {
  constexpr std::size_t kAround = kLengthBytes + kTypeBytes + kCrcBytes;
  if (rest.size() < kAround) return not_whole("the file is cut off");
  const std::size_t length = big_endian_at(rest, 0);
  if (length > rest.size() - kAround) {
    return not_whole("a chunk of " + std::to_string(length) +
                     " bytes runs past the end of the file");
  }
  const Bytes whole = rest.subspan(kLengthBytes, kTypeBytes + length);
  const std::uint32_t crc = big_endian_at(rest, kLengthBytes + kTypeBytes + length);
  rest = rest.subspan(kAround + length);
  return PngChunk{characters_of(whole.first(kTypeBytes)), whole,
                  characters_of(whole.subspan(kTypeBytes)), crc};
}

}  // namespace glassbox
