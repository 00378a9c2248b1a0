// A number that tells texts apart: two different texts are not likely to have the same one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace glassbox::labs {

// FNV-1a of 64 bits (Fowler, Noll and Vo 1991) over several texts one after the other; the places
// where one text ends and the next begins are part of the digest. It is not a secure hash. It need
// not be: nobody gains anything by making two texts with the same digest.
class Digest {
public:
  Digest& add(std::string_view text) {
    for (const char c : text) put(static_cast<unsigned char>(c));
    for (std::uint64_t size = text.size(), i = 0; i < 8; ++i, size >>= 8)
      put(static_cast<unsigned char>(size & 0xff));
    return *this;
  }
  std::uint64_t number() const { return state_; }
  // The digest as 16 hexadecimal digits.
  std::string text() const { return fmt::format("{:016x}", state_); }

private:
  void put(unsigned char byte) { state_ = (state_ ^ byte) * 0x100000001b3u; }
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace glassbox::labs
