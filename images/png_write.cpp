#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <exception>
#include <functional>
#include <limits>
#include <new>
#include <type_traits>

#include <oneapi/tbb/parallel_for.h>

#include <glassbox/images/pack.h>
#include <glassbox/images/palette.h>
#include <glassbox/images/write.h>

namespace glassbox {
namespace {

// The filter and the level are fixed, so that the same picture gives the same bytes. Rendered
// pictures have runs of equal pixels and smooth gradients; the filter Up turns the gradients into
// runs, and a fast level of zlib is enough to compress runs.
constexpr std::uint8_t kFilterUp = 2;
constexpr int kCompressionLevel = 2;
// Rows are compressed in bands of about this many bytes, each independently, so that all available
// threads can work in parallel. Where a band begins depends on the picture alone. A band cannot
// refer to the one before it, which makes pictures only slightly larger (docs/performance.md).
constexpr std::size_t kBandBytes = std::size_t{1} << 18;

struct Sink {
  std::vector<std::byte> bytes;
  bool is_out_of_memory = false;
  char message[128] = {};
};

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(data);
  try {
    sink->bytes.insert(sink->bytes.end(), first, first + size);
  } catch (const std::exception&) {
    sink->is_out_of_memory = true;
  }
  if (sink->is_out_of_memory) png_error(png, "out of memory");
}

void flush(png_structp) {}

// libpng reports errors by longjmp to write_png. The stack frames that this skips are libpng's own
// C functions and append above, which has nothing left to destroy when it calls libpng.
[[noreturn]] void on_write_error(png_structp png, png_const_charp message) {
  auto* sink = static_cast<Sink*>(png_get_error_ptr(png));
  std::strncpy(sink->message, message, sizeof sink->message - 1);
  png_longjmp(png, 1);
}

void on_write_warning(png_structp, png_const_charp) {}

struct Layout {
  int width = 0, height = 0, channels = 0;
  int bits_per_channel = 8;
  std::span<const Rgba8> palette = {};  // empty: the samples are no indices
};

// Writes the samples of row y; 16-bit samples with the upper byte first.
using PackRow = std::function<void(int y, std::uint8_t* out)>;

std::size_t row_bytes(const Layout& layout) {
  return std::size_t(layout.width) * std::size_t(layout.channels) *
         std::size_t(layout.bits_per_channel / 8);
}

// ---- the rows, compressed ----

// Returns rows first .. last - 1 with the filter Up. Each row begins with a byte that names the
// filter; then come its bytes minus those of the row above it.
std::vector<std::uint8_t> filtered_rows(const Layout& layout, const PackRow& pack, int first,
                                        int last) {
  const std::size_t bytes = row_bytes(layout);
  std::vector<std::uint8_t> above(bytes), row(bytes);
  if (first > 0) pack(first - 1, above.data());
  std::vector<std::uint8_t> filtered(std::size_t(last - first) * (bytes + 1));
  std::uint8_t* out = filtered.data();
  for (int y = first; y < last; ++y, out += bytes + 1) {
    pack(y, row.data());
    out[0] = kFilterUp;
    std::transform(row.begin(), row.end(), above.begin(), out + 1,
                   [](std::uint8_t x, std::uint8_t up) { return std::uint8_t(x - up); });
    std::swap(above, row);
  }
  return filtered;
}

// One band's part of the zlib stream: deflate blocks that end at a byte boundary, and the values
// from which the checksum of all data is computed.
struct Band {
  std::vector<std::uint8_t> deflated;
  uLong adler = 0;
  std::size_t length = 0;
};

class Deflater {
public:
  Deflater() {
    constexpr int kNoHeader = -15, kMemoryLevel = 8;
    if (deflateInit2(&z_, kCompressionLevel, Z_DEFLATED, kNoHeader, kMemoryLevel, Z_FILTERED) !=
        Z_OK) {
      throw std::bad_alloc();
    }
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&z_); }

  // Compresses the bytes. If `flush` is Z_FINISH, the output ends the stream; if it is
  // Z_SYNC_FLUSH, the output ends at a whole byte. The length of the output is not known in
  // advance, so it is collected in parts.
  std::vector<std::uint8_t> deflate_all(std::span<const std::uint8_t> bytes, int flush) {
    z_.next_in = const_cast<Bytef*>(bytes.data());
    z_.avail_in = uInt(bytes.size());
    std::vector<std::uint8_t> deflated;
    std::array<std::uint8_t, std::size_t{1} << 16> part;
    do {
      z_.next_out = part.data();
      z_.avail_out = uInt(part.size());
      if (deflate(&z_, flush) == Z_STREAM_ERROR) throw std::bad_alloc();
      deflated.insert(deflated.end(), part.begin(), part.end() - z_.avail_out);
    } while (z_.avail_out == 0);
    deflated.shrink_to_fit();  // all bands are kept until the last is done
    return deflated;
  }

private:
  z_stream z_{};
};

Band compressed(const std::vector<std::uint8_t>& bytes, bool is_last) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) throw std::bad_alloc();
  Band band{{}, adler32(0, nullptr, 0), bytes.size()};
  band.adler = adler32_z(band.adler, bytes.data(), bytes.size());
  band.deflated = Deflater().deflate_all(bytes, is_last ? Z_FINISH : Z_SYNC_FLUSH);
  return band;
}

// The whole zlib stream, band by band.
std::vector<Band> compressed_rows(const Layout& layout, const PackRow& pack) {
  const auto rows = int(
      std::clamp<std::size_t>(kBandBytes / (row_bytes(layout) + 1), 1, std::size_t(layout.height)));
  std::vector<Band> bands(std::size_t((layout.height + rows - 1) / rows));
  tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t i) {
    const int first = int(i) * rows, last = std::min(first + rows, layout.height);
    bands[i] = compressed(filtered_rows(layout, pack, first, last), last == layout.height);
  });
  // The zlib header (RFC 1950) says: deflate with a window of 32 KiB, a fast level. After the
  // blocks of all bands comes the checksum of all data.
  constexpr std::array<std::uint8_t, 2> kHeader = {0x78, 0x5e};
  std::vector<std::uint8_t>& front = bands.front().deflated;
  front.insert(front.begin(), kHeader.begin(), kHeader.end());
  uLong sum = adler32(0, nullptr, 0);
  for (const Band& band : bands) sum = adler32_combine(sum, band.adler, z_off_t(band.length));
  for (int shift = 24; shift >= 0; shift -= 8) {
    bands.back().deflated.push_back(std::uint8_t(sum >> shift));
  }
  return bands;
}

// ---- the file ----

int colour_type(const Layout& layout) {
  if (!layout.palette.empty()) return PNG_COLOR_TYPE_PALETTE;
  constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                            PNG_COLOR_TYPE_RGBA};
  return kTypes[layout.channels - 1];
}

std::vector<png_color> palette_of(const Layout& layout) {
  std::vector<png_color> colours;
  for (const Rgba8& colour : layout.palette) colours.push_back({colour.r, colour.g, colour.b});
  return colours;
}

// Returns false after an error; the message is then in the Sink.
bool write_png(png_structp png, png_infop info, const Layout& layout,
               const std::vector<png_color>& palette, const std::vector<Band>& bands,
               std::vector<png_text>& text) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, png_uint_32(layout.width), png_uint_32(layout.height),
               layout.bits_per_channel, colour_type(layout), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), int(palette.size()));
  if (!text.empty()) png_set_text(png, info, text.data(), int(text.size()));
  png_write_info(png, info);
  const auto chunk = [&](const char* name, const std::uint8_t* data, std::size_t size) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), data, size);
  };
  for (std::size_t i = 0; i < bands.size(); ++i) {
    chunk("IDAT", bands[i].deflated.data(), bands[i].deflated.size());
  }
  chunk("IEND", nullptr, 0);
  return true;
}

struct Writer {
  Sink sink;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, on_write_error, on_write_warning);
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
    return fail("PNG keyword \"" + keyword + "\"",
                "is not 1 to 79 printable ASCII characters with single spaces inside",
                "use a shorter or simpler name");
  }
  if (text.find('\0') != std::string::npos) {
    return fail("PNG text \"" + keyword + "\"", "contains a zero byte", "remove the zero byte");
  }
  return {};
}

// Uses a tEXt chunk (Latin-1) for ASCII text, otherwise an iTXt chunk (UTF-8); it is never
// compressed.
png_text png_text_of(const TextEntry& entry) {
  const auto& [keyword, text] = entry;
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return is_printable_ascii(c) || c == '\n'; });
  png_text result{};
  result.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  result.key = const_cast<png_charp>(keyword.c_str());  // libpng copies keyword and text
  result.text = const_cast<png_charp>(text.c_str());
  return result;
}

Result<std::vector<std::byte>> encode_rows(const Layout& layout, const PackRow& pack,
                                           std::span<const TextEntry> text) {
  if (layout.width <= 0 || layout.height <= 0) {
    return fail("", "an image without pixels cannot be a PNG",
                "use an image with at least one pixel");
  }
  std::vector<png_text> texts;
  for (const TextEntry& entry : text) {
    if (auto good = check_text(entry); !good) return tl::unexpected<Error>(good.error());
    texts.push_back(png_text_of(entry));
  }
  Writer writer;
  if (!writer.info)
    return fail("", "the PNG library (libpng) does not start",
                "close other programs to free memory");
  png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_write_fn(writer.png, &writer.sink, append, flush);
  const std::vector<Band> bands = compressed_rows(layout, pack);
  if (write_png(writer.png, writer.info, layout, palette_of(layout), bands, texts)) {
    return std::move(writer.sink.bytes);
  }
  if (writer.sink.is_out_of_memory) throw std::bad_alloc();
  return fail("", std::string("the PNG cannot be encoded: ") + writer.sink.message,
              "write a .ppm file instead");
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image<Rgba8>& image,
                                          std::span<const TextEntry> text) {
  const int channels = is_opaque(image) ? 3 : 4;
  const auto pack = [&](int y, std::uint8_t* out) {
    pack_channels(std::span(image.pixels).subspan(image.index(0, y), std::size_t(image.width)),
                  channels, out);
  };
  return encode_rows({image.width, image.height, channels, 8}, pack, text);
}

Result<std::vector<std::byte>> encode_png(const StoredImage& image,
                                          std::span<const TextEntry> text) {
  if (image.channels < 1 || image.channels > 4) {
    return fail("", "a PNG has 1 to 4 channels, not " + std::to_string(image.channels),
                "write each channel to a file of its own");
  }
  const std::size_t row = std::size_t(image.width) * std::size_t(image.channels);
  const auto wrong_count = [] {
    return fail("", "the number of samples is not width x height x channels",
                "give one sample for each channel of each pixel");
  };
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& samples) -> Result<std::vector<std::byte>> {
        if constexpr (std::is_same_v<Sample, float>) {
          return fail("", "an image of floats cannot be a PNG",
                      "write a PFM (in the library: encode_pfm)");
        } else {
          if (samples.size() != row * std::size_t(image.height)) return wrong_count();
          const auto pack = [&](int y, std::uint8_t* out) {
            const Sample* const from = samples.data() + std::size_t(y) * row;
            for (std::size_t i = 0; i < row; ++i) {
              if constexpr (sizeof(Sample) == 2) *out++ = std::uint8_t(from[i] >> 8);
              *out++ = std::uint8_t(from[i] & 0xff);
            }
          };
          return encode_rows({image.width, image.height, image.channels, 8 * sizeof(Sample)}, pack,
                             text);
        }
      },
      image.samples);
}

Result<std::vector<std::byte>> encode_png(const Image<std::uint8_t>& indices,
                                          std::span<const Rgba8> palette) {
  if (const auto whole = check_palette(indices, palette); !whole) {
    return tl::unexpected<Error>(whole.error());
  }
  const auto pack = [&](int y, std::uint8_t* out) {
    std::copy_n(indices.pixels.begin() + std::ptrdiff_t(indices.index(0, y)), indices.width, out);
  };
  return encode_rows({indices.width, indices.height, 1, 8, palette}, pack, {});
}

}  // namespace glassbox
