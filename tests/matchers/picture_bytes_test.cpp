// Tests the files of golden images: the library reads them back, and whatever is not the same
// picture is not taken for it.
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "tests/compare/pictures.h"
#include "tests/images/png_builder.h"
#include "tests/support/catch.h"

#include <glassbox/compare/testing/picture_bytes.h>
#include <glassbox/images/stored_image.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

std::span<const std::byte> as_bytes_of(const Bytes& file) {
  return std::as_bytes(std::span(file));
}

Bytes bytes_of(const std::vector<std::byte>& file) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(file.data());
  return {first, first + file.size()};
}

std::string extension_of(Format format) {
  return format == Format::kFloats ? ".pfm" : ".png";
}

// Pictures of every format and number of channels that can be stored, and of many sizes. Flat
// pictures have runs that compress; noise has none.
std::vector<StoredImage> random_pictures() {
  std::vector<StoredImage> pictures;
  Random random(44);
  for (int round = 0; round < 8; ++round) {
    for (const Format format : kFormats) {
      for (int channels = 1; channels <= 4; ++channels) {
        if (format == Format::kFloats && channels % 2 == 0) continue;
        const int width = int(random.integer(1, 40)), height = int(random.integer(1, 40));
        pictures.push_back(round % 2 == 0 ? random_picture(random, width, height, channels, format)
                                          : blank(width, height, channels, format));
      }
    }
  }
  return pictures;
}

Format format_of(const StoredImage& image) {
  return kFormats[image.samples.index()];
}

bool is_stored_in(const Bytes& file, const StoredImage& image) {
  return golden::is_stored_in(
      file, golden::content_of(picture_view(image), extension_of(format_of(image))));
}

Bytes encoded(const StoredImage& image) {
  const PictureView view = picture_view(image);
  REQUIRE(golden::why_not_stored(view, extension_of(format_of(image))).empty());
  return golden::encode(golden::content_of(view, extension_of(format_of(image))));
}

// The chunks of a PNG file, each with its length, type, data and checksum.
std::vector<Bytes> chunks_of(const Bytes& file) {
  std::vector<Bytes> chunks;
  for (auto at = file.begin() + 8; at != file.end(); at += std::ptrdiff_t(chunks.back().size())) {
    const std::ptrdiff_t size = at[0] << 24 | at[1] << 16 | at[2] << 8 | at[3];
    chunks.emplace_back(at, at + 12 + size);
  }
  return chunks;
}

// Distributes the data of a chunk to two chunks, the second of them anywhere behind the first.
void split(std::vector<Bytes>& chunks, std::vector<Bytes>::iterator chunk, Random& random) {
  const std::string type(chunk->begin() + 4, chunk->begin() + 8);
  const Bytes data(chunk->begin() + 8, chunk->end() - 4);
  const auto middle = data.begin() + random.integer(0, std::int64_t(data.size()));
  chunk->clear();
  put_chunk(*chunk, type, {data.begin(), middle});
  Bytes second;
  put_chunk(second, type, {middle, data.end()});
  chunks.insert(chunk + random.integer(1, chunks.end() - chunk), second);
}

Bytes file_of_chunks(const Bytes& signature_of, const std::vector<Bytes>& chunks) {
  Bytes file(signature_of.begin(), signature_of.begin() + 8);
  for (const Bytes& chunk : chunks) file.insert(file.end(), chunk.begin(), chunk.end());
  return file;
}

// The picture with one of its samples changed by the least amount.
StoredImage with_a_defect(StoredImage image, Random& random) {
  std::visit(
      [&](auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        auto& sample = samples[std::size_t(random.integer(0, std::int64_t(samples.size()) - 1))];
        Bytes bytes(sizeof(Sample));
        std::memcpy(bytes.data(), &sample, sizeof(Sample));
        bytes.front() ^= 1;
        std::memcpy(&sample, bytes.data(), sizeof(Sample));
      },
      image.samples);
  return image;
}

}  // namespace

TEST_CASE("the library reads the matchers' files back, sample for sample") {
  for (const StoredImage& image : random_pictures()) {
    INFO(image.width << " x " << image.height << ", " << channel_names(image) << ", "
                     << format_name(image));
    const auto back = decode_stored(as_bytes_of(encoded(image)));
    REQUIRE(back);
    CHECK(*back == image);
  }
}

TEST_CASE("a picture is found in its own file and in the library's, and no other is") {
  Random random(45);
  for (const StoredImage& image : random_pictures()) {
    INFO(image.width << " x " << image.height << ", " << channel_names(image) << ", "
                     << format_name(image));
    const Bytes file = encoded(image);
    CHECK(is_stored_in(file, image));
    const std::vector<TextEntry> text{{"Software", "some program"}};
    const auto other =
        format_of(image) == Format::kFloats ? encode_pfm(image) : encode_png(image, text);
    REQUIRE(other);
    CHECK(is_stored_in(bytes_of(*other), image));
    CHECK_FALSE(is_stored_in(file, with_a_defect(image, random)));
    StoredImage turned = image;
    std::swap(turned.width, turned.height);
    CHECK(is_stored_in(file, turned) == (image.width == image.height));
  }
}

TEST_CASE("rows may lie apart, and from the bottom to the top") {
  Random random(46);
  for (const StoredImage& image : random_pictures()) {
    const std::ptrdiff_t row = image.width * image.channels, step = row + random.integer(0, 9);
    std::visit(
        [&](const auto& samples) {
          using Samples = std::decay_t<decltype(samples)>;
          Samples down(std::size_t(step * image.height)), up(down.size());
          for (int y = 0; y < image.height; ++y) {
            const auto from = samples.begin() + y * row;
            std::copy(from, from + row, down.begin() + y * step);
            std::copy(from, from + row, up.begin() + (image.height - 1 - y) * step);
          }
          const std::string extension = extension_of(format_of(image));
          const auto* top_row = up.data() + (image.height - 1) * step;
          const auto encoded_view = [&](const auto* first, std::ptrdiff_t row_step) {
            return golden::encode(golden::content_of(
                {image.width, image.height, image.channels, first, row_step}, extension));
          };
          CHECK(encoded_view(down.data(), step) == encoded(image));
          CHECK(encoded_view(top_row, -step) == encoded(image));
        },
        image.samples);
  }
}

TEST_CASE("an alpha that is opaque everywhere is not stored, as in the library's files") {
  Image<Rgba8> image(5, 4, {1, 2, 3, 255});
  const auto of_library = [&] { return *decode_stored(*encode_png(image)); };
  const auto of_matchers = [&] {
    const golden::Content content = golden::content_of(picture_view(image), ".png");
    return *decode_stored(as_bytes_of(golden::encode(content)));
  };
  CHECK(of_matchers().channels == 3);
  CHECK(of_matchers() == of_library());
  image.at(2, 3).a = 254;
  CHECK(of_matchers().channels == 4);
  CHECK(of_matchers() == of_library());
}

TEST_CASE("a broken file is no picture's, and no byte beyond its end is read") {
  Random random(47);
  const StoredImage image = random_picture(random, 9, 7, 3, Format::kBytes);
  const Bytes file = encoded(image);
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Bytes part(file.begin(), file.begin() + std::ptrdiff_t(size));
    CHECK_FALSE(is_stored_in(part, image));
  }
  // Every byte of the file is the signature's, or a checksum covers it.
  for (int round = 0; round < 2000; ++round) {
    Bytes broken = file;
    const auto at = std::size_t(random.integer(0, std::int64_t(file.size()) - 1));
    broken[at] ^= std::uint8_t(random.integer(1, 255));
    CHECK_FALSE(is_stored_in(broken, image));
  }
}

TEST_CASE("a file whose chunks are in another order is found only if the library reads it") {
  Random random(49);
  for (int round = 0; round < 3000; ++round) {
    const StoredImage image = random_picture(random, 9, 7, 3, Format::kBytes);
    const std::vector<TextEntry> text{{"Software", "some program"}};
    const Bytes file = bytes_of(*encode_png(image, text));
    std::vector<Bytes> chunks = chunks_of(file);
    for (std::int64_t edits = random.integer(1, 5); edits > 0 && !chunks.empty(); --edits) {
      const std::int64_t last = std::int64_t(chunks.size()) - 1;
      const auto from = chunks.begin() + random.integer(0, last);
      const auto to = chunks.begin() + random.integer(0, last);
      switch (random.integer(0, 3)) {
        case 0:
          std::swap(*from, *to);
          break;
        case 1:
          chunks.insert(to, Bytes(*from));
          break;
        case 2:
          chunks.erase(from);
          break;
        default:
          split(chunks, from, random);
      }
    }
    const Bytes edited = file_of_chunks(file, chunks);
    if (!is_stored_in(edited, image)) continue;
    std::string order;
    for (const Bytes& chunk : chunks) {
      order += std::string(chunk.begin() + 4, chunk.begin() + 8) + " ";
    }
    INFO(order);
    const auto back = decode_stored(as_bytes_of(edited));
    REQUIRE(back);
    CHECK(*back == image);
  }
}

TEST_CASE("a file that states a smaller window is found only if the library reads it") {
  Random random(50);
  int found = 0, refused = 0;
  for (int round = 0; round < 200; ++round) {
    // The rows repeat each other, up to all of the picture further on.
    const int width = int(random.integer(1, 300)), height = int(random.integer(1, 60));
    const StoredImage tile = random_picture(random, width, 3, 3, Format::kBytes);
    StoredImage image = blank(width, height, 3, Format::kBytes);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (int c = 0; c < 3; ++c) set_sample(image, x, y, c, sample_at(tile, x, y % 3, c));
      }
    }
    const Bytes file = encoded(image);
    std::vector<Bytes> chunks = chunks_of(file);
    // zlib's two bytes are a multiple of 31, the first as a number of 256s.
    Bytes data(chunks[1].begin() + 8, chunks[1].end() - 4);
    data[0] = std::uint8_t(random.integer(0, 7) << 4 | 8);
    data[1] = std::uint8_t(31 - (data[0] << 8) % 31);
    chunks[1].clear();
    put_chunk(chunks[1], "IDAT", data);
    const Bytes edited = file_of_chunks(file, chunks);
    const auto back = decode_stored(as_bytes_of(edited));
    refused += back ? 0 : 1;
    INFO("seed 50, round " << round << ", " << width << " x " << height);
    if (!is_stored_in(edited, image)) continue;
    ++found;
    REQUIRE(back);
    CHECK(*back == image);
  }
  CHECK(found > 20);
  CHECK(refused > 20);
}

TEST_CASE("what cannot be stored is refused with a reason and a remedy") {
  const std::uint8_t bytes[16] = {};
  const float floats[16] = {};
  const auto refused = [](const PictureView& view, const std::string& extension) {
    return golden::why_not_stored(view, extension);
  };
  const std::uint8_t* none = nullptr;
  CHECK(refused({2, 2, 4, bytes}, ".png").empty());
  CHECK(refused({2, 2, 3, floats}, ".pfm").empty());
  CHECK(refused({2, 2, 4, bytes}, ".jpg").find("end its name in") != std::string::npos);
  CHECK(refused({0, 2, 4, bytes}, ".png").find("0 x 2") != std::string::npos);
  // As large as what glassbox diff compares.
  const int most = int(kCompareLimits.max_side);
  REQUIRE(std::uint64_t(most) * std::uint64_t(most) <= kCompareLimits.max_pixels);
  CHECK(refused({most, 1, 1, bytes}, ".png").empty());
  CHECK(refused({1, most, 1, bytes}, ".png").empty());
  CHECK(refused({most, most, 1, bytes}, ".png").empty());
  for (const int larger : {most + 1, 1 << 28}) {
    CHECK(refused({larger, 1, 1, bytes}, ".png").find("sides of 1 to 16384") != std::string::npos);
    CHECK(refused({1, larger, 1, bytes}, ".png").find("sides of 1 to 16384") != std::string::npos);
  }
  CHECK(refused({2, 2, 5, bytes}, ".png").find("5 channels") != std::string::npos);
  CHECK(refused({2, 2, 4, none}, ".png").find("too few samples") != std::string::npos);
  CHECK(refused({2, 2, 4, bytes, 2}, ".png").find("not in pixels") != std::string::npos);
  CHECK(refused({2, 2, 4, bytes, -2}, ".png").find("not in pixels") != std::string::npos);
  CHECK(refused({2, 2, 4, bytes}, ".pfm").find(".png") != std::string::npos);
  CHECK(refused({2, 2, 3, floats}, ".png").find(".pfm") != std::string::npos);
  CHECK(refused({2, 2, 4, floats}, ".pfm").find("alpha") != std::string::npos);
}

}  // namespace glassbox::test
