// A run as arrays: the numbers are those of the trace, the rows of a triangle lead to its vertices
// and pieces, and the size is known in advance.
#include <glassbox/render/trace/arrays.h>

#include <algorithm>
#include <cstring>

#include <glassbox/mesh/builtin/scenes.h>

#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

// Element `index` of an array, counted over all its dimensions.
template <class T>
T number_at(const TraceArrays& arrays, const std::string& name, std::size_t index) {
  for (const Table& table : arrays.tables()) {
    for (const Array& array : table.arrays()) {
      if (array.name != name) continue;
      T value;
      REQUIRE((index + 1) * sizeof value <= array.bytes.size());
      std::memcpy(&value, array.bytes.data() + index * sizeof value, sizeof value);
      return value;
    }
  }
  FAIL("no array " << name);
  return {};
}

std::size_t bytes_of(const TraceArrays& arrays) {
  std::size_t bytes = 0;
  for (const Table& table : arrays.tables()) {
    for (const Array& array : table.arrays()) bytes += array.bytes.size();
  }
  return bytes;
}

struct Sample {
  Scene scene;
  View view;
  TraceFilter filter;
};

// The cube seen from nearby, so that the near plane cuts it.
Sample near_cube() {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  Camera camera = test::camera_for(*scene, 1.5);
  std::get<PerspectiveLens>(camera.lens).near += 1;
  const auto view = make_view(camera, 96, 64);
  REQUIRE(view);
  return {*scene, *view, {}};
}

TEST_CASE("arrays have the records' numbers, row for row") {
  const Sample sample = near_cube();
  const Trace run = trace(sample.scene, sample.view, RenderSettings{}, {}).trace;
  TraceArrays arrays(sample.view, {});
  trace(sample.scene, sample.view, RenderSettings{}, {}, arrays);
  arrays.finish();
  REQUIRE(!run.fragments.empty());
  std::size_t vertex = 0, piece = 0, cut = 0, cut_vertex = 0;
  for (std::size_t t = 0; t < run.triangles.size(); ++t) {
    const TracedTriangle& triangle = run.triangles[t];
    REQUIRE(number_at<std::uint32_t>(arrays, "triangle.number", t) == triangle.number);
    REQUIRE(number_at<std::uint64_t>(arrays, "triangle.first_vertex", t) == vertex);
    REQUIRE(number_at<std::uint64_t>(arrays, "triangle.first_piece", t) == piece);
    REQUIRE(number_at<std::uint64_t>(arrays, "triangle.first_cut", t) == cut);
    REQUIRE(number_at<std::uint8_t>(arrays, "triangle.vertex_count", t) == triangle.polygon.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const TracedCorner& corner = triangle.corners[k];
      REQUIRE(number_at<float>(arrays, "corner.clip", 4 * (3 * t + k) + 3) == corner.clip.w);
      REQUIRE(number_at<double>(arrays, "corner.eye", 3 * (3 * t + k) + 2) == corner.eye.z);
      REQUIRE(number_at<std::uint32_t>(arrays, "corner.outcode", 3 * t + k) == corner.outcode);
    }
    for (const ClipStep& step : triangle.clipping) {
      REQUIRE(number_at<std::uint64_t>(arrays, "cut.first_vertex", cut) == cut_vertex);
      REQUIRE(number_at<std::uint64_t>(arrays, "cut.triangle", cut++) == t);
      cut_vertex += std::size_t(step.after.count);
    }
    for (const TracedVertex& v : triangle.polygon) {
      REQUIRE(number_at<float>(arrays, "vertex.screen", 2 * vertex) == v.screen.position.x);
      REQUIRE(number_at<std::int32_t>(arrays, "vertex.snapped", 2 * vertex + 1) == v.snapped.y);
      ++vertex;
    }
    for (const TracedPiece& p : triangle.pieces) {
      REQUIRE(number_at<std::int64_t>(arrays, "piece.double_area", piece) ==
              (p.setup ? p.setup->double_area : 0));
      ++piece;
    }
  }
  CHECK(cut > 0);
  for (std::size_t f = 0; f < run.fragments.size(); ++f) {
    const TracedFragment& fragment = run.fragments[f];
    REQUIRE(number_at<std::int64_t>(arrays, "fragment.triangle", f) == fragment.source.number);
    REQUIRE(number_at<std::uint16_t>(arrays, "fragment.pixel", 2 * f) == fragment.fragment.x);
    REQUIRE(number_at<float>(arrays, "fragment.depth", f) == fragment.fragment.depth);
    REQUIRE(number_at<std::int64_t>(arrays, "fragment.edges", 3 * f + 1) ==
            fragment.coverage.edges[1]);
    REQUIRE(number_at<std::uint8_t>(arrays, "fragment.after", 4 * f + 2) == fragment.after.b);
    REQUIRE(number_at<double>(arrays, "fragment.depth_bound", f) > 0);
  }
  CHECK(number_at<double>(arrays, "round_trip.largest_ratio", 0) <= 1);
  CHECK(number_at<std::uint64_t>(arrays, "round_trip.corners", 0) > 0);
}

TEST_CASE("the size of the arrays is known to the byte before they are filled") {
  const Sample sample = near_cube();
  for (const std::vector<std::string>& wanted :
       {std::vector<std::string>{}, {"vertex", "fragment.depth"}, {"corner.clip"}}) {
    TraceArrays arrays(sample.view, wanted);
    CHECK(arrays.unknown().empty());
    TraceCounter counter;
    trace(sample.scene, sample.view, RenderSettings{}, {}, counter);
    arrays.reserve(counter.counts());
    trace(sample.scene, sample.view, RenderSettings{}, {}, arrays);
    arrays.finish();
    CHECK(bytes_of(arrays) == arrays.bytes_for(counter.counts()));
  }
}

TEST_CASE("a name that no array has is told") {
  const Sample sample = near_cube();
  CHECK(TraceArrays(sample.view, {"corner.clip", "corner.clap"}).unknown() ==
        std::vector<std::string>{"corner.clap"});
}

TEST_CASE("bounds of fragments come from their own triangle, batch after batch") {
  const auto scene = make_builtin("room");
  REQUIRE(scene);
  const auto view = make_view(test::camera_for(*scene, 1.5), 48, 32);
  REQUIRE(view);
  const Trace run = trace(*scene, *view, RenderSettings{}, {}).trace;
  TraceArrays arrays(*view, {"fragment.depth_bound"});
  trace(*scene, *view, RenderSettings{}, {}, arrays);
  for (std::size_t f = 0; f < run.fragments.size(); f += 41) {
    const TracedFragment& fragment = run.fragments[f];
    const auto triangle =
        std::find_if(run.triangles.begin(), run.triangles.end(),
                     [&](const TracedTriangle& t) { return t.number == fragment.source.number; });
    const auto draw = std::find_if(run.draws.begin(), run.draws.end(), [&](const TracedDraw& d) {
      return d.instance == fragment.instance;
    });
    const TriangleBounds bounds = bounds_of(run, *triangle, *draw, bounds_of(*draw, *view));
    const TracedPiece& piece = triangle->pieces[fragment.source.piece];
    CHECK(number_at<double>(arrays, "fragment.depth_bound", f) ==
          fragment_bounds(*piece.setup, fragment.fragment, setup_bounds(piece, bounds)).depth);
  }
}

}  // namespace
}  // namespace glassbox
