#include <glassbox/base/random.h>
#include <glassbox/images/png_text.h>

#include "tests/images/png_builder.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;
using test::Bytes;
using Entries = std::vector<TextEntry>;

Result<Entries> read(const Bytes& png) {
  return read_png_text(std::as_bytes(std::span(png)));
}

struct Chunk {
  std::string type, data;
};

Bytes png_with(const std::vector<Chunk>& chunks) {
  Bytes png = test::png_signature();
  for (const auto& [type, data] : chunks) {
    test::put_chunk(png, type, Bytes(data.begin(), data.end()));
  }
  test::put_chunk(png, "IEND", {});
  return png;
}

Entries entries_of(const std::vector<Chunk>& chunks) {
  const auto entries = read(png_with(chunks));
  if (!entries) FAIL(entries.error().message());
  return *entries;
}

}  // namespace

TEST_CASE("the text that encode_png writes is read back") {
  const Image<Rgba8> image(3, 2, {1, 2, 3, 4});
  const Entries text{{"Command", "glassbox render\nduck.glb"},
                     {"Title", "Teekanne f\xc3\xbcr zwei \xe2\x82\xac"},
                     {"Empty", ""},
                     {"Tabs and returns", "a\tb\rc\r\nd"}};
  CHECK(read_png_text(encode_png(image, text).value()).value() == text);
  CHECK(read_png_text(encode_png(as_stored(image), text).value()).value() == text);
  CHECK(read_png_text(encode_png(image).value()).value().empty());
}

TEST_CASE("tEXt is Latin-1, iTXt UTF-8 with a language, both in the file's order") {
  CHECK(entries_of({{"iTXt", "Title\0\0\0de\0Titel\0T\xc3\xa4"s},
                    {"IDAT", "not looked into"},
                    {"tEXt", "K\xe9y\0caf\xe9 \xff\x80"s}}) ==
        Entries{{"Title", "T\xc3\xa4"}, {"K\xc3\xa9y", "caf\xc3\xa9 \xc3\xbf\xc2\x80"}});
}

TEST_CASE("text that is compressed or not as the format says is left out, the rest is kept") {
  const Entries kept{{"Key", "text"}};
  const Chunk good{"tEXt", "Key\0text"s};
  for (const Chunk& bad :
       std::initializer_list<Chunk>{{"zTXt", "Key\0\0compressed"s},
                                    {"iTXt", "Key\0\1\0\0\0compressed"s},
                                    {"iTXt", "Key\0\0\0\0\0\xc3"s},  // ends within a character
                                    // an overlong encoding of zero
                                    {"iTXt", "Key\0\0\0\0\0\xc0\x80"s},
                                    {"iTXt", "Key\0\0\0\0\0\xed\xa0\x80"s},  // a surrogate
                                    {"iTXt", "Key\0\0\0\0\0a\0b"s},
                                    {"iTXt", "Key\0\0\0\0no text"s},
                                    {"iTXt", "Key\0\0"s},
                                    {"iTXt", "Key"s},
                                    {"iTXt", ""s},
                                    {"tEXt", "no text"s},
                                    {"tEXt", "\0no keyword"s},
                                    {"tEXt", "Key\0a\0b"s},
                                    {"tEXt", std::string(80, 'k') + "\0text"s},
                                    {"tEXt", ""s}}) {
    CAPTURE(bad.type, bad.data);
    CHECK(entries_of({bad, good}) == kept);
    CHECK(entries_of({good, bad}) == kept);
  }
}

TEST_CASE("texts of 64 KiB and 64 of them are read, longer and more are left out") {
  const std::string longest(kMaxTextBytes, 'x');
  CHECK(entries_of({{"tEXt", "A\0"s + longest}, {"tEXt", "B\0"s + longest + 'x'}}) ==
        Entries{{"A", longest}});
  CHECK(entries_of({{"iTXt", "A\0\0\0\0\0"s + longest}, {"iTXt", "B\0\0\0\0\0x"s + longest}}) ==
        Entries{{"A", longest}});
  std::vector<Chunk> chunks;
  for (int i = 0; i < 70; ++i) chunks.push_back({"tEXt", "K\0"s + std::to_string(i)});
  const Entries entries = entries_of(chunks);
  CHECK(entries.size() == 64);
  CHECK(entries.back().second == "63");
}

TEST_CASE("what is no PNG has no text") {
  CHECK(read({}).value().empty());
  CHECK(read({0x89, 'P', 'N', 'G'}).value().empty());
  CHECK(read({'P', '6', ' ', '1', ' ', '1', ' ', '2', '5', '5', ' '}).value().empty());
}

TEST_CASE("a text with the wrong check sum is an error, whichever bit is wrong") {
  const Bytes whole = png_with({{"tEXt", "Key\0text"s}});
  const std::size_t text_at = test::png_signature().size() + 4;  // after the length
  const std::size_t text_end = text_at + 4 + 8 + 4;              // type, data, checksum
  for (std::size_t bit = text_at * 8; bit < text_end * 8; ++bit) {
    Bytes flipped = whole;
    flipped[bit / 8] = std::uint8_t(flipped[bit / 8] ^ 1 << bit % 8);
    CAPTURE(bit);
    const auto entries = read(flipped);
    // With a flipped bit in its type the chunk is an unknown one, and skipped.
    if (bit / 8 < text_at + 4) {
      CHECK((entries && entries->empty()));
    } else {
      REQUIRE_FALSE(entries);
      CHECK(entries.error().message() ==
            "PNG text: the checksum of a text is wrong; save the image again");
    }
  }
}

TEST_CASE("a PNG cut off anywhere is an error") {
  const Bytes whole = png_with({{"tEXt", "Key\0text"s}, {"IDAT", "data"}});
  for (std::size_t size = test::png_signature().size(); size < whole.size(); ++size) {
    CAPTURE(size, whole.size());
    const auto entries = read(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
    REQUIRE_FALSE(entries);
    CHECK_FALSE(entries.error().cause.empty());
    CHECK_FALSE(entries.error().remedy.empty());
  }
  Bytes huge = test::png_signature();
  test::put32(huge, 0xffffffffu);
  for (const char c : {'t', 'E', 'X', 't'}) huge.push_back(std::uint8_t(c));
  huge.resize(huge.size() + 8);
  CHECK(read(huge).error().cause == "a chunk of 4294967295 bytes runs past the end of the file");
}

TEST_CASE("random chunks give text or an error, never worse") {
  const std::uint64_t seed = 23;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 3000; ++round) {
    Bytes png = test::png_signature();
    for (std::int64_t chunk = random.integer(0, 4); chunk > 0; --chunk) {
      const char* const types[] = {"tEXt", "iTXt", "zTXt", "IDAT"};
      Bytes data(std::size_t(random.integer(0, 12)));
      // With few different bytes, separators occur in every place.
      for (auto& byte : data) byte = std::uint8_t("\0\0\0\1ab\xc3\xa4"[random.integer(0, 7)]);
      test::put_chunk(png, types[random.integer(0, 3)], data);
    }
    test::put_chunk(png, "IEND", {});
    const auto entries = read(png);
    REQUIRE(entries);
    for (const auto& [keyword, text] : *entries) {
      REQUIRE_FALSE(keyword.empty());
      REQUIRE(text.find('\0') == std::string::npos);
    }
    if (png.size() > 20) {
      png[std::size_t(random.integer(8, 11))] ^= std::uint8_t(1 << random.integer(0, 7));
      static_cast<void>(read(png));  // the first length is wrong
    }
  }
}
