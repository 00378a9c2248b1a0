// A trace is what the run did: each recorded step, applied to its recorded input, gives its recorded output.
#include <map>
#include <tuple>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/trace/tracer.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr int kWidth = 96, kHeight = 64;

struct Case {
  std::string name;
  Scene scene;
  View view;
};

View framed(const Scene& scene) {
  const auto automatic = frame(scene, double(kWidth) / kHeight);
  REQUIRE(automatic);
  const auto view =
      make_view(scene.cameras.empty() ? *automatic : scene.cameras.front(), kWidth, kHeight);
  REQUIRE(view);
  return *view;
}

// All built-in scenes, and the room from so near that much of it is clipped.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const auto scene = make_builtin(std::string(builtin.name));
    REQUIRE(scene);
    all.push_back({std::string(builtin.name), *scene, framed(*scene)});
  }
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

TEST_CASE("a run that is traced gives the bytes of one that is not") {
  for (const Case& c : cases()) {
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
  for (const Case& c : cases()) {
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
      }
      for (const TracedPiece& piece : triangle.pieces) {
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

TEST_CASE("the recorded fragments follow from their triangles, bit for bit") {
  for (const Case& c : cases()) {
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
      REQUIRE(in_front(traced.code, traced.stored) == (traced.fate != Fate::kHidden));
    }
  }
}

TEST_CASE("the last fragment that survived at a pixel is what the picture shows there") {
  for (const char* name : {"teapot", "room", "forest"}) {
    INFO(name);
    const auto scene = make_builtin(name);
    REQUIRE(scene);
    const RenderSettings settings;
    const TracedRun run = trace(*scene, framed(*scene), settings, {});
    Image<Rgba8> last(kWidth, kHeight, settings.background);
    for (const TracedFragment& traced : run.trace.fragments) {
      if (traced.fate != Fate::kWritten && traced.fate != Fate::kBlended) continue;
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
  const View view = framed(*scene);
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

// Turns every triangle over: nothing of a closed body is left but its inside.
class TurnedOver : public Observer {
public:
  void faced(const TriangleSetup&, bool front, bool& culled) override { culled = front; }
};

TEST_CASE("an observer that changes what a stage made has replaced the stage") {
  const auto scene = make_builtin("cube");
  REQUIRE(scene);
  const View view = framed(*scene);
  TurnedOver observer;
  RenderSettings culling_fronts;
  culling_fronts.cull = Cull::kFront;
  const Rendering replaced = render_staged(*scene, view, RenderSettings{}, &observer);
  const Rendering expected = render_staged(*scene, view, culling_fronts);
  CHECK(replaced.buffers.color == expected.buffers.color);
  CHECK(!(replaced.buffers.color == render_staged(*scene, view, RenderSettings{}).buffers.color));
}

}  // namespace
}  // namespace glassbox
