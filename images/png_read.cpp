#include <glassbox/images/png_read.h>

#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/images/image_size.h>
#include <glassbox/images/inflate.h>
#include <glassbox/images/png_plain.h>

namespace glassbox {
namespace {

static_assert(sizeof(Rgba8) == 4 && alignof(Rgba8) == 1, "libpng writes rows of RGBA bytes");

struct Source {
  std::span<const std::byte> rest;
  char message[128] = {};
};

void read_bytes(png_structp png, png_bytep target, png_size_t size) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (size > source->rest.size()) png_error(png, "the file is cut off");
  std::memcpy(target, source->rest.data(), size);
  source->rest = source->rest.subspan(size);
}

// libpng reports errors by longjmp to the caller that called setjmp. The stack frames that this
// skips are libpng's own C functions and read_bytes above, which have nothing with a destructor.
[[noreturn]] void on_read_error(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}

// Turns some of libpng's warnings into errors. Most of the warnings are harmless, except those
// about tRNS: libpng would skip the chunk, and the alpha would be lost. A wrong checksum of IEND,
// the end of the file, is an error in libpng 1.6.39 and a warning in 1.6.48; here it is an error
// with both versions, so that every machine refuses the same files.
void on_read_warning(png_structp png, png_const_charp message) {
  const std::string_view warning = message;
  if (warning.starts_with("tRNS") || warning == "IEND: CRC error") png_error(png, message);
}

struct Header {
  png_uint_32 width = 0, height = 0;
  int bits_per_pixel = 0;  // in the file
};

enum class Form { kRgba8, kStored };

// The format in which libpng delivers the pixels.
struct Rows {
  int passes = 0;
  int channels = 0;
  int bits_per_channel = 0;  // 8 or 16
  std::size_t bytes_per_row = 0;
};

// The functions that call libpng return false after an error; the message is then in the Source.
bool read_header(png_structp png, png_infop info, Header& header) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  header.width = png_get_image_width(png, info);
  header.height = png_get_image_height(png, info);
  header.bits_per_pixel = png_get_bit_depth(png, info) * png_get_channels(png, info);
  return true;
}

bool start_rows(png_structp png, png_infop info, Form form, Rows& rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_expand(png);  // expands palettes, samples of 1, 2 or 4 bits, and tRNS
  if (form == Form::kRgba8) {
    png_set_scale_16(png);  // each sample becomes the nearest 8-bit value
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  } else if (std::endian::native == std::endian::little) {
    png_set_swap(png);  // 16-bit samples are big-endian in the file
  }
  rows.passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  rows.channels = png_get_channels(png, info);
  rows.bits_per_channel = png_get_bit_depth(png, info);
  rows.bytes_per_row = png_get_rowbytes(png, info);
  return true;
}

bool read_rows(png_structp png, const Rows& rows, png_uint_32 height, void* pixels,
               std::size_t size) {
  if (setjmp(png_jmpbuf(png))) return false;
  if (rows.bytes_per_row * height != size) png_error(png, "unexpected row size");
  for (int pass = 0; pass < rows.passes; ++pass) {
    for (png_uint_32 y = 0; y < height; ++y) {
      png_read_row(png, static_cast<png_bytep>(pixels) + y * rows.bytes_per_row, nullptr);
    }
  }
  png_read_end(png, nullptr);
  return true;
}

struct Reader {
  Source source;
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit Reader(std::span<const std::byte> bytes) : source{bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_read_error, on_read_warning);
    if (png) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

  Error error() const {
    return {{}, {}, std::string("not a valid PNG: ") + source.message, "save the image again"};
  }
};

// Reads everything before the pixels, and refuses sizes above the limits.
Result<Header> start(Reader& reader, Form form, Rows& rows, const DecodeLimits& limits) {
  if (!reader.info)
    return fail("", "the PNG library (libpng) does not start",
                "close other programs to free memory");
  const std::uint64_t bytes = reader.source.rest.size();
  png_set_read_fn(reader.png, &reader.source, read_bytes);
  // Comments, colour profiles, gamma and the like are skipped without being read: samples are taken
  // as stored, and a skipped chunk could be a decompression bomb. libpng still reads tRNS.
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  // libpng's own limits are as large as possible, because check_image_size applies ours.
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);

  Header header;
  if (!read_header(reader.png, reader.info, header)) return tl::unexpected<Error>(reader.error());
  const auto bits = std::uint64_t(std::max(header.bits_per_pixel, 1));
  const auto fits =
      check_image_size(header.width, header.height, bytes, kDeflateMaxRatio * 8 / bits, limits);
  if (!fits) return tl::unexpected<Error>(fits.error());
  if (!start_rows(reader.png, reader.info, form, rows)) {
    return tl::unexpected<Error>(reader.error());
  }
  return header;
}

template <class Pixels>
bool fill(Reader& reader, const Header& header, const Rows& rows, Pixels& pixels) {
  return read_rows(reader.png, rows, header.height, pixels.data(),
                   pixels.size() * sizeof(pixels[0]));
}

}  // namespace

bool is_png(std::span<const std::byte> bytes) {
  return bytes.size() >= 8 &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

Result<Image<Rgba8>> decode_png(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  Reader reader(bytes);
  Rows rows;
  const auto header = start(reader, Form::kRgba8, rows, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  Image<Rgba8> image(int(header->width), int(header->height));
  if (!fill(reader, *header, rows, image.pixels)) return tl::unexpected<Error>(reader.error());
  return image;
}

Result<StoredImage> decode_png_stored(std::span<const std::byte> bytes,
                                      const DecodeLimits& limits) {
  if (auto image = decode_plain_png(bytes, limits)) return *std::move(image);
  return decode_with_libpng(bytes, limits);
}

Result<StoredImage> decode_with_libpng(std::span<const std::byte> bytes,
                                       const DecodeLimits& limits) {
  Reader reader(bytes);
  Rows rows;
  const auto header = start(reader, Form::kStored, rows, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  StoredImage image{int(header->width), int(header->height), rows.channels, {}};
  const std::size_t count = image.pixels() * std::size_t(image.channels);
  const bool read =
      rows.bits_per_channel == 16
          ? fill(reader, *header, rows, image.samples.emplace<std::vector<std::uint16_t>>(count))
          : fill(reader, *header, rows, image.samples.emplace<std::vector<std::uint8_t>>(count));
  if (!read) return tl::unexpected<Error>(reader.error());
  return image;
}

Result<StoredHeader> stored_header_of_png(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits) {
  Reader reader(bytes);
  Rows rows;
  const auto header = start(reader, Form::kStored, rows, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  return StoredHeader{int(header->width), int(header->height), rows.channels};
}

}  // namespace glassbox
