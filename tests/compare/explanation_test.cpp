// Explanations of a difference: each kind of slip is planted in real pictures and has to be found,
// and none may be found where there is none.
#include "tests/support/catch.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/compare/pictures.h"

#include <glassbox/compare/pixels/explanation.h>
#include <glassbox/images/srgb.h>

namespace glassbox::test {
namespace {

using Words = std::vector<std::string>;

// Opaque pictures without symmetry, some with much background and some with little.
const char* const kPictures[] = {"f-glyph.png", "shade-phong.png", "inside-room.png"};

Words explained(const StoredImage& reference, const StoredImage& test, const Selection& selection,
                bool nan_equals_nan = false, const SetAside& set_aside = {}) {
  const PicturePair pair{reference, test, selection, nan_equals_nan, set_aside};
  return explain_differences(pair, find_differences(pair));
}

Words explained(const StoredImage& reference, const StoredImage& test) {
  return explained(reference, test, Selection(reference.width, reference.height));
}

// Pixel (x, y) of the moved picture is the reference's pixel (x_sign x + x_offset, y_sign y +
// y_offset), or has the value `outside` where the reference has no such pixel.
struct Move {
  int x_sign = 1, x_offset = 0;
  int y_sign = 1, y_offset = 0;
};
StoredImage moved(const StoredImage& image, const Move& move, double outside = 77) {
  StoredImage result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int from_x = move.x_sign * x + move.x_offset;
      const int from_y = move.y_sign * y + move.y_offset;
      const bool inside =
          from_x >= 0 && from_x < image.width && from_y >= 0 && from_y < image.height;
      for (int c = 0; c < image.channels; ++c) {
        set_sample(result, x, y, c, inside ? sample_at(image, from_x, from_y, c) : outside);
      }
    }
  }
  return result;
}

// Replaces every sample by change(channel, value).
template <class Change>
StoredImage changed(const StoredImage& image, Change change) {
  StoredImage result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        set_sample(result, x, y, c, change(c, sample_at(image, x, y, c)));
      }
    }
  }
  return result;
}

// Converts an RGB picture of 8 bits to another number of channels and another format.
StoredImage converted(const StoredImage& rgb, int channels, Format format) {
  StoredImage result = blank(rgb.width, rgb.height, channels, format);
  const double scale = format == Format::kShorts ? 257 : format == Format::kFloats ? 1.0 / 256 : 1;
  for (int y = 0; y < rgb.height; ++y) {
    for (int x = 0; x < rgb.width; ++x) {
      for (int c = 0; c < channels; ++c) {
        set_sample(result, x, y, c, sample_at(rgb, x, y, c < 3 ? c : (x + y) % 3) * scale);
      }
    }
  }
  return result;
}

// Replaces the colours of `count` pixels, spread over the picture, by one that does not occur in
// it.
void disturb(StoredImage& image, int count) {
  for (int i = 0; i < count; ++i) {
    const int x = (37 * i + 11) % (image.width - 8) + 4, y = (23 * i + 5) % (image.height - 8) + 4;
    for (int c = 0; c < image.channels; ++c) {
      set_sample(image, x, y, c, std::fmod(sample_at(image, x, y, c) + 101 + 13 * c, 251));
    }
  }
}

// Expects the explanation `words` for the picture as it is, and also after seven pixels are
// disturbed.
void check(const StoredImage& reference, StoredImage test, const std::string& words) {
  CHECK(explained(reference, test) == Words{words});
  disturb(test, 7);
  CHECK(explained(reference, test) == Words{words + " (except for 7 pixels)"});
}

TEST_CASE("a move by up to two pixels is found") {
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    INFO(name);
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const std::string sign_x = dx < 0 ? "" : "+", sign_y = dy < 0 ? "" : "+";
        check(reference, moved(reference, {1, -dx, 1, -dy}),
              "the test is the reference moved by (" + sign_x + std::to_string(dx) + ", " + sign_y +
                  std::to_string(dy) + ") pixels");
      }
    }
    CHECK(explained(reference, moved(reference, {1, 3, 1, 0})).empty());
  }
}

TEST_CASE("a move is found in grey, RGBA, 16 bits and floats, too") {
  const StoredImage rgb = golden("f-glyph.png");
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      const StoredImage reference = converted(rgb, channels, format);
      INFO(channels << " channels of " << name_of(format));
      CHECK(explained(reference, moved(reference, {1, -1, 1, 2})) ==
            Words{"the test is the reference moved by (+1, -2) pixels"});
    }
  }
}

TEST_CASE("mirrorings are found") {
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    const int right = reference.width - 1, bottom = reference.height - 1;
    INFO(name);
    check(reference, moved(reference, {1, 0, -1, bottom}), "the test is the reference upside down");
    check(reference, moved(reference, {-1, right, 1, 0}),
          "the test is the reference mirrored left to right");
    check(reference, moved(reference, {-1, right, -1, bottom}),
          "the test is the reference turned by 180 degrees");
  }
}

TEST_CASE("red and blue in each other's place are found, with alpha and without") {
  for (const char* name : kPictures) {
    for (const Format format : kFormats) {
      for (const int channels : {3, 4}) {
        const StoredImage reference = converted(golden(name), channels, format);
        StoredImage test = reference;
        for (int y = 0; y < test.height; ++y) {
          for (int x = 0; x < test.width; ++x) {
            set_sample(test, x, y, 0, sample_at(reference, x, y, 2));
            set_sample(test, x, y, 2, sample_at(reference, x, y, 0));
          }
        }
        INFO(name << ", " << channels << " channels of " << name_of(format));
        CHECK(explained(reference, test) == Words{"red and blue are swapped"});
      }
    }
  }
}

TEST_CASE("a constant added to every sample is found, clamped or not") {
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    INFO(name);
    const auto plus = [&](int r, int g, int b) {
      return changed(reference, [&](int c, double value) {
        return std::clamp(value + (c == 0 ? r : c == 1 ? g : b), 0.0, 255.0);
      });
    };
    check(reference, plus(1, 1, 1), "(+1, +1, +1) was added to every pixel of the reference");
    check(reference, plus(-1, -1, -1), "(-1, -1, -1) was added to every pixel of the reference");
    check(reference, plus(0, 3, -2), "(+0, +3, -2) was added to every pixel of the reference");
    const StoredImage wide = converted(reference, 3, Format::kShorts);
    CHECK(explained(wide, changed(wide, [](int, double value) {
                      return std::min(value + 1, 65535.0);
                    })) == Words{"(+1, +1, +1) was added to every pixel of the reference"});
  }
}

TEST_CASE("inverted colours are found, and alpha stays as it is") {
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    INFO(name);
    check(reference, changed(reference, [](int, double value) { return 255 - value; }),
          "the test's colours are the reference's colours, inverted");
    const StoredImage rgba = converted(reference, 4, Format::kShorts);
    CHECK(explained(rgba, changed(rgba, [](int c, double value) {
                      return c == 3 ? value : 65535 - value;
                    })) == Words{"the test's colours are the reference's colours, inverted"});
  }
}

TEST_CASE("an sRGB encoding too many and one too few are found") {
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    INFO(name);
    check(reference,
          changed(reference,
                  [](int, double value) {
                    return double(encode_srgb(decode_unorm8(std::uint8_t(value))));
                  }),
          "the test's colours are sRGB-encoded once more than the reference's");
    check(reference,
          changed(reference,
                  [](int, double value) {
                    return double(encode_unorm8(decode_srgb(std::uint8_t(value))));
                  }),
          "the test's colours are sRGB-encoded once less than the reference's");
  }
}

TEST_CASE(
    "light stored with the encoding and without is known, though each is rounded for itself") {
  Random random(52);
  StoredImage linear = blank(64, 48, 3, Format::kBytes), encoded = linear;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double share = random.unit();  // makes dark samples more frequent than light ones
        const auto light = float(share * random.unit());
        set_sample(linear, x, y, c, encode_unorm8(light));
        set_sample(encoded, x, y, c, encode_srgb(light));
      }
    }
  }
  check(linear, encoded, "the test's colours are sRGB-encoded once more than the reference's");
  check(encoded, linear, "the test's colours are sRGB-encoded once less than the reference's");
}

TEST_CASE("a difference in one channel only is named") {
  const StoredImage rgb = golden("shade-phong.png");
  const auto disturbed = [](const StoredImage& image, int channel) {
    StoredImage test = image;
    for (int i = 0; i < 50; ++i) {
      const double value = sample_at(image, 3 * i, 2 * i, channel);
      set_sample(test, 3 * i, 2 * i, channel, value > 100 ? value - 1 - i : value + 1 + i);
    }
    return test;
  };
  const StoredImage rgba = converted(rgb, 4, Format::kBytes);
  const StoredImage grey_alpha = converted(rgb, 2, Format::kBytes);
  const StoredImage grey = converted(rgb, 1, Format::kBytes);
  CHECK(explained(rgba, disturbed(rgba, 0)) == Words{"only red differs"});
  CHECK(explained(rgba, disturbed(rgba, 1)) == Words{"only green differs"});
  CHECK(explained(rgba, disturbed(rgba, 2)) == Words{"only blue differs"});
  CHECK(explained(rgba, disturbed(rgba, 3)) == Words{"only alpha differs"});
  CHECK(explained(grey_alpha, disturbed(grey_alpha, 0)) == Words{"only grey differs"});
  CHECK(explained(grey_alpha, disturbed(grey_alpha, 1)) == Words{"only alpha differs"});
  CHECK(explained(grey, disturbed(grey, 0)).empty());
  CHECK(explained(rgba, disturbed(disturbed(rgba, 0), 3)).empty());
}

TEST_CASE("NaN, where it is the same as NaN, stands in the way of no explanation") {
  StoredImage reference = converted(golden("f-glyph.png"), 3, Format::kFloats);
  for (int x = 20; x < 200; ++x) set_sample(reference, x, 40, 1, std::nan(""));
  for (int x = 0; x < 320; ++x) {
    set_sample(reference, x, 3, 0, std::numeric_limits<double>::infinity());
  }
  const Selection all(reference.width, reference.height);
  CHECK(explained(reference, moved(reference, {1, -1, 1, -1}), all, true) ==
        Words{"the test is the reference moved by (+1, +1) pixels"});
  StoredImage red = reference;
  set_sample(red, 7, 7, 0, 12);
  CHECK(explained(reference, red, all, true) == Words{"only red differs"});
}

TEST_CASE("what is left out is no evidence against an explanation") {
  const StoredImage reference = golden("f-glyph.png");
  StoredImage test = moved(reference, {1, 0, -1, reference.height - 1});
  Selection selection(reference.width, reference.height);
  REQUIRE(selection.exclude(PixelBox{0, 0, 160, 180}));
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 160; ++x) set_sample(test, x, y, 0, (x * y) % 256);
  }
  CHECK(explained(reference, test, selection) == Words{"the test is the reference upside down"});
}

TEST_CASE("what is set aside is no evidence against an explanation") {
  Random random(68);
  for (const char* name : kPictures) {
    const StoredImage reference = golden(name);
    const int right = reference.width - 1, bottom = reference.height - 1;
    for (const Move& move : {Move{1, 1, 1, -2}, Move{-1, right, 1, 0}, Move{1, 0, -1, bottom}}) {
      const StoredImage slipped = moved(reference, move);
      // One step, where the slip changed nothing.
      StoredImage test = slipped;
      for (int y = 0; y < test.height; ++y) {
        for (int x = 0; x < test.width; ++x) {
          bool same = true;
          for (int c = 0; c < 3; ++c) {
            same &= sample_at(slipped, x, y, c) == sample_at(reference, x, y, c);
          }
          if (!same || random.integer(0, 2) == 0) continue;
          const double blue = sample_at(reference, x, y, 2);
          set_sample(test, x, y, 2, blue > 0 ? blue - 1 : 1);
        }
      }
      const Selection all(reference.width, reference.height);
      const Words words = explained(reference, slipped);
      INFO(name << ", seed 68");
      REQUIRE(words.size() == 1);
      CHECK(explained(reference, test, all) != words);
      CHECK(explained(reference, test, all, false, {0.02, false}) == words);
    }
  }
}

TEST_CASE("noise and a real difference are not explained") {
  CHECK(explained(golden("shade-flat.png"), golden("shade-phong.png")).empty());
  CHECK(explained(golden("shade-gouraud.png"), golden("shade-phong.png")).empty());
  CHECK(explained(golden("depth-d16-far.png"), golden("depth-d32-far.png")).empty());
  Random random(51);
  for (const Format format : kFormats) {
    for (int channels = 1; channels <= 4; ++channels) {
      const StoredImage reference = random_picture(random, 64, 48, channels, format);
      const StoredImage test = random_picture(random, 64, 48, channels, format);
      INFO(channels << " channels of " << name_of(format));
      CHECK(explained(reference, test).empty());
    }
  }
}

TEST_CASE("a slip of one in ten pixels explains nothing") {
  const StoredImage reference = golden("inside-room.png");
  StoredImage test =
      changed(reference, [](int, double value) { return std::min(value + 1, 255.0); });
  const Selection all(reference.width, reference.height);
  const auto differing = find_differences({reference, test, all}).differing;
  StoredImage few = test, many = test;
  disturb(few, int(differing / 12));
  disturb(many, int(differing / 5));
  CHECK(explained(reference, few).size() == 1);
  CHECK(explained(reference, many).empty());
}

// One pixel at any place differs from a picture of one colour. Moving, mirroring or swapping does
// not change a picture of one colour, so none of them may explain it.
TEST_CASE("a wrong pixel in a picture of one colour is not taken for a slip of the whole") {
  for (const double background : {0.0, 90.0, 255.0}) {
    for (const auto& [width, height] :
         {std::pair(9, 7), std::pair(1, 9), std::pair(9, 1), std::pair(2, 2), std::pair(3, 3)}) {
      for (const int channels : {1, 3}) {
        const StoredImage reference = changed(blank(width, height, channels, Format::kBytes),
                                              [&](int, double) { return background; });
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            StoredImage test = reference;
            for (int c = 0; c < channels; ++c) set_sample(test, x, y, c, 91 + 10 * c);
            INFO(width << " x " << height << ", " << channels << " channels, pixel (" << x << ", "
                       << y << "), background " << background);
            CHECK(explained(reference, test).empty());
            CHECK(explained(test, reference).empty());
          }
        }
      }
    }
  }
}

TEST_CASE("something that vanished before a black or white background is no constant added") {
  for (const double background : {0.0, 255.0}) {
    StoredImage with =
        changed(blank(40, 30, 3, Format::kBytes), [&](int, double) { return background; });
    const StoredImage without = with;
    // The first pixels differ most from the background: a constant taken from them would clamp all
    // others.
    for (int y = 10; y < 20; ++y) {
      for (int x = 10; x < 20; ++x) {
        const double shade = y == 10 ? 20 : 20 + (x + y) % 9;
        for (int c = 0; c < 3; ++c)
          set_sample(with, x, y, c, background == 0 ? 255 - shade : shade);
      }
    }
    INFO("background " << background);
    CHECK(explained(with, without).empty());
    CHECK(explained(without, with).empty());
    // The same for a shape of one colour that changed to another colour.
    StoredImage flat = without, darker = without;
    for (int y = 10; y < 20; ++y) {
      for (int x = 10; x < 20; ++x) {
        for (int c = 0; c < 3; ++c) {
          set_sample(flat, x, y, c, 120);
          set_sample(darker, x, y, c, background == 0 ? 80 : 160);
        }
      }
    }
    CHECK(explained(flat, darker).empty());
  }
}

TEST_CASE("a picture of one colour that became another one is the constant apart") {
  const StoredImage reference =
      changed(blank(5, 4, 3, Format::kBytes), [](int c, double) { return 10.0 + c; });
  const StoredImage test = changed(reference, [](int, double value) { return value + 2; });
  CHECK(explained(reference, test) ==
        Words{"(+2, +2, +2) was added to every pixel of the reference"});
}

TEST_CASE("pictures that are the same need no explanation") {
  const StoredImage image = golden("teapot.png");
  CHECK(explained(image, image).empty());
}

}  // namespace
}  // namespace glassbox::test
