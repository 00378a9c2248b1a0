#include <glassbox/render/trace/column_pack.h>

#include <glassbox/base/little_endian.h>  // columns are stored with the byte order of memory

namespace glassbox {

void ColumnPack::append(std::span<const std::uint8_t> numbers, std::size_t size) {
  const std::size_t count = numbers.size() / size;
  const std::size_t first = bytes_.size();
  bytes_.resize(first + numbers.size());
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (size == 8) {
      for (std::size_t k = 0; k < 8; ++k) bytes_[first + k * count + i] = numbers[8 * i + k];
      continue;
    }
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < size; ++k) bits |= std::uint32_t(numbers[size * i + k]) << (8 * k);
    const std::uint32_t difference = bits - before;
    for (std::size_t k = 0; k < size; ++k) {
      bytes_[first + k * count + i] = std::uint8_t(difference >> (8 * k));
    }
    before = bits;
  }
}

}  // namespace glassbox
