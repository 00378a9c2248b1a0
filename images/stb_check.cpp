#include <glassbox/images/stb_check.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <glassbox/images/byte_order.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

tl::unexpected<Error> cut_off(const char* format) {
  return fail("", std::string("the ") + format + " file is cut off", "save the image again");
}

// Checks the Huffman tables of one segment. stb writes past the end of its own arrays where a table
// has more than 256 codes (github.com/nothings/stb, issue 1289).
bool has_sound_tables(Bytes segment) {
  // A table has a head (a byte with its kind and number, then 16 counts) and at most 256 codes.
  constexpr std::size_t kHeadBytes = 17, kMaxCodes = 256;
  while (!segment.empty()) {
    if (segment.size() < kHeadBytes) return false;
    std::size_t codes = 0;
    for (const std::byte count : segment.subspan(1, 16)) codes += std::size_t(count);
    if (codes > kMaxCodes || segment.size() - kHeadBytes < codes) return false;
    segment = segment.subspan(kHeadBytes + codes);
  }
  return true;
}

// Returns the number of bytes before the marker that ends the coded data of a scan. FF 00 (which
// encodes a data byte FF) and restart markers do not end the data.
std::size_t coded_bytes(Bytes bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    const auto next = unsigned(bytes[i + 1]);
    const bool restart = next >= 0xd0 && next <= 0xd7;
    if (bytes[i] == std::byte{0xff} && next != 0 && next != 0xff && !restart) return i;
  }
  return bytes.size();
}

// Whether all pixels, of 1, 4 or 8 bits each, are below `colours`, the size of the palette.
bool chooses_at_most(Bytes rows, std::uint64_t row_bytes, std::uint64_t width, unsigned bits,
                     std::int64_t colours) {
  if (colours >= std::int64_t(1) << bits) return true;
  for (; rows.size() >= row_bytes; rows = rows.subspan(row_bytes)) {
    for (std::uint64_t x = 0; x < width; ++x) {
      const unsigned byte = unsigned(rows[x * bits / 8]);
      const unsigned index = byte >> (8 - bits - x * bits % 8) & ((1u << bits) - 1);
      if (std::int64_t(index) >= colours) return false;
    }
  }
  return true;
}

// Returns the number of bytes of the run-length packets that hold this many pixels. A packet is a
// count and one pixel, or a count and as many pixels.
std::uint64_t packed_bytes(Bytes packets, std::uint64_t pixels, std::uint64_t pixel_bytes) {
  std::uint64_t at = 0;
  while (pixels > 0 && at < packets.size()) {
    const std::uint64_t head = std::uint64_t(packets[at]);
    const std::uint64_t run = std::min(head % 128 + 1, pixels);
    at += 1 + (head >= 128 ? 1 : run) * pixel_bytes;
    pixels -= run;
  }
  return pixels == 0 ? at : packets.size() + 1;
}

// Returns the bytes after the header of a Radiance HDR picture, which ends with an empty line, and
// after the line with the size.
std::optional<Bytes> hdr_pixels(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t blank = text.find("\n\n");
  if (blank == std::string_view::npos) return std::nullopt;
  const std::size_t end = text.find('\n', blank + 2);
  if (end == std::string_view::npos) return std::nullopt;
  return bytes.subspan(end + 1);
}

// Removes one row of run lengths from the front: four bytes that say its width, then for each byte
// of the pixels packets of a count and its bytes. A count above 128 repeats one byte.
bool take_hdr_row(Bytes& rest, std::uint64_t width) {
  constexpr std::size_t kHead = 4, kBytesOfPixel = 4;
  if (rest.size() < kHead || rest[0] != std::byte{2} || rest[1] != std::byte{2}) return false;
  if ((std::uint64_t(rest[2]) << 8 | std::uint64_t(rest[3])) != width) return false;
  rest = rest.subspan(kHead);
  for (std::size_t i = 0; i < kBytesOfPixel; ++i) {
    for (std::uint64_t left = width; left > 0;) {
      const std::uint64_t head = rest.empty() ? 0 : std::uint64_t(rest[0]);
      const std::uint64_t run = head > 128 ? head - 128 : head, stored = head > 128 ? 1 : head;
      if (run == 0 || run > left || rest.size() < 1 + stored) return false;
      rest = rest.subspan(1 + stored);
      left -= run;
    }
  }
  return true;
}

bool has_old_run(Bytes pixels) {
  const std::byte one{1};
  for (; pixels.size() >= 4; pixels = pixels.subspan(4)) {
    if (pixels[0] == one && pixels[1] == one && pixels[2] == one) return true;
  }
  return false;
}

}  // namespace

Result<void> check_jpeg(Bytes bytes) {
  // An encoder writes about ten scans; each scan costs stb a pass over the image.
  constexpr int kMaxScans = 500;
  const auto broken = [](const std::string& cause) {
    return fail("", "JPEG with " + cause, "save the image again");
  };
  int scans = 0;
  Bytes rest = bytes.subspan(std::min<std::size_t>(bytes.size(), 2));  // start of image
  for (;;) {
    // A marker is FF and a byte that gives its kind; additional FF and padding bytes may come
    // before it.
    while (rest.size() >= 2 && (rest[0] != std::byte{0xff} || rest[1] == std::byte{0xff})) {
      rest = rest.subspan(1);
    }
    if (rest.size() < 2) return cut_off("JPEG");
    const auto marker = unsigned(rest[1]);
    constexpr unsigned kEnd = 0xd9, kScan = 0xda, kTables = 0xc4;
    if (marker == kEnd) return {};
    // Markers without a length and restart markers in the wrong place are refused, as by stb.
    const bool has_length = marker >= 0xc0 && marker != 0xff && !(marker >= 0xd0 && marker <= 0xd8);
    if (!has_length) return broken("a marker in the wrong place");
    if (rest.size() < 4) return cut_off("JPEG");
    const std::size_t length = std::size_t(rest[2]) << 8 | std::size_t(rest[3]);
    if (length < 2) return broken("a segment of fewer bytes than the number that says its length");
    if (rest.size() < 2 + length) return cut_off("JPEG");
    const Bytes segment = rest.subspan(4, length - 2);
    rest = rest.subspan(2 + length);
    if (marker == kTables && !has_sound_tables(segment))
      return broken("a Huffman table that is not valid");
    if (marker == kScan) {
      if (++scans > kMaxScans) return broken("more than " + std::to_string(kMaxScans) + " scans");
      rest = rest.subspan(coded_bytes(rest));
    }
  }
}

Result<void> check_bmp_compression(Bytes bytes) {
  static constexpr const char* kNames[] = {nullptr, "RLE8", "RLE4", nullptr, "JPEG", "PNG"};
  if (bytes.size() < 34 || little_endian_at(bytes, 14, 4) < 40) return {};
  const std::uint64_t kind = little_endian_at(bytes, 30, 4);
  if (kind >= std::size(kNames) || kNames[kind] == nullptr) return {};
  return fail("", std::string("is a BMP with ") + kNames[kind] + " compression, which is not read",
              "save it without compression, or convert it to PNG");
}

Result<void> check_bmp(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kFileHeaderBytes = 14;
  if (bytes.size() < 30) return cut_off("BMP");
  const std::uint64_t info_bytes = little_endian_at(bytes, 14, 4);
  const bool os2 = info_bytes == 12;
  const std::uint64_t bits = little_endian_at(bytes, os2 ? 24 : 28, 2);
  const std::uint64_t row_bytes = (width * bits + 31) / 32 * 4;
  const std::uint64_t pixels_at = little_endian_at(bytes, 10, 4);
  if (pixels_at + row_bytes * height > bytes.size()) return cut_off("BMP");
  if (bits == 1 || bits == 4 || bits == 8) {
    // The palette's size is computed as stb does it; for an OS/2 palette stb loses the last four
    // colours.
    const std::int64_t palette_bytes =
        std::int64_t(pixels_at) - std::int64_t(kFileHeaderBytes + (os2 ? 24 : info_bytes));
    const Bytes rows = bytes.subspan(pixels_at, row_bytes * height);
    if (!chooses_at_most(rows, row_bytes, width, unsigned(bits), palette_bytes / (os2 ? 3 : 4))) {
      return fail("", "BMP with a pixel that names a colour beyond the end of the palette",
                  "convert it to PNG");
    }
  }
  return {};
}

Result<void> check_tga(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kHeaderBytes = 18;
  if (bytes.size() < kHeaderBytes) return cut_off("TGA");
  const bool has_palette = little_endian_at(bytes, 1, 1) != 0;
  const bool packed = little_endian_at(bytes, 2, 1) >= 9;
  const std::uint64_t pixel_bytes = (little_endian_at(bytes, 16, 1) + 7) / 8;
  const std::uint64_t palette_bytes =
      has_palette ? little_endian_at(bytes, 5, 2) * ((little_endian_at(bytes, 7, 1) + 7) / 8) : 0;
  // stb takes the number of the palette's first entry for a number of bytes to skip, and it reads
  // every row from left to right.
  const bool shifted = has_palette && little_endian_at(bytes, 3, 2) != 0;
  const bool other_order = (little_endian_at(bytes, 17, 1) & 0xd0) != 0;
  if (shifted || other_order) {
    return fail("",
                shifted ? "TGA with a palette that does not start at 0"
                        : "TGA with an unusual order of pixels",
                "convert it to PNG");
  }
  const std::uint64_t pixels_at = kHeaderBytes + little_endian_at(bytes, 0, 1) + palette_bytes;
  if (pixels_at > bytes.size()) return cut_off("TGA");
  const Bytes samples = bytes.subspan(pixels_at);
  const std::uint64_t pixels = width * height;
  const std::uint64_t needed =
      packed ? packed_bytes(samples, pixels, pixel_bytes) : pixels * pixel_bytes;
  if (needed > samples.size()) return cut_off("TGA");
  return {};
}

Result<void> check_hdr(Bytes bytes, std::uint64_t width, std::uint64_t height) {
  const auto pixels = hdr_pixels(bytes);
  if (!pixels) return cut_off("Radiance HDR");
  constexpr std::uint64_t kMinPackedWidth = 8, kMaxPackedWidth = 32767;
  const bool packed = width >= kMinPackedWidth && width <= kMaxPackedWidth && pixels->size() >= 3 &&
                      (*pixels)[0] == std::byte{2} && (*pixels)[1] == std::byte{2} &&
                      (*pixels)[2] < std::byte{0x80};
  if (!packed) {
    const std::uint64_t needed = width * height * 4;
    if (has_old_run(pixels->first(std::min<std::uint64_t>(needed, pixels->size())))) {
      return fail("", "is a Radiance HDR picture with the older run lengths, which are not read",
                  "save it again with another program");
    }
    if (needed > pixels->size()) return cut_off("Radiance HDR");
    return {};
  }
  Bytes rest = *pixels;
  for (std::uint64_t y = 0; y < height; ++y) {
    if (take_hdr_row(rest, width)) continue;
    return fail("",
                "the Radiance HDR file is cut off, or the run lengths of row " +
                    std::to_string(y + 1) + " are wrong",
                "save the image again");
  }
  return {};
}

}  // namespace glassbox
