#include <glassbox/images/pnm.h>

#include <bit>
#include <concepts>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <glassbox/images/netpbm_header.h>
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

struct PfmFile {
  int width = 0, height = 0, channels = 0;
  bool little_endian = false;
  const std::byte* samples = nullptr;
};

Result<PfmFile> open_pfm(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  if (!is_pfm(bytes)) {
    return fail("",
                "the file begins with " + header->magic +
                    ", but a PFM file begins with Pf (one channel) or PF (three)",
                "give a PFM file");
  }
  const std::uint64_t pixels = std::uint64_t(header->width) * header->height;
  const auto samples = netpbm_samples(*header, bytes, pixels * header->channels * sizeof(float));
  if (!samples) return tl::unexpected<Error>(samples.error());
  return PfmFile{int(header->width), int(header->height), int(header->channels), header->scale < 0,
                 samples->data()};
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

// A file with its samples as the binary formats have them: one or two bytes each.
struct PnmFile {
  int width = 0, height = 0, channels = 0;
  std::uint32_t largest = 0;           // the sample value of full intensity
  std::vector<std::byte> converted;    // the samples of formats that store them in another way
  const std::byte* samples = nullptr;  // in the file, or in `converted`
  PnmEnd end;

  std::size_t count() const {
    return std::size_t(width) * std::size_t(height) * std::size_t(channels);
  }
};

// A bit of P1 and P4 is 1 for black.
std::byte sample_of_bit(bool black) {
  return std::byte(black ? 0 : 1);
}

// Unpacks the bits of P4, whose rows begin at whole bytes.
std::vector<std::byte> unpack_bits(const NetpbmHeader& header, Bytes rows) {
  const std::size_t width = header.width, row_bytes = (width + 7) / 8;
  std::vector<std::byte> samples(width * header.height);
  std::byte* out = samples.data();
  for (std::size_t y = 0; y < header.height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const unsigned byte = unsigned(rows[y * row_bytes + x / 8]);
      *out++ = sample_of_bit((byte >> (7 - x % 8) & 1) != 0);
    }
  }
  return samples;
}

// Reads the next sample of P1, one digit, or of P2 and P3, a decimal number.
std::optional<std::uint32_t> plain_sample(const NetpbmHeader& header, NetpbmWords& words) {
  if (header.magic != "P1") return words.number();
  const int digit = words.digit();
  if (digit != '0' && digit != '1') return std::nullopt;
  return std::uint32_t(sample_of_bit(digit == '1'));
}

// Reads the samples of P1, P2 and P3, which are text. `length` becomes the length of that text.
Result<std::vector<std::byte>> read_plain(const NetpbmHeader& header, Bytes text,
                                          std::size_t& length) {
  const std::size_t count = std::size_t(header.width) * header.height * header.channels;
  std::vector<std::byte> samples;
  samples.reserve(count * (header.largest > 255 ? 2 : 1));
  NetpbmWords words(text);
  for (std::size_t i = 0; i < count; ++i) {
    const auto sample = plain_sample(header, words);
    const std::string which = "sample " + std::to_string(i + 1) + " of " + std::to_string(count);
    if (!sample) {
      const bool ends = words.character() < 0;
      return fail("", which + (ends ? " is missing or no number" : " is no number"),
                  "save the image again");
    }
    if (*sample > header.largest) {
      return fail("",
                  which + " is " + std::to_string(*sample) + ", above the largest value, " +
                      std::to_string(header.largest),
                  "write no sample above the largest value");
    }
    if (header.largest > 255) samples.push_back(std::byte(*sample >> 8));  // big-endian
    samples.push_back(std::byte(*sample & 0xff));
  }
  length = words.at();
  return samples;
}

bool is_plain(const NetpbmHeader& header) {
  return header.magic[1] <= '3';
}

Result<NetpbmHeader> read_pnm_header(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_netpbm_header(bytes, limits);
  if (!header || is_pnm(bytes)) return header;
  return fail("",
              "the file begins with " + header->magic +
                  ", but P1 to P7 (PBM, PGM, PPM, PAM) "
                  "are read here",
              "give one of these");
}

// The number of bytes that the samples have in the file; of text, the fewest that they can have.
std::uint64_t sample_bytes(const NetpbmHeader& header) {
  const std::uint64_t width = header.width, height = header.height;
  if (header.magic == "P1") return width * height;
  if (header.magic == "P4") return (width + 7) / 8 * height;
  const std::uint64_t samples = width * height * header.channels;
  if (is_plain(header)) return 2 * samples - 1;  // a digit each, and a space between them
  return samples * (header.largest > 255 ? 2 : 1);
}

Result<PnmFile> open_pnm(Bytes bytes, const DecodeLimits& limits) {
  const auto header = read_pnm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  const auto samples = netpbm_samples(*header, bytes, sample_bytes(*header));
  if (!samples) return tl::unexpected<Error>(samples.error());
  PnmFile file{int(header->width),
               int(header->height),
               int(header->channels),
               header->largest,
               {},
               samples->data(),
               {}};
  std::size_t length = std::size_t(sample_bytes(*header));
  if (is_plain(*header)) {
    auto read = read_plain(*header, *samples, length);
    if (!read) return tl::unexpected<Error>(read.error());
    file.converted = std::move(*read);
    file.samples = file.converted.data();
  } else if (header->magic == "P4") {
    file.converted = unpack_bits(*header, *samples);
    file.samples = file.converted.data();
  }
  file.end.at = header->size + length;
  const bool ends_in_cr_lf = !is_plain(*header) && bytes[header->size - 1] == std::byte{'\r'} &&
                             samples->front() == std::byte{'\n'};
  file.end.has_line_feed_too_many = ends_in_cr_lf && file.end.at < bytes.size();
  return file;
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
std::vector<Sample> read_samples(const PnmFile& file) {
  std::vector<Sample> samples(file.count());
  SampleReader<Sample> reader(file);
  for (Sample& sample : samples) sample = reader.next();
  return samples;
}

}  // namespace

bool is_pnm(Bytes bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{'P'} && bytes[1] >= std::byte{'1'} &&
         bytes[1] <= std::byte{'7'};
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
  if (file->end.has_line_feed_too_many) {
    return fail("", line_feed_text(), "write the file in binary mode, so that LF stays LF");
  }
  Image<Rgba8> image(file->width, file->height);
  SampleReader<std::uint8_t> reader(*file);
  const bool has_color = file->channels >= 3, has_alpha = file->channels % 2 == 0;
  for (Rgba8& pixel : image.pixels) {
    pixel.r = reader.next();
    pixel.g = has_color ? reader.next() : pixel.r;
    pixel.b = has_color ? reader.next() : pixel.r;
    if (has_alpha) pixel.a = reader.next();
  }
  return image;
}

Result<StoredImage> decode_pnm_stored(Bytes bytes, const DecodeLimits& limits, PnmEnd* end) {
  const auto file = open_pnm(bytes, limits);
  if (!file) return tl::unexpected<Error>(file.error());
  if (end) *end = file->end;
  StoredImage image{file->width, file->height, file->channels, {}};
  if (file->largest > 255) {
    image.samples = read_samples<std::uint16_t>(*file);
  } else {
    image.samples = read_samples<std::uint8_t>(*file);
  }
  return image;
}

std::string line_feed_text() {
  return "the header ends in CR LF, where one byte belongs: LF is read as the first sample, every "
         "other sample comes one byte too late, and one byte is left over";
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
  const auto header = read_pnm_header(bytes, limits);
  if (!header) return tl::unexpected<Error>(header.error());
  const auto samples = netpbm_samples(*header, bytes, sample_bytes(*header));
  if (!samples) return tl::unexpected<Error>(samples.error());
  return StoredHeader{int(header->width), int(header->height), int(header->channels)};
}
Result<StoredHeader> stored_header_of_pfm(Bytes bytes, const DecodeLimits& limits) {
  return open_pfm(bytes, limits).map([](const PfmFile& file) {
    return StoredHeader{file.width, file.height, file.channels};
  });
}

}  // namespace glassbox
