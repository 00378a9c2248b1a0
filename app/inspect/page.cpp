#include "app/inspect/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/inspect/manifest.h"
#include "app/report/number_json.h"
#include "inspect_page.h"  // made by html/embed.cmake

#include <glassbox/base/arithmetic.h>
#include <glassbox/compare/report/page_blob.h>
#include <glassbox/html/blob.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/column_pack.h>
#include <glassbox/render/trace/columns.h>
#include <glassbox/render/trace/fields.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox::app {
namespace {

using Json = nlohmann::ordered_json;

// All records of this many fragments are about 6 MB of the page; those of more are left out.
constexpr std::uint64_t kMaxRecords = 30'000;

Json entries_json(const ColumnPack& pack) {
  Json json = Json::array();
  for (const ColumnEntry& entry : pack.entries()) {
    json.push_back({entry.name, entry.type, entry.count});
  }
  return json;
}

// ---- columns ----

// What a column gets of a record: a number, or several one after the other.
template <Arithmetic T>
std::array<T, 1> numbers_of(T number) {
  return {number};
}
template <class T, std::size_t N>
std::array<T, N> numbers_of(const std::array<T, N>& numbers) {
  return numbers;
}
template <int N, class T>
std::array<T, std::size_t(N)> numbers_of(const glm::vec<N, T>& v) {
  std::array<T, std::size_t(N)> numbers;
  for (int i = 0; i < N; ++i) numbers[std::size_t(i)] = v[i];
  return numbers;
}

template <class Record, class Pick>
void add_column(ColumnPack& pack, const char* name, const std::vector<Record>& records,
                const Pick& pick) {
  using Numbers = decltype(numbers_of(pick(records[0])));
  std::vector<typename Numbers::value_type> column;
  for (const Record& record : records) {
    const Numbers numbers = numbers_of(pick(record));
    column.insert(column.end(), numbers.begin(), numbers.end());
  }
  pack.add(name, column);
}

// The corners, vertices or pieces of all records, one after the other.
template <class Record, class PartsOf>
auto parts_of(const std::vector<Record>& records, PartsOf parts) {
  using Parts = std::remove_cvref_t<std::invoke_result_t<PartsOf, const Record&>>;
  std::vector<typename Parts::value_type> all;
  for (const Record& record : records) {
    all.insert(all.end(), (record.*parts).begin(), (record.*parts).end());
  }
  return all;
}

// ---- geometry ----

// The positions of each mesh that its triangles name, and where in the mesh they stand.
struct UsedPositions {
  std::vector<std::uint32_t> index;  // index into Mesh::positions
  std::vector<std::uint32_t> place;  // where an index into Mesh::positions went
};

std::vector<UsedPositions> used_positions(const Scene& scene, const ColumnRun& run) {
  std::vector<UsedPositions> used(scene.meshes.size());
  std::size_t row = 0;
  for (std::size_t d = 0; d < run.draws.size(); ++d) {
    const std::uint32_t mesh = scene.instances[run.draws[d].instance].mesh;
    used[mesh].place.resize(scene.meshes[mesh].positions.size(), kNone);
    for (std::uint32_t i = 0; i < run.triangles_of_draw[d]; ++i, ++row) {
      for (const auto& column : run.triangles.position) used[mesh].place[column[row]] = 0;
    }
  }
  for (UsedPositions& one : used) {
    for (std::uint32_t i = 0; i < one.place.size(); ++i) {
      if (one.place[i] == kNone) continue;
      one.place[i] = std::uint32_t(one.index.size());
      one.index.push_back(i);
    }
  }
  return used;
}

void add_positions(const Scene& scene, const std::vector<UsedPositions>& used, ColumnPack& pack,
                   Json& meshes) {
  std::vector<std::uint32_t> index;
  std::vector<Point<Object>> positions;
  for (std::size_t m = 0; m < used.size(); ++m) {
    meshes.push_back({{"name", scene.meshes[m].name}, {"positions", used[m].index.size()}});
    for (const std::uint32_t i : used[m].index) {
      index.push_back(i);
      positions.push_back(scene.meshes[m].positions[i]);
    }
  }
  pack.add("position.index", index);
  add_column(pack, "position.x", positions, [](const auto& p) { return p.x; });
  add_column(pack, "position.y", positions, [](const auto& p) { return p.y; });
  add_column(pack, "position.z", positions, [](const auto& p) { return p.z; });
}

void add_triangles(const Scene& scene, const ColumnRun& run, const std::vector<UsedPositions>& used,
                   ColumnPack& pack) {
  std::array<std::vector<std::uint32_t>, 3> corners = run.triangles.position;
  std::size_t row = 0;
  for (std::size_t d = 0; d < run.draws.size(); ++d) {
    const UsedPositions& of_mesh = used[scene.instances[run.draws[d].instance].mesh];
    for (std::uint32_t i = 0; i < run.triangles_of_draw[d]; ++i, ++row) {
      for (auto& column : corners) column[row] = of_mesh.place[column[row]];
    }
  }
  pack.add("triangle.number", run.triangles.number);
  pack.add("triangle.face", run.triangles.face);
  pack.add("triangle.a", corners[0]);
  pack.add("triangle.b", corners[1]);
  pack.add("triangle.c", corners[2]);
  pack.add("triangle.marks", run.triangles.marks);
}

void add_cut_triangles(const ColumnRun& run, ColumnPack& pack) {
  std::vector<ClipVertex> vertices;
  for (const CutTriangle& cut : run.cut) {
    const auto begin = cut.polygon.vertices.begin();
    vertices.insert(vertices.end(), begin, begin + cut.polygon.count);
  }
  add_column(pack, "cut.number", run.cut, [](const auto& cut) { return cut.number; });
  add_column(pack, "cut.count", run.cut,
             [](const auto& cut) { return std::uint8_t(cut.polygon.count); });
  add_column(pack, "cut.clip", vertices, [](const auto& v) { return to_glm(v.position); });
  add_column(pack, "cut.weights", vertices, [](const auto& v) { return v.weights; });
}

// ---- fragments ----

void add_fragments(const FragmentColumns& fragments, ColumnPack& pack) {
  pack.add("fragment.triangle", fragments.triangle);
  pack.add("fragment.piece", fragments.piece);
  pack.add("fragment.x", fragments.x);
  pack.add("fragment.y", fragments.y);
  pack.add("fragment.fate", fragments.fate);
  constexpr std::array kChannels{"written.r", "written.g", "written.b", "written.a"};
  for (std::size_t k = 0; k < 4; ++k) pack.add(kChannels[k], fragments.written[k]);
  pack.add("fragment.code", fragments.code);
}

// ---- all records of a few pixels ----

void add_fragment_records(const Trace& trace, ColumnPack& pack) {
  const auto add = [&](const char* name, const auto& pick) {
    add_column(pack, name, trace.fragments, pick);
  };
  add("record.edges", [](const TracedFragment& f) {
    const auto& [a, b, c] = f.coverage.edges;
    return glm::dvec3(double(a), double(b), double(c));  // below 2^52
  });
  add("record.lambda", [](const TracedFragment& f) { return f.fragment.lambda; });
  add("record.weights", [](const TracedFragment& f) { return f.fragment.weights; });
  add("record.depth", [](const TracedFragment& f) { return f.fragment.depth; });
  add("record.inverse_w", [](const TracedFragment& f) { return f.fragment.inverse_w; });
  add("record.code", [](const TracedFragment& f) { return f.code; });
  add("record.stored", [](const TracedFragment& f) { return f.stored; });
  add("record.normal", [](const TracedFragment& f) { return f.at.normal; });
  add("record.position", [](const TracedFragment& f) { return f.at.position; });
  add("record.diffuse", [](const TracedFragment& f) { return f.at.diffuse; });
  add("record.specular", [](const TracedFragment& f) { return f.at.specular; });
  add("record.color", [](const TracedFragment& f) { return f.at.color; });
  add("record.texcoord", [](const TracedFragment& f) { return f.at.texcoord; });
  add("record.surface", [](const TracedFragment& f) { return f.surface; });
  add("record.light", [](const TracedFragment& f) { return f.light; });
  add("record.before", [](const TracedFragment& f) { return f.before; });
  add("record.after", [](const TracedFragment& f) { return f.after; });
}

void add_triangle_records(const Trace& trace, ColumnPack& pack) {
  const auto& triangles = trace.triangles;
  const auto corners = parts_of(triangles, &TracedTriangle::corners);
  const auto polygons = parts_of(triangles, &TracedTriangle::polygon);
  const auto pieces = parts_of(triangles, &TracedTriangle::pieces);
  add_column(pack, "traced.number", triangles, [](const auto& t) { return t.number; });
  add_column(pack, "traced.world", corners, [](const auto& c) { return to_glm(c.world); });
  add_column(pack, "traced.eye", corners, [](const auto& c) { return to_glm(c.eye); });
  add_column(pack, "traced.clip", corners, [](const auto& c) { return to_glm(c.clip); });
  add_column(pack, "traced.outcode", corners, [](const auto& c) { return c.outcode; });
  add_column(pack, "traced.vertices", triangles,
             [](const auto& t) { return std::uint8_t(t.polygon.size()); });
  add_column(pack, "traced.ndc", polygons, [](const TracedVertex& v) {
    return glm::vec4(to_glm(v.ndc.position), v.ndc.inverse_w);
  });
  add_column(pack, "traced.screen", polygons,
             [](const auto& v) { return to_glm(v.screen.position); });
  add_column(pack, "traced.pieces", triangles,
             [](const auto& t) { return std::uint8_t(t.pieces.size()); });
  add_column(pack, "traced.area", pieces,
             [](const auto& p) { return p.setup ? double(p.setup->double_area) : 0; });
  add_column(pack, "traced.inverse_area", pieces,
             [](const auto& p) { return p.setup ? p.setup->inverse_area : 0; });
  add_column(pack, "traced.flags", pieces, [](const TracedPiece& p) {
    return std::uint8_t((p.setup && p.setup->clockwise ? 1 : 0) | (p.front ? 2 : 0) |
                        (p.culled ? 4 : 0));
  });
}

void add_bounds(const Trace& trace, ColumnPack& pack) {
  const auto known = bounds_of_all(trace);
  std::vector<TriangleBounds> triangles;
  for (const TracedTriangle& t : trace.triangles) triangles.push_back(known.at(t.number).bounds);
  const auto corners = parts_of(triangles, &TriangleBounds::corners);
  const auto polygons = parts_of(triangles, &TriangleBounds::polygon);
  add_column(pack, "bound.world", corners, [](const auto& c) { return c.world; });
  add_column(pack, "bound.eye", corners, [](const auto& c) { return c.eye; });
  add_column(pack, "bound.clip", corners, [](const auto& c) { return c.clip; });
  add_column(pack, "bound.ndc", polygons,
             [](const auto& v) { return glm::dvec4(v.ndc.position, v.ndc.inverse_w); });
  add_column(pack, "bound.screen", polygons, [](const auto& v) { return v.screen; });
  add_column(pack, "bound.fragment", trace.fragments, [&](const TracedFragment& f) {
    const auto found = known.find(f.source.number);
    const bool is_known = f.source.is_triangle && found != known.end();
    const FragmentBounds b = is_known ? bounds_of(found->second, f) : FragmentBounds{};
    return std::array{b.lambda[0],  b.lambda[1],  b.lambda[2], b.weights[0],
                      b.weights[1], b.weights[2], b.depth,     b.inverse_w};
  });
}

// ---- pictures ----

Result<std::string> picture_text(const Image<Rgba8>& image) {
  std::vector<std::uint8_t> samples;
  samples.reserve(image.pixels.size() * 4);
  for (const Rgba8& p : image.pixels) samples.insert(samples.end(), {p.r, p.g, p.b, p.a});
  const PixelBox all{0, 0, image.width, image.height};
  return encode_blob(StoredImage{image.width, image.height, 4, std::move(samples)},
                     std::span(&all, 1));
}

// Normals in place of the colours.
Image<Rgba8> normals_of(const Scene& scene, const View& view, RenderSettings settings) {
  settings.show = Show::kNormal;
  settings.background = {0, 0, 0, 0};
  return std::move(render_staged(scene, view, settings).buffers.color);
}

// ---- limits ----

Result<void> check_limits(const ColumnRun& run, const InspectOptions& options) {
  const auto too_much = [&](const char* what, std::uint64_t count, std::uint64_t limit,
                            const char* option) {
    return fail(
        options.scene_name,
        fmt::format("{} {} are more than the {} that a page is meant for", count, what, limit),
        fmt::format("name a part of the picture with --rect X0,Y0,X1,Y1, or a smaller "
                    "--size; {} allows more, in a page that opens slowly",
                    option));
  };
  if (run.triangle_count > options.max_triangles) {
    return too_much("triangles", run.triangle_count, options.max_triangles, "--max-triangles");
  }
  if (run.fragment_count > options.max_fragments) {
    return too_much("fragments", run.fragment_count, options.max_fragments, "--max-fragments");
  }
  return {};
}

std::optional<PixelRect> recorded_pixels(const InspectOptions& options) {
  if (options.rectangle) return options.rectangle;
  if (options.pixel) {
    const auto [x, y] = *options.pixel;
    return PixelRect{x, y, x + 1, y + 1};
  }
  return {};
}

}  // namespace

Result<PageFacts> make_inspect_page(const Scene& scene, const Camera& camera, const View& view,
                                    const RenderSettings& asked, const InspectOptions& options) {
  // Depth, triangle ids and overdraw are overlays of the page; under them lies the picture.
  RenderSettings settings = at_centres(asked);
  if (asked.show != Show::kNormal && asked.show != Show::kUv) settings.show = Show::kColor;

  const ColumnRun run = record_columns(scene, view, settings,
                                       {.pixels = options.rectangle,
                                        .max_triangles = options.max_triangles,
                                        .max_fragments = options.max_fragments},
                                       options.stages);
  if (const auto fits = check_limits(run, options); !fits) return tl::unexpected(fits.error());

  Json manifest = manifest_of(scene, camera, view, settings, options, run);
  manifest["opening_overlay"] = asked.show == Show::kDepth      ? "depth"
                                : asked.show == Show::kId       ? "id"
                                : asked.show == Show::kOverdraw ? "overdraw"
                                                                : "none";
  ColumnPack pack;
  const std::vector<UsedPositions> used = used_positions(scene, run);
  add_positions(scene, used, pack, manifest["meshes"]);
  add_triangles(scene, run, used, pack);
  add_cut_triangles(run, pack);
  add_fragments(run.fragments, pack);
  if (const auto pixels = recorded_pixels(options)) {
    manifest["recorded"] = numbers_json(*pixels);
    TraceFilter filter;
    filter.pixels = pixels;
    filter.max_bytes = kMaxRecords * sizeof(TracedFragment);
    const Trace trace = glassbox::trace(scene, view, settings, filter).trace;
    manifest["records_complete"] = trace.complete;
    if (trace.complete) {
      add_fragment_records(trace, pack);
      add_triangle_records(trace, pack);
      add_bounds(trace, pack);
    }
  }
  if (!options.student.empty()) manifest["student"] = Json::parse(options.student);
  if (options.made != nullptr) manifest["opening_overlay"] = "made";
  manifest["columns"] = entries_json(pack);

  std::string blobs;
  const auto add_blob = [&](const char* id, const Result<std::string>& text) -> Result<void> {
    if (!text) return tl::unexpected(text.error());
    blobs += data_block(id, *text);
    return {};
  };
  if (const auto added = add_blob("columns", packed_text(pack.bytes())); !added) {
    return tl::unexpected(added.error());
  }
  const auto normals = add_blob("normals", picture_text(normals_of(scene, view, settings)));
  if (!normals) return tl::unexpected(normals.error());
  manifest["pictures"] = Json::array();
  const std::pair<const char*, const Image<Rgba8>*> others[] = {
      {"reference", options.reference}, {"made", options.made}, {"truth", options.truth}};
  for (const auto& [name, picture] : others) {
    if (picture == nullptr) continue;
    manifest["pictures"].push_back(name);
    if (const auto added = add_blob(name, picture_text(*picture)); !added)
      return tl::unexpected(added.error());
  }
  // What other fragments made of the rest of the picture.
  if (options.rectangle) {
    const auto rest = add_blob("picture", picture_text(run.rendering.buffers.color));
    if (!rest) return tl::unexpected(rest.error());
  }
  return PageFacts{
      assemble_page(kInspectPage, "glassbox inspect", json_block("manifest", manifest) + blobs),
      run.triangle_count, run.fragment_count};
}

}  // namespace glassbox::app
