// A trace records what the run did: each recorded step, applied to its recorded input, gives its
// recorded output.
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include <glassbox/base/rounding.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/tracer.h>

#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox {
namespace {

constexpr int kTraceWidth = 96, kTraceHeight = 64;

struct TraceCase {
  std::string name;
  Scene scene;
  View view;
};

// The view of the scene's camera, or nothing if that camera cannot be rendered.
std::optional<View> framed(const Scene& scene) {
  const auto automatic = framing_camera(scene, double(kTraceWidth) / kTraceHeight);
  REQUIRE(automatic);
  const auto view = make_view(scene.cameras.empty() ? *automatic : scene.cameras.front(),
                              kTraceWidth, kTraceHeight);
  if (!view) return std::nullopt;
  return *view;
}

View inside_cube() {
  const auto pose = look_at({0, 0, 1.5}, {0.2, 0.1, 0}, {0, 1, 0});
  REQUIRE(pose);
  PerspectiveLens lens;
  lens.near = 1.2;
  lens.far = 2.3;
  const auto view = make_view({"inside", lens, inverse_rigid(*pose)}, kTraceWidth, kTraceHeight);
  REQUIRE(view);
  return *view;
}

// The glTF files among the real assets, up to a size that keeps this short: strips, fans, sparse
// and interleaved accessors, mirrored nodes, skins, morph targets, masks, blending. Files that the
// loader refuses are skipped.
void add_real_files(std::vector<TraceCase>& all) {
  namespace fs = std::filesystem;
  for (const char* folder : {"meshes/gltf", "meshes/asset-generator"}) {
    const fs::path root = fs::path(GLASSBOX_ASSETS_DIR) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const std::string extension = entry.path().extension().string();
      if ((extension != ".gltf" && extension != ".glb") || entry.file_size() > 300000) continue;
      const auto scene = load_scene(entry.path().string());
      if (!scene || count_triangles(*scene) == 0 || count_triangles(*scene) > 20000) continue;
      const auto view = framed(*scene);
      if (view) all.push_back({entry.path().string(), *scene, *view});
    }
  }
}

// All built-in scenes, the cube from so near that its faces are cut, and real files if they are
// present.
std::vector<TraceCase> trace_cases() {
  std::vector<TraceCase> all;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const auto scene = make_builtin(std::string(builtin.name));
    REQUIRE(scene);
    const auto view = framed(*scene);
    REQUIRE(view);
    all.push_back({std::string(builtin.name), *scene, *view});
  }
  all.push_back({"inside the cube", *make_builtin("cube"), inside_cube()});
  add_real_files(all);
  return all;
}

bool same(const ClipVertex& a, const ClipVertex& b) {
  return a.position == b.position && a.weights == b.weights;
}

bool same(const ScreenVertex& a, const ScreenVertex& b) {
  return a.position == b.position && a.inverse_w == b.inverse_w;
}

const TracedDraw& draw_of(const Trace& trace, std::uint32_t instance) {
  for (const TracedDraw& draw : trace.draws) {
    if (draw.instance == instance) return draw;
  }
  FAIL("no draw of instance " << instance);
  return trace.draws.front();
}

// Applies each plane by itself to the polygon that the plane before it has left.
void replay_clipping(const Trace& recorded, const TracedTriangle& triangle) {
  const std::array<ClipVertex, 3> corners = clip_vertices(triangle);
  std::vector<ClipVertex> polygon(corners.begin(), corners.end());
  for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
    const ClipStep& step = triangle.clipping[i];
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const double distance = signed_distance(recorded.planes[i], polygon[k].position);
      // A vertex that is below the plane only by rounding may count as on it (clip.cpp,
      // keep_deepest_dip).
      REQUIRE((step.distances[k] == distance || (step.distances[k] == 0 && distance < 0)));
    }
    std::vector<ClipVertex> after;
    for (int j = 0; j < step.after.count; ++j) {
      const ClipVertex& vertex = step.after.vertices[std::size_t(j)];
      const auto [from, to] = step.sources[std::size_t(j)];
      if (from == to) REQUIRE(same(vertex, polygon[std::size_t(from)]));
      if (from != to) {
        REQUIRE(step.distances[std::size_t(from)] * step.distances[std::size_t(to)] < 0);
        // The coordinate that the plane determines is rounded once, by half an ulp, times its
        // coefficient.
        const ClipPlane& p = recorded.planes[i];
        const double off = std::abs(p.a) * ulp(vertex.position.x) +
                           std::abs(p.b) * ulp(vertex.position.y) +
                           std::abs(p.c) * ulp(vertex.position.z);
        REQUIRE(std::abs(signed_distance(p, vertex.position)) <= off / 2);
      }
      after.push_back(vertex);
    }
    polygon = after;
  }
}

TEST_CASE("real glTF files are among the scenes whose traces are replayed") {
  const std::filesystem::path assets = GLASSBOX_ASSETS_DIR;
  if (!std::filesystem::exists(assets)) SKIP_TEST("no assets at " << assets.string());
  std::vector<TraceCase> real;
  add_real_files(real);
  CHECK(real.size() > 20);
}

TEST_CASE("a run that is traced gives the bytes of one that is not") {
  for (const TraceCase& c : trace_cases()) {
    INFO(c.name);
    for (const Shading shading : {Shading::kFlat, Shading::kPhong}) {
      RenderSettings settings;
      settings.shading = shading;
      settings.want_id = true;
      const Rendering plain = render_staged(c.scene, c.view, settings);
      const TracedRun traced = trace(c.scene, c.view, settings, {});
      CHECK(traced.rendering.buffers.color == plain.buffers.color);
      CHECK(traced.rendering.buffers.depth == plain.buffers.depth);
      CHECK(traced.rendering.buffers.id == plain.buffers.id);
      CHECK(traced.trace.complete);
      CHECK(traced.trace.fragments.size() == plain.statistics.covered);
    }
  }
}

TEST_CASE("the recorded geometric steps replayed give the recorded results, bit for bit") {
  for (const TraceCase& c : trace_cases()) {
    INFO(c.name);
    const Trace recorded = trace(c.scene, c.view, RenderSettings{}, {}).trace;
    REQUIRE(!recorded.triangles.empty());
    for (const TracedTriangle& triangle : recorded.triangles) {
      CAPTURE(triangle.number);
      const TracedDraw& draw = draw_of(recorded, triangle.instance);
      std::array<ClipVertex, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const TracedCorner& corner = triangle.corners[k];
        const Point<Object> anchored{corner.object.x - draw.anchor.x,
                                     corner.object.y - draw.anchor.y,
                                     corner.object.z - draw.anchor.z};
        REQUIRE(draw.clip_from_anchored * anchored == corner.clip);
        REQUIRE(outcode(corner.clip, recorded.planes) == corner.outcode);
        corners[k].position = corner.clip;
        corners[k].weights[k] = 1;
      }
      const ClipPolygon polygon = clip_triangle(corners, recorded.planes);
      REQUIRE(polygon.count == int(triangle.polygon.size()));
      for (std::size_t k = 0; k < triangle.polygon.size(); ++k) {
        const TracedVertex& vertex = triangle.polygon[k];
        REQUIRE(same(polygon.vertices[k], vertex.clip));
        const NdcVertex ndc = divide(vertex.clip);
        REQUIRE((ndc.position == vertex.ndc.position && ndc.inverse_w == vertex.ndc.inverse_w));
        REQUIRE(same(to_screen(vertex.ndc, c.view.viewport), vertex.screen));
        REQUIRE(snap(vertex.screen) == vertex.snapped);
      }
      replay_clipping(recorded, triangle);
      for (const TracedPiece& piece : triangle.pieces) {
        for (std::size_t k = 0; k < 3; ++k) {
          REQUIRE(same(triangle.polygon[piece.polygon[k]].screen, piece.vertices[k]));
        }
        const auto setup = setup_triangle(piece.vertices);
        REQUIRE(setup.has_value() == piece.setup.has_value());
        if (!setup) continue;
        REQUIRE(setup->double_area == piece.setup->double_area);
        REQUIRE(setup->depth == piece.setup->depth);
        REQUIRE(setup->inverse_w == piece.setup->inverse_w);
        REQUIRE((piece.front == (setup->clockwise == draw.mirrored)));
      }
    }
  }
}

TEST_CASE("in a picture of edges a triangle has the vertices that it has otherwise") {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  RenderSettings edges;
  edges.wireframe = true;
  const View view = *framed(*scene);
  const Trace filled = trace(*scene, view, RenderSettings{}, {}).trace;
  const Trace outlined = trace(*scene, view, edges, {}).trace;
  REQUIRE(filled.triangles.size() == outlined.triangles.size());
  for (std::size_t i = 0; i < filled.triangles.size(); ++i) {
    REQUIRE(filled.triangles[i].polygon.size() == outlined.triangles[i].polygon.size());
  }
}

TEST_CASE("the recorded fragments follow from their triangles, bit for bit") {
  for (const TraceCase& c : trace_cases()) {
    INFO(c.name);
    const RenderSettings settings;
    const Trace recorded = trace(c.scene, c.view, settings, {}).trace;
    std::map<std::tuple<std::uint32_t, std::uint32_t>, const TracedPiece*> pieces;
    for (const TracedTriangle& triangle : recorded.triangles) {
      for (std::uint32_t i = 0; i < triangle.pieces.size(); ++i) {
        pieces[{triangle.number, i}] = &triangle.pieces[i];
      }
    }
    for (const TracedFragment& traced : recorded.fragments) {
      if (!traced.source.is_triangle) continue;
      CAPTURE(traced.source.number, traced.fragment.x, traced.fragment.y);
      const TracedPiece& piece = *pieces.at({traced.source.number, traced.source.piece});
      REQUIRE(piece.setup);
      REQUIRE(!piece.culled);
      const Fragment fragment = interpolate(*piece.setup, traced.coverage);
      REQUIRE(fragment.depth == traced.fragment.depth);
      REQUIRE(fragment.weights == traced.fragment.weights);
      REQUIRE(depth_code(settings.depth, fragment.depth) == traced.code);
      REQUIRE(in_front(traced.code, traced.stored) == (traced.result != FragmentResult::kHidden));
    }
  }
}

TEST_CASE("the last fragment that survived at a pixel is what the picture shows there") {
  for (const char* name : {"teapot", "room", "forest"}) {
    INFO(name);
    const auto scene = make_builtin(name);
    REQUIRE(scene);
    const RenderSettings settings;
    const TracedRun run = trace(*scene, *framed(*scene), settings, {});
    Image<Rgba8> last(kTraceWidth, kTraceHeight, settings.background);
    for (const TracedFragment& traced : run.trace.fragments) {
      if (traced.result != FragmentResult::kWritten && traced.result != FragmentResult::kBlended)
        continue;
      Rgba8& pixel = last.at(traced.fragment.x, traced.fragment.y);
      REQUIRE(traced.before == pixel);
      pixel = traced.after;
    }
    CHECK(last == run.rendering.buffers.color);
  }
}

TEST_CASE("filters keep what they name and nothing else") {
  const auto scene = make_builtin("teapot");
  REQUIRE(scene);
  const View view = *framed(*scene);
  const Trace all = trace(*scene, view, RenderSettings{}, {}).trace;

  TraceFilter filter;
  filter.pixels = PixelRect{40, 30, 42, 31};
  const Trace few = trace(*scene, view, RenderSettings{}, filter).trace;
  std::size_t expected = 0;
  for (const TracedFragment& traced : all.fragments) {
    const bool inside =
        traced.fragment.y == 30 && (traced.fragment.x == 40 || traced.fragment.x == 41);
    expected += inside ? 1 : 0;
  }
  CHECK(expected > 0);
  CHECK(few.fragments.size() == expected);
  CHECK(few.triangles.size() >= 1);
  CHECK(few.triangles.size() < all.triangles.size() / 10);

  filter = {};
  filter.triangle = few.fragments.front().source.number;
  const Trace one = trace(*scene, view, RenderSettings{}, filter).trace;
  REQUIRE(one.triangles.size() == 1);
  CHECK(one.triangles.front().number == *filter.triangle);

  filter = {};
  filter.max_bytes = 10000;
  const Trace cut = trace(*scene, view, RenderSettings{}, filter).trace;
  CHECK(!cut.complete);
  CHECK(cut.triangles.size() * sizeof(TracedTriangle) <= filter.max_bytes);
}

// Culls the fronts and keeps the backs: only the inside of a closed body is left.
class FrontFaceCuller : public Observer {
public:
  void facing_tested(const TriangleSetup&, bool front, bool& culled) override { culled = front; }
};

TEST_CASE("an observer that changes what a stage made has replaced the stage") {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  const View view = *framed(*scene);
  FrontFaceCuller observer;
  RenderSettings culling_fronts;
  culling_fronts.cull = Cull::kFront;
  const Rendering replaced = render_staged(*scene, view, RenderSettings{}, &observer);
  const Rendering expected = render_staged(*scene, view, culling_fronts);
  CHECK(replaced.buffers.color == expected.buffers.color);
  CHECK(!(replaced.buffers.color == render_staged(*scene, view, RenderSettings{}).buffers.color));
}

}  // namespace
}  // namespace glassbox
