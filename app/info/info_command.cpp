// glassbox info SCENE: prints what is in a scene, and what is wrong with it.
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/info/info_sections.h"
#include "app/info/info_tables.h"
#include "app/why/verdict_text.h"
#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/output_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/check.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/formats/load_memory.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::app {

class InfoCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  int tell_of_layers() const;  // reports on the file of a layered depth image
  Result<void> check_options() const;

  std::string scene_;
  std::optional<std::string> json_output_;
  std::optional<std::string> glb_output_;
  bool has_tables_ = false;
  std::optional<std::uint32_t> rows_;  // of each table
};

namespace {

using Json = nlohmann::ordered_json;

template <class Space>
Json bounds_json(const Box<Space>& box) {
  if (box.empty()) return nullptr;
  return {{"low", {box.low.x, box.low.y, box.low.z}},
          {"high", {box.high.x, box.high.y, box.high.z}}};
}

template <class Space>
std::string bounds_text(const Box<Space>& box) {
  if (box.empty()) return "nothing";
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", box.low.x, box.low.y,
                     box.low.z, box.high.x, box.high.y, box.high.z);
}

// Names, lists of extensions and warnings are cut after this number of characters.
constexpr std::size_t kLongText = 1000;

constexpr std::uint32_t kUsualRows = 20;

std::string alpha_name(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::kOpaque:
      return "opaque";
    case AlphaMode::kMask:
      return "mask";
    case AlphaMode::kBlend:
      return "blend";
  }
  return "";
}

std::string lens_name(const Lens& lens) {
  if (std::holds_alternative<OrthographicLens>(lens)) return "orthographic";
  return std::holds_alternative<FrustumLens>(lens) ? "frustum" : "perspective";
}

// The findings about a mesh, one phrase each; none for a mesh without findings. Open edges are
// listed, though they are no fault.
std::vector<std::string> findings(const MeshReport& report) {
  std::vector<std::string> found;
  const auto count = [&](std::uint64_t n, const char* one, const char* many) {
    if (n > 0) found.push_back(counted(n, one, many));
  };
  count(report.open_edges, "open edge", "open edges");
  count(report.non_manifold_edges, "edge with more than two faces",
        "edges with more than two faces");
  count(report.inconsistent_edges, "edge where the winding changes",
        "edges where the winding changes");
  count(report.pinched_vertices, "pinched vertex", "pinched vertices");
  count(report.degenerate_faces, "face without area", "faces without area");
  count(report.degenerate_triangles, "triangle without area", "triangles without area");
  count(report.self_intersecting_faces, "face that crosses itself", "faces that cross themselves");
  if (report.quads_in_z_order > 0) {
    found.push_back(counted(report.quads_in_z_order, "quad") +
                    " in Z order (proper if the last two corners are exchanged)");
  }
  count(report.duplicate_faces, "duplicate face", "duplicate faces");
  if (report.non_planar_faces > 0) {
    found.push_back(
        fmt::format("{} (the worst is face {}: a corner is {:.3g} object units off its plane)",
                    counted(report.non_planar_faces, "bent face"), report.worst_planarity_face,
                    report.worst_planarity_deviation));
  }
  count(report.unused_positions, "unused vertex", "unused vertices");
  return found;
}

// The attributes of the mesh's corners besides a position.
std::vector<std::string> attributes(const Mesh& mesh) {
  std::vector<std::string> names;
  if (!mesh.normals.empty()) names.push_back("normals");
  if (!mesh.texcoords.empty()) names.push_back("texture coordinates");
  if (!mesh.colors.empty()) names.push_back("colours");
  return names;
}

Json mesh_json(const Mesh& mesh, const MeshReport& report) {
  Json json{{"name", mesh.name},
            {"material", mesh.material},
            {"attributes", attributes(mesh)},
            {"positions", report.positions},
            {"vertices", report.vertices},
            {"faces", report.faces},
            {"triangles", report.triangles},
            {"lines", report.lines},
            {"points", report.points},
            {"bounds", bounds_json(report.bounds)},
            {"area", report.area},
            {"edges", report.edges},
            {"open_edges", report.open_edges},
            {"non_manifold_edges", report.non_manifold_edges},
            {"inconsistent_edges", report.inconsistent_edges},
            {"pinched_vertices", report.pinched_vertices},
            {"unused_vertices", report.unused_positions},
            {"components", report.components},
            {"euler_characteristic", report.euler_characteristic},
            {"closed", report.closed}};
  json["genus"] = report.genus ? Json(*report.genus) : Json(nullptr);
  json["degenerate_faces"] = report.degenerate_faces;
  json["degenerate_triangles"] = report.degenerate_triangles;
  json["self_intersecting_faces"] = report.self_intersecting_faces;
  json["quads_in_z_order"] = report.quads_in_z_order;
  json["duplicate_faces"] = report.duplicate_faces;
  json["non_planar_faces"] = report.non_planar_faces;
  json["worst_planarity_deviation"] = report.worst_planarity_deviation;
  json["findings"] = findings(report);
  return json;
}

struct Totals {
  std::uint64_t triangles = 0, lines = 0, points = 0;  // as drawn: counted once for each instance
};

Totals totals(const Scene& scene, const std::vector<MeshReport>& reports) {
  Totals sum;
  for (const Instance& instance : scene.instances) {
    sum.triangles += reports[instance.mesh].triangles;
    sum.lines += reports[instance.mesh].lines;
    sum.points += reports[instance.mesh].points;
  }
  return sum;
}

std::array<float, 3> emission_of(const Material& material) {
  return emits_light(material) ? material.emission : std::array<float, 3>{0, 0, 0};
}

Json scene_json(const Scene& scene, const std::vector<MeshReport>& reports) {
  const Totals sum = totals(scene, reports);
  Json json{{"scene", scene.name},
            {"file", scene.file},
            {"instances", scene.instances.size()},
            {"nodes", scene.nodes.size()},
            {"triangles", sum.triangles},
            {"lines", sum.lines},
            {"points", sum.points},
            {"bounds", bounds_json(bounds(scene))}};
  json["meshes"] = Json::array();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    json["meshes"].push_back(mesh_json(scene.meshes[i], reports[i]));
  }
  json["materials"] = Json::array();
  for (const Material& material : scene.materials) {
    const Rgba& color = material.base_color;
    json["materials"].push_back({{"name", material.name},
                                 {"base_color", {color.r, color.g, color.b, color.a}},
                                 {"textured", material.texture.has_value()},
                                 {"alpha_mode", alpha_name(material.alpha_mode)},
                                 {"double_sided", material.double_sided},
                                 {"unlit", material.unlit},
                                 {"emission", emission_of(material)},
                                 {"emission_textured", material.emission_texture.has_value()}});
  }
  json["images"] = Json::array();
  for (const Image<Rgba8>& image : scene.images) {
    json["images"].push_back({{"width", image.width}, {"height", image.height}});
  }
  json["cameras"] = Json::array();
  for (const Camera& camera : scene.cameras) {
    if (camera.fault.empty()) {
      json["cameras"].push_back({{"name", camera.name}, {"lens", lens_name(camera.lens)}});
    } else {
      json["cameras"].push_back({{"name", camera.name}, {"fault", camera.fault}});
    }
  }
  json["lights"] = scene.lights.size();
  json["extensions"] = scene.extensions;
  json["warnings"] = scene.warnings;
  return json;
}

void print_scene(const Scene& scene, const std::vector<MeshReport>& reports) {
  const Totals sum = totals(scene, reports);
  fmt::print("{}\n",
             printable(scene.file.empty() ? scene.name + " (built-in)" : scene.file, kLongText));
  fmt::print("  {} of {}: {}, {}, {} as drawn\n", counted(scene.instances.size(), "instance"),
             counted(scene.meshes.size(), "mesh", "meshes"), counted(sum.triangles, "triangle"),
             counted(sum.lines, "line"), counted(sum.points, "point"));
  fmt::print("  bounds {}\n", bounds_text(bounds(scene)));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const MeshReport& report = reports[i];
    const std::vector<std::string> has = attributes(scene.meshes[i]);
    fmt::print("  mesh {} '{}': {}, {}, {}, {}, Euler characteristic {}, {}{}\n", i,
               printable(scene.meshes[i].name), counted(report.faces, "face"),
               counted(report.vertices, "vertex", "vertices"), counted(report.edges, "edge"),
               counted(report.components, "component"), report.euler_characteristic,
               report.closed ? "closed" : "open",
               has.empty() ? "" : fmt::format("; with {}", fmt::join(has, ", ")));
    for (const std::string& finding : findings(report)) fmt::print("    - {}\n", finding);
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    fmt::print("  material {} '{}': {}{}{}{}{}\n", i, printable(material.name),
               alpha_name(material.alpha_mode), material.texture ? ", textured" : "",
               material.double_sided ? ", double-sided" : "", material.unlit ? ", unlit" : "",
               emits_light(material) ? ", emits light" : "");
  }
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    fmt::print("  image {}: {} x {}\n", i, scene.images[i].width, scene.images[i].height);
  }
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const Camera& camera = scene.cameras[i];
    fmt::print("  camera {} '{}': {}\n", i, printable(camera.name),
               camera.fault.empty() ? lens_name(camera.lens) : "cannot be used");
  }
  if (!scene.lights.empty()) fmt::print("  {}\n", counted(scene.lights.size(), "light"));
  if (!scene.extensions.empty())
    fmt::print("  extensions: {}\n",
               printable(fmt::format("{}", fmt::join(scene.extensions, ", ")), kLongText));
}

void print_warnings(const Scene& scene) {
  for (const std::string& warning : scene.warnings)
    fmt::print("  warning: {}\n", printable(warning, kLongText));
}

// The contents of a glTF file that are not drawn; nothing for other scenes.
Result<std::optional<GltfContents>> contents_of(const SceneAndBytes& loaded) {
  const auto some = [](GltfContents contents) { return std::optional(std::move(contents)); };
  if (loaded.bytes.empty()) {
    const std::string& file = loaded.scene.file;
    if (!is_gltf_name(file)) return std::optional<GltfContents>();
    return list_gltf(file).map(some);
  }
  const std::optional<SceneFormat> format = format_of(loaded.bytes);
  if (format != SceneFormat::kGlb && format != SceneFormat::kGltf) {
    return std::optional<GltfContents>();
  }
  return list_gltf_memory(loaded.bytes, "").map(some);
}

}  // namespace

void InfoCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command =
      *app.add_subcommand("info", "print what is in a scene, and which mistakes it has");
  command.footer(
      "Examples:\n"
      "  glassbox info duck.glb\n"
      "  glassbox info part.obj --json - | jq '.meshes[0].open_edges'\n"
      "  glassbox info teapot --write teapot.glb\n"
      "  glassbox info cube --tables --rows 4\n"
      "  glassbox info room.ldi\n\n"
      "--tables prints the tables of each mesh: vertices, edges and faces with their neighbours, "
      "and the\n"
      "faces' normals by the product of two edges and by Newell's sums (docs/command_line.md).\n"
      "For a layered depth image (docs/layers.md) it prints the number of samples and the "
      "camera.\n\n" +
      builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  add_json_output(command, json_output_);
  command.add_option("--write", glb_output_, "write the scene as GLB")->type_name("FILE.glb");
  command.add_flag("--tables", has_tables_,
                   "tables of vertices, edges and faces, with neighbours and normals");
  command
      .add_option("--rows", rows_,
                  fmt::format("rows of each table; the rest is counted [{}]", kUsualRows))
      ->type_name("N");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> InfoCommand::check_options() const {
  if (rows_ && !has_tables_) {
    return fail("--rows", "it is only for --tables", "add --tables, or leave this option out");
  }
  return glb_output_ ? check_extension(*glb_output_, ".glb") : Result<void>();
}

int InfoCommand::tell_of_layers() const {
  if (has_tables_)
    return refuse(
        {scene_, "--tables", "a layered depth image has no meshes", "leave --tables out"});
  if (glb_output_)
    return refuse({scene_, "--write", "a layered depth image is not a scene", "leave --write out"});
  const Result<LayersInfo> info = layers_info(scene_);
  if (!info) return refuse(info.error());
  if (json_output_) {
    if (const auto written = write_json(*json_output_, info->json); !written)
      return refuse(written.error());
  }
  if (json_output_ != "-") fmt::print("{}", info->text);
  return kSuccess;
}

int InfoCommand::run() {
  if (const auto legal = check_options(); !legal) return refuse(legal.error());
  if (is_layer_file(scene_)) return tell_of_layers();
  const Result<SceneAndBytes> loaded = load_scene_and_bytes(scene_);
  if (!loaded) return refuse(loaded.error());
  const auto contents = contents_of(*loaded);
  if (!contents) return refuse(contents.error());
  const Scene& scene = loaded->scene;
  std::vector<MeshReport> reports;
  for (const Mesh& mesh : scene.meshes) reports.push_back(mesh_report(mesh));

  const std::size_t rows = rows_.value_or(kUsualRows);
  const std::vector<std::string> stiff = numerical_warnings(scene);
  const std::vector<std::string> surfaces = surface_findings(scene, std::nullopt);

  if (glb_output_) {
    if (const auto written = write_glb(scene, *glb_output_); !written)
      return refuse(written.error());
  }
  if (json_output_) {
    Json json = scene_json(scene, reports);
    if (has_tables_) {
      for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        json["meshes"][i]["tables"] = tables_json(scene.meshes[i], rows);
    }
    add_contents(contents->value_or(GltfContents()), json);
    json["stiffness"] = stiff;
    json["surfaces"] = surfaces;
    const auto written = write_json(*json_output_, json);
    if (!written) return refuse(written.error());
  }
  if (json_output_ != "-") {
    print_scene(scene, reports);
    if (*contents) fmt::print("{}", contents_text(**contents));
    print_warnings(scene);
    for (const std::string& line : surfaces) fmt::print("  {}\n", line);
    for (const std::string& line : stiff) fmt::print("  {}\n", line);
    if (has_tables_) fmt::print("{}", tables_text(scene, rows));
  }
  return kSuccess;
}

void add_info_command(CLI::App& app, int& exit_code) {
  add_command<InfoCommand>(app, exit_code);
}

}  // namespace glassbox::app
