// Observers that replace a stage of a run: the next stages use their results.
#include <vector>

#include "tests/support/catch.h"

#include <glassbox/mesh/builtin/cube.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/staged/staged.h>

using namespace glassbox;

namespace {

struct Shown {
  Scene scene = make_cube();
  View view = make_view(framing_camera(scene, 1.0).value(), 32, 32).value();
  RenderSettings settings;

  Image<Rgba8> picture_with(const Observers& observers) const {
    return render_staged(scene, view, settings, observers).buffers.color;
  }
};

// Finds the covered pixels itself, except for those of one row.
class WithoutRow : public Observer {
public:
  explicit WithoutRow(int row) : row_(row) {}
  void piece_ready(const ReadyTriangle& triangle) override { setup_ = triangle.setup; }
  const std::vector<Coverage>* covered(const FragmentSource&) override {
    pixels_.clear();
    for_each_covered(setup_, {0, 0, 32, 32}, [&](const Coverage& pixel) {
      if (pixel.y != row_) pixels_.push_back(pixel);
    });
    return &pixels_;
  }

private:
  int row_;
  TriangleSetup setup_;
  std::vector<Coverage> pixels_;
};

// Moves the snapped vertices one pixel to the right.
class VertexShifter : public Observer {
public:
  void fanned(std::span<SnappedVertex> polygon, int&) override {
    for (SnappedVertex& vertex : polygon) vertex.x += kSubpixels;
  }
};

class Counts : public Observer {
public:
  void attributes_interpolated(const Fragment&, Varyings&) override { ++varied_fragments; }
  void fanned(std::span<SnappedVertex>, int&) override { ++polygons; }
  int varied_fragments = 0, polygons = 0;
};

}  // namespace

TEST_CASE("pixels that an observer gives are drawn in the place of the stage's") {
  const Shown shown;
  WithoutRow all(-1), without(16);
  const Image<Rgba8> picture = shown.picture_with(nullptr);
  CHECK(shown.picture_with(&all).pixels == picture.pixels);
  const Image<Rgba8> cut = shown.picture_with(&without);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      CAPTURE(x, y);
      CHECK(cut.at(x, y) == (y == 16 ? shown.settings.background : picture.at(x, y)));
    }
  }
}

TEST_CASE("vertices that an observer snaps are those that are set up") {
  const Shown shown;
  VertexShifter moved;
  const Image<Rgba8> picture = shown.picture_with(nullptr), right = shown.picture_with(&moved);
  int covered = 0, same = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x + 1 < 32; ++x) {
      const bool is_cube = picture.at(x, y) != shown.settings.background;
      covered += is_cube;
      same += is_cube && right.at(x + 1, y) != shown.settings.background;
    }
  }
  CHECK(covered > 100);
  CHECK(same == covered);
}

TEST_CASE("of two observers the second sees what the first has made of a run") {
  const Shown shown;
  WithoutRow without(16);
  Counts counts, alone;
  CHECK(shown.picture_with({&without, &counts}).pixels == shown.picture_with(&without).pixels);
  shown.picture_with(&alone);
  CHECK(counts.polygons == alone.polygons);
  CHECK(counts.varied_fragments < alone.varied_fragments);
  CHECK(counts.varied_fragments > 0);
}
