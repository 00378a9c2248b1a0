// Tests that the tiles of mark_moved_edges give the verdicts of the rule for one pixel.
#include "tests/support/catch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tests/compare/pictures.h"
#include "tests/compare/plain_moved_edge.h"

#include <glassbox/compare/pixels/moved_edge.h>

namespace glassbox::test {
namespace {

// Marks all pixels that are kDifferent.
void mark_all(const PicturePair& pair, std::vector<PixelKind>& kinds) {
  const auto width = std::size_t(pair.reference.width);
  for (int y = 0; y < pair.reference.height; y += kMovedEdgeRows) {
    const int rows = std::min(kMovedEdgeRows, pair.reference.height - y);
    mark_moved_edges(pair, y,
                     std::span(kinds).subspan(std::size_t(y) * width, std::size_t(rows) * width));
  }
}

std::vector<PixelKind> all_marked(const PicturePair& pair) {
  std::vector<PixelKind> kinds(pair.reference.pixels(), PixelKind::kDifferent);
  mark_all(pair, kinds);
  return kinds;
}

// Rectangles of random values on a plain ground; half of the pictures of floats have large values.
StoredImage rectangles(Random& random, int width, int height, int channels, Format format) {
  StoredImage image = blank(width, height, channels, format);
  const double scale = format == Format::kFloats && random.unit() < 0.5 ? 1e37 : 1;
  for (int i = 0; i < 2 + width * height / 40; ++i) {
    const int left = int(random.integer(-3, width)), top = int(random.integer(-3, height));
    const int right = left + int(random.integer(1, 9)), bottom = top + int(random.integer(1, 9));
    for (int c = 0; c < channels; ++c) {
      const double value = random_sample(random, format) * scale;
      for (int y = std::max(top, 0); y < std::min(bottom, height); ++y) {
        for (int x = std::max(left, 0); x < std::min(right, width); ++x) {
          set_sample(image, x, y, c, value);
        }
      }
    }
  }
  return image;
}

// The picture moved by a part of a pixel, with other values in some pixels.
StoredImage moved_and_changed(Random& random, const StoredImage& image, Format format) {
  StoredImage test = image;
  const double part_x = random.unit() * 0.7, part_y = random.unit() * 0.7;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        const auto at = [&](int i, int j) {
          return sample_at(image, std::max(x - i, 0), std::max(y - j, 0), c);
        };
        const double above = at(0, 1) + (at(1, 1) - at(0, 1)) * part_x;
        const double here = at(0, 0) + (at(1, 0) - at(0, 0)) * part_x;
        set_sample(test, x, y, c, here + (above - here) * part_y);
        if (random.unit() < 0.15) set_sample(test, x, y, c, random_sample(random, format));
      }
    }
  }
  return test;
}

void make_opaque(StoredImage& image, Format format) {
  const double full = format == Format::kBytes ? 255 : format == Format::kShorts ? 65535 : 1;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) set_sample(image, x, y, image.channels - 1, full);
  }
}

// A pair of any format, of any number of channels, of a size below and above that of tiles, with
// and without pixels that are left out.
struct RandomPair {
  StoredImage reference, test;
  Selection selection;
  PicturePair pair() const { return {reference, test, selection}; }
};

RandomPair random_pair(Random& random, Format format, int channels) {
  const bool large = random.unit() < 0.1;
  const int width = int(large ? random.integer(60, 140) : random.integer(1, 40));
  const int height = int(large ? random.integer(30, 70) : random.integer(1, 20));
  const StoredImage reference = rectangles(random, width, height, channels, format);
  RandomPair made{reference, moved_and_changed(random, reference, format), {width, height}};
  if (channels % 2 == 0 && random.unit() < 0.3) {
    make_opaque(made.reference, format);
    make_opaque(made.test, format);
  }
  if (random.unit() < 0.5) {
    const int x = int(random.integer(0, width - 1)), y = int(random.integer(0, height - 1));
    REQUIRE(made.selection.exclude(PixelBox{x, y, 6, 6}));
  }
  return made;
}

template <class Use>
void for_random_pairs(std::uint64_t seed, int rounds, const Use& use) {
  Random random(seed);
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      for (int round = 0; round < rounds; ++round) {
        INFO(name_of(format) << ", " << channels << " channels, round " << round);
        use(random, format, random_pair(random, format, channels));
      }
    }
  }
}

bool plainly(const PicturePair& pair, Format format, PixelPosition pixel) {
  return format == Format::kFloats ? is_moved_edge_plainly<double>(pair, pixel)
                                   : is_moved_edge_plainly<float>(pair, pixel);
}

TEST_CASE("tiles give the verdicts of the rule for one pixel, exactly") {
  std::uint64_t pixels = 0, moved = 0;
  for_random_pairs(81, 10, [&](Random& random, Format format, RandomPair made) {
    if (format == Format::kFloats && random.unit() < 0.3) {
      const int x = int(random.integer(0, made.test.width - 1));
      const int y = int(random.integer(0, made.test.height - 1));
      set_sample(made.test, x, y, 0, std::numeric_limits<double>::quiet_NaN());
    }
    const PicturePair pair = made.pair();
    const auto kinds = all_marked(pair);
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const PixelPosition pixel{int(i) % made.test.width, int(i) / made.test.width};
      const bool plain = plainly(pair, format, pixel);
      wrong += plain == (kinds[i] == PixelKind::kMovedEdge) ? 0u : 1u;
      ++pixels;
      moved += plain ? 1u : 0u;
    }
    CHECK(wrong == 0);
  });
  INFO(moved << " of " << pixels << " pixels are moved edges");
  CHECK(moved * 10 > pixels);
  CHECK(moved * 10 < pixels * 9);
}

// Rounding can decide only where a value lies at its bound. For 8 bits without alpha, sums below
// 2^20 are exact.
TEST_CASE("floats are precise enough for 8 and 16 bits") {
  std::uint64_t pixels = 0, other = 0;
  for_random_pairs(82, 5, [&](Random&, Format format, const RandomPair& made) {
    if (format == Format::kFloats) return;
    const PicturePair pair = made.pair();
    std::uint64_t own = 0;
    for (int y = 0; y < made.test.height; ++y) {
      for (int x = 0; x < made.test.width; ++x) {
        ++pixels;
        const bool precise = is_moved_edge_plainly<double>(pair, {x, y});
        own += precise == is_moved_edge_plainly<float>(pair, {x, y}) ? 0u : 1u;
      }
    }
    if (format == Format::kBytes && made.test.channels % 2 == 1) CHECK(own == 0);
    other += own;
  });
  INFO(other << " of " << pixels << " pixels are judged otherwise in double");
  CHECK(other * 1000 <= pixels);
}

TEST_CASE("a verdict does not depend on which other pixels are judged") {
  for_random_pairs(83, 5, [&](Random& random, Format, const RandomPair& made) {
    const PicturePair pair = made.pair();
    const auto all = all_marked(pair);
    const double most = random.unit(), share = most * random.unit();
    std::vector<PixelKind> some(all.size(), PixelKind::kSame), expected = some;
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (random.unit() > share) continue;
      some[i] = PixelKind::kDifferent;
      expected[i] = all[i];
    }
    mark_all(pair, some);
    CHECK(some == expected);
  });
}

TEST_CASE("a verdict does not depend on where in the picture the pixel lies") {
  Random random(84);
  for (const Format format : kFormats) {
    const StoredImage reference = rectangles(random, 150, 75, 4, format);
    const StoredImage test = moved_and_changed(random, reference, format);
    const Selection all(150, 75);
    const auto whole = all_marked({reference, test, all});
    for (int round = 0; round < 10; ++round) {
      const PixelBox box{int(random.integer(0, 100)), int(random.integer(0, 35)), 50, 40};
      const StoredImage part_reference = part_of(reference, box, format);
      const StoredImage part_test = part_of(test, box, format);
      const Selection part_all(50, 40);
      const auto part = all_marked({part_reference, part_test, part_all});
      std::uint64_t wrong = 0;
      for (int y = 4; y < 36; ++y) {
        for (int x = 4; x < 46; ++x) {
          wrong +=
              part[std::size_t(y * 50 + x)] == whole[std::size_t((box.y + y) * 150 + box.x + x)]
                  ? 0u
                  : 1u;
        }
      }
      CHECK(wrong == 0);
    }
  }
}

}  // namespace
}  // namespace glassbox::test
