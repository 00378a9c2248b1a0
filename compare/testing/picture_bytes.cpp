#include <glassbox/compare/testing/picture_bytes.h>

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <string_view>

#include <glassbox/base/little_endian.h>
#include <glassbox/images/inflate.h>

namespace glassbox::golden {
namespace {

constexpr int kMaxSide = 16384;  // px, as much as glassbox diff compares

std::size_t row_samples(const PictureView& picture) {
  return std::size_t(picture.width) * std::size_t(picture.channels);
}

// The first sample of row y, counted from the top.
template <class Sample>
const Sample* row_of(const PictureView& picture, const Sample* samples, int y) {
  const std::ptrdiff_t step =
      picture.row_step != 0 ? picture.row_step : std::ptrdiff_t(row_samples(picture));
  return samples + y * step;
}

// ---- PNG (third edition) ----

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::uint8_t kFilterUp = 2;
// A fast level of zlib: rendered pictures consist of runs.
constexpr int kCompressionLevel = 4;
// A chunk has at most 2^31 - 1 bytes (5.3).
constexpr std::size_t kMaxChunk = std::size_t(1) << 30;

void append_number(Bytes& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(std::uint8_t(number >> shift));
}

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
  return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 |
         std::uint32_t(bytes[at + 2]) << 8 | std::uint32_t(bytes[at + 3]);
}

// Length, type, data, and the checksum of type and data (5.3).
void append_chunk(Bytes& out, std::string_view type, const std::uint8_t* data, std::size_t size) {
  append_number(out, std::uint32_t(size));
  const std::size_t begin = out.size();
  out.insert(out.end(), type.begin(), type.end());
  if (size > 0) out.insert(out.end(), data, data + size);
  append_number(out, std::uint32_t(crc32_z(0, out.data() + begin, out.size() - begin)));
}

// Whether the last channel is an alpha of the largest value in every pixel.
template <class Sample>
bool has_opaque_alpha(const PictureView& picture, const Sample* samples) {
  if (picture.channels % 2 != 0) return false;
  for (int y = 0; y < picture.height; ++y) {
    const Sample* row = row_of(picture, samples, y);
    for (std::size_t i = std::size_t(picture.channels) - 1; i < row_samples(picture);
         i += std::size_t(picture.channels)) {
      if (row[i] != std::numeric_limits<Sample>::max()) return false;
    }
  }
  return true;
}

void append_sample(std::uint8_t*& out, std::uint8_t sample) {
  *out++ = sample;
}
void append_sample(std::uint8_t*& out, std::uint16_t sample) {
  *out++ = std::uint8_t(sample >> 8);
  *out++ = std::uint8_t(sample);
}

template <class Sample>
Content png_of(const PictureView& picture, const Sample* samples) {
  const std::size_t channels = std::size_t(picture.channels);
  const std::size_t kept = channels - (has_opaque_alpha(picture, samples) ? 1 : 0);
  Content png{Content::kPng, {}, {}};
  append_number(png.header, std::uint32_t(picture.width));
  append_number(png.header, std::uint32_t(picture.height));
  constexpr std::uint8_t kColourTypes[] = {0, 4, 2, 6};  // of 1, 2, 3 and 4 channels (11.2.1)
  png.header.insert(png.header.end(),
                    {std::uint8_t(8 * sizeof(Sample)), kColourTypes[kept - 1], 0, 0, 0});

  // Each row begins with the number of its filter. The filter Up stores the difference from the row
  // above.
  const std::size_t row_bytes = std::size_t(picture.width) * kept * sizeof(Sample);
  png.rows.resize(std::size_t(picture.height) * (row_bytes + 1));
  Bytes above(row_bytes), row(row_bytes);
  std::uint8_t* out = png.rows.data();
  for (int y = 0; y < picture.height; ++y) {
    const Sample* in = row_of(picture, samples, y);
    std::uint8_t* packed = row.data();
    for (int x = 0; x < picture.width; ++x, in += channels) {
      for (std::size_t c = 0; c < kept; ++c) append_sample(packed, in[c]);
    }
    *out++ = kFilterUp;
    for (std::size_t i = 0; i < row_bytes; ++i) *out++ = std::uint8_t(row[i] - above[i]);
    std::swap(above, row);
  }
  return png;
}

Content png_of(const PictureView& picture) {
  const auto* const* words = std::get_if<const std::uint16_t*>(&picture.samples);
  return words != nullptr ? png_of(picture, *words)
                          : png_of(picture, std::get<const std::uint8_t*>(picture.samples));
}

Bytes encode_png(const Content& png) {
  uLongf size = compressBound(uLong(png.rows.size()));
  Bytes deflated(size);
  if (compress2(deflated.data(), &size, png.rows.data(), uLong(png.rows.size()),
                kCompressionLevel) != Z_OK) {
    throw std::bad_alloc();  // of the documented errors the only possible one
  }
  Bytes file(kSignature.begin(), kSignature.end());
  append_chunk(file, "IHDR", png.header.data(), png.header.size());
  for (std::size_t at = 0; at < size; at += kMaxChunk) {
    append_chunk(file, "IDAT", deflated.data() + at, std::min<std::size_t>(size - at, kMaxChunk));
  }
  append_chunk(file, "IEND", nullptr, 0);
  return file;
}

// Whether the file's rows, once inflated, are these. Another version of zlib compresses them into
// other bytes. A file with a chunk that may change the meaning of the samples is not recognised.
// Neither is one that glassbox diff would refuse: with a wrong checksum, without its end, or with a
// window that is too small.
bool is_png_of(const Content& png, const Bytes& file) {
  if (file.size() < kSignature.size() ||
      std::memcmp(file.data(), kSignature.data(), kSignature.size()) != 0) {
    return false;
  }
  Bytes header, deflated;
  std::string_view before;  // the type of the chunk before
  bool has_data = false, ended = false;
  for (std::size_t at = kSignature.size(); !ended && at + 12 <= file.size();) {
    const std::size_t size = number_at(file, at);
    if (size > file.size() - at - 12) return false;
    const auto checksum = std::uint32_t(crc32_z(0, file.data() + at + 4, size + 4));
    if (number_at(file, at + 8 + size) != checksum) return false;
    const std::string_view type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
    const auto data = file.begin() + std::ptrdiff_t(at + 8);
    // IHDR comes first, and the IDATs one behind the other (5.6).
    const bool is_first = at == kSignature.size();
    if ((type == "IHDR") != is_first) return false;
    if (type == "IDAT" && before != "IDAT" && has_data) return false;
    has_data = has_data || type == "IDAT";
    if (type == "IHDR") {
      header.assign(data, data + std::ptrdiff_t(size));
    } else if (type == "IDAT") {
      deflated.insert(deflated.end(), data, data + std::ptrdiff_t(size));
    } else if (type == "IEND") {
      ended = true;
    } else if (type != "tEXt" && type != "iTXt") {
      return false;
    }
    before = type;
    at += 12 + size;
  }
  if (!ended || header != png.header) return false;
  if (!has_wide_window(std::as_bytes(std::span(deflated)), png.rows.size())) return false;
  Bytes rows(png.rows.size());
  uLongf size = uLongf(rows.size());
  return uncompress(rows.data(), &size, deflated.data(), uLong(deflated.size())) == Z_OK &&
         size == rows.size() && rows == png.rows;
}

// ---- PFM ----

// The rows follow each other from the bottom to the top. "-1.0" says that the floats are
// little-endian.
Content pfm_of(const PictureView& picture) {
  const std::string header = std::string(picture.channels == 1 ? "Pf" : "PF") + "\n" +
                             std::to_string(picture.width) + " " + std::to_string(picture.height) +
                             "\n-1.0\n";
  const std::size_t row_bytes = row_samples(picture) * sizeof(float);
  Content pfm{Content::kPfm, {header.begin(), header.end()}, {}};
  pfm.rows.resize(row_bytes * std::size_t(picture.height));
  std::uint8_t* out = pfm.rows.data();
  for (int y = picture.height; y-- > 0; out += row_bytes) {
    std::memcpy(out, row_of(picture, std::get<const float*>(picture.samples), y), row_bytes);
  }
  return pfm;
}

Bytes encode_pfm(const Content& pfm) {
  Bytes file = pfm.header;
  file.insert(file.end(), pfm.rows.begin(), pfm.rows.end());
  return file;
}

bool is_pfm_of(const Content& pfm, const Bytes& file) {
  return file.size() == pfm.header.size() + pfm.rows.size() &&
         std::equal(pfm.header.begin(), pfm.header.end(), file.begin()) &&
         std::equal(pfm.rows.begin(), pfm.rows.end(),
                    file.begin() + std::ptrdiff_t(pfm.header.size()));
}

}  // namespace

std::string why_not_stored(const PictureView& picture, const std::string& extension) {
  if (extension != ".png" && extension != ".pfm") {
    return "a golden image is a .png or a .pfm file; end its name in .png or .pfm";
  }
  if (std::min(picture.width, picture.height) < 1 ||
      std::max(picture.width, picture.height) > kMaxSide) {
    return "a picture of " + std::to_string(picture.width) + " x " +
           std::to_string(picture.height) + " cannot be compared; give it sides of 1 to " +
           std::to_string(kMaxSide) + " pixels";
  }
  if (picture.channels < 1 || picture.channels > 4) {
    return "the picture has " + std::to_string(picture.channels) + " channels; give it 1 to 4";
  }
  const bool has_samples =
      std::visit([](auto* first) { return first != nullptr; }, picture.samples);
  if (!has_samples)
    return "the picture has too few samples; give it one for each channel of a pixel";
  if (picture.row_step != 0 && std::size_t(std::abs(picture.row_step)) < row_samples(picture)) {
    return "rows are " + std::to_string(picture.row_step) + " samples apart, and a row has " +
           std::to_string(row_samples(picture)) + "; count row_step in samples, not in pixels";
  }
  const bool is_float = std::holds_alternative<const float*>(picture.samples);
  if (is_float && extension == ".png") return "PNG has no floats; end the name in .pfm";
  if (!is_float && extension == ".pfm") return "PFM has floats alone; end the name in .png";
  if (is_float && picture.channels != 1 && picture.channels != 3) {
    return "a PFM has 1 or 3 channels, and the picture has " + std::to_string(picture.channels) +
           "; leave its alpha out";
  }
  return "";
}

Content content_of(const PictureView& picture, const std::string& extension) {
  return extension == ".pfm" ? pfm_of(picture) : png_of(picture);
}

Bytes encode(const Content& content) {
  return content.format == Content::kPfm ? encode_pfm(content) : encode_png(content);
}

bool is_stored_in(const Bytes& file, const Content& content) {
  return content.format == Content::kPfm ? is_pfm_of(content, file) : is_png_of(content, file);
}

}  // namespace glassbox::golden
