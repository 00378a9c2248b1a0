// Tests which pixels count as moved edges: on text and shapes that moved by parts of a pixel.
#include "tests/support/catch.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/compare/moved_edges.h"
#include "tests/compare/pictures.h"

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

// How the pixels of a pair were judged.
struct Judged {
  std::uint64_t moved = 0, moved_left = 0;  // differing pixels that did not change, and those left
  std::uint64_t plain = 0, plain_found = 0;
  std::uint64_t edges = 0, edges_found = 0;
};

void judge(const MovedPair& made, Judged& judged) {
  const Selection all(made.reference.width, made.reference.height);
  const PicturePair pair{made.reference, made.test, all, false, {{}, true}};
  for (DifferenceRows rows(pair); rows.next();) {
    for (int x = 0; x < made.reference.width; ++x) {
      const PixelKind kind = rows.kinds()[std::size_t(x)];
      if (kind == PixelKind::kSame || made.has_changed(x, rows.y())) continue;
      ++judged.moved;
      judged.moved_left += kind == PixelKind::kDifferent ? 1u : 0u;
    }
    for (const ChangedPixel& one : made.changed) {
      if (one.at.y != rows.y()) continue;
      const bool found = rows.kinds()[std::size_t(one.at.x)] == PixelKind::kDifferent;
      const bool plain = one.kind == ChangeKind::kOnPlain;
      ++(plain ? judged.plain : judged.edges);
      (plain ? judged.plain_found : judged.edges_found) += found ? 1u : 0u;
    }
  }
}

TEST_CASE("edges that move by up to half a pixel are set aside, and changed pixels are not") {
  Judged judged;
  for (const std::string& look : moved_edge_looks()) {
    for (const double shift : {0.1, 0.3, 0.5}) {
      judge(moved_pair(look, shift, 24, 3, 160, 100), judged);
    }
  }
  INFO(judged.moved_left << " of " << judged.moved << " moved edges left, " << judged.edges_found
                         << " of " << judged.edges << " changed pixels at edges found");
  CHECK(judged.moved > 10000);
  CHECK(judged.moved_left * 1000 < judged.moved);
  CHECK(judged.plain > 100);
  CHECK(judged.plain_found == judged.plain);
  CHECK(judged.edges > 100);
  CHECK(judged.edges_found * 100 > judged.edges * 80);
}

TEST_CASE("where nothing moved, every pixel that changed counts") {
  Judged judged;
  for (const std::string& look : moved_edge_looks()) {
    judge(moved_pair(look, 0, 60, 5, 160, 100), judged);
  }
  CHECK(judged.moved == 0);
  CHECK(judged.plain_found == judged.plain);
  CHECK(judged.edges > 100);
  CHECK(judged.edges_found * 100 >= judged.edges * 97);
}

TEST_CASE("a figure that is gone, or moved by two pixels, counts") {
  const MovedPair pair = moved_pair("large-light-text", 0, 0, 9, 160, 100);
  const Selection all(160, 100);
  const auto share_left = [&](const StoredImage& test) {
    const PicturePair changed{pair.reference, test, all, false, {{}, true}};
    const Differences found = find_differences(changed);
    return double(found.differing) / double(found.differing + found.moved_edges.pixels);
  };
  StoredImage empty = pair.reference;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 80; ++x) {
      for (int c = 0; c < 3; ++c) set_sample(empty, x, y, c, sample_at(pair.reference, 0, 0, c));
    }
  }
  CHECK(share_left(empty) > 0.9);
  StoredImage moved = pair.reference;
  for (int y = 0; y < 100; ++y) {
    for (int x = 2; x < 160; ++x) {
      for (int c = 0; c < 3; ++c)
        set_sample(moved, x, y, c, sample_at(pair.reference, x - 2, y, c));
    }
  }
  CHECK(share_left(moved) > 0.3);
}

// The differing pixels of a pair that are moved edges, as a text of one character each.
std::string kinds_of(const StoredImage& reference, const StoredImage& test,
                     const Selection& selection) {
  const PicturePair pair{reference, test, selection, false, {{}, true}};
  std::string text;
  for (DifferenceRows rows(pair); rows.next();) {
    for (const PixelKind kind : rows.kinds()) text += "=!e-"[int(kind)];
  }
  return text;
}

std::string kinds_of(const StoredImage& reference, const StoredImage& test) {
  return kinds_of(reference, test, Selection(reference.width, reference.height));
}

StoredImage as_format(const StoredImage& bytes, Format format, double scale) {
  StoredImage image = blank(bytes.width, bytes.height, bytes.channels, format);
  for (int y = 0; y < bytes.height; ++y) {
    for (int x = 0; x < bytes.width; ++x) {
      for (int c = 0; c < bytes.channels; ++c) {
        set_sample(image, x, y, c, sample_at(bytes, x, y, c) * scale);
      }
    }
  }
  return image;
}

TEST_CASE("where neither picture has an edge, every change counts, however small") {
  Random random(17);
  for (const Format format : kFormats) {
    for (int round = 0; round < 60; ++round) {
      const int channels = int(random.integer(1, 4));
      StoredImage plain = blank(24, 20, channels, format);
      for (int c = 0; c < channels; ++c) {
        const double sample = random_sample(random, format);
        for (int y = 0; y < 20; ++y) {
          for (int x = 0; x < 24; ++x) set_sample(plain, x, y, c, sample);
        }
      }
      // Another colour everywhere, and a dot of it.
      const double step = format == Format::kFloats ? 1e-3 : double(random.integer(1, 40));
      const int changed = int(random.integer(0, channels - 1));
      const double sample = sample_at(plain, 0, 0, changed);
      const double other = sample > 0 ? std::max(sample - step, 0.0) : sample + step;
      StoredImage all = plain, dot = plain;
      set_sample(dot, 11, 9, changed, other);
      for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 24; ++x) set_sample(all, x, y, changed, other);
      }
      INFO(name_of(format) << ", seed 17, round " << round);
      CHECK(kinds_of(plain, all) == std::string(24 * 20, '!'));
      std::string lonely(24 * 20, '=');
      lonely[9 * 24 + 11] = '!';
      CHECK(kinds_of(plain, dot) == lonely);
      CHECK(kinds_of(dot, plain) == lonely);
    }
  }
}

TEST_CASE("it does not matter which picture is the reference") {
  for (const std::string& look : moved_edge_looks()) {
    const MovedPair pair = moved_pair(look, 0.4, 20, 11, 120, 80);
    CHECK(kinds_of(pair.reference, pair.test) == kinds_of(pair.test, pair.reference));
  }
}

TEST_CASE("16-bit samples and floats are judged as bytes are") {
  const MovedPair pair = moved_pair("grey-text", 0.3, 20, 12, 120, 80);
  const std::string bytes = kinds_of(pair.reference, pair.test);
  const auto disagreement = [&bytes](const std::string& other) {
    REQUIRE(other.size() == bytes.size());
    return std::inner_product(bytes.begin(), bytes.end(), other.begin(), 0, std::plus<>(),
                              [](char a, char b) { return a == b ? 0 : 1; });
  };
  // They have no slack for rounding, or a smaller one.
  CHECK(disagreement(kinds_of(as_format(pair.reference, Format::kShorts, 257),
                              as_format(pair.test, Format::kShorts, 257))) <= 3);
  CHECK(disagreement(kinds_of(as_format(pair.reference, Format::kFloats, 1),
                              as_format(pair.test, Format::kFloats, 1))) <= 3);
}

TEST_CASE("a channel that is the same everywhere agrees with every movement") {
  const MovedPair pair = moved_pair("grey-text", 0.3, 0, 17, 120, 80);
  const auto with_plain_blue = [](const StoredImage& image) {
    StoredImage floats = as_format(image, Format::kFloats, 1 / 255.0);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) set_sample(floats, x, y, 2, 0.3);
    }
    return floats;
  };
  const std::string kinds = kinds_of(with_plain_blue(pair.reference), with_plain_blue(pair.test));
  CHECK(std::count(kinds.begin(), kinds.end(), 'e') > 500);
  CHECK(std::count(kinds.begin(), kinds.end(), '!') < 5);
}

TEST_CASE("a colour that only alpha uncovers moves with its edge") {
  // Black text on nothing: the colour is that of the ink where there is ink, and 0 elsewhere.
  const MovedPair pair = moved_pair("small-dark-text", 0.3, 0, 13, 120, 80);
  const auto inked = [](const StoredImage& image) {
    StoredImage text = blank(image.width, image.height, 4, Format::kBytes);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const double alpha = 255 - sample_at(image, x, y, 0);
        set_sample(text, x, y, 3, alpha);
        for (int c = 0; c < 3; ++c) set_sample(text, x, y, c, alpha > 0 ? 60 * (c + 1) : 0);
      }
    }
    return text;
  };
  const std::string kinds = kinds_of(inked(pair.reference), inked(pair.test));
  CHECK(std::count(kinds.begin(), kinds.end(), 'e') > 500);
  CHECK(std::count(kinds.begin(), kinds.end(), '!') < 5);
}

TEST_CASE("what is left out has no influence on what is judged") {
  MovedPair pair = moved_pair("grey-text", 0.3, 0, 14, 120, 80);
  Selection selection(120, 80);
  REQUIRE(selection.exclude(PixelBox{40, 0, 30, 80}));
  const std::string before = kinds_of(pair.reference, pair.test, selection);
  Random random(15);
  for (int y = 0; y < 80; ++y) {
    for (int x = 40; x < 70; ++x) {
      for (int c = 0; c < 3; ++c) set_sample(pair.test, x, y, c, double(random.integer(0, 255)));
    }
  }
  CHECK(kinds_of(pair.reference, pair.test, selection) == before);
}

TEST_CASE("no pixel near NaN or an infinity is a moved edge") {
  const MovedPair pair = moved_pair("grey-text", 0.3, 0, 16, 60, 60);
  const StoredImage reference = as_format(pair.reference, Format::kFloats, 1);
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    StoredImage test = as_format(pair.test, Format::kFloats, 1);
    set_sample(test, 20, 20, 1, value);
    const std::string kinds = kinds_of(reference, test);
    for (int y = 16; y <= 24; ++y) {
      for (int x = 16; x <= 24; ++x) CHECK(kinds[std::size_t(y * 60 + x)] != 'e');
    }
  }
}

// Writes the pictures that tests/peers compares: NAME-reference.png, NAME-test.png, and NAME.txt
// with the pixels that changed, one "x y kind" a line.
TEST_CASE("the pictures for other tools", "[.][corpus]") {
  const char* folder = std::getenv("CORPUS");
  REQUIRE(folder != nullptr);
  for (const std::string& look : moved_edge_looks()) {
    for (const int changes : {0, 40}) {
      for (const double shift : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
        if (shift == 0 && changes == 0) continue;
        const MovedPair pair = moved_pair(look, shift, changes, std::uint64_t(shift * 10) + 20);
        const std::string name =
            fmt::format("{}/{}-{}", folder, pair.name, changes > 0 ? "changed" : "moved");
        REQUIRE(write_file(name + "-reference.png", *encode_png(pair.reference)));
        REQUIRE(write_file(name + "-test.png", *encode_png(pair.test)));
        std::ofstream truth(name + ".txt");
        for (const auto& [at, kind] : pair.changed) {
          truth << at.x << ' ' << at.y << ' ' << (kind == ChangeKind::kAtEdge ? "edge" : "plain")
                << '\n';
        }
        REQUIRE(truth.flush());
      }
    }
  }
}

}  // namespace
}  // namespace glassbox::test
