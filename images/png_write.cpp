#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <exception>
#include <functional>
#include <type_traits>

#include <glassbox/images/pack.h>
#include <glassbox/images/write.h>

namespace glassbox {
namespace {

// Fixed, so that the same picture gives the same bytes: rendered pictures have runs and slopes, which the filter Up
// turns into runs; a fast level of zlib finds those.
constexpr int kFilters = PNG_FILTER_UP;
constexpr int kCompressionLevel = 2;

struct Sink {
  std::vector<std::byte> bytes;
  char message[128] = {};
};

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bool stored = true;
  try {
    sink->bytes.insert(sink->bytes.end(), first, first + size);
  } catch (const std::exception&) {
    stored = false;
  }
  if (!stored) png_error(png, "out of memory");
}

void flush(png_structp) {}

// libpng's errors leave by longjmp to write_png. Between there and here are only libpng's own C frames and append
// above, which has nothing left to destroy when it calls.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* sink = static_cast<Sink*>(png_get_error_ptr(png));
  std::strncpy(sink->message, message, sizeof sink->message - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Layout {
  int width = 0, height = 0, channels = 0;
  int bits_per_channel = 8;
};

// The samples of row y, 16 bits in the machine's byte order.
using RowAt = std::function<const void*(int y)>;

int colour_type(int channels) {
  constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                            PNG_COLOR_TYPE_RGBA};
  return kTypes[channels - 1];
}

// False after an error, whose message is in the sink.
bool write_png(png_structp png, png_infop info, const Layout& layout, const RowAt& row_at,
               std::vector<png_text>& text) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_filter(png, PNG_FILTER_TYPE_BASE, kFilters);
  png_set_compression_level(png, kCompressionLevel);
  png_set_IHDR(png, info, png_uint_32(layout.width), png_uint_32(layout.height),
               layout.bits_per_channel, colour_type(layout.channels), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!text.empty()) png_set_text(png, info, text.data(), int(text.size()));
  png_write_info(png, info);
  if (std::endian::native == std::endian::little) png_set_swap(png);  // of 16 bits
  for (int y = 0; y < layout.height; ++y) {
    png_write_row(png, static_cast<png_const_bytep>(row_at(y)));
  }
  png_write_end(png, nullptr);
  return true;
}

struct Writer {
  Sink sink;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

bool is_printable_ascii(char c) {
  return c >= ' ' && c <= '~';
}

Result<void> check_text(const TextEntry& entry) {
  const auto& [keyword, text] = entry;
  const bool good = !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' &&
                    keyword.back() != ' ' && keyword.find("  ") == std::string::npos &&
                    std::all_of(keyword.begin(), keyword.end(), is_printable_ascii);
  if (!good) {
    return fail("PNG keyword \"" + keyword + "\"", "not 1 to 79 printable ASCII characters",
                "use a short name with single spaces inside");
  }
  if (text.find('\0') != std::string::npos) {
    return fail("PNG text \"" + keyword + "\"", "has a zero byte in it", "leave it out");
  }
  return {};
}

// tEXt (Latin-1) where the text is ASCII, else iTXt (UTF-8); never compressed.
png_text png_text_of(const TextEntry& entry) {
  const auto& [keyword, text] = entry;
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return is_printable_ascii(c) || c == '\n'; });
  png_text result{};
  result.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  result.key = const_cast<png_charp>(keyword.c_str());  // libpng copies both
  result.text = const_cast<png_charp>(text.c_str());
  return result;
}

Result<std::vector<std::byte>> encode_rows(const Layout& layout, const RowAt& row_at,
                                           std::span<const TextEntry> text) {
  if (layout.width <= 0 || layout.height <= 0) {
    return fail("", "an image without pixels cannot be a PNG", "give it a size above zero");
  }
  std::vector<png_text> texts;
  for (const TextEntry& entry : text) {
    if (auto good = check_text(entry); !good) return tl::unexpected<Error>(good.error());
    texts.push_back(png_text_of(entry));
  }
  Writer writer;
  if (!writer.info) return fail("", "libpng does not start", "free some memory");
  png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_write_fn(writer.png, &writer.sink, append, flush);
  if (!write_png(writer.png, writer.info, layout, row_at, texts)) {
    return fail("", std::string("the PNG cannot be encoded: ") + writer.sink.message,
                "write a .ppm file instead");
  }
  return std::move(writer.sink.bytes);
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image<Rgba8>& image,
                                          std::span<const TextEntry> text) {
  const int channels = is_opaque(image) ? 3 : 4;
  std::vector<std::uint8_t> row(std::size_t(image.width) * std::size_t(channels));
  const auto row_at = [&](int y) {
    pack_channels(std::span(image.pixels).subspan(image.index(0, y), std::size_t(image.width)),
                  channels, row.data());
    return row.data();
  };
  return encode_rows({image.width, image.height, channels, 8}, row_at, text);
}

Result<std::vector<std::byte>> encode_png(const StoredImage& image,
                                          std::span<const TextEntry> text) {
  if (image.channels < 1 || image.channels > 4) {
    return fail("", "a PNG has 1 to 4 channels, not " + std::to_string(image.channels),
                "write each channel to a file of its own");
  }
  const std::size_t row = std::size_t(image.width) * std::size_t(image.channels);
  const auto wrong_count = [] {
    return fail("", "the image has not as many samples as its size says", "fill all of it");
  };
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& samples) -> Result<std::vector<std::byte>> {
        if constexpr (std::is_same_v<Sample, float>) {
          return fail("", "floats cannot be a PNG", "write them with encode_pfm");
        } else {
          if (samples.size() != row * std::size_t(image.height)) return wrong_count();
          const auto row_at = [&](int y) { return samples.data() + std::size_t(y) * row; };
          return encode_rows({image.width, image.height, image.channels, 8 * sizeof(Sample)},
                             row_at, text);
        }
      },
      image.samples);
}

}  // namespace glassbox
