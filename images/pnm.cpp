#include <glassbox/images/pnm.h>

#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>

#include <glassbox/images/png_read.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

std::vector<std::byte> with_header(const std::string& header, std::size_t sample_bytes) {
  std::vector<std::byte> bytes(header.size() + sample_bytes);
  std::memcpy(bytes.data(), header.data(), header.size());
  return bytes;
}

std::string size_line(int width, int height) {
  return std::to_string(width) + " " + std::to_string(height) + "\n";
}

void put_float(std::byte*& out, float value) {  // little-endian on every machine
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) *out++ = std::byte(bits >> shift & 0xff);
}
void put(std::byte*& out, float pixel) {
  put_float(out, pixel);
}
void put(std::byte*& out, const Rgb32f& pixel) {
  put_float(out, pixel.r);
  put_float(out, pixel.g);
  put_float(out, pixel.b);
}

template <class Pixel>
std::vector<std::byte> encode_pfm_as(const char* magic, const Image<Pixel>& image) {
  const std::string header =
      std::string(magic) + "\n" + size_line(image.width, image.height) + "-1.0\n";
  std::vector<std::byte> bytes = with_header(header, image.pixels.size() * sizeof(Pixel));
  std::byte* out = bytes.data() + header.size();
  for (int y = image.height; y-- > 0;) {
    for (int x = 0; x < image.width; ++x) put(out, image.at(x, y));
  }
  return bytes;
}

float get_float(const std::byte* in, bool little_endian) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) bits = bits << 8 | std::uint32_t(in[little_endian ? 3 - i : i]);
  return std::bit_cast<float>(bits);
}
void get(const std::byte*& in, bool little_endian, float& pixel) {
  pixel = get_float(in, little_endian);
  in += 4;
}
void get(const std::byte*& in, bool little_endian, Rgb32f& pixel) {
  for (float* channel : {&pixel.r, &pixel.g, &pixel.b}) get(in, little_endian, *channel);
}

tl::unexpected<Error> bad_header() {
  return fail("", "not a valid PPM, PGM or PFM header", "save the image again");
}

Result<void> check_samples(const NetpbmHeader& header, Bytes bytes, std::uint64_t pixel_bytes) {
  const std::uint64_t needed = header.width * header.height * pixel_bytes;
  if (bytes.size() - header.size >= needed) return {};
  return fail("",
              "the file is cut off: " + std::to_string(bytes.size() - header.size) + " of " +
                  std::to_string(needed) + " bytes of samples",
              "save the image again");
}

template <class Pixel>
Result<Image<Pixel>> decode_pfm_as(const char* magic, Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  if (header->magic != magic) {
    return fail("", "a " + header->magic + " file where " + magic + " is expected",
                "Pf is PFM with one channel, PF with three");
  }
  double scale = 0;
  const char* end = header->last.data() + header->last.size();
  const auto parsed = std::from_chars(header->last.data(), end, scale);
  if (parsed.ec != std::errc{} || parsed.ptr != end || !(scale < 0 || scale > 0)) {
    return bad_header();
  }
  const auto whole = check_samples(*header, bytes, sizeof(Pixel));
  if (!whole) return tl::unexpected<Error>(whole.error());

  Image<Pixel> image(int(header->width), int(header->height));
  const std::byte* in = bytes.data() + header->size;
  for (int y = image.height; y-- > 0;) {
    for (int x = 0; x < image.width; ++x) get(in, scale < 0, image.at(x, y));
  }
  return image;
}

}  // namespace

std::vector<std::byte> encode_ppm(const Image<Rgba8>& image) {
  const std::string header = "P6\n" + size_line(image.width, image.height) + "255\n";
  std::vector<std::byte> bytes = with_header(header, image.pixels.size() * 3);
  std::byte* out = bytes.data() + header.size();
  for (const Rgba8& pixel : image.pixels) {
    *out++ = std::byte{pixel.r};
    *out++ = std::byte{pixel.g};
    *out++ = std::byte{pixel.b};
  }
  return bytes;
}

std::vector<std::byte> encode_pfm(const Image<float>& image) {
  return encode_pfm_as("Pf", image);
}
std::vector<std::byte> encode_pfm(const Image<Rgb32f>& image) {
  return encode_pfm_as("PF", image);
}

Result<NetpbmHeader> read_netpbm_header(Bytes bytes, const DecodeLimits& limits) {
  constexpr std::size_t kLongestWord = 32;
  NetpbmHeader header;
  std::size_t at = 0;
  const auto character = [&] { return at < bytes.size() ? int(bytes[at]) : -1; };
  const auto is_space = [](int c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  // Words are separated by white space and comments (from # to the end of the line).
  const auto word = [&] {
    std::string text;
    while (is_space(character()) || character() == '#') {
      if (character() == '#') {
        while (character() >= 0 && character() != '\n') ++at;
      } else {
        ++at;
      }
    }
    while (character() > ' ' && text.size() <= kLongestWord) {
      text += char(character());
      ++at;
    }
    return text;
  };
  const auto number = [&](std::uint64_t& value) {
    const std::string text = word();
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size() &&
           value <= 0xffffffffu;
  };

  header.magic = word();
  if (header.magic.size() != 2 || !number(header.width) || !number(header.height)) {
    return bad_header();
  }
  header.last = word();
  // Exactly one separator stands before the samples, which may look like white space themselves.
  if (header.last.empty() || !is_space(character())) return bad_header();
  header.size = at + 1;
  // At least a byte a pixel; check_samples knows how many.
  const auto fits = check_image_size(header.width, header.height, bytes.size(), 1, limits);
  if (!fits) return tl::unexpected<Error>(fits.error());
  return header;
}

Result<Image<Rgba8>> decode_pnm(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  const bool colour = header->magic == "P6";
  if (!colour && header->magic != "P5") {
    return fail("", "a " + header->magic + " file where P5 or P6 is expected", "convert it to PNG");
  }
  std::uint32_t largest = 0;
  const char* end = header->last.data() + header->last.size();
  const auto parsed = std::from_chars(header->last.data(), end, largest);
  if (parsed.ec != std::errc{} || parsed.ptr != end || largest == 0 || largest > 65535) {
    return bad_header();
  }
  const std::size_t sample_bytes = largest > 255 ? 2 : 1;  // big-endian
  const auto whole = check_samples(*header, bytes, sample_bytes * (colour ? 3 : 1));
  if (!whole) return tl::unexpected<Error>(whole.error());

  const std::byte* in = bytes.data() + header->size;
  const auto sample = [&] {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < sample_bytes; ++i) value = value << 8 | std::uint32_t(*in++);
    value = value < largest ? value : largest;
    return std::uint8_t((value * 255 + largest / 2) / largest);  // to the nearest
  };
  Image<Rgba8> image(int(header->width), int(header->height));
  for (Rgba8& pixel : image.pixels) {
    pixel.r = sample();
    pixel.g = colour ? sample() : pixel.r;
    pixel.b = colour ? sample() : pixel.r;
  }
  return image;
}

Result<Image<float>> decode_pfm(Bytes bytes, const DecodeLimits& limits) {
  return decode_pfm_as<float>("Pf", bytes, limits);
}
Result<Image<Rgb32f>> decode_pfm_rgb(Bytes bytes, const DecodeLimits& limits) {
  return decode_pfm_as<Rgb32f>("PF", bytes, limits);
}

}  // namespace glassbox
