#include <glassbox/compare/metrics/ssim.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "tests/metrics/pictures.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using test::WholePair;

bool same(const SsimValues& a, const SsimValues& b) {
  return a.windows == b.windows && a.mean == b.mean && a.min == b.min;
}

WholePair noisy_pair(int width, int height, int channels) {
  return {test::noise_picture(width, height, channels, 1),
          test::picture<std::uint8_t>(width, height, channels, [](int x, int y, int c) {
            return (test::noise(x, y, c, 1) * 3 + test::noise(x, y, c, 2)) / 4;
          })};
}

}  // namespace

TEST_CASE("the structural similarity of a picture with itself is exactly 1", "[metrics]") {
  const StoredImage image = test::noise_picture(40, 29, 3, 1);
  const SsimValues values = ssim(WholePair{image, image});
  CHECK(values.windows == 30 * 19 * 3);
  CHECK(values.mean == 1);
  CHECK(values.min == 1);
}

TEST_CASE("structural similarity does not depend on which picture is the reference", "[metrics]") {
  const WholePair pair = noisy_pair(40, 29, 3);
  CHECK(same(ssim(pair), ssim(pair.swapped())));
  CHECK(ssim(pair).mean < 1);
  CHECK(ssim(pair).min <= ssim(pair).mean);
  CHECK(ssim(pair).min >= -1);
}

TEST_CASE("structural similarity has the same bits for any tiles and threads", "[metrics]") {
  const WholePair pair = noisy_pair(301, 77, 2);
  const SsimValues whole = ssim(pair);
  for (const TileSize tiles : {TileSize{1, 32}, {128, 1}, {37, 5}, {16, 31}}) {
    CHECK(same(ssim(pair, tiles), whole));
  }
  for (const int threads : {1, 2, 5}) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 5);
    tbb::task_arena arena(threads);
    arena.execute([&] { CHECK(same(ssim(pair, {20, 7}), whole)); });
  }
}

TEST_CASE("a picture of one window has one, and a smaller one has none", "[metrics]") {
  CHECK(ssim(noisy_pair(11, 11, 1)).windows == 1);
  CHECK(ssim(noisy_pair(10, 11, 1)).windows == 0);
  CHECK(ssim(noisy_pair(11, 10, 1)).windows == 0);
  CHECK(ssim(noisy_pair(1, 1, 4)).windows == 0);
}

TEST_CASE("16-bit samples 257 times as large have the similarity of the bytes", "[metrics]") {
  const WholePair bytes = noisy_pair(40, 29, 3);
  const WholePair words{test::deepened(bytes.reference), test::deepened(bytes.test)};
  // Both numbers are rounded alike: 257 v / 65535 and v / 255.
  CHECK(same(ssim(bytes), ssim(words)));
}

TEST_CASE("a difference that is left out does not make pictures less similar", "[metrics]") {
  WholePair pair{test::noise_picture(40, 29, 3, 1), test::noise_picture(40, 29, 3, 1)};
  std::get<std::vector<std::uint8_t>>(pair.test.samples)[3 * (14 * 40 + 20)] ^= 0x80;
  CHECK(ssim(pair).min < 1);
  REQUIRE(pair.selection.exclude({20, 14, 1, 1}));
  CHECK(ssim(pair).windows == (30 * 19 - 1) * 3);
  CHECK(ssim(pair).min == 1);
}

TEST_CASE("a window counts where its centre is compared", "[metrics]") {
  WholePair pair = noisy_pair(30, 30, 1);
  REQUIRE(pair.selection.exclude({0, 0, 30, 15}));
  CHECK(ssim(pair).windows == 20 * 10);
  REQUIRE(pair.selection.exclude({5, 5, 20, 20}));
  CHECK(ssim(pair).windows == 0);
}
