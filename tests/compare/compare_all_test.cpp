// Tests that many pairs compared at the same time have the results of one after the other.
#include "tests/support/catch.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/compare_all.h>
#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/report/json.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

// Pairs of small pictures: the same, different, of other sizes, missing, new, and broken ones.
std::vector<PicturePaths> write_pairs(const TemporaryDirectory& here, int count) {
  std::vector<PicturePaths> pairs;
  Random random(65);
  for (int i = 0; i < count; ++i) {
    const int kind = i % 6;
    StoredImage image = random_picture(random, 20 + i % 7, 15, 3, Format::kBytes);
    PicturePaths paths{fmt::format("{}.png", i), here.file(fmt::format("r{}.png", i)),
                       here.file(fmt::format("t{}.png", i)), kind != 4, kind != 5};
    if (paths.has_reference) REQUIRE(write_file(paths.reference, *encode_png(image)));
    if (kind == 1) set_sample(image, i % 20, i % 15, 1, 7 + i % 200);
    if (kind == 2) image = random_picture(random, 11, 13, 3, Format::kBytes);
    if (paths.has_test) REQUIRE(write_file(paths.test, *encode_png(image)));
    if (kind == 3) REQUIRE(write_file(paths.test, std::vector<std::byte>(30)));
    pairs.push_back(paths);
  }
  return pairs;
}

TEST_CASE("pairs compared together have the results of each alone, in their order") {
  const TemporaryDirectory here;
  const auto pairs = write_pairs(here, 90);
  std::multiset<std::size_t> started;
  CompareOptions options;
  options.metrics = *parse_metrics("psnr,ssim");
  const auto together = compare_all(pairs, options, [&](std::size_t i) { started.insert(i); });
  REQUIRE(together.size() == pairs.size());
  CHECK(started.size() == pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    INFO(i);
    CHECK(started.count(i) == 1);
    CHECK(to_json(together[i]) == to_json(compare_pair(pairs[i], options)));
    CHECK(together[i].seconds >= 0);
    CHECK(!together[i].pixels);
  }
  CHECK(compare_all({}, options).empty());
}

TEST_CASE("pixels are kept where they are asked for, and are those of the files") {
  const TemporaryDirectory here;
  const auto pairs = write_pairs(here, 6);
  CompareOptions options;
  options.keep_pixels = true;
  for (const Comparison& kept : compare_all(pairs, options)) {
    INFO(kept.name);
    CHECK(bool(kept.pixels) == bool(kept.differences));
    if (!kept.pixels) continue;
    Comparison without = kept;
    without.pixels = nullptr;
    const auto read = pixels_of(without), same = pixels_of(kept);
    REQUIRE(read);
    REQUIRE(same);
    CHECK(*same == kept.pixels);
    CHECK((*read)->reference == kept.pixels->reference);
    CHECK((*read)->test == kept.pixels->test);
  }
}

}  // namespace
}  // namespace glassbox::test
