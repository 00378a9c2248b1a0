#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glassbox/images/stereo/cables.h>

#include "tests/images/stereo/pictures.h"

namespace {

using namespace glassbox;
using test::noise;

Image<Rgba8> through(const Image<Rgba8>& sent, Cable cable) {
  auto arrived = send_through_cable(sent, cable);
  REQUIRE(arrived);
  return *arrived;
}

EyeErrors errors(const Image<Rgba8>& sent, Cable cable, Glasses glasses = Glasses::kRedCyan) {
  const auto found = channel_errors(sent, through(sent, cable), glasses);
  REQUIRE(found);
  return *found;
}

EyeErrors leaks(const Image<Rgba8>& sent, Cable cable, Glasses glasses = Glasses::kRedCyan) {
  const auto found = channel_leaks(sent, cable, glasses);
  REQUIRE(found);
  return *found;
}

// Returns a line of greys that oscillates by `bytes` around 128 at `megahertz`, or a line that
// oscillates between red and cyan of the same luma.
enum class Swing { kLuma, kRedAgainstCyan };
Image<Rgba8> wave(double megahertz, double bytes, Swing swing) {
  Image<Rgba8> line(640, 1);
  for (int x = 0; x < line.width; ++x) {
    const double s = bytes * std::cos(2 * 3.14159265358979 * megahertz / 13.5 * x);
    const auto byte = [](double value) { return std::uint8_t(std::lround(128 + value)); };
    line.at(x, 0) = swing == Swing::kLuma
                        ? Rgba8{byte(s), byte(s), byte(s), 255}
                        : Rgba8{byte(s), byte(-s * 299 / 701), byte(-s * 299 / 701), 255};
  }
  return line;
}

// Returns half of the range of red minus green over the middle of a line.
double colour_swing(const Image<Rgba8>& line) {
  int low = 255, high = -255;
  for (int x = 160; x < 480; ++x) {
    const Rgba8 pixel = line.at(x, 0);
    const int difference = pixel.r - pixel.g;
    low = std::min(low, difference);
    high = std::max(high, difference);
  }
  return (high - low) / 2.0;
}

}  // namespace

TEST_CASE("greys without edges and colours without edges arrive as they were sent") {
  for (const auto& cable : all_cables()) {
    CAPTURE(cable.name);
    CHECK(name_of(cable.value) == cable.name);
    // On composite, demodulation leaves a carrier of the doubled frequency at 6.34 MHz, where the
    // filters attenuate by 50 dB.
    const int allowed = cable.value == Cable::kComposite ? 1 : 0;
    for (const Rgba8 colour : {Rgba8{0, 0, 0, 255}, Rgba8{255, 255, 255, 255}, Rgba8{90, 90, 90, 7},
                               Rgba8{255, 0, 0, 255}, Rgba8{13, 200, 77, 255}}) {
      const Image<Rgba8> arrived = through(Image<Rgba8>(97, 3, colour), cable.value);
      for (const Rgba8& pixel : arrived.pixels) {
        CHECK(std::abs(pixel.r - colour.r) <= allowed);
        CHECK(std::abs(pixel.g - colour.g) <= allowed);
        CHECK(std::abs(pixel.b - colour.b) <= allowed);
        CHECK(pixel.a == colour.a);
      }
    }
  }
}

TEST_CASE("luma arrives untouched where it has a wire of its own, however fine") {
  for (const double megahertz : {0.3, 2.0, 3.58, 6.0}) {
    const Image<Rgba8> sent = wave(megahertz, 100, Swing::kLuma);
    CHECK(through(sent, Cable::kComponent) == sent);
    CHECK(through(sent, Cable::kSVideo) == sent);
  }
}

TEST_CASE("on composite, fine luma near the subcarrier becomes colour and coarse luma does not") {
  const Image<Rgba8> near = through(wave(3.4, 100, Swing::kLuma), Cable::kComposite);
  const Image<Rgba8> far = through(wave(0.5, 100, Swing::kLuma), Cable::kComposite);
  CHECK(colour_swing(near) > 50);
  CHECK(colour_swing(far) <= 2);
}

// The subcarrier has the opposite phase on the next line; rounding and clamping leave a few bytes.
TEST_CASE("on composite, false colours of one line are the opposite of the next line's") {
  const Image<Rgba8> line = wave(3.4, 60, Swing::kLuma);
  Image<Rgba8> two(line.width, 2);
  for (int x = 0; x < line.width; ++x) two.at(x, 0) = two.at(x, 1) = line.at(x, 0);
  const Image<Rgba8> arrived = through(two, Cable::kComposite);
  int largest = 0;
  for (int x = 0; x < line.width; ++x) {
    const Rgba8 even = arrived.at(x, 0), odd = arrived.at(x, 1);
    CHECK(std::abs((even.r - even.g) + (odd.r - odd.g)) <= 4);
    largest = std::max(largest, std::abs(even.r - even.g));
  }
  CHECK(largest > 30);
}

// Red against cyan of the same luma has I and Q in the ratio 0.596 + 0.427 * 0.596 to 0.211 + 0.427
// * 0.211. To the difference between red and green, a unit of I contributes 0.956 + 0.272 and a
// unit of Q 0.621 + 0.647. A wave at a filter's corner frequency arrives with half its amplitude,
// one far below with all of it, and one far above with none. Rounding adds up to 2 bytes.
TEST_CASE("chroma is cut where its cable says") {
  const auto arrives = [](double megahertz, Cable cable) {
    const Image<Rgba8> sent = wave(megahertz, 80, Swing::kRedAgainstCyan);
    return colour_swing(through(sent, cable)) / colour_swing(sent);
  };
  CHECK(arrives(0.5, Cable::kComponent) > 0.97);
  CHECK(std::abs(arrives(2.75, Cable::kComponent) - 0.5) <= 0.03);
  CHECK(arrives(5, Cable::kComponent) < 0.03);

  const double i = 0.596 * (0.956 + 0.272), q = 0.211 * (0.621 + 0.647);
  CHECK(arrives(0.1, Cable::kSVideo) > 0.97);
  CHECK(std::abs(arrives(0.5, Cable::kSVideo) - (i + q / 2) / (i + q)) <= 0.03);
  CHECK(std::abs(arrives(1.3, Cable::kSVideo) - i / 2 / (i + q)) <= 0.03);
  CHECK(arrives(2.5, Cable::kSVideo) < 0.03);
}

TEST_CASE(
    "what goes wrong grows from component over S-Video to composite, in each eye and for all "
    "glasses (E1)") {
  Random random(23);
  const Image<Rgba8> left = noise(160, 24, random), right = noise(160, 24, random);
  for (const auto& glasses : all_glasses()) {
    CAPTURE(glasses.name);
    const auto anaglyph = make_anaglyph(left, right, AnaglyphMethod::kMask, glasses.value);
    REQUIRE(anaglyph);
    for (const auto measure : {errors, leaks}) {
      const EyeErrors component = measure(*anaglyph, Cable::kComponent, glasses.value);
      const EyeErrors s_video = measure(*anaglyph, Cable::kSVideo, glasses.value);
      const EyeErrors composite = measure(*anaglyph, Cable::kComposite, glasses.value);
      CHECK((0 < component.left && component.left < s_video.left));
      CHECK((0 < component.right && component.right < s_video.right));
      CHECK(s_video.left + s_video.right < composite.left + composite.right);
    }
  }
}

// Computed by hand: red differs by 3 and 4 in two of four pixels, green by 6 in one, and blue
// nowhere.
TEST_CASE("channel errors are root mean squares over each eye's channels") {
  const Image<Rgba8> sent(2, 2, {100, 100, 100, 255});
  Image<Rgba8> arrived = sent;
  arrived.at(0, 0).r = 103;
  arrived.at(1, 0).r = 96;
  arrived.at(0, 1).g = 106;
  const auto red_cyan = channel_errors(sent, arrived, Glasses::kRedCyan);
  const auto amber_blue = channel_errors(sent, arrived, Glasses::kAmberBlue);
  REQUIRE((red_cyan && amber_blue));
  CHECK(red_cyan->left == std::sqrt(25.0 / 4));
  CHECK(red_cyan->right == std::sqrt(36.0 / 8));
  CHECK(amber_blue->left == std::sqrt(61.0 / 8));
  CHECK(amber_blue->right == 0);
  CHECK_FALSE(channel_errors(sent, {1, 1}, Glasses::kRedCyan));
}

TEST_CASE("nothing leaks out of black, and empty pictures stay empty") {
  Image<Rgba8> red_only(64, 2, {0, 0, 0, 255});
  for (int x = 20; x < 40; ++x) red_only.at(x, 0).r = 255;
  CHECK(leaks(red_only, Cable::kSVideo).left == 0);
  CHECK(leaks(red_only, Cable::kSVideo).right > 1);
  for (const auto& cable : all_cables()) CHECK(through({}, cable.value).pixels.empty());
  CHECK(through({1, 1, {10, 20, 30, 255}}, Cable::kSVideo).at(0, 0) == Rgba8{10, 20, 30, 255});
}
