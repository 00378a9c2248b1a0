#include "tests/support/catch.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <glassbox/images/exr_header.h>
#include <glassbox/images/format.h>
#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stb_read.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

#include "tests/images/exr_builder.h"
#include "tests/images/plain_builder.h"
#include "tests/images/stored_builder.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::Bytes;
using test::stored;

Result<StoredImage> decode(const Bytes& bytes, const DecodeLimits& limits = kCompareLimits) {
  return decode_stored(std::as_bytes(std::span(bytes)), limits);
}

Bytes bytes_of(const std::string& text) {
  return Bytes(text.begin(), text.end());
}
Bytes bytes_of(const std::vector<std::byte>& bytes) {
  Bytes result;
  for (const std::byte byte : bytes) result.push_back(std::uint8_t(byte));
  return result;
}

struct File {
  std::string name;
  Bytes bytes;
};

// Returns one small file of each kind in the fuzzer's corpus: every format, depth and channel
// count.
std::vector<File> small_files() {
  std::vector<File> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("found-") || entry.path().extension() == ".txt") continue;
    files.push_back({name, bytes_of(read_file(entry.path().string()).value())});
  }
  std::sort(files.begin(), files.end(),
            [](const File& a, const File& b) { return a.name < b.name; });
  return files;
}

// The kinds of files that a corpus of every format has.
std::set<std::string> all_kinds() {
  std::set<std::string> kinds{"JPEG", "BMP", "TGA", "Radiance HDR", "PFM Pf", "PFM PF"};
  for (const char* magic : {"P1", "P2", "P3", "P4", "P5", "P6", "P7"}) {
    kinds.insert("PNM "s + magic);
  }
  for (const char* type : {"0", "2", "3", "4", "6"}) kinds.insert("PNG, colour type "s + type);
  for (int number = 0; number <= int(ExrCompression::kB44a); ++number) {
    kinds.insert("OpenEXR, compression " + std::to_string(number));
  }
  return kinds;
}

// The kind of a file, as in all_kinds.
std::string kind_of(const Bytes& file) {
  const auto bytes = std::as_bytes(std::span(file));
  constexpr std::size_t kPngType = 25;  // where a PNG has its colour type
  const auto format = picture_format_of(bytes);
  if (!format) return is_tga(bytes) ? "TGA" : "unknown";
  const std::string magic(file.begin(), file.begin() + 2);
  switch (format->format) {
    case PictureFormat::kPng:
      return "PNG, colour type " + std::to_string(file[kPngType]);
    case PictureFormat::kJpeg:
      return "JPEG";
    case PictureFormat::kBmp:
      return "BMP";
    case PictureFormat::kPnm:
      return "PNM " + magic;
    case PictureFormat::kPfm:
      return "PFM " + magic;
    case PictureFormat::kHdr:
      return "Radiance HDR";
    case PictureFormat::kExr: {
      const auto header = read_exr_header(bytes, kCompareLimits).value();
      return "OpenEXR, compression " + std::to_string(int(header.compression));
    }
    case PictureFormat::kNotRead:
      break;
  }
  return "not read";
}

void require_explained(const Result<StoredImage>& image) {
  REQUIRE_FALSE(image);
  REQUIRE_FALSE(image.error().cause.empty());
  REQUIRE_FALSE(image.error().remedy.empty());
}

void require_whole(const StoredImage& image) {
  std::visit(
      [&](const auto& samples) {
        REQUIRE(samples.size() == image.pixels() * std::size_t(image.channels));
      },
      image.samples);
}

// The result of `work` (below 128) in a child process, and by how much the process's peak memory
// grew.
struct Run {
  int result = 0;
  long grown_kib = 0;
};
template <class Work>
Run in_child(Work work) {
  const auto resident_kib = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  int pipe_ends[2];
  REQUIRE(::pipe(pipe_ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const long before = resident_kib();
    const int result = work();
    const long grown = resident_kib() - before;
    const bool told = ::write(pipe_ends[1], &grown, sizeof grown) == sizeof grown;
    ::_exit(told ? result : 127);
  }
  ::close(pipe_ends[1]);
  Run run;
  if (::read(pipe_ends[0], &run.grown_kib, sizeof run.grown_kib) != sizeof run.grown_kib) {
    run.grown_kib = -1;
  }
  ::close(pipe_ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  run.result = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return run;
}

// Returns files of a few hundred bytes that claim to have `width` x `height` pixels.
std::vector<File> bombs(std::uint32_t width, std::uint32_t height) {
  const std::string size = std::to_string(width) + " " + std::to_string(height);
  std::vector<File> files;
  for (const std::uint8_t colour_type : std::initializer_list<std::uint8_t>{0, 2, 3, 4, 6}) {
    const bool palette = colour_type == 3;
    for (const bool interlaced : {false, true}) {
      files.push_back({"PNG", test::build_png({.width = width,
                                               .height = height,
                                               .bit_depth = std::uint8_t(palette ? 1 : 16),
                                               .colour_type = colour_type,
                                               .palette = palette ? Bytes(6) : Bytes(),
                                               .rows = Bytes(300),
                                               .interlaced = interlaced})});
    }
  }
  for (const char* magic : {"P2 ", "P3 ", "P5 ", "P6 "}) {
    files.push_back({"PNM", bytes_of(magic + size + " 65535\n" + std::string(300, '1'))});
  }
  for (const char* magic : {"P1 ", "P4 "}) {
    files.push_back({"PBM", bytes_of(magic + size + "\n" + std::string(300, '1'))});
  }
  files.push_back({"PAM", bytes_of("P7\nWIDTH " + std::to_string(width) + "\nHEIGHT " +
                                   std::to_string(height) + "\nDEPTH 1\nMAXVAL 1\nENDHDR\n1")});
  files.push_back(
      {"HDR", bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) +
                       " +X " + std::to_string(width) + "\n\2\2" + std::string(300, 'x'))});
  for (const char* magic : {"Pf ", "PF "}) {
    files.push_back({"PFM", bytes_of(magic + size + " -1\n" + std::string(300, 'x'))});
  }
  files.push_back({"EXR", test::build_exr({.data = {0, 0, width - 1, height - 1},
                                           .display = {0, 0, width - 1, height - 1},
                                           .compression = 3})});
  const auto narrow = std::uint16_t(width), low = std::uint16_t(height);
  for (const std::uint32_t bits : {1u, 8u, 24u, 32u}) {
    files.push_back(
        {"BMP", test::build_bmp(width, height, bits, Bytes(300), bits < 24 ? Bytes(8) : Bytes())});
  }
  files.push_back({"TGA", test::build_tga(2, narrow, low, 32, Bytes(300))});
  files.push_back({"TGA", test::build_tga(10, narrow, low, 32, Bytes(300, 0xff))});
  for (const char* name : {"grey.jpg", "progressive.jpg"}) {
    const auto small = small_files();
    Bytes jpeg = std::find_if(small.begin(), small.end(), [&](const File& file) {
                   return file.name == name;
                 })->bytes;
    // The frame header is FF C0 or FF C2, a length of two bytes, the depth, then height and width.
    std::size_t at = 2;
    while (jpeg[at] != 0xff || (jpeg[at + 1] != 0xc0 && jpeg[at + 1] != 0xc2)) ++at;
    jpeg[at + 5] = std::uint8_t(height >> 8);
    jpeg[at + 6] = std::uint8_t(height);
    jpeg[at + 7] = std::uint8_t(width >> 8);
    jpeg[at + 8] = std::uint8_t(width);
    files.push_back({name, jpeg});
  }
  return files;
}

}  // namespace

TEST_CASE("the corpus has files of every format, and of every compression of OpenEXR") {
  std::set<std::string> kinds;
  for (const auto& [name, bytes] : small_files()) kinds.insert(kind_of(bytes));
  CHECK(kinds == all_kinds());
}

TEST_CASE("a small file of every format, cut off anywhere, is refused") {
  for (const auto& [name, bytes] : small_files()) {
    REQUIRE(decode(bytes));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CAPTURE(name, size, bytes.size());
      require_explained(decode(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(size))));
    }
  }
}

TEST_CASE("a small file of every format with one byte changed decodes whole or is refused") {
  const std::uint64_t seed = 59;
  CAPTURE(seed);
  Random random(seed);
  for (const auto& [name, bytes] : small_files()) {
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      for (int round = 0; round < 4; ++round) {
        Bytes changed = bytes;
        changed[at] = std::uint8_t(random.bits());
        CAPTURE(name, at, int(changed[at]));
        const auto image = decode(changed, {.max_pixels = 1 << 20});
        if (image) {
          require_whole(*image);
        } else {
          require_explained(image);
        }
      }
    }
  }
}

TEST_CASE("a tiny file that claims to be huge is refused without the memory") {
  for (const auto& [width, height] :
       {std::pair(16384u, 16384u), std::pair(60000u, 60000u), std::pair(16384u, 16383u)}) {
    for (const auto& [name, bytes] : bombs(width, height)) {
      CAPTURE(name, width, height, bytes.size());
      const Run run = in_child([&, &file = bytes] { return decode(file) ? 1 : 0; });
      CHECK(run.result == 0);
      // The smallest of these pictures would need 256 MiB; a process that only reads headers needs
      // a few pages.
      CHECK(run.grown_kib >= 0);
      CHECK(run.grown_kib < 32 * 1024);
    }
  }
}

TEST_CASE("a small OpenEXR picture of many channels is refused without the memory") {
  // A file of 400 kB claims to have 1024 x 1024 pixels of 64 floats, which are 256 MiB.
  const std::vector<std::uint32_t> window{0, 0, 1023, 1023};
  test::ExrParts parts{
      .channels = {}, .data = window, .display = window, .compression = 3, .rows = {Bytes(400000)}};
  for (int i = 0; i < 63; ++i) parts.channels.push_back({"c" + std::to_string(i), 2});
  parts.channels.push_back({"Y", 2});
  const Bytes file = test::build_exr(parts);
  const Run run = in_child([&] { return decode(file, {.max_pixels = 1 << 20}) ? 1 : 0; });
  CHECK(run.result == 0);
  CHECK(run.grown_kib >= 0);
  CHECK(run.grown_kib < 32 * 1024);  // as above
}

TEST_CASE("more pixels than the limit allows are refused before they are decoded") {
  for (const auto& [name, bytes] : small_files()) {
    CAPTURE(name);
    const auto image = decode(bytes);
    REQUIRE(image);
    const auto pixels = std::uint64_t(image->pixels());
    CHECK(decode(bytes, {.max_pixels = pixels}));
    require_explained(decode(bytes, {.max_pixels = pixels - 1}));
    const auto side = std::uint32_t(std::max(image->width, image->height));
    CHECK(decode(bytes, {.max_side = side}));
    require_explained(decode(bytes, {.max_side = side - 1}));
  }
}

TEST_CASE("a wrong check sum matters where it guards samples, and nowhere else") {
  test::PngParts parts{
      .colour_type = 3, .palette = {1, 2, 3, 4, 5, 6}, .transparency = {7, 8}, .rows = {0, 1}};
  test::put_chunk(parts.extra, "gAMA", {0, 0, 0xb1, 0x8f});
  test::put_chunk(parts.extra, "tEXt", bytes_of("Key\0text"s));
  const Bytes whole = test::build_png(parts);
  const StoredImage expected = stored<std::uint8_t>(1, 1, 4, {4, 5, 6, 8});
  REQUIRE(decode(whole).value() == expected);
  for (const char* type : {"IHDR", "PLTE", "tRNS", "IDAT", "IEND", "gAMA", "tEXt"}) {
    CAPTURE(type);
    const std::string name = type;
    const auto found = std::search(whole.begin(), whole.end(), name.begin(), name.end());
    REQUIRE(found != whole.end());
    const auto at = std::size_t(found - whole.begin());
    const std::size_t length = whole[at - 1];  // below 256
    Bytes changed = whole;
    changed[at + 4 + length] ^= 1;
    if (name == "gAMA" || name == "tEXt") {
      CHECK(decode(changed).value() == expected);
    } else {
      require_explained(decode(changed));
    }
  }
}

TEST_CASE("a tRNS that libpng would leave out is refused: the alpha would be gone") {
  const test::PngParts palette{.colour_type = 3, .palette = {1, 2, 3}, .rows = {0, 0}};
  test::PngParts parts = palette;
  parts.transparency = {1, 2};  // longer than the palette
  require_explained(decode(test::build_png(parts)));
  parts = {.colour_type = 2, .transparency = {0, 1, 0, 2}, .rows = {0, 1, 2, 3}};  // too short
  require_explained(decode(test::build_png(parts)));
  // the colour type already has alpha
  parts = {.colour_type = 6, .transparency = {0, 1}, .rows = {0, 1, 2, 3, 4}};
  require_explained(decode(test::build_png(parts)));
  parts = palette;
  test::put_chunk(parts.extra, "tRNS", {1});  // before the palette
  require_explained(decode(test::build_png(parts)));
}

TEST_CASE("a JPEG with more codes in a table than the format has is refused") {
  const auto files = small_files();
  const auto grey = std::find_if(files.begin(), files.end(),
                                 [](const File& file) { return file.name == "grey.jpg"; });
  // The table has 16 counts of codes that add up to 257 or more, followed by that many values.
  for (const int codes : {257, 600, 4080}) {
    Bytes jpeg{0xff, 0xd8, 0xff, 0xc4};
    const int length = 2 + 17 + codes;
    jpeg.push_back(std::uint8_t(length >> 8));
    jpeg.push_back(std::uint8_t(length));
    jpeg.push_back(0);
    for (int i = 0; i < 16; ++i) {
      jpeg.push_back(std::uint8_t(std::clamp(codes - i * 255, 0, 255)));
    }
    jpeg.resize(jpeg.size() + std::size_t(codes));
    jpeg.push_back(0xff);
    jpeg.push_back(0xd9);
    CAPTURE(codes);
    const auto image = decode(jpeg);
    REQUIRE_FALSE(image);
    CHECK(image.error().cause == "JPEG with a Huffman table that is not valid");
    CHECK_FALSE(decode_image(std::as_bytes(std::span(jpeg))));
    // The same table after a scan.
    Bytes late(grey->bytes.begin(), grey->bytes.end() - 2);  // without the last marker
    late.insert(late.end(), jpeg.begin() + 2, jpeg.end());
    CHECK(decode(late).error().cause == "JPEG with a Huffman table that is not valid");
    // With a byte FF before its start, it must not reach stb as a JPEG.
    jpeg.insert(jpeg.begin(), 0xff);
    require_explained(decode(jpeg));
  }
}

#ifdef __GLIBC__
TEST_CASE("a JPEG that leaves out a scan decodes the same, whatever was in the memory before") {
  const auto path = GLASSBOX_SOURCE_DIR "/tests/fuzz/corpus/stored/found-no-dc.jpg";
  const auto decode_over = [&](int byte) {
    ::mallopt(M_PERTURB, byte);  // fills the memory that malloc returns
    const auto image = read_stored(path);
    ::mallopt(M_PERTURB, 0);
    REQUIRE(image);
    return *image;
  };
  CHECK(decode_over(1) == decode_over(85));
}
#endif

TEST_CASE("a BMP that chooses colours behind the end of its palette is refused") {
  const Bytes palette(4 * 3);  // the colours 0, 1 and 2
  CHECK(decode(test::build_bmp(3, 1, 8, {0, 1, 2, 0}, palette)));
  require_explained(decode(test::build_bmp(3, 1, 8, {0, 3, 2, 0}, palette)));
  // only the padding has a larger number
  CHECK(decode(test::build_bmp(3, 1, 8, {0, 1, 2, 99}, palette)));
  CHECK(decode(test::build_bmp(3, 2, 4, {0x01, 0x2f, 0, 0, 0x10, 0x20, 0, 0}, palette)));
  require_explained(
      decode(test::build_bmp(3, 2, 4, {0x01, 0x20, 0, 0, 0x10, 0x30, 0, 0}, palette)));
  require_explained(decode(test::build_bmp(9, 1, 1, {0, 0x80, 0, 0}, Bytes(4))));
}

TEST_CASE("a TGA that stb would read in another order is refused") {
  const Bytes samples{1, 2, 3, 4, 5, 6};
  REQUIRE(decode(test::build_tga(2, 2, 1, 24, samples)));
  for (const std::uint8_t order : std::initializer_list<std::uint8_t>{0x10, 0x40, 0x80}) {
    Bytes tga = test::build_tga(2, 2, 1, 24, samples);
    tga[17] = order;  // rows from right to left, or every second or fourth row first
    CHECK(decode(tga).error().cause == "TGA with an unusual order of pixels");
  }
  Bytes shifted = test::build_tga(1, 2, 1, 8, {0, 1}, samples);
  REQUIRE(decode(shifted));
  shifted[3] = 1;
  CHECK(decode(shifted).error().cause == "TGA with a palette that does not start at 0");
}

TEST_CASE("garbage behind the first bytes of every format decodes whole or is refused") {
  const std::uint64_t seed = 61;
  CAPTURE(seed);
  Random random(seed);
  const std::vector<std::string> starts{"",
                                        "\x89PNG\r\n\x1a\n",
                                        "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"s,
                                        "\xff\xd8",
                                        "\xff\xd8\xff",
                                        "BM",
                                        "P5 3 3 255\n",
                                        "P6 2 2 999\n",
                                        "Pf 2 2 1\n",
                                        "PF 1 1 -1\n",
                                        "P5",
                                        "Pf ",
                                        "\0\0\2"s,
                                        "\0\0\x0a"s,
                                        "\0\1\1"s,
                                        "GIF89a",
                                        "8BPS",
                                        "#?RADIANCE\n",
                                        "\x76\x2f\x31\x01\2\0\0\0"s,
                                        "\x53\x80\xf6\x34"};
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = bytes_of(starts[std::size_t(round) % starts.size()]);
    for (std::int64_t n = random.integer(0, 120); n > 0; --n) {
      bytes.push_back(std::uint8_t(random.bits()));
    }
    const auto image = decode(bytes, {.max_pixels = 1 << 20});
    CAPTURE(round);
    if (image) {
      require_whole(*image);
    } else {
      require_explained(image);
    }
    static_cast<void>(read_png_text(std::as_bytes(std::span(bytes))));
  }
}

TEST_CASE("16384 x 16384 grey pixels come back from a PNG") {
  constexpr int kSide = 16384;
  // Slopes and steps are easy to compress, and rows near each other differ.
  const auto sample_at = [](int x, int y) { return std::uint8_t((x >> 4) + y * 3 + (y >> 8)); };
  std::vector<std::byte> png;
  {
    std::vector<std::uint8_t> samples(std::size_t(kSide) * kSide);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        samples[std::size_t(y) * kSide + std::size_t(x)] = sample_at(x, y);
      }
    }
    png = encode_png(stored(kSide, kSide, 1, std::move(samples))).value();
  }
  const auto image = decode_stored(png);
  REQUIRE(image);
  REQUIRE(image->width == kSide);
  REQUIRE(image->height == kSide);
  REQUIRE(image->channels == 1);
  const auto& samples = std::get<std::vector<std::uint8_t>>(image->samples);
  std::size_t wrong = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      wrong += samples[std::size_t(y) * kSide + std::size_t(x)] != sample_at(x, y) ? 1u : 0u;
    }
  }
  CHECK(wrong == 0);
  CHECK_FALSE(decode_image(png));  // above the default limit for reading RGBA
}
