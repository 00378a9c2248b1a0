#include <glassbox/images/pnm.h>

#include <bit>
#include <charconv>
#include <concepts>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <glassbox/images/image_size.h>
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

// Copies floats from the bytes of a file, which are little-endian if `little` is true.
void copy_floats(const std::byte* from, bool little, std::byte* to, std::size_t count) {
  if (little == (std::endian::native == std::endian::little)) {
    std::memcpy(to, from, count * sizeof(float));
    return;
  }
  // Swapped as bytes, so that no NaN passes through a register that would change it.
  for (std::size_t i = 0; i < count; ++i, from += 4, to += 4) {
    for (int k = 0; k < 4; ++k) to[k] = from[3 - k];
  }
}

// Encodes floats in memory, rows top-down, to a file with its rows bottom-up.
std::vector<std::byte> encode_floats(int width, int height, int channels, const void* samples) {
  const std::string header =
      (channels == 1 ? "Pf\n" : "PF\n") + size_line(width, height) + "-1.0\n";
  const std::size_t row = std::size_t(width) * std::size_t(channels);
  const std::size_t rows = std::size_t(height);
  std::vector<std::byte> bytes = with_header(header, row * rows * sizeof(float));
  std::byte* out = bytes.data() + header.size();
  for (std::size_t y = rows; y-- > 0; out += row * sizeof(float)) {
    const auto* in = static_cast<const std::byte*>(samples) + y * row * sizeof(float);
    copy_floats(in, true, out, row);  // swapping is the same in both directions
  }
  return bytes;
}

tl::unexpected<Error> bad_header() {
  return fail("", "not a valid PPM, PGM or PFM header", "save the image again");
}

struct NetpbmHeader {
  std::string magic;        // "P6"
  std::uint64_t width = 0;  // px
  std::uint64_t height = 0;
  // The largest sample for PPM and PGM, the scale for PFM.
  std::string last;
  std::size_t size = 0;  // bytes before the first sample
};

// Reads the header and checks the size against the limits.
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
  // Exactly one separator is before the samples, because the first sample's bytes may look like
  // white space themselves.
  if (header.last.empty() || !is_space(character())) return bad_header();
  header.size = at + 1;
  // A pixel takes at least one byte; samples_of checks the exact number.
  const auto fits = check_image_size(header.width, header.height, bytes.size(), 1, limits);
  if (!fits) return tl::unexpected<Error>(fits.error());
  return header;
}

// Returns the bytes after the header, if there are enough of them.
Result<const std::byte*> samples_of(const NetpbmHeader& header, Bytes bytes,
                                    std::uint64_t pixel_bytes) {
  const std::uint64_t needed = header.width * header.height * pixel_bytes;
  const Bytes rest = bytes.subspan(header.size);
  if (rest.size() >= needed) return rest.data();
  return fail("",
              "the file is cut off: its pixels need " + std::to_string(needed) +
                  " bytes, but it has only " + std::to_string(rest.size()) + " for them",
              "save the image again");
}

struct PfmFile {
  int width = 0, height = 0, channels = 0;
  bool little_endian = false;
  const std::byte* samples = nullptr;
};

Result<PfmFile> open_pfm(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  if (header->magic != "Pf" && header->magic != "PF") {
    return fail("",
                "the file begins with " + header->magic +
                    ", but a PFM file begins with Pf (one channel) or PF (three)",
                "give a PFM file");
  }
  double scale = 0;
  const char* end = header->last.data() + header->last.size();
  const auto parsed = std::from_chars(header->last.data(), end, scale);
  if (parsed.ec != std::errc{} || parsed.ptr != end || !(scale < 0 || scale > 0)) {
    return bad_header();
  }
  const int channels = header->magic == "Pf" ? 1 : 3;
  const auto samples = samples_of(*header, bytes, std::uint64_t(channels) * sizeof(float));
  if (!samples) return tl::unexpected<Error>(samples.error());
  return PfmFile{int(header->width), int(header->height), channels, scale < 0, *samples};
}

// `pixels` has room for every sample.
void read_floats(const PfmFile& file, void* pixels) {
  const std::size_t row = std::size_t(file.width) * std::size_t(file.channels);
  const std::byte* in = file.samples;
  for (std::size_t y = std::size_t(file.height); y-- > 0; in += row * sizeof(float)) {
    auto* out = static_cast<std::byte*>(pixels) + y * row * sizeof(float);
    copy_floats(in, file.little_endian, out, row);
  }
}

template <class Pixel>
Result<Image<Pixel>> decode_pfm_as(const char* magic, Bytes bytes, const DecodeLimits& limits) {
  static_assert(sizeof(Rgb32f) == 3 * sizeof(float));
  const auto file = open_pfm(bytes, limits);
  if (!file) return tl::unexpected<Error>(file.error());
  if (std::size_t(file->channels) * sizeof(float) != sizeof(Pixel)) {
    const std::string other = file->channels == 1 ? "Pf" : "PF";
    return fail("",
                "the file begins with " + other + ", but " + magic +
                    " is needed: Pf is PFM with one channel, PF with three",
                std::string("give a PFM file that begins with ") + magic);
  }
  Image<Pixel> image(file->width, file->height);
  read_floats(*file, image.pixels.data());
  return image;
}

struct PnmFile {
  int width = 0, height = 0, channels = 0;
  std::uint32_t largest = 0;  // the sample value of full intensity
  const std::byte* samples = nullptr;
};

Result<PnmFile> open_pnm(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  if (header->magic != "P5" && header->magic != "P6") {
    return fail(
        "", "the file begins with " + header->magic + ", but only P5 (PGM) and P6 (PPM) are read",
        "convert the file to PNG");
  }
  std::uint32_t largest = 0;
  const char* end = header->last.data() + header->last.size();
  const auto parsed = std::from_chars(header->last.data(), end, largest);
  if (parsed.ec != std::errc{} || parsed.ptr != end || largest == 0 || largest > 65535) {
    return bad_header();
  }
  const int channels = header->magic == "P6" ? 3 : 1;
  const auto samples =
      samples_of(*header, bytes, std::uint64_t(channels) * (largest > 255 ? 2 : 1));
  if (!samples) return tl::unexpected<Error>(samples.error());
  return PnmFile{int(header->width), int(header->height), channels, largest, *samples};
}

// Reads the samples of a file one by one, scaled and rounded to the range from 0 to the largest
// Sample.
template <std::unsigned_integral Sample>
class SampleReader {
public:
  explicit SampleReader(const PnmFile& file) : in_(file.samples), largest_(file.largest) {}

  Sample next() {
    std::uint32_t value = std::uint32_t(*in_++);
    if (largest_ > 255) value = value << 8 | std::uint32_t(*in_++);  // big-endian
    value = value < largest_ ? value : largest_;
    return Sample((value * kFull + largest_ / 2) / largest_);  // below 2^16 * 2^16
  }

private:
  static constexpr std::uint32_t kFull = std::numeric_limits<Sample>::max();
  const std::byte* in_;
  std::uint32_t largest_;
};

template <class Sample>
std::vector<Sample> read_samples(const PnmFile& file, std::size_t count) {
  std::vector<Sample> samples(count);
  SampleReader<Sample> reader(file);
  for (Sample& sample : samples) sample = reader.next();
  return samples;
}

}  // namespace

bool is_pnm(Bytes bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{'P'} &&
         (bytes[1] == std::byte{'5'} || bytes[1] == std::byte{'6'});
}

bool is_pfm(Bytes bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{'P'} &&
         (bytes[1] == std::byte{'f'} || bytes[1] == std::byte{'F'});
}

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
  return encode_floats(image.width, image.height, 1, image.pixels.data());
}
std::vector<std::byte> encode_pfm(const Image<Rgb32f>& image) {
  return encode_floats(image.width, image.height, 3, image.pixels.data());
}
Result<std::vector<std::byte>> encode_pfm(const StoredImage& image) {
  const auto* samples = std::get_if<std::vector<float>>(&image.samples);
  if (!samples || (image.channels != 1 && image.channels != 3)) {
    return fail("",
                channel_names(image) + " of " + format_name(image) +
                    " cannot be a PFM, which has 1 or 3 channels of floats",
                "write a PNG instead");
  }
  if (samples->size() != image.pixels() * std::size_t(image.channels)) {
    return fail("", "the number of samples is not width x height x channels",
                "give one sample for each channel of each pixel");
  }
  return encode_floats(image.width, image.height, image.channels, samples->data());
}

Result<Image<Rgba8>> decode_pnm(Bytes bytes, const DecodeLimits& limits) {
  const auto file = open_pnm(bytes, limits);
  if (!file) return tl::unexpected<Error>(file.error());
  Image<Rgba8> image(file->width, file->height);
  SampleReader<std::uint8_t> reader(*file);
  for (Rgba8& pixel : image.pixels) {
    pixel.r = reader.next();
    pixel.g = file->channels == 3 ? reader.next() : pixel.r;
    pixel.b = file->channels == 3 ? reader.next() : pixel.r;
  }
  return image;
}

Result<StoredImage> decode_pnm_stored(Bytes bytes, const DecodeLimits& limits) {
  const auto file = open_pnm(bytes, limits);
  if (!file) return tl::unexpected<Error>(file.error());
  StoredImage image{file->width, file->height, file->channels, {}};
  const std::size_t count = image.pixels() * std::size_t(image.channels);
  if (file->largest > 255) {
    image.samples = read_samples<std::uint16_t>(*file, count);
  } else {
    image.samples = read_samples<std::uint8_t>(*file, count);
  }
  return image;
}

Result<Image<float>> decode_pfm(Bytes bytes, const DecodeLimits& limits) {
  return decode_pfm_as<float>("Pf", bytes, limits);
}
Result<Image<Rgb32f>> decode_pfm_rgb(Bytes bytes, const DecodeLimits& limits) {
  return decode_pfm_as<Rgb32f>("PF", bytes, limits);
}
Result<StoredImage> decode_pfm_stored(Bytes bytes, const DecodeLimits& limits) {
  const auto file = open_pfm(bytes, limits);
  if (!file) return tl::unexpected<Error>(file.error());
  StoredImage image{file->width, file->height, file->channels, {}};
  std::vector<float> samples(image.pixels() * std::size_t(image.channels));
  read_floats(*file, samples.data());
  image.samples = std::move(samples);
  return image;
}

Result<StoredHeader> stored_header_of_pnm(Bytes bytes, const DecodeLimits& limits) {
  return open_pnm(bytes, limits).map([](const PnmFile& file) {
    return StoredHeader{file.width, file.height, file.channels};
  });
}
Result<StoredHeader> stored_header_of_pfm(Bytes bytes, const DecodeLimits& limits) {
  return open_pfm(bytes, limits).map([](const PfmFile& file) {
    return StoredHeader{file.width, file.height, file.channels};
  });
}

}  // namespace glassbox
