#include <glassbox/images/png_read.h>

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>
#include <utility>

namespace glassbox {
namespace {

static_assert(sizeof(Rgba8) == 4 && alignof(Rgba8) == 1, "libpng writes rows of RGBA bytes");

// Deflate spends at least one bit on 129 bytes: a match of 258 in two bits. zlib's own documentation gives this ratio.
constexpr std::uint64_t kDeflateMaxRatio = 1032;

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

// libpng's errors leave by longjmp to the caller that set the jump. Between there and here are only libpng's own C
// frames and read_bytes above: nothing with a destructor.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Header {
  png_uint_32 width = 0, height = 0;
  int bits_per_pixel = 0;
};

// Both functions return false after an error, whose message is in the source.
bool read_header(png_structp png, png_infop info, Header& header) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_info(png, info);
  header.width = png_get_image_width(png, info);
  header.height = png_get_image_height(png, info);
  header.bits_per_pixel = png_get_bit_depth(png, info) * png_get_channels(png, info);
  return true;
}

bool read_pixels(png_structp png, png_infop info, png_uint_32 height, Rgba8* pixels,
                 std::size_t width) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_expand(png);    // palettes, 1, 2 and 4 bits, tRNS
  png_set_scale_16(png);  // the nearest 8-bit value
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != width * sizeof(Rgba8)) png_error(png, "unexpected row size");
  for (int pass = 0; pass < passes; ++pass) {
    for (png_uint_32 y = 0; y < height; ++y) {
      png_read_row(png, reinterpret_cast<png_bytep>(pixels + y * width), nullptr);
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
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

tl::unexpected<Error> bad_png(const Reader& reader) {
  return fail("", std::string("not a valid PNG: ") + reader.source.message, "save the image again");
}

}  // namespace

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t bytes,
                              std::uint64_t pixels_per_byte, const DecodeLimits& limits) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) return fail("", "image of " + size, "give it a size above zero");
  if (width > limits.max_side || height > limits.max_side) {
    return fail(
        "", "image of " + size + ", sides above the limit of " + std::to_string(limits.max_side),
        "scale it down or raise the limit on the side");
  }
  // Sides are 32-bit numbers, so the product cannot overflow.
  if (width * height > limits.max_pixels) {
    return fail("",
                "image of " + size + ", more than the limit of " +
                    std::to_string(limits.max_pixels) + " in all",
                "scale it down or raise the limit on pixels");
  }
  if (width * height / pixels_per_byte > bytes) {
    return fail("", "image of " + size + " cannot fit into " + std::to_string(bytes) + " bytes",
                "the file is cut off or its size field is wrong: save it again");
  }
  return {};
}

bool is_png(std::span<const std::byte> bytes) {
  return bytes.size() >= 8 &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

Result<Image<Rgba8>> decode_png(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  Reader reader(bytes);
  if (!reader.info) return fail("", "libpng does not start", "free some memory");
  png_set_read_fn(reader.png, &reader.source, read_bytes);
  // Comments, colour profiles and the like are skipped unread: they can be bombs of their own.
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_image_size decides

  Header header;
  if (!read_header(reader.png, reader.info, header)) return bad_png(reader);
  const auto bits = std::uint64_t(std::max(header.bits_per_pixel, 1));
  const auto fits = check_image_size(header.width, header.height, bytes.size(),
                                     kDeflateMaxRatio * 8 / bits, limits);
  if (!fits) return tl::unexpected<Error>(fits.error());

  Image<Rgba8> image(int(header.width), int(header.height));
  if (!read_pixels(reader.png, reader.info, header.height, image.pixels.data(), header.width)) {
    return bad_png(reader);
  }
  return image;
}

}  // namespace glassbox
