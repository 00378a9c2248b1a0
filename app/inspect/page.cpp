#include "app/inspect/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/inspect/manifest.h"
#include "inspect_page.h"  // made by html/embed.cmake

#include <glassbox/compare/report/page_blob.h>
#include <glassbox/html/blob.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/column_pack.h>
#include <glassbox/render/trace/columns.h>
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
  std::array<std::vector<float>, 3> position;
  for (std::size_t m = 0; m < used.size(); ++m) {
    meshes.push_back({{"name", scene.meshes[m].name}, {"positions", used[m].index.size()}});
    for (const std::uint32_t i : used[m].index) {
      const Point<Object>& p = scene.meshes[m].positions[i];
      index.push_back(i);
      position[0].push_back(p.x);
      position[1].push_back(p.y);
      position[2].push_back(p.z);
    }
  }
  pack.add("position.index", index);
  pack.add("position.x", position[0]);
  pack.add("position.y", position[1]);
  pack.add("position.z", position[2]);
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
  std::vector<std::uint32_t> number;
  std::vector<std::uint8_t> count;
  std::vector<float> clip;
  std::vector<double> weights;
  for (const CutTriangle& cut : run.cut) {
    number.push_back(cut.number);
    count.push_back(std::uint8_t(cut.polygon.count));
    for (int k = 0; k < cut.polygon.count; ++k) {
      const ClipVertex& vertex = cut.polygon.vertices[std::size_t(k)];
      const auto& p = vertex.position;
      clip.insert(clip.end(), {p.x, p.y, p.z, p.w});
      weights.insert(weights.end(), vertex.weights.begin(), vertex.weights.end());
    }
  }
  pack.add("cut.number", number);
  pack.add("cut.count", count);
  pack.add("cut.clip", clip);
  pack.add("cut.weights", weights);
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

template <std::size_t N>
void append(std::vector<float>& column, const std::array<float, N>& numbers) {
  column.insert(column.end(), numbers.begin(), numbers.end());
}
void append(std::vector<float>& column, const Rgba& color) {
  column.insert(column.end(), {color.r, color.g, color.b, color.a});
}

void add_fragment_records(const Trace& trace, ColumnPack& pack) {
  std::vector<double> edges;
  std::vector<float> lambda, weights, depth, inverse_w;
  std::vector<std::uint32_t> code, stored;
  std::vector<float> normal, position, diffuse, specular, color, texcoord, surface, light;
  std::vector<std::uint8_t> before, after;
  for (const TracedFragment& f : trace.fragments) {
    for (const std::int64_t edge : f.coverage.edges) edges.push_back(double(edge));  // below 2^52
    append(lambda, f.fragment.lambda);
    append(weights, f.fragment.weights);
    depth.push_back(f.fragment.depth);
    inverse_w.push_back(f.fragment.inverse_w);
    code.push_back(f.code);
    stored.push_back(f.stored);
    append(normal, f.at.normal);
    append(position, f.at.position);
    append(diffuse, f.at.diffuse);
    append(specular, f.at.specular);
    append(color, f.at.color);
    append(texcoord, f.at.texcoord);
    append(surface, f.surface);
    append(light, f.light);
    before.insert(before.end(), {f.before.r, f.before.g, f.before.b, f.before.a});
    after.insert(after.end(), {f.after.r, f.after.g, f.after.b, f.after.a});
  }
  pack.add("record.edges", edges);
  pack.add("record.lambda", lambda);
  pack.add("record.weights", weights);
  pack.add("record.depth", depth);
  pack.add("record.inverse_w", inverse_w);
  pack.add("record.code", code);
  pack.add("record.stored", stored);
  pack.add("record.normal", normal);
  pack.add("record.position", position);
  pack.add("record.diffuse", diffuse);
  pack.add("record.specular", specular);
  pack.add("record.color", color);
  pack.add("record.texcoord", texcoord);
  pack.add("record.surface", surface);
  pack.add("record.light", light);
  pack.add("record.before", before);
  pack.add("record.after", after);
}

// What is known of a triangle besides its record.
struct KnownTriangle {
  const TracedTriangle* triangle = nullptr;
  TriangleBounds bounds;
};

std::map<std::uint32_t, KnownTriangle> bounds_of_all(const Trace& trace) {
  std::map<std::uint32_t, KnownTriangle> known;
  std::map<std::uint32_t, const TracedDraw*> draws;
  std::map<std::uint32_t, DrawBounds> of_draw;
  for (const TracedDraw& draw : trace.draws) {
    draws[draw.instance] = &draw;
    of_draw[draw.instance] = bounds_of(draw, trace.view);
  }
  for (const TracedTriangle& t : trace.triangles) {
    known[t.number] = {&t, bounds_of(trace, t, *draws.at(t.instance), of_draw.at(t.instance))};
  }
  return known;
}

void append(std::vector<double>& column, const glm::dvec3& v) {
  column.insert(column.end(), {v.x, v.y, v.z});
}
void append(std::vector<double>& column, const glm::dvec4& v) {
  column.insert(column.end(), {v.x, v.y, v.z, v.w});
}

void add_bounds(const Trace& trace, ColumnPack& pack) {
  const auto known = bounds_of_all(trace);
  std::vector<double> world, eye, clip, ndc, screen, fragment;
  for (const TracedTriangle& t : trace.triangles) {
    const TriangleBounds& bounds = known.at(t.number).bounds;
    for (const CornerBounds& corner : bounds.corners) {
      append(world, corner.world);
      append(eye, corner.eye);
      append(clip, corner.clip);
    }
    for (const VertexBounds& vertex : bounds.polygon) {
      append(ndc, glm::dvec4(vertex.ndc.position, vertex.ndc.inverse_w));
      append(screen, vertex.screen);
    }
  }
  for (const TracedFragment& f : trace.fragments) {
    FragmentBounds bounds;
    if (const auto found = known.find(f.source.number);
        f.source.is_triangle && found != known.end()) {
      const TracedPiece& piece = found->second.triangle->pieces[f.source.piece];
      bounds = fragment_bounds(*piece.setup, f.fragment, setup_bounds(piece, found->second.bounds));
    }
    fragment.insert(fragment.end(), bounds.lambda.begin(), bounds.lambda.end());
    fragment.insert(fragment.end(), bounds.weights.begin(), bounds.weights.end());
    fragment.insert(fragment.end(), {bounds.depth, bounds.inverse_w});
  }
  pack.add("bound.world", world);
  pack.add("bound.eye", eye);
  pack.add("bound.clip", clip);
  pack.add("bound.ndc", ndc);
  pack.add("bound.screen", screen);
  pack.add("bound.fragment", fragment);
}

void add_triangle_records(const Trace& trace, ColumnPack& pack) {
  std::vector<std::uint32_t> number, outcode;
  std::vector<std::uint8_t> vertices, pieces, flags;
  std::vector<double> world, eye, area;
  std::vector<float> clip, ndc, screen, inverse_area;
  for (const TracedTriangle& t : trace.triangles) {
    number.push_back(t.number);
    for (const TracedCorner& c : t.corners) {
      world.insert(world.end(), {c.world.x, c.world.y, c.world.z});
      eye.insert(eye.end(), {c.eye.x, c.eye.y, c.eye.z});
      clip.insert(clip.end(), {c.clip.x, c.clip.y, c.clip.z, c.clip.w});
      outcode.push_back(c.outcode);
    }
    vertices.push_back(std::uint8_t(t.polygon.size()));
    for (const TracedVertex& v : t.polygon) {
      ndc.insert(ndc.end(),
                 {v.ndc.position.x, v.ndc.position.y, v.ndc.position.z, v.ndc.inverse_w});
      screen.insert(screen.end(), {v.screen.position.x, v.screen.position.y, v.screen.position.z});
    }
    pieces.push_back(std::uint8_t(t.pieces.size()));
    for (const TracedPiece& p : t.pieces) {
      area.push_back(p.setup ? double(p.setup->double_area) : 0);
      inverse_area.push_back(p.setup ? p.setup->inverse_area : 0);
      flags.push_back(std::uint8_t((p.setup && p.setup->clockwise ? 1 : 0) | (p.front ? 2 : 0) |
                                   (p.culled ? 4 : 0)));
    }
  }
  pack.add("traced.number", number);
  pack.add("traced.world", world);
  pack.add("traced.eye", eye);
  pack.add("traced.clip", clip);
  pack.add("traced.outcode", outcode);
  pack.add("traced.vertices", vertices);
  pack.add("traced.ndc", ndc);
  pack.add("traced.screen", screen);
  pack.add("traced.pieces", pieces);
  pack.add("traced.area", area);
  pack.add("traced.inverse_area", inverse_area);
  pack.add("traced.flags", flags);
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

  const ColumnRun run = record_columns(
      scene, view, settings, {options.rectangle, options.max_triangles, options.max_fragments});
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
    manifest["recorded"] = {pixels->x0, pixels->y0, pixels->x1, pixels->y1};
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
