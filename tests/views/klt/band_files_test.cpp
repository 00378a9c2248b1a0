// Bands in files: what is written is read again, in every order of samples, and what is hostile is refused.
#include <tests/support/catch.h>

#include <fstream>

#include <glassbox/base/random.h>
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
        // Sample (x, y) of band b is 20 b + 5 y + x.
        const auto add = [&](int b, int y, int x) {
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
           {header_with("data type = 6\n"), "6 is none that is read"},
           {header_with("data type = 1\ninterleave = bsx\n"), "'interleave'"},
           {header_with("data type = 1\nband names = {a}\n"), "1, and there are 2 bands"},
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
  CHECK_FALSE(read_bands({directory.file("nothing.png")}, kMegabyte));
  const std::string header = directory.file("huge.hdr");
  write(header, "ENVI\nsamples = 16384\nlines = 16384\nbands = 512\ndata type = 5\n");
  CHECK(refusal(read_bands({header}, kMegabyte)).find("--max-mb") != std::string::npos);
  write(header, "ENVI\nsamples = 2\nlines = 2\nbands = 1\ndata type = 5\n");
  CHECK(refusal(read_bands({header}, kMegabyte)).find("no file with its numbers") !=
        std::string::npos);
  write(directory.file("huge.img"), "short");
  CHECK(refusal(read_bands({header}, kMegabyte)).find("has 5 bytes") != std::string::npos);
}

}  // namespace glassbox::views
