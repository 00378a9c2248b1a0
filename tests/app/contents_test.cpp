// Every command that loads a file reports once what the file needs and the picture lacks. PLY files
// are accepted by every command.
#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// Writes a triangle in a data URI. Its normal texture, animation and extension are not drawn.
void write_undrawn_features(const WorkingDirectory& here) {
  here.write("wishes.gltf", R"({
    "asset": {"version": "2.0"}, "nodes": [{"mesh": 0, "name": "a"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"normalTexture": {"index": 0}, "emissiveFactor": [0, 0.5, 0],
                   "extensions": {"KHR_materials_sheen": {}}}],
    "textures": [{"name": "bumps"}],
    "animations": [{"name": "spin", "channels": [{}], "samplers": [{}]}],
    "extensionsUsed": ["KHR_materials_sheen"],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
}

const char* const kWarnings[] = {
    "the extension 'KHR_materials_sheen' is not supported and was ignored in one place",
    "normal textures are not drawn (1 material)",
    "1 animation is not played: everything is drawn where the file places it"};

TEST_CASE("what a glTF file asks for and a picture lacks is one line on standard error") {
  const WorkingDirectory here;
  write_undrawn_features(here);
  for (const char* command :
       {"render wishes.gltf --size 32x32 -o a.png", "explain wishes.gltf --size 32x32",
        "pixel wishes.gltf --size 32x32 --at 8,20", "step wishes.gltf --size 32x32 --triangle 0"}) {
    CAPTURE(command);
    const Outcome outcome = here.run(command);
    REQUIRE(outcome.exit_code == 0);
    for (const char* warning : kWarnings) {
      CAPTURE(warning, outcome.err);
      CHECK(count_of(outcome.err, warning) == 1);
    }
  }
}

TEST_CASE("info lists what is in a glTF file, as text and as JSON") {
  const WorkingDirectory here;
  write_undrawn_features(here);
  const Outcome text = here.run("info wishes.gltf");
  REQUIRE(text.exit_code == 0);
  for (const char* part :
       {"1 primitive in the file: POSITION\n",
        "texture 0 'bumps': of unknown size, normals of 1 material (not drawn)\n",
        "animation 0 'spin': 1 channel\n", "opaque, emits light\n"}) {
    CAPTURE(part, text.out);
    CHECK(contains(text.out, part));
  }
  for (const char* warning : kWarnings) CHECK(count_of(text.out, warning) == 1);
  const Json json = Json::parse(here.run("info wishes.gltf --json -").out);
  CHECK(json.at("warnings").size() == 3);
  CHECK(json.at("animations") == Json::parse(R"([{"name": "spin", "channels": 1}])"));
  CHECK(json.at("skins").empty());
  CHECK(json.at("primitives")[0].at("attributes") == Json::array({"POSITION"}));
  CHECK(json.at("primitives")[0].at("morph_targets") == 0);
  CHECK(json.at("textures")[0].at("uses")[0].at("use") == "normals");
  CHECK(json.at("textures")[0].at("uses")[0].at("drawn") == false);
  CHECK(json.at("materials")[0].at("emission") == Json::array({0.0, 0.5, 0.0}));
}

TEST_CASE("step tells what is emitted from what is lit") {
  const WorkingDirectory here;
  write_undrawn_features(here);
  const Outcome outcome = here.run("step wishes.gltf --size 32x32 --triangle 0");
  CHECK(contains(outcome.out, "emitted  (0, 0.5, 0), linear\n"));
  CHECK(contains(outcome.out, ", linear, with the emitted light\n"));
  CHECK_FALSE(contains(here.run("step cube --size 32x32 --pick 16,16").out, "emitted"));
}

TEST_CASE("a PLY file is rendered, described and stepped through like any other") {
  const WorkingDirectory here;
  here.write("part.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
             "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
             "0 0 0 255 0 0\n2 0 0 0 255 0\n2 1 0 0 0 255\n0 1 0 255 255 255\n4 0 1 2 3\n");
  const Outcome tile = here.run("render part.ply --size 48x32 -o tile.png");
  REQUIRE(tile.exit_code == 0);
  CHECK(tile.err.find("warning") == std::string::npos);
  REQUIRE(here.run("render part.ply --size 48x32 --engine staged -o staged.png").exit_code == 0);
  CHECK(here.run("diff tile.png staged.png").exit_code == 0);
  const Json json = Json::parse(here.run("info part.ply --json -").out);
  CHECK(json.at("triangles") == 2);
  CHECK(json.at("meshes")[0].at("faces") == 1);
  CHECK(json.at("meshes")[0].at("attributes") == Json::array({"colours"}));
  CHECK(json.at("scene") == "part");
  CHECK(here.run("step part.ply --size 48x32 --pick 24,16").exit_code == 0);
  CHECK(here.run("explain part.ply --size 48x32").exit_code == 0);
}

TEST_CASE("a point cloud is refused in one line") {
  const WorkingDirectory here;
  here.write("cloud.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
             "property float z\nend_header\n0 0 0\n");
  const Outcome outcome = here.run("render cloud.ply -o a.png");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "cloud.ply: header: has 1 vertex and no faces: a point cloud"));
  CHECK(count_of(outcome.err, "\n") == 1);
}

}  // namespace
}  // namespace glassbox::test
