// An engine that is neither of the two built-in ones: pairs, anaglyphs and all settings work with
// it.
#include <memory>
#include <utility>
#include <vector>

#include <glassbox/render/renderer.h>

#include "tests/render/stereo/pairs.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// The properties of a job that an engine was given.
struct JobProperties {
  std::size_t eyes = 0;
  bool is_pair = false, draws_over = false;
};

class RecordingEngine : public Engine {
public:
  explicit RecordingEngine(std::vector<JobProperties>& asked) : asked_(asked) {}

  PairCullCounts draw(const PictureJob& job) override {
    asked_.push_back({job.eyes.size(), job.culling != nullptr, job.eyes.back().draws_over()});
    return reference_.draw(job);
  }

private:
  std::vector<JobProperties>& asked_;
  StagedEngine reference_;
};

}  // namespace

TEST_CASE(
    "an engine of one's own draws single pictures, pairs and anaglyphs, and is asked once each") {
  const PairCase c = pair_cases().front();
  std::vector<JobProperties> asked;
  Renderer own(c.scene, Transfer::kSrgb, std::make_unique<RecordingEngine>(asked));
  Renderer tiles(c.scene, Transfer::kSrgb);

  CHECK(own.render(c.centre, {}).buffers.color == tiles.render(c.centre, {}).buffers.color);
  REQUIRE(asked.size() == 1);
  CHECK((asked[0].eyes == 1 && !asked[0].is_pair));

  const StereoRendering pair = own.render_pair(c.centre, c.pair, {});
  CHECK(pair.left.color == tiles.render_pair(c.centre, c.pair, {}).left.color);
  REQUIRE(asked.size() == 2);
  CHECK((asked[1].eyes == 2 && asked[1].is_pair && !asked[1].draws_over));

  const StereoRendering anaglyph = own.render_masked_anaglyph(c.centre, c.pair, {}, {});
  CHECK(anaglyph.left.color == tiles.render_masked_anaglyph(c.centre, c.pair, {}, {}).left.color);
  REQUIRE(asked.size() == 3);
  CHECK((asked[2].eyes == 2 && asked[2].draws_over));
}

TEST_CASE("what an engine does not cull for the camera between the eyes, the reference culls") {
  const PairCase c = pair_cases().front();
  std::vector<JobProperties> asked;
  Renderer own(c.scene, Transfer::kSrgb, std::make_unique<RecordingEngine>(asked));
  const StereoSettings centre_culled{{}, StereoCulling::kCentre};
  const StereoRendering expected = render_pair(c.scene, c.centre, c.pair, centre_culled);
  const StereoRendering drawn = own.render_pair(c.centre, c.pair, centre_culled);
  CHECK(asked.empty());
  CHECK(drawn.right.color == expected.right.color);
  CHECK(drawn.culled == expected.culled);
  CHECK(drawn.lost == expected.lost);
}

}  // namespace glassbox::test
