// Bands in files: written bands are read again in every order of samples, and invalid files are
// refused.
#include <tests/support/catch.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <glassbox/base/random.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

#include "tests/images/temporary_directory.h"
#include "views/klt/band_files.h"
#include "views/klt/cube_header.h"

namespace glassbox::views {
namespace {

using glassbox::test::TemporaryDirectory;

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

constexpr std::uint64_t kMegabyte = 1 << 20;

std::string header_with(const std::string& more) {
  return "ENVI\nsamples = 3\nlines=2\n Bands = 2\n" + more;
}

std::string refusal(const auto& result) {
  REQUIRE_FALSE(result);
  return result.error().message();
}

}  // namespace

TEST_CASE("a cube that is written is read again, bit by bit") {
  const TemporaryDirectory directory;
  const Bands bands{2, 2, {{"a", {1, -2.5, 1e300, 5e-324}}, {"b, {c}", {0, 1, 2, 3}}}};
  const std::string path = directory.file("cube");
  REQUIRE(write_cube(path, bands));
  const auto again = read_bands({path + ".hdr"}, kMegabyte);
  REQUIRE(again);
  REQUIRE(again->count() == 2);
  CHECK(again->bands[0].samples == bands.bands[0].samples);
  CHECK(again->bands[1].samples == bands.bands[1].samples);
  CHECK(again->bands[1].name == "b   c");
}

TEST_CASE("cubes of every type, byte order and order of samples are read") {
  const std::string offset = "header offset = 5\n";
  const struct {
    const char* type;
    std::vector<std::byte> (*bytes)(int value, bool big);
    int sign;
  } types[] = {
      {"1", [](int v, bool) { return std::vector{std::byte(v)}; }, 1},
      {"2",
       [](int v, bool big) {
         const std::byte low = std::byte(-v & 255), high = std::byte(-v >> 8 & 255);
         return big ? std::vector{high, low} : std::vector{low, high};
       },
       -1},
      {"12",
       [](int v, bool big) {
         return big ? std::vector{std::byte(0), std::byte(v)}
                    : std::vector{std::byte(v), std::byte(0)};
       },
       1},
  };
  for (const auto& [type, bytes_of, sign] : types) {
    for (const bool big : {false, true}) {
      for (const std::string interleave : {"bsq", "bil", "BIP"}) {
        INFO("type " << type << ", " << interleave << ", big " << big);
        std::vector<std::byte> bytes(5);
        // Sample (x, y) of band b has the value 20 b + 5 y + x.
        const auto add = [&, &bytes_of = bytes_of](int b, int y, int x) {
          for (const std::byte byte : bytes_of(20 * b + 5 * y + x, big)) bytes.push_back(byte);
        };
        for (int i = 0; i < 12; ++i) {
          if (interleave == "bsq") add(i / 6, i / 3 % 2, i % 3);
          if (interleave == "bil") add(i / 3 % 2, i / 6, i % 3);
          if (interleave == "BIP") add(i % 2, i / 6, i / 2 % 3);
        }
        const auto header = parse_cube_header(
            header_with(offset + "data type = " + type + "\ninterleave = " + interleave +
                        "\nbyte order = " + (big ? "1" : "0") + "\n"));
        REQUIRE(header);
        REQUIRE(header->bytes() == bytes.size());
        const auto bands = decode_cube(*header, bytes);
        REQUIRE(bands);
        for (int b = 0; b < 2; ++b) {
          for (int i = 0; i < 6; ++i)
            CHECK(bands->bands[std::size_t(b)].samples[std::size_t(i)] ==
                  sign * (20 * b + 5 * (i / 3) + i % 3));
        }
        bytes.pop_back();
        CHECK_FALSE(decode_cube(*header, bytes));
      }
    }
  }
}

TEST_CASE("numbers of every type are what their bytes say, in both orders") {
  const auto sample = [](int type, std::vector<int> little) {
    const auto read = [&](bool big) {
      std::vector<std::byte> bytes;
      for (const int byte : little) bytes.push_back(std::byte(byte));
      if (big) std::ranges::reverse(bytes);
      const auto header = parse_cube_header(
          "ENVI\nsamples = 1\nlines = 1\nbands = 1\ndata type = " + std::to_string(type) +
          "\nbyte order = " + (big ? "1\n" : "0\n"));
      REQUIRE(header);
      REQUIRE(header->bytes() == bytes.size());
      return decode_cube(*header, bytes)->bands[0].samples[0];
    };
    CHECK(read(false) == read(true));
    return read(false);
  };
  CHECK(sample(1, {200}) == 200);
  CHECK(sample(2, {0xfe, 0xff}) == -2);
  CHECK(sample(3, {0xfd, 0xff, 0xff, 0xff}) == -3);
  CHECK(sample(4, {0, 0, 0x20, 0xc0}) == -2.5);
  CHECK(sample(5, {0, 0, 0, 0, 0, 0, 0x04, 0x40}) == 2.5);
  CHECK(sample(12, {0xfe, 0xff}) == 65534);
  CHECK(sample(13, {0xfd, 0xff, 0xff, 0xff}) == 4294967293.0);
}

TEST_CASE("names over several lines, comments and other fields of a header are read over") {
  const auto header =
      parse_cube_header(header_with("; a comment\ndata type = 4\ndescription = {\n more = lines "
                                    "}\nband names = {red,\n near infrared}\n\n"));
  REQUIRE(header);
  CHECK(header->names == std::vector<std::string>{"red", "near infrared"});
}

TEST_CASE("headers that are none are refused, with the place") {
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"", "ENVI"},
           {"ENVI", "'samples': is missing"},
           {"ENVI\nsamples = 3\nlines = 2\nbands = 1\n", "'data type': is missing"},
           {"ENVI\nsamples = 99999999999999999999\n", "whole number"},
           {"ENVI\nsamples = -3\n", "whole number"},
           {"ENVI\nsamples = 0\n", "whole number"},
           {"ENVI\nsamples = 3x\n", "whole number"},
           {"ENVI\nnonsense\n", "line 2"},
           {header_with("data type = 6\n"), "6 is not supported"},
           {header_with("data type = 1\ninterleave = bsx\n"), "'interleave'"},
           {header_with("data type = 1\nband names = {a}\n"), "has 1 names, but there are 2 bands"},
           {header_with("data type = 1\nband names = {a, b\n"), "line 6"},
           {header_with("data type = 1\nbyte order = 2\n"), "'byte order'"}}) {
    INFO(text);
    const std::string message = refusal(parse_cube_header(text));
    CHECK(message.find(says) != std::string::npos);
  }
}

TEST_CASE("headers of random bytes and random changes never do more than be refused") {
  Random random(7);
  const std::string good =
      header_with("data type = 2\nheader offset = 4\ninterleave = bil\nband names = {a, b}\n");
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    for (int change = 0; change < int(random.integer(1, 6)); ++change) {
      const auto at = std::size_t(random.integer(0, std::int64_t(text.size()) - 1));
      if (random.integer(0, 1) == 0)
        text[at] = char(random.integer(0, 255));
      else
        text.erase(at, std::size_t(random.integer(1, 9)));
      if (text.empty()) text = "E";
    }
    const auto header = parse_cube_header(text);
    if (!header) continue;
    ++read;
    const std::vector<std::byte> bytes(64);
    const auto bands = decode_cube(*header, bytes);
    if (bands) CHECK(header->bytes() <= bytes.size());
  }
  CHECK(read > 100);
}

TEST_CASE("pictures give a band for each colour, at their own depth, and only of one size") {
  const TemporaryDirectory directory;
  const std::string grey = directory.file("grey.pgm"), color = directory.file("colour.png"),
                    other = directory.file("other.pgm");
  write(grey, std::string("P5\n2 1\n65535\n") + std::string("\x01\x02\xff\xff", 4));
  write(other, "P5\n1 1\n255\nx");
  REQUIRE(write_image(color, Image<Rgba8>(2, 1, {10, 20, 30, 255})));
  const auto bands = read_bands({grey, color}, kMegabyte);
  REQUIRE(bands);
  REQUIRE(bands->count() == 4);
  CHECK(bands->bands[0].samples == std::vector<double>{258, 65535});
  CHECK(bands->bands[3].name == "colour blue");
  CHECK(bands->bands[3].samples == std::vector<double>{30, 30});
  CHECK(refusal(read_bands({grey, other}, kMegabyte)).find("is 1 x 1") != std::string::npos);
  CHECK(refusal(read_bands({grey, color}, 40)).find("--max-mb") != std::string::npos);
}

TEST_CASE("a band for each channel that is no alpha") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.png");
  REQUIRE(write_image(path, Image<Rgba8>(2, 1, {10, 20, 30, 40})));
  const auto color = read_bands({path}, kMegabyte);
  REQUIRE(color);
  REQUIRE(color->count() == 3);
  CHECK(color->bands[0].samples == std::vector<double>{10, 10});
  CHECK(color->bands[1].name == "a green");
  const StoredImage grey{2, 1, 2, std::vector<std::uint8_t>{7, 255, 9, 0}};
  REQUIRE(encode_png(grey).and_then([&](const auto& png) { return write_file(path, png); }));
  const auto bands = read_bands({path}, kMegabyte);
  REQUIRE(bands);
  REQUIRE(bands->count() == 1);
  CHECK(bands->bands[0].samples == std::vector<double>{7, 9});
}

TEST_CASE("what files would take is asked of their headers, before anything is decoded") {
  const TemporaryDirectory directory;
  const std::string whole = directory.file("whole.png"), broken = directory.file("broken.png"),
                    other = directory.file("other.pgm");
  REQUIRE(write_image(whole, Image<Rgba8>(64, 48, {10, 20, 30, 255})));
  // The check sums of its pixels are wrong, which only decoding reveals.
  auto bytes = *read_file(whole);
  const std::size_t pixels =
      std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find("IDAT");
  REQUIRE(pixels != std::string_view::npos);
  for (std::size_t i = pixels + 8; i < pixels + 24; ++i) bytes[i] ^= std::byte{0x55};
  REQUIRE(write_file(broken, bytes));
  write(other, "P5\n1 1\n255\nx");
  const auto opened = open_bands({broken}, kMegabyte);
  REQUIRE(opened);
  CHECK(opened->width == 64);
  CHECK(opened->height == 48);
  CHECK(opened->count == 3);
  CHECK(refusal(decode_bands(*opened)).find("broken.png: not a valid PNG") != std::string::npos);
  // 64 x 48 x 3 doubles are 73728 bytes; both files need twice that.
  const std::uint64_t one = 73728;
  CHECK(open_bands({broken}, one));
  CHECK(refusal(open_bands({broken}, one - 1))
            .find("the bands would need 0.0703 MB of memory, more than is allowed; allow more "
                  "memory with --max-mb 1") != std::string::npos);
  CHECK(open_bands({broken, whole}, 2 * one));
  CHECK(refusal(open_bands({broken, whole}, 2 * one - 1)).find("--max-mb") != std::string::npos);
  CHECK(refusal(open_bands({broken, other}, kMegabyte)).find("is 1 x 1") != std::string::npos);
  CHECK(refusal(open_bands({other}, 0)).find("7.63e-06 MB") != std::string::npos);
}

TEST_CASE("files that are none, cut off or of absurd sizes are refused with their name") {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string& name, const std::string& bytes, const char* says) {
    const std::string path = directory.file(name);
    write(path, bytes);
    const std::string message = refusal(read_bands({path}, std::uint64_t(1) << 40));
    INFO(name << ": " << message);
    CHECK(message.find(name) != std::string::npos);
    CHECK(message.find(says) != std::string::npos);
  };
  REQUIRE(write_image(directory.file("a.png"), Image<Rgba8>(9, 9, {10, 20, 30, 255})));
  const auto png = *read_file(directory.file("a.png"));
  const std::string text(reinterpret_cast<const char*>(png.data()), png.size());
  refused("empty.png", "", "empty");
  refused("text.png", "these are no pixels", "not a PNG");
  refused("short.png", text.substr(0, 20), "cut off");
  refused("half.png", text.substr(0, text.size() - 20), "cut off");
  std::string huge = text;
  huge[16] = huge[20] = char(0x7f);  // the high bytes of its width and height
  refused("huge.png", huge, "PNG");
  refused("short.pgm", "P5\n4 4\n255\nabc", "cannot fit");
  refused("huge.pgm", "P5\n4000000000 4000000000\n255\nabc", "at most 16384");
  refused("none.pgm", "P5\n0 4\n255\n", "at least one pixel");
  refused("negative.pgm", "P5\n-4 4\n255\n", "not a valid");
  CHECK(refusal(read_bands({directory.file("nothing.png")}, kMegabyte)).find("nothing.png") !=
        std::string::npos);
  CHECK(refusal(read_bands({directory.file("")}, kMegabyte)).find("is a directory") !=
        std::string::npos);

  const std::string header = directory.file("cube.hdr"), numbers = directory.file("cube.img");
  write(header, "ENVI\nsamples = 2\nlines = 2\nbands = 1\ndata type = 5\n");
  CHECK(
      refusal(read_bands({header}, kMegabyte)).find("the file with its samples is not beside it") !=
      std::string::npos);
  write(numbers, "short");
  CHECK(refusal(read_bands({header}, kMegabyte)).find("has 5 bytes") != std::string::npos);
  write(numbers, std::string(32, '\0'));
  CHECK(read_bands({header}, 32));
  CHECK(refusal(read_bands({header}, 31)).find("--max-mb 1") != std::string::npos);
  // A little may follow the numbers, but not a whole disk.
  std::filesystem::resize_file(numbers, 32 + kMaxTrailingBytes);
  CHECK(read_bands({header}, 32));
  std::filesystem::resize_file(numbers, std::uintmax_t(1) << 40);
  CHECK(refusal(read_bands({header}, 32)).find("has 1099511627776 bytes") != std::string::npos);
  // 512 bands are allowed altogether.
  write(header, "ENVI\nsamples = 1\nlines = 1\nbands = 300\ndata type = 1\n");
  write(numbers, std::string(300, 'x'));
  CHECK(read_bands({header}, kMegabyte));
  CHECK(refusal(read_bands({header, header}, kMegabyte)).find("more than 512 bands") !=
        std::string::npos);
}

}  // namespace glassbox::views
