#include <glassbox/images/exr_piz.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include <glassbox/images/byte_order.h>

// PIZ numbers the 16-bit values that occur in a chunk, transforms these numbers with a wavelet, and
// packs the result with a Huffman code. It treats a float as two values of 16 bits. The format is
// that of OpenEXR's sources: ImfPizCompressor.cpp, ImfWav.cpp and ImfHuf.cpp.
namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;
using PizNumbers = std::vector<std::uint16_t>;

// ---- the values that occur ----

// Removes the list of values from the front. It is a part of a set of 65536 bits: the numbers of
// its first and its last byte, and the bytes between. 0 always occurs.
std::optional<PizNumbers> take_values(Bytes& packed) {
  constexpr std::size_t kSetBytes = 65536 / 8;
  if (packed.size() < 4) return std::nullopt;
  const std::size_t first = little_endian_at(packed, 0, 2), last = little_endian_at(packed, 2, 2);
  packed = packed.subspan(4);
  PizNumbers values{0};
  if (last >= kSetBytes) return std::nullopt;
  if (first > last) return values;
  const std::size_t count = last - first + 1;
  if (packed.size() < count) return std::nullopt;
  for (std::size_t i = 0; i < 8 * count; ++i) {
    const std::size_t value = 8 * first + i;
    const bool occurs = (unsigned(packed[i / 8]) >> i % 8 & 1u) != 0;
    if (occurs && value != 0) values.push_back(std::uint16_t(value));
  }
  packed = packed.subspan(count);
  return values;
}

// ---- the Huffman code ----

// Reads bits, the most significant one of a byte first. Behind the end there are zeros.
class HuffmanBits {
public:
  explicit HuffmanBits(Bytes bytes) : bytes_(bytes), left_(8 * std::uint64_t(bytes.size())) {}
  HuffmanBits(Bytes bytes, std::uint64_t count) : bytes_(bytes), left_(count) {}

  std::uint64_t left() const { return left_; }
  // The next bits, of which there are at most 16.
  std::uint32_t peek(unsigned count) {
    for (; buffered_ < count; buffered_ += 8) {
      const auto byte = at_ < bytes_.size() ? std::uint32_t(bytes_[at_++]) : 0u;
      buffer_ = buffer_ << 8 | byte;
    }
    return buffer_ >> (buffered_ - count) & ((1u << count) - 1);
  }
  // Removes bits that were peeked at, if there are so many.
  bool drop(unsigned count) {
    if (left_ < count) return false;
    left_ -= count;
    buffered_ -= count;
    return true;
  }
  std::optional<std::uint32_t> take(unsigned count) {
    const std::uint32_t bits = peek(count);
    return drop(count) ? std::optional(bits) : std::nullopt;
  }

private:
  Bytes bytes_;
  std::uint64_t left_;
  std::size_t at_ = 0;
  std::uint32_t buffer_ = 0;
  unsigned buffered_ = 0;  // bits of the buffer that are not removed
};

constexpr unsigned kLongest = 58;  // bits of a code
constexpr std::uint32_t kSymbols = 65537;

struct HuffmanSymbol {
  std::uint32_t value = 0;
  unsigned length = 0;  // bits of its code, or 0 for none
};

// Reads the lengths of the codes of the symbols from `first` to `last`, 6 bits each. Some lengths
// stand for runs of symbols that do not occur. Returns the symbols that occur.
std::optional<std::vector<HuffmanSymbol>> take_lengths(HuffmanBits& bits, std::uint32_t first,
                                                       std::uint32_t last) {
  constexpr std::uint32_t kLongRun = 63, kShortestLongRun = 6, kShortestRun = 2;
  std::vector<HuffmanSymbol> symbols;
  for (std::uint32_t value = first; value <= last;) {
    const auto length = bits.take(6);
    if (!length) return std::nullopt;
    if (*length <= kLongest) {
      if (*length > 0) symbols.push_back({value, *length});
      ++value;
      continue;
    }
    const auto run = *length == kLongRun ? bits.take(8) : std::optional(*length - kLongest - 1);
    if (!run) return std::nullopt;
    value += *run + (*length == kLongRun ? kShortestLongRun : kShortestRun);
    if (value > last + 1) return std::nullopt;
  }
  return symbols;
}

// A canonical code: codes of one length are consecutive numbers, and longer ones begin with
// smaller numbers.
class HuffmanCode {
public:
  // Sorts the symbols by the lengths of their codes.
  explicit HuffmanCode(std::vector<HuffmanSymbol> symbols) : symbols_(std::move(symbols)) {
    std::ranges::stable_sort(symbols_, {}, &HuffmanSymbol::length);
    for (const HuffmanSymbol& symbol : symbols_) ++lengths_[symbol.length].count;
    std::uint64_t code = 0;
    for (unsigned length = kLongest; length > 0; --length) {
      lengths_[length].first_code = code;
      code = (code + lengths_[length].count) >> 1;
    }
    std::size_t at = 0;
    for (Length& length : lengths_) {
      length.first_symbol = at;
      at += length.count;
    }
    fill_table();
  }

  std::optional<std::uint32_t> take(HuffmanBits& bits) const {
    const HuffmanSymbol& symbol = table_[bits.peek(kTableBits)];
    if (symbol.length > 0) {
      return bits.drop(symbol.length) ? std::optional(symbol.value) : std::nullopt;
    }
    std::uint64_t code = 0;
    for (unsigned length = 1; length <= kLongest; ++length) {
      const auto bit = bits.take(1);
      if (!bit) return std::nullopt;
      code = code << 1 | *bit;
      const Length& of = lengths_[length];
      if (code >= of.first_code && code - of.first_code < of.count) {
        return symbols_[of.first_symbol + std::size_t(code - of.first_code)].value;
      }
    }
    return std::nullopt;
  }

private:
  // The table has the symbols of short codes for all bits that can follow them.
  static constexpr unsigned kTableBits = 12;
  void fill_table() {
    table_.resize(std::size_t(1) << kTableBits);
    for (unsigned length = 1; length <= kTableBits; ++length) {
      const Length& of = lengths_[length];
      const std::size_t copies = std::size_t(1) << (kTableBits - length);
      for (std::size_t i = 0; i < of.count; ++i) {
        const std::size_t begin = std::size_t(of.first_code + i) * copies;
        if (begin >= table_.size()) break;  // more codes than a length has: the file is broken
        std::fill_n(table_.begin() + std::ptrdiff_t(begin), copies, symbols_[of.first_symbol + i]);
      }
    }
  }

  struct Length {
    std::uint64_t first_code = 0;
    std::size_t first_symbol = 0, count = 0;
  };
  std::vector<HuffmanSymbol> symbols_;
  std::array<Length, kLongest + 1> lengths_{};
  std::vector<HuffmanSymbol> table_;
};

// Decodes `count` values. The last symbol is none of them: 8 bits follow it, which say how many
// times the value before is repeated.
std::optional<PizNumbers> decode_huffman(Bytes packed, std::size_t count) {
  constexpr std::size_t kHeadBytes = 20;
  if (packed.size() < kHeadBytes) return std::nullopt;
  const auto first = std::uint32_t(little_endian_at(packed, 0, 4));
  const auto last = std::uint32_t(little_endian_at(packed, 4, 4));
  const std::uint64_t bit_count = little_endian_at(packed, 12, 4);
  if (first >= kSymbols || last >= kSymbols) return std::nullopt;
  packed = packed.subspan(kHeadBytes);
  HuffmanBits lengths(packed);
  auto symbols = take_lengths(lengths, first, last);
  if (!symbols) return std::nullopt;
  packed = packed.subspan(packed.size() - std::size_t(lengths.left() / 8));
  if ((bit_count + 7) / 8 > packed.size()) return std::nullopt;
  const HuffmanCode code(std::move(*symbols));
  HuffmanBits bits(packed, bit_count);
  PizNumbers values;
  values.reserve(count);
  while (values.size() < count) {
    const auto symbol = code.take(bits);
    if (!symbol) return std::nullopt;
    if (*symbol != last) {
      values.push_back(std::uint16_t(*symbol));
      continue;
    }
    const auto run = bits.take(8);
    if (!run || values.empty() || *run > count - values.size()) return std::nullopt;
    values.insert(values.end(), *run, values.back());
  }
  return values;
}

// ---- the wavelet ----

// These make the two samples of their mean and their difference. The first is for numbers below
// 2^14, whose differences need no more than 16 bits; the second calculates modulo 2^16.
struct UndoSmall {
  void operator()(std::uint16_t& low, std::uint16_t& high) const {
    const int difference = std::int16_t(high);
    const int first = std::int16_t(low) + (difference & 1) + (difference >> 1);
    low = std::uint16_t(first);
    high = std::uint16_t(first - difference);
  }
};
struct UndoLarge {
  void operator()(std::uint16_t& low, std::uint16_t& high) const {
    const unsigned difference = high, second = low - (difference >> 1);
    low = std::uint16_t(difference + second - 0x8000u);
    high = std::uint16_t(second);
  }
};

// A plane of samples: neighbours in x and in y lie this far apart.
struct WaveletPlane {
  std::uint16_t* samples = nullptr;
  std::size_t width = 0, height = 0, step_x = 0, step_y = 0;

  std::uint16_t& at(std::size_t x, std::size_t y) const { return samples[x * step_x + y * step_y]; }
};

// Undoes a two-dimensional Haar transform from the coarsest level to the finest one.
template <class Undo>
void undo_wavelet(const WaveletPlane& plane, Undo undo) {
  std::size_t far = std::bit_floor(std::min(plane.width, plane.height));
  for (std::size_t near = far / 2; near > 0; far = near, near /= 2) {
    std::size_t y = 0;
    for (; y + far <= plane.height; y += far) {
      std::size_t x = 0;
      for (; x + far <= plane.width; x += far) {
        std::uint16_t &a = plane.at(x, y), &b = plane.at(x + near, y);
        std::uint16_t &c = plane.at(x, y + near), &d = plane.at(x + near, y + near);
        undo(a, c);
        undo(b, d);
        undo(a, b);
        undo(c, d);
      }
      if (plane.width & near) undo(plane.at(x, y), plane.at(x, y + near));
    }
    if ((plane.height & near) == 0) continue;
    for (std::size_t x = 0; x + far <= plane.width; x += far) {
      undo(plane.at(x, y), plane.at(x + near, y));
    }
  }
}

// The values of a chunk stand channel after channel.
void undo_wavelets(PizNumbers& values, const ExrChunk& chunk, bool are_small) {
  std::uint16_t* begin = values.data();
  for (const ExrChannel& channel : chunk.channels) {
    const std::size_t parts = channel.bytes() / 2;  // a float has two
    for (std::size_t part = 0; part < parts; ++part) {
      const WaveletPlane plane{begin + part, chunk.width, chunk.height, parts, parts * chunk.width};
      if (are_small) {
        undo_wavelet(plane, UndoSmall());
      } else {
        undo_wavelet(plane, UndoLarge());
      }
    }
    begin += parts * chunk.width * chunk.height;
  }
}

// Orders the values row by row.
std::vector<std::byte> rows_of(const PizNumbers& values, const ExrChunk& chunk) {
  std::vector<std::byte> samples(2 * values.size());
  const std::size_t stride = samples.size() / chunk.height;
  const std::uint16_t* from = values.data();
  std::byte* begin = samples.data();
  for (const ExrChannel& channel : chunk.channels) {
    const std::size_t row = chunk.width * channel.bytes();
    for (std::size_t y = 0; y < chunk.height; ++y) {
      std::byte* to = begin + y * stride;
      for (std::size_t i = 0; i < row; i += 2, ++from) {
        to[i] = std::byte(std::uint8_t(*from));
        to[i + 1] = std::byte(std::uint8_t(*from >> 8));
      }
    }
    begin += row;
  }
  return samples;
}

}  // namespace

std::optional<std::vector<std::byte>> undo_piz(Bytes packed, const ExrChunk& chunk) {
  constexpr std::size_t kLengthBytes = 4;
  const auto values = take_values(packed);
  if (!values || packed.size() < kLengthBytes) return std::nullopt;
  const std::uint64_t length = little_endian_at(packed, 0, kLengthBytes);
  packed = packed.subspan(kLengthBytes);
  if (packed.size() < length) return std::nullopt;
  auto numbers = decode_huffman(packed.first(length), chunk.bytes() / 2);
  if (!numbers) return std::nullopt;
  undo_wavelets(*numbers, chunk, values->size() - 1 < 1u << 14);
  // OpenEXR's library gives the value 0 to numbers that have none.
  for (std::uint16_t& number : *numbers) {
    number = number < values->size() ? (*values)[number] : std::uint16_t(0);
  }
  return rows_of(*numbers, chunk);
}

}  // namespace glassbox
