// OpenEXR files that OpenEXR's library writes, and what it reads from them, as a second opinion.
#include "tests/support/catch.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfTiledOutputFile.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/images/stored_file.h>

#include "tests/images/stored_builder.h"

namespace {

using namespace glassbox;

// A channel with its samples, row by row.
struct Written {
  std::string name;
  Imf::PixelType type = Imf::HALF;
  std::vector<char> samples;

  std::size_t bytes() const { return type == Imf::HALF ? 2 : 4; }
};

Imf::FrameBuffer frame_of(std::vector<Written>& channels, int width) {
  Imf::FrameBuffer frame;
  for (Written& channel : channels) {
    frame.insert(channel.name, Imf::Slice(channel.type, channel.samples.data(), channel.bytes(),
                                          channel.bytes() * std::size_t(width)));
  }
  return frame;
}

// Writes a file of scan lines, or of tiles if `tile` is not 0.
std::string write_exr(std::vector<Written>& channels, int width, int height,
                      Imf::Compression compression, unsigned tile) {
  Imf::Header header(width, height);
  header.compression() = compression;
  for (const Written& channel : channels) {
    // The reader refuses B44's halves that are perceptual (pLinear); nowhere else does it matter.
    const bool is_b44 = compression == Imf::B44_COMPRESSION || compression == Imf::B44A_COMPRESSION;
    const bool is_perceptual = !is_b44 || channel.type != Imf::HALF;
    header.channels().insert(channel.name, Imf::Channel(channel.type, 1, 1, is_perceptual));
  }
  Imf::StdOSStream stream;
  if (tile > 0) {
    header.setTileDescription(Imf::TileDescription(tile, tile + 3, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(stream, header);
    file.setFrameBuffer(frame_of(channels, width));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    header.lineOrder() = width % 2 == 0 ? Imf::INCREASING_Y : Imf::DECREASING_Y;
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame_of(channels, width));
    file.writePixels(height);
  }
  return stream.str();
}

// Replaces the samples with those that the library reads.
void read_back(const std::string& bytes, std::vector<Written>& channels, int width, int height) {
  Imf::StdISStream stream;
  stream.str(bytes);
  Imf::InputFile file(stream);
  for (Written& channel : channels) std::ranges::fill(channel.samples, char(0));
  file.setFrameBuffer(frame_of(channels, width));
  file.readPixels(0, height - 1);
}

// Returns samples of one of four kinds: noise of all bits, a slope, few values, a constant.
std::vector<char> samples_of(int kind, Imf::PixelType type, int width, int height, Random& random) {
  std::vector<char> samples;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float value = kind == 1   ? float(x) * 0.25f + float(y)
                          : kind == 2 ? float(random.integer(0, 3))
                                      : 0.5f;
      const Imath::half half = value;
      const std::uint64_t noise = random.bits();
      const void* from = &noise;
      if (kind != 0 && type == Imf::HALF) from = &half;
      if (kind != 0 && type != Imf::HALF) from = &value;
      const auto* bytes = static_cast<const char*>(from);
      samples.insert(samples.end(), bytes, bytes + (type == Imf::HALF ? 2 : 4));
    }
  }
  return samples;
}

std::uint32_t float_bits(const Written& channel, std::size_t pixel) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, channel.samples.data() + pixel * channel.bytes(), channel.bytes());
  if (channel.type != Imf::HALF) return bits;
  if ((bits >> 10 & 31) == 31) {
    return (bits & 0x8000u) << 16 | 0x7f800000u | (bits & 0x3ffu) << 13;
  }
  return std::bit_cast<std::uint32_t>(
      float(Imath::half(Imath::half::FromBits, std::uint16_t(bits))));
}

// Compares the channels of the picture, which come first in `channels`, and the further ones.
void check_same(const StoredFile& file, const std::vector<Written>& channels, std::size_t shown) {
  REQUIRE(std::size_t(file.image.channels) == shown);
  const auto& samples = std::get<std::vector<float>>(file.image.samples);
  REQUIRE(samples.size() == file.image.pixels() * shown);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(samples[i]);
    wrong += bits != float_bits(channels[i % shown], i / shown) ? 1u : 0u;
  }
  CHECK(wrong == 0);
  std::size_t at = 0;
  for (std::size_t i = shown; i < channels.size(); ++i) {
    const auto& expected = channels[i].samples;
    REQUIRE(file.rest.size() >= at + expected.size());
    CHECK(std::memcmp(file.rest.data() + at, expected.data(), expected.size()) == 0);
    at += expected.size();
  }
  CHECK(file.rest.empty() == (shown == channels.size()));
}

}  // namespace

TEST_CASE("a file is what OpenEXR's library reads from it, with every compression but DWA") {
  struct Set {
    std::vector<std::string> names;  // the picture's in their order, then further ones in theirs
    std::size_t shown;
  };
  const Set sets[] = {{{"R", "G", "B"}, 3}, {{"R", "G", "B", "A"}, 4},
                      {{"Y"}, 1},           {{"Y", "A"}, 2},
                      {{"depth"}, 1},       {{"R", "G", "B", "A", "N.X", "Z"}, 4}};
  const std::uint64_t seed = 409;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 3000; ++round) {
    const auto compression = Imf::Compression(round % 8);  // from NO_COMPRESSION to B44A
    const int width = int(random.integer(1, 40)), height = int(random.integer(1, 70));
    const int kind = int(random.integer(0, 3));
    const bool has_tiles = random.integer(0, 1) == 1;
    const auto tile = has_tiles ? unsigned(random.integer(1, 30)) : 0u;
    const Set& set = sets[random.integer(0, 5)];
    CAPTURE(round, int(compression), width, height, kind, tile, set.names.size());
    std::vector<Written> channels;
    for (const std::string& name : set.names) {
      // Only further channels may be integers.
      const bool is_shown = channels.size() < set.shown;
      const auto type = Imf::PixelType(random.integer(is_shown ? 1 : 0, 2));
      channels.push_back({name, type, samples_of(kind, type, width, height, random)});
    }
    const std::vector<Written> original = channels;
    const std::string bytes = write_exr(channels, width, height, compression, tile);
    const auto file = decode_stored_file(std::as_bytes(std::span(bytes)));
    REQUIRE(file);
    REQUIRE(file->image.width == width);
    REQUIRE(file->image.height == height);
    read_back(bytes, channels, width, height);
    check_same(*file, channels, set.shown);
    if (compression <= Imf::PIZ_COMPRESSION) check_same(*file, original, set.shown);
  }
}

TEST_CASE("PIZ with more than 2^14 different values is what OpenEXR's library reads") {
  for (const auto type : {Imf::HALF, Imf::FLOAT}) {
    for (const unsigned tile : {0u, 200u}) {
      constexpr int kWidth = 900, kHeight = 70;
      std::vector<Written> channels;
      for (const int slope : {1, 2, 3}) {
        // A slope: its many values are different, and easy to compress.
        std::vector<char> samples;
        for (int pixel = 0; pixel < kWidth * kHeight; ++pixel) {
          const auto bits = std::uint32_t(pixel * slope % 0x7c00);
          const auto* bytes = reinterpret_cast<const char*>(&bits);
          samples.insert(samples.end(), bytes, bytes + (type == Imf::HALF ? 2 : 4));
        }
        channels.push_back({std::string(1, "RGB"[slope - 1]), type, std::move(samples)});
      }
      const std::string bytes = write_exr(channels, kWidth, kHeight, Imf::PIZ_COMPRESSION, tile);
      REQUIRE(bytes.size() < 3 * channels[0].samples.size() * 9 / 10);
      const auto file = decode_stored_file(std::as_bytes(std::span(bytes)));
      REQUIRE(file);
      check_same(*file, channels, 3);
    }
  }
}
