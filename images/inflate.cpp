#include <glassbox/images/inflate.h>

#include <libdeflate.h>

#include <memory>
#include <new>

namespace glassbox {

std::optional<std::size_t> inflate_exactly(std::span<const std::byte> packed,
                                           std::span<std::byte> target) {
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  std::size_t used = 0;
  // With a null pointer for the written size, libdeflate accepts nothing but a full target.
  const auto result =
      libdeflate_zlib_decompress_ex(decompressor.get(), packed.data(), packed.size(), target.data(),
                                    target.size(), &used, nullptr);
  if (result != LIBDEFLATE_SUCCESS) return std::nullopt;
  return used;
}

}  // namespace glassbox
