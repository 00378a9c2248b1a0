// PBM, PGM, PPM and PAM: all forms of one picture give the same samples.
#include "tests/support/catch.h"

#include <string>

#include <glassbox/base/random.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_file.h>

#include "tests/images/stored_builder.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::stored;
using U8 = std::vector<std::uint8_t>;
using U16 = std::vector<std::uint16_t>;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}
Result<StoredImage> decode(const std::string& text) {
  return decode_stored(bytes_of(text));
}
std::string cause_of(const std::string& text) {
  const auto image = decode(text);
  REQUIRE_FALSE(image);
  CHECK_FALSE(image.error().remedy.empty());
  return image.error().cause;
}

// What is left after the magic number of a file with these numbers.
std::string size_text(int width, int height, unsigned largest) {
  return " " + std::to_string(width) + " " + std::to_string(height) + " " +
         std::to_string(largest) + "\n";
}

std::string binary_of(const std::vector<unsigned>& samples, unsigned largest) {
  std::string text;
  for (const unsigned sample : samples) {
    if (largest > 255) text += char(sample >> 8);
    text += char(sample);
  }
  return text;
}

// The samples as decimal numbers, with any white space and comments between them.
std::string plain_of(const std::vector<unsigned>& samples, Random& random) {
  static const std::string kGaps[] = {" ", "\n", "\t ", "\r\n", " # 9 9\n", "\n\n  "};
  std::string text;
  for (const unsigned sample : samples) {
    text += kGaps[std::size_t(random.integer(0, 5))] + std::to_string(sample);
  }
  return text;
}

std::string pam_of(int width, int height, int channels, unsigned largest, const std::string& tuple,
                   const std::string& samples) {
  return "P7\n# a comment\nWIDTH " + std::to_string(width) + "\nHEIGHT " + std::to_string(height) +
         "\nDEPTH " + std::to_string(channels) + "\nMAXVAL " + std::to_string(largest) + "\n" +
         (tuple.empty() ? "" : "TUPLTYPE " + tuple + "\n") + "ENDHDR\n" + samples;
}

}  // namespace

TEST_CASE("plain PGM and PPM and PAM are the pictures that their binary forms are") {
  const std::uint64_t seed = 211;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 300; ++round) {
    const int width = int(random.integer(1, 9)), height = int(random.integer(1, 7));
    const int channels = random.integer(0, 1) == 0 ? 1 : 3;
    static constexpr unsigned kLargest[] = {1, 9, 255, 256, 1000, 65535};
    const unsigned largest = kLargest[random.integer(0, 5)];
    std::vector<unsigned> samples(std::size_t(width * height * channels));
    for (unsigned& sample : samples) sample = unsigned(random.integer(0, std::int64_t(largest)));
    CAPTURE(width, height, channels, largest);
    const std::string head = size_text(width, height, largest);
    const std::string pixels = binary_of(samples, largest);
    const std::string binary = (channels == 3 ? "P6" : "P5") + head + pixels;
    const std::string plain = (channels == 3 ? "P3" : "P2") + head + plain_of(samples, random);
    const auto expected = decode(binary);
    REQUIRE(expected);
    REQUIRE(decode(plain).value() == *expected);
    REQUIRE(decode(plain + "\n").value() == *expected);
    const std::string tuple = channels == 3 ? "RGB" : "GRAYSCALE";
    REQUIRE(decode(pam_of(width, height, channels, largest, tuple, pixels)).value() == *expected);
    REQUIRE(decode(pam_of(width, height, channels, largest, "", pixels)).value() == *expected);
    REQUIRE(decode_image(bytes_of(plain)).value() == decode_image(bytes_of(binary)).value());
    // Without its last sample, it is refused.
    const auto last = plain.find_last_of(" \t\n");
    REQUIRE_FALSE(decode(plain.substr(0, last)));
  }
}

TEST_CASE("in a bitmap 1 is black, as text and as bits, and in a black and white PAM 1 is white") {
  const std::uint64_t seed = 223;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    const int width = int(random.integer(1, 20)), height = int(random.integer(1, 4));
    StoredImage image = stored(width, height, 1, U8(std::size_t(width * height)));
    auto& samples = std::get<U8>(image.samples);
    std::string plain, packed, white;
    for (int y = 0; y < height; ++y) {
      std::string row(std::size_t(width + 7) / 8, '\0');
      for (int x = 0; x < width; ++x) {
        const bool black = random.integer(0, 1) == 1;
        samples[std::size_t(y * width + x)] = black ? 0 : 255;
        plain += black ? '1' : '0';  // digits of a bitmap need no space between them
        if (random.integer(0, 3) == 0) plain += x + 1 == width ? "\n" : " ";
        if (black) row[std::size_t(x) / 8] = char(row[std::size_t(x) / 8] | 0x80 >> x % 8);
        white += char(black ? 0 : 1);
      }
      packed += row;
    }
    const std::string size = " " + std::to_string(width) + " " + std::to_string(height) + "\n";
    CAPTURE(width, height, plain);
    REQUIRE(decode("P1" + size + plain).value() == image);
    REQUIRE(decode("P4" + size + packed).value() == image);
    REQUIRE(decode(pam_of(width, height, 1, 1, "BLACKANDWHITE", white)).value() == image);
    REQUIRE_FALSE(decode("P4" + size + packed.substr(1)));
  }
}

TEST_CASE("a PAM may have alpha") {
  CHECK(decode(pam_of(1, 1, 2, 255, "GRAYSCALE_ALPHA", "\x01\x02")).value() ==
        stored(1, 1, 2, U8{1, 2}));
  const std::string rgba = pam_of(1, 1, 4, 65535, "RGB_ALPHA", "\1\2\3\4\5\6\7\x8");
  CHECK(decode(rgba).value() == stored(1, 1, 4, U16{0x102, 0x304, 0x506, 0x708}));
  CHECK(decode_image(bytes_of(rgba))->at(0, 0) == Rgba8{1, 3, 5, 7});
  CHECK(decode_image(bytes_of(pam_of(1, 1, 2, 255, "", "\x01\x02")))->at(0, 0) ==
        Rgba8{1, 1, 1, 2});
}

TEST_CASE("PAM channels with another meaning, and broken lines, are refused") {
  CHECK(cause_of(pam_of(1, 1, 5, 255, "", "abcde")) ==
        "is a PAM of 5 channels, which is neither grey nor RGB, with or without alpha");
  CHECK(cause_of(pam_of(1, 1, 3, 255, "CIELAB", "abc")).find("named 'CIELAB'") !=
        std::string::npos);
  CHECK_FALSE(decode(pam_of(1, 1, 0, 255, "", "a")));
  CHECK_FALSE(decode(pam_of(1, 1, 3, 0, "", "abc")));
  CHECK_FALSE(decode(pam_of(1, 1, 3, 65536, "", "abcdef")));
  CHECK_FALSE(decode("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 255\n"));
  CHECK_FALSE(decode("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 255\nCOLOUR 1\nENDHDR\na"));
  CHECK_FALSE(decode("P7\nWIDTH x\nHEIGHT 1\nDEPTH 1\nMAXVAL 255\nENDHDR\na"));
}

TEST_CASE("a plain sample that is wrong is named") {
  CHECK(cause_of("P3 1 1 255\n1 256 3") == "sample 2 of 3 is 256, above the largest value, 255");
  CHECK(cause_of("P2 2 1 255\n1 0x2") == "sample 2 of 2 is missing or no number");
  CHECK(cause_of("P2 3 1 255\n1 -2 3") == "sample 2 of 3 is no number");
  CHECK(cause_of("P1 3 1\n0 2 1") == "sample 2 of 3 is no number");
  CHECK(cause_of("P3 16384 16384 255\n1 2 3").find("cannot fit") != std::string::npos);
}

TEST_CASE("a line feed too many behind a binary header is named, and nothing else is") {
  const std::string pixels = "abcdefghijklmnopqr";
  for (const char* header : {"P6\r\n3 2\r\n255\r\n", "P6 3 2 255\r\n"}) {
    const std::string file = header + pixels;
    const auto read = decode_stored_file(bytes_of(file));
    REQUIRE(read);
    // The format says one byte: LF is the first sample.
    CHECK(read->image == decode("P6 3 2 255\n\n" + pixels.substr(0, 17)).value());
    REQUIRE(read->notes.size() == 1);
    CHECK(read->notes[0].find("the header ends in CR LF") == 0);
    CHECK(read->rest_name == "1 byte behind it");
    const auto refused = decode_image(bytes_of(file));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().cause == read->notes[0]);
  }
  for (const std::string& file :
       {"P6 3 2 255\r" + pixels, "P6 3 2 255\r\n" + pixels.substr(1), "P6 3 2 255\n" + pixels,
        "P3\r\n1 1\r\n255\r\n1 2 3\r\n"s, "P6 3 2 255\n" + pixels + "\n"}) {
    CAPTURE(file);
    const auto read = decode_stored_file(bytes_of(file));
    REQUIRE(read);
    CHECK(read->notes.empty());
    CHECK(read->rest.empty());
    CHECK(decode_image(bytes_of(file)));
  }
}

TEST_CASE("what stands behind the first picture of a file is kept for the comparison") {
  const auto read = decode_stored_file(bytes_of("P5 1 1 255\naP5 1 1 255\nb"));
  REQUIRE(read);
  CHECK(read->image == stored(1, 1, 1, U8{'a'}));
  CHECK(read->rest.size() == 12);
  CHECK(read->rest_name == "12 bytes behind it");
}
