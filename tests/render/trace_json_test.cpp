// Traces as JSON: the numbers are those of the trace, and every key is documented.
#include <fstream>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/trace/tracer.h>

#include "app/trace/json.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using Json = nlohmann::ordered_json;

TracedRun room_pixel(const Scene& scene) {
  const auto view = make_view(test::camera_for(scene, 1.5), 96, 64);
  REQUIRE(view);
  TraceFilter filter;
  filter.pixels = PixelRect{40, 30, 43, 33};
  return trace(scene, *view, RenderSettings{}, filter);
}

void collect_keys(const Json& json, std::set<std::string>& keys) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      keys.insert(key);
      collect_keys(value, keys);
    }
  }
  if (json.is_array()) {
    for (const Json& value : json) collect_keys(value, keys);
  }
}

TEST_CASE("the JSON of a trace, written and read again, has the records' numbers to the bit") {
  const auto scene = make_builtin("room");
  REQUIRE(scene);
  const TracedRun run = room_pixel(*scene);
  const Json json = Json::parse(to_json(*scene, run.trace).dump());
  CHECK(json.at("schema") == kTraceSchema);
  CHECK(json.at("complete") == true);
  REQUIRE(json.at("triangles").size() == run.trace.triangles.size());
  REQUIRE(json.at("fragments").size() == run.trace.fragments.size());
  REQUIRE(!run.trace.fragments.empty());
  for (std::size_t i = 0; i < run.trace.triangles.size(); ++i) {
    const TracedTriangle& triangle = run.trace.triangles[i];
    const Json& written = json.at("triangles")[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Clip>& clip = triangle.corners[k].clip;
      const Json& corner = written.at("corners")[k];
      REQUIRE(corner.at("clip")[0].get<float>() == clip.x);
      REQUIRE(corner.at("clip")[3].get<float>() == clip.w);
      REQUIRE(corner.at("eye")[2].get<double>() == triangle.corners[k].eye.z);
    }
    for (std::size_t k = 0; k < triangle.polygon.size(); ++k) {
      REQUIRE(written.at("polygon")[k].at("screen")[1].get<float>() ==
              triangle.polygon[k].screen.position.y);
      REQUIRE(written.at("polygon")[k].at("snapped")[0] == triangle.polygon[k].snapped.x);
    }
  }
  for (std::size_t i = 0; i < run.trace.fragments.size(); ++i) {
    const TracedFragment& fragment = run.trace.fragments[i];
    const Json& written = json.at("fragments")[i];
    REQUIRE(written.at("edges") == Json(fragment.coverage.edges));
    REQUIRE(written.at("depth").get<float>() == fragment.fragment.depth);
    REQUIRE(written.at("depth_test").at("incoming") == fragment.code);
    REQUIRE(written.at("fate") == name_of(fragment.result));
    REQUIRE(written.contains("bounds"));
  }
}

TEST_CASE("fragments of lines, points and edges are of no triangle and no piece of one") {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, 0.5f, 0}, {1, 0.6f, 0}, {0, 0, 0}};
  test::add_face(mesh, {0, 1, 2});
  mesh.lines.push_back({Corner{3}, Corner{4}});
  mesh.points.push_back(Corner{5});
  const Scene scene = test::scene_of(mesh);
  const auto view = make_view(test::camera_for(scene, 1.5), 48, 32);
  REQUIRE(view);
  RenderSettings settings;
  settings.wireframe = true;
  const TracedRun run = trace(scene, *view, settings, {});
  const Json json = to_json(scene, run.trace);
  std::set<LineKind> kinds;
  for (std::size_t i = 0; i < run.trace.fragments.size(); ++i) {
    const FragmentSource& source = run.trace.fragments[i].source;
    REQUIRE_FALSE(source.is_triangle);
    kinds.insert(source.line);
    CHECK(json.at("fragments")[i].at("triangle").is_null());
    CHECK(json.at("fragments")[i].at("piece") == 0);
  }
  CHECK(kinds.size() == 3);
}

TEST_CASE("docs/trace.md names every key of the JSON") {
  const auto scene = make_builtin("room");
  REQUIRE(scene);
  std::set<std::string> keys;
  collect_keys(to_json(*scene, room_pixel(*scene).trace), keys);
  // The cube from nearby, so that the near plane cuts it, and a scene with blending.
  const auto cube = make_builtin("cube");
  REQUIRE(cube);
  Camera near = test::camera_for(*cube, 1.5);
  std::get<PerspectiveLens>(near.lens).near += 1;
  const auto view = make_view(near, 96, 64);
  REQUIRE(view);
  collect_keys(to_json(*cube, trace(*cube, *view, RenderSettings{}, {}).trace), keys);
  CHECK(keys.contains("from"));

  std::ifstream in(std::string(GLASSBOX_SOURCE_DIR) + "/docs/trace.md");
  std::stringstream text;
  text << in.rdbuf();
  for (const std::string& key : keys) {
    CAPTURE(key);
    CHECK(text.str().find("`" + key + "`") != std::string::npos);
  }
}

TEST_CASE("a trace into a sink is the trace that is collected") {
  const auto scene = make_builtin("room");
  REQUIRE(scene);
  struct Counter : TraceSink {
    std::size_t draws = 0, triangles = 0, fragments = 0;
    void draw(const TracedDraw&) override { ++draws; }
    void triangle(const TracedTriangle&) override { ++triangles; }
    void fragment(const TracedFragment&) override { ++fragments; }
  } counter;
  const TracedRun run = room_pixel(*scene);
  TraceFilter filter;
  filter.pixels = PixelRect{40, 30, 43, 33};
  const StreamedRun sunk = trace(*scene, run.trace.view, RenderSettings{}, filter, counter);
  CHECK(sunk.complete);
  CHECK(sunk.rendering.buffers.color == run.rendering.buffers.color);
  CHECK(counter.draws == run.trace.draws.size());
  CHECK(counter.triangles == run.trace.triangles.size());
  CHECK(counter.fragments == run.trace.fragments.size());
}

TEST_CASE("a filter by vertex keeps the triangles around it and their fragments") {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  const auto view = make_view(test::camera_for(*scene, 1.5), 96, 64);
  REQUIRE(view);
  const Trace all = trace(*scene, *view, RenderSettings{}, {}).trace;
  TraceFilter filter;
  const std::uint32_t seen = all.fragments.front().source.number;
  for (const TracedTriangle& triangle : all.triangles) {
    if (triangle.number == seen) filter.position = triangle.corners[0].position;
  }
  REQUIRE(filter.position);
  filter.colors = false;
  const Trace around = trace(*scene, *view, RenderSettings{}, filter).trace;
  std::set<std::uint32_t> expected, found;
  for (const TracedTriangle& triangle : all.triangles) {
    for (const TracedCorner& corner : triangle.corners) {
      if (corner.position == *filter.position) expected.insert(triangle.number);
    }
  }
  for (const TracedTriangle& triangle : around.triangles) found.insert(triangle.number);
  CHECK(found == expected);
  CHECK(found.size() < all.triangles.size());
  REQUIRE(!around.fragments.empty());
  for (const TracedFragment& fragment : around.fragments) {
    CHECK(expected.contains(fragment.source.number));
    CHECK(fragment.after == Rgba8{});
  }
}

}  // namespace
}  // namespace glassbox
