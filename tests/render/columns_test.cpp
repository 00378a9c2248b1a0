// The columns of a run contain what the trace contains, in a form that other programs can read
// back.
#include <algorithm>
#include <array>
#include <cstring>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/trace/column_pack.h>
#include <glassbox/render/trace/columns.h>
#include <glassbox/render/trace/tracer.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

constexpr int kColumnsWidth = 96, kColumnsHeight = 64;

struct ColumnCase {
  std::string name;
  Scene scene;
  View view;
};

// All built-in scenes, framed; the room is seen from among its furniture, where triangles are cut.
std::vector<ColumnCase> column_cases() {
  std::vector<ColumnCase> all;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const auto scene = make_builtin(std::string(builtin.name));
    REQUIRE(scene);
    const auto camera = framing_camera(*scene, double(kColumnsWidth) / kColumnsHeight);
    REQUIRE(camera);
    const auto view = make_view(scene->cameras.empty() ? *camera : scene->cameras.front(),
                                kColumnsWidth, kColumnsHeight);
    REQUIRE(view);
    all.push_back({std::string(builtin.name), *scene, *view});
  }
  return all;
}

// The same scene from its automatic camera, with the near plane through its middle.
ColumnCase cut_in_the_middle(const ColumnCase& c) {
  auto camera = framing_camera(c.scene, double(kColumnsWidth) / kColumnsHeight);
  REQUIRE(camera);
  auto& lens = std::get<PerspectiveLens>(camera->lens);
  lens.near = (lens.near + lens.far.value()) / 2;
  const auto view = make_view(*camera, kColumnsWidth, kColumnsHeight);
  REQUIRE(view);
  return {c.name + ", cut in the middle", c.scene, *view};
}

// ---- the pack file, read back without the library ----

template <class T>
std::vector<T> unpacked(const ColumnPack& pack, const std::string& name) {
  std::size_t offset = 0;
  for (const ColumnEntry& entry : pack.entries()) {
    const std::size_t size = entry.type[1] == '8'   ? 1
                             : entry.type[1] == '1' ? 2
                             : entry.type[1] == '3' ? 4
                                                    : 8;
    if (entry.name != name) {
      offset += size * entry.count;
      continue;
    }
    REQUIRE(size == sizeof(T));
    std::vector<T> numbers(entry.count);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < entry.count; ++i) {
      std::uint64_t bits = 0;
      for (std::size_t k = 0; k < size; ++k) {
        bits |= std::uint64_t(pack.bytes()[offset + k * entry.count + i]) << (8 * k);
      }
      sum = size == 8 ? bits : sum + bits;
      std::memcpy(&numbers[i], &sum, size);  // little-endian: the low bytes come first
    }
    return numbers;
  }
  FAIL("no column " << name);
  return {};
}

template <class T>
std::vector<T> random_bits(Random& random, std::size_t count) {
  std::vector<T> numbers(count);
  for (T& number : numbers) {
    const std::uint64_t bits = random.bits();
    std::memcpy(&number, &bits, sizeof(T));
  }
  return numbers;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST_CASE("columns of every type come back to the bit, NaN and empty ones included") {
  Random random(41);
  const auto u8 = random_bits<std::uint8_t>(random, 1000);
  const auto u16 = random_bits<std::uint16_t>(random, 999);
  const auto u32 = random_bits<std::uint32_t>(random, 1001);
  const auto f32 = random_bits<float>(random, 500);
  const auto f64 = random_bits<double>(random, 77);
  ColumnPack pack;
  pack.add("u8", u8);
  pack.add("none", std::vector<float>{});
  pack.add("u16", u16);
  pack.add("u32", u32);
  pack.add("f32", f32);
  pack.add("f64", f64);
  CHECK(same_bits(unpacked<std::uint8_t>(pack, "u8"), u8));
  CHECK(same_bits(unpacked<float>(pack, "none"), {}));
  CHECK(same_bits(unpacked<std::uint16_t>(pack, "u16"), u16));
  CHECK(same_bits(unpacked<std::uint32_t>(pack, "u32"), u32));
  CHECK(same_bits(unpacked<float>(pack, "f32"), f32));
  CHECK(same_bits(unpacked<double>(pack, "f64"), f64));
  CHECK(pack.bytes().size() == 1000 + 2 * 999 + 4 * 1001 + 4 * 500 + 8 * 77);
}

// ---- a run ----

TEST_CASE("the last fragment written in each pixel is the pixel of the image") {
  for (const ColumnCase& c : column_cases()) {
    INFO(c.name);
    const ColumnRun run = record_columns(c.scene, c.view, {}, {});
    CHECK(run.rendering.buffers.color == render_staged(c.scene, c.view, {}).buffers.color);
    Image<Rgba8> replayed(kColumnsWidth, kColumnsHeight, RenderSettings{}.background);
    const FragmentColumns& f = run.fragments;
    std::size_t written = 0;
    for (std::size_t i = 0; i < f.result.size(); ++i) {
      if (f.result[i] < std::uint8_t(FragmentResult::kWritten)) continue;
      replayed.at(f.x[i], f.y[i]) = {f.written[0][written], f.written[1][written],
                                     f.written[2][written], f.written[3][written]};
      ++written;
    }
    CHECK(written == run.rendering.statistics.written);
    CHECK(f.result.size() == run.rendering.statistics.covered);
    CHECK(replayed == run.rendering.buffers.color);
  }
}

TEST_CASE("columns and the trace tell the same of every triangle and fragment") {
  for (const ColumnCase& c : column_cases()) {
    INFO(c.name);
    const ColumnRun run = record_columns(c.scene, c.view, {}, {});
    const Trace trace = glassbox::trace(c.scene, c.view, {}, {}).trace;
    REQUIRE(trace.complete);
    REQUIRE(run.fragments.result.size() == trace.fragments.size());
    bool same = true;
    for (std::size_t i = 0; i < trace.fragments.size(); ++i) {
      const TracedFragment& f = trace.fragments[i];
      same = same && run.fragments.x[i] == f.fragment.x && run.fragments.y[i] == f.fragment.y &&
             run.fragments.result[i] == std::uint8_t(f.result) &&
             run.fragments.piece[i] == f.source.piece &&
             run.fragments.triangle[i] == (f.source.is_triangle ? f.source.number : kNoTriangle);
    }
    CHECK(same);
    REQUIRE(run.triangles.number.size() == trace.triangles.size());
    std::size_t cut = 0;
    for (std::size_t i = 0; i < trace.triangles.size(); ++i) {
      const TracedTriangle& t = trace.triangles[i];
      const std::uint8_t marks = run.triangles.marks[i];
      INFO("triangle " << t.number);
      REQUIRE(run.triangles.number[i] == t.number);
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(run.triangles.position[k][i] == t.corners[k].position);
      }
      REQUIRE(((marks & (kMarkRejected | kMarkClippedAway)) != 0) == t.polygon.empty());
      const auto any = [&](const auto& is) {
        return std::any_of(t.pieces.begin(), t.pieces.end(), is);
      };
      REQUIRE(((marks & kMarkZeroArea) != 0) == any([](const TracedPiece& p) { return !p.setup; }));
      REQUIRE(((marks & kMarkCulled) != 0) == any([](const TracedPiece& p) { return p.culled; }));
      REQUIRE(((marks & kMarkSetUp) != 0) ==
              any([](const TracedPiece& p) { return p.setup && !p.culled; }));
      if (!(marks & kMarkCut)) continue;
      REQUIRE(run.cut[cut].number == t.number);
      REQUIRE(run.cut[cut].polygon.count == int(t.polygon.size()));
      for (std::size_t k = 0; k < t.polygon.size(); ++k) {
        REQUIRE(run.cut[cut].polygon.vertices[k].position == t.polygon[k].clip.position);
        REQUIRE(run.cut[cut].polygon.vertices[k].weights == t.polygon[k].clip.weights);
      }
      ++cut;
    }
    CHECK(cut == run.cut.size());
    CHECK(cut == run.rendering.statistics.clipped);
  }
}

TEST_CASE("a rectangle leaves exactly its own fragments, and their triangles") {
  const ColumnCase room = [] {
    for (ColumnCase& c : column_cases()) {
      if (c.name == "room") return std::move(c);
    }
    FAIL("there is no room");
    return ColumnCase{};
  }();
  const PixelRect part{30, 20, 50, 41};
  const ColumnRun all = record_columns(room.scene, room.view, {}, {});
  const ColumnRun some = record_columns(room.scene, room.view, {}, {part});
  std::vector<std::array<std::uint32_t, 4>> expected, found;
  const auto list = [](const FragmentColumns& f, const PixelRect& rect, auto& out) {
    for (std::size_t i = 0; i < f.result.size(); ++i) {
      if (f.x[i] >= rect.x0 && f.x[i] < rect.x1 && f.y[i] >= rect.y0 && f.y[i] < rect.y1) {
        out.push_back({f.triangle[i], f.x[i], f.y[i], f.result[i]});
      }
    }
  };
  list(all.fragments, part, expected);
  list(some.fragments, {0, 0, kColumnsWidth, kColumnsHeight}, found);
  CHECK(found == expected);
  CHECK_FALSE(found.empty());
  CHECK(some.triangles.number.size() < all.triangles.number.size());
  for (const auto& fragment : found) {
    CHECK(std::count(some.triangles.number.begin(), some.triangles.number.end(), fragment[0]) == 1);
  }
}

TEST_CASE("a rectangle leaves the triangles that cover it, or would if they were not clipped") {
  Random random(43);
  std::size_t cut_away = 0;
  std::vector<ColumnCase> cases = column_cases();
  for (const ColumnCase& whole : column_cases()) cases.push_back(cut_in_the_middle(whole));
  for (const ColumnCase& c : cases) {
    for (int i = 0; i < 4; ++i) {
      const int x = int(random.integer(0, kColumnsWidth - 8));
      const int y = int(random.integer(0, kColumnsHeight - 8));
      const PixelRect part{x, y, x + 8, y + 8};
      INFO(c.name << ", " << x << ", " << y);
      const TriangleColumns found = record_columns(c.scene, c.view, {}, {part}).triangles;
      TraceFilter filter;
      filter.pixels = part;
      std::vector<std::uint32_t> expected;
      for (const TracedTriangle& t : glassbox::trace(c.scene, c.view, {}, filter).trace.triangles) {
        expected.push_back(t.number);
      }
      CHECK(found.number == expected);
      cut_away +=
          std::size_t(std::count_if(found.marks.begin(), found.marks.end(), [](std::uint8_t marks) {
            return (marks & (kMarkRejected | kMarkClippedAway)) != 0;
          }));
    }
  }
  CHECK(cut_away > 0);
}

TEST_CASE("beyond the limits nothing is kept, but all is counted") {
  const ColumnCase c = column_cases().front();
  const ColumnRun all = record_columns(c.scene, c.view, {}, {});
  ColumnFilter filter;
  filter.max_triangles = 7;
  filter.max_fragments = 11;
  const ColumnRun some = record_columns(c.scene, c.view, {}, filter);
  CHECK(some.triangles.number.size() == 7);
  CHECK(some.fragments.result.size() == 11);
  CHECK(some.triangle_count == all.triangles.number.size());
  CHECK(some.fragment_count == all.fragments.result.size());
  CHECK(some.rendering.buffers.color == all.rendering.buffers.color);
}

TEST_CASE("a masked channel stays in the columns what it is in the picture") {
  const ColumnCase c = column_cases().front();
  RenderSettings settings;
  settings.mask = {true, false, false, true};
  const ColumnRun run = record_columns(c.scene, c.view, settings, {});
  CHECK(std::all_of(run.fragments.written[1].begin(), run.fragments.written[1].end(),
                    [&](std::uint8_t g) { return g == settings.background.g; }));
  CHECK(std::any_of(run.fragments.written[0].begin(), run.fragments.written[0].end(),
                    [&](std::uint8_t r) { return r != settings.background.r; }));
}

}  // namespace
}  // namespace glassbox
