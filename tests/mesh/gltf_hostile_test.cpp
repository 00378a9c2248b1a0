// glTF files with wrong numbers: each gives an error that names the place, and none crashes the
// loader or makes it allocate memory out of proportion.
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "tests/images/temporary_directory.h"
#include "tests/mesh/gltf_builder.h"
#include "tests/support/allocations.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

#include <glassbox/base/random.h>

using namespace glassbox;
using namespace glassbox::test;

namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// A file that has every kind of offset, count and index.
GltfBuilder rich() {
  GltfBuilder b;
  json& primitive = b.triangle();
  primitive["attributes"]["NORMAL"] = b.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  primitive["attributes"]["TEXCOORD_0"] = b.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
  primitive["indices"] = b.accessor(b.view(std::vector<std::uint16_t>{0, 1, 2}), 5123, "SCALAR", 3);
  primitive["targets"] = {{{"POSITION", 1}}};
  b.document["meshes"][0]["weights"] = {0.5};
  b.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  b.document["nodes"].push_back({{"camera", 0}, {"children", {2}}});
  b.document["nodes"].push_back({{"mesh", 0}, {"rotation", {0, 0, 0, 1}}});
  b.document["scenes"] = {{{"nodes", {0, 1}}}};
  return b;
}

// The error after `json_pointer` of the rich file has been set to `value`.
std::string error_with(const char* json_pointer, const json& value) {
  GltfBuilder b = rich();
  b.document[json::json_pointer(json_pointer)] = value;
  return error_of(b.load());
}

}  // namespace

TEST_CASE("a GLB cut off at any byte is an error or a scene, never a crash") {
  const Bytes file = rich().glb();
  REQUIRE(load_gltf_memory(file, ""));
  for (std::size_t length = 0; length < file.size(); ++length) {
    CAPTURE(length);
    CHECK_FALSE(load_gltf_memory(std::span(file).first(length), ""));
  }
}

TEST_CASE("a GLB with changed bytes is an error or a scene whose indices are in range") {
  const Bytes original = rich().glb();
  const std::uint64_t seed = 20260401;
  Random random(seed);
  for (int run = 0; run < 3000; ++run) {
    CAPTURE(seed, run);
    Bytes file = original;
    for (std::int64_t changes = random.integer(1, 4); changes > 0; --changes) {
      file[std::size_t(random.integer(0, std::int64_t(file.size()) - 1))] =
          std::byte(random.bits() & 0xff);
    }
    const auto scene = load_gltf_memory(file, "");
    if (!scene) {
      CHECK_FALSE(scene.error().cause.empty());
      CHECK_FALSE(mentions(scene.error().message(), "\n"));
      continue;
    }
    for (const Mesh& mesh : scene->meshes) {
      for (const Corner& corner : mesh.corners) REQUIRE(corner.position < mesh.positions.size());
      REQUIRE(mesh.material < scene->materials.size());
    }
  }
}

TEST_CASE("every index into a table is checked where it stands") {
  CHECK(mentions(error_with("/nodes/0/mesh", 5),
                 "node 0, mesh: names entry 5 of 'meshes', which has 1"));
  CHECK(mentions(error_with("/nodes/1/camera", 9), "node 1, camera"));
  CHECK(mentions(error_with("/nodes/1/children/0", 3), "node 1, children[0]"));
  CHECK(mentions(error_with("/nodes/1/children/0", -1), "node 1, children[0]: is -1"));
  CHECK(mentions(error_with("/nodes/0/skin", 0), "node 0, skin"));
  CHECK(mentions(error_with("/scenes/0/nodes/0", 7), "scene 0, nodes[0]"));
  CHECK(mentions(error_with("/scene", 1), "scene"));
  CHECK(mentions(error_with("/meshes/0/primitives/0/attributes/POSITION", 77),
                 "mesh 0, primitives[0].attributes.POSITION"));
  CHECK(mentions(error_with("/meshes/0/primitives/0/indices", 4), "mesh 0, primitives[0].indices"));
  CHECK(
      mentions(error_with("/meshes/0/primitives/0/material", 0), "mesh 0, primitives[0].material"));
  CHECK(mentions(error_with("/accessors/0/bufferView", 9), "accessor 0, bufferView"));
  CHECK(mentions(error_with("/bufferViews/0/buffer", 1), "bufferView 0, buffer"));
  CHECK(mentions(error_with("/textures", {{{"source", 0}}}), "texture 0, source"));
  CHECK(mentions(error_with("/textures", {{{"sampler", 2}}}), "texture 0, sampler"));
  CHECK(mentions(error_with("/skins", {{{"joints", {8}}}}), "skin 0, joints[0]"));
  CHECK(mentions(error_with("/images", {{{"bufferView", 99}}}), "image 0, bufferView"));
}

TEST_CASE("offsets, strides and counts are checked against the bytes that exist") {
  CHECK(mentions(error_with("/accessors/0/count", 4),
                 "accessor 0: 4 elements reach beyond the 36 bytes of bufferView 0"));
  CHECK(mentions(error_with("/accessors/0/count", 4294967294u), "accessor 0: "));
  CHECK(
      mentions(error_with("/accessors/0/count", 1.5), "accessor 0, count: is 1.5, not an integer"));
  CHECK(mentions(error_with("/accessors/0/count", 1e30), "accessor 0, count"));
  CHECK(mentions(error_with("/accessors/0/count", 18446744073709551615u), "accessor 0, count"));
  CHECK(mentions(error_with("/accessors/0/byteOffset", 4), "accessor 0: "));
  CHECK(mentions(error_with("/accessors/0/byteOffset", 9007199254740991u), "accessor 0: "));
  CHECK(mentions(error_with("/bufferViews/0/byteLength", 9007199254740991u),
                 "bufferView 0: reaches beyond"));
  CHECK(mentions(error_with("/bufferViews/1/byteOffset", 9007199254740991u),
                 "bufferView 1: reaches beyond"));
  CHECK(mentions(error_with("/bufferViews/0/byteStride", 8),
                 "accessor 0: has elements of 12 bytes that begin only 8 bytes apart"));
  CHECK(mentions(error_with("/bufferViews/0/byteStride", 256), "bufferView 0, byteStride"));
  CHECK(
      mentions(error_with("/buffers", {{{"byteLength", 100000}}}), "buffer 0: says 100000 bytes"));
  CHECK(mentions(error_with("/accessors/1/count", 2),
                 "NORMAL, accessor 1: has 2 elements where the primitive has 3 vertices"));
  CHECK(mentions(error_with("/accessors/0/type", "SCALAR"), "accessor 0"));
  CHECK(mentions(error_with("/accessors/0/componentType", 5130), "accessor 0, componentType"));
  CHECK(
      mentions(error_with("/accessors/3/componentType", 5122), "indices, accessor 3: has a type"));
  CHECK(mentions(error_with("/meshes/0/weights", {1, 2}), "has 1 morph targets but 2 weights"));
}

TEST_CASE("an accessor without data may not ask for more elements than the file has bytes") {
  GltfBuilder b;
  b.document["accessors"] = {{{"componentType", 5126}, {"count", 1000000000}, {"type", "VEC3"}}};
  b.primitive({{"attributes", {{"POSITION", 0}}}});
  CHECK(mentions(error_of(b.load()), "accessor 0: has 1000000000 elements without data"));
}

TEST_CASE("a vertex index beyond the vertices, or the restart value, is named") {
  for (const std::uint16_t bad : {std::uint16_t(3), std::uint16_t(65535)}) {
    GltfBuilder b;
    json& primitive = b.triangle();
    primitive["indices"] =
        b.accessor(b.view(std::vector<std::uint16_t>{0, 1, bad}), 5123, "SCALAR", 3);
    const std::string error = error_of(b.load());
    CHECK(mentions(error, "mesh 0, primitive 0, indices, accessor 1, element 2"));
    CHECK(mentions(error, bad == 3 ? "names vertex 3, but the primitive has only 3" : "restart"));
  }
}

TEST_CASE("sparse indices must ascend and stay below the count") {
  for (const auto& bad : {std::vector<std::uint8_t>{2, 1}, std::vector<std::uint8_t>{1, 3}}) {
    GltfBuilder b;
    b.triangle();
    const std::size_t indices = b.view(bad);
    b.document["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", 0}}}};
    CHECK(mentions(error_of(b.load()), "accessor 0: sparse index 1"));
  }
}

TEST_CASE("numbers that are not finite are named with mesh, primitive, accessor and element") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  GltfBuilder b;
  b.primitive({{"attributes", {{"POSITION", b.floats({0, 0, 0, 1, nan, 0, 0, 1, 0}, "VEC3", 3)}}}});
  b.document["meshes"][0]["name"] = "rock";
  CHECK(mentions(error_of(b.load()),
                 "mesh 0 'rock', primitive 0, POSITION, accessor 0, element 1: is not a number"));
  GltfBuilder uv;
  json& primitive = uv.triangle();
  primitive["attributes"]["TEXCOORD_0"] = uv.floats({0, 0, 0, 0, infinity, 0}, "VEC2", 2);
  CHECK(mentions(error_of(uv.load()), "TEXCOORD_0, accessor 1, element 2: is infinite"));
}

TEST_CASE("cycles, self children, two parents, deep chains and bad matrices are refused") {
  CHECK(mentions(error_with("/nodes/1/children/0", 1), "node 1: is its own child"));
  CHECK(mentions(error_with("/nodes/2/children", {1}), "cycle"));
  CHECK(mentions(error_with("/nodes/0/children", {2}), "node 2: is named as a child twice"));
  CHECK(mentions(error_with("/scenes/0/nodes", {2}), "scene 0: starts at node 2"));
  CHECK(mentions(error_with("/scenes/0/nodes", {0, 0}), "twice"));
  CHECK(mentions(error_with("/nodes/2/rotation", {0, 0, 0, 0}), "node 2: its rotation"));
  CHECK(mentions(
      error_with("/nodes/1/matrix", {1e308, 0, 0, 0, 0, 1e308, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}),
      "last row"));
  // By rows, as other programs print it, and with numbers in both: only the first is transposed.
  CHECK(mentions(error_with("/nodes/1/matrix", {1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}),
                 "node 1: its matrix looks transposed"));
  CHECK(mentions(error_with("/nodes/1/matrix", {1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 1, 0, 0, 1}),
                 "the last row of its matrix is not 0 0 0 1"));
  CHECK(mentions(error_with("/nodes/0/scale", {1, 2}), "node 0, scale: has 2 items"));

  const auto chain = [](const json& scale, const LoadLimits& limits) {
    GltfBuilder b;
    b.triangle();
    b.document["nodes"] = json::array();
    for (int i = 0; i < 5000; ++i) {
      b.document["nodes"].push_back({{"children", {i + 1}}, {"scale", scale}});
    }
    b.document["nodes"].push_back({{"mesh", 0}});
    return error_of(b.load(limits));
  };
  LoadLimits deeper;
  deeper.max_node_depth = 10000;
  CHECK(mentions(chain({1, 1, 1}, {}), "node 1024: is nested deeper than 1024 levels"));
  CHECK(chain({1, 1, 1}, deeper).empty());
  // The scale of node n is 2^(n + 1), and 2^1024 overflows a double.
  CHECK(mentions(chain({2, 2, 2}, deeper),
                 "node 1023: its matrix in the world has numbers that are not finite"));
}

TEST_CASE("short files cannot ask for many corners by sharing accessors, meshes or morph targets") {
  std::vector<float> many(300000, 0.5f);
  GltfBuilder b;
  const std::size_t positions = b.floats(many, "VEC3", 3);
  const json primitive = {{"attributes", {{"POSITION", positions}}}};
  b.primitive(primitive);
  for (int i = 0; i < 2000; ++i) b.document["meshes"][0]["primitives"].push_back(primitive);
  CHECK(mentions(error_of(b.load()), "vertices and corners, too many for a file of"));

  GltfBuilder crossed;
  json& small = crossed.document["meshes"];
  crossed.triangle();
  const json point = small[0]["primitives"][0];
  for (int i = 0; i < 2000; ++i) {
    small[0]["primitives"].push_back(point);
    crossed.document["nodes"].push_back({{"mesh", 0}});
  }
  CHECK(mentions(error_of(crossed.load()), "primitives, the most for a file of"));

  GltfBuilder instances;
  instances.triangle();
  for (int i = 0; i < 1000; ++i) instances.document["nodes"].push_back({{"mesh", 0}});
  LoadLimits limits;
  limits.max_corners = 2999;
  CHECK(mentions(error_of(instances.load(limits)), "more than 2999 corners"));
}

TEST_CASE("JSON that is no glTF is refused with its place") {
  const auto error = [](const std::string& text) {
    return error_of(load_gltf_memory(bytes_of(text), ""));
  };
  CHECK(mentions(error(""), "empty"));
  CHECK(mentions(error("[]"), "not a JSON object"));
  CHECK(mentions(error("{\"asset\":{\"version\":\"2.0\"}} x"), "JSON: parse error"));
  CHECK(mentions(error("\xef\xbb\xbf{}"), "byte order mark"));
  CHECK(mentions(error("{\"asset\":{\"version\":\"1.0\"}}"), "only glTF 2"));
  CHECK(mentions(error("{\"asset\":{\"version\":2}}"), "asset.version: is not a string"));
  const auto needs = [&](const std::string& version) {
    return error("{\"asset\":{\"version\":\"2.1\",\"minVersion\":\"" + version + "\"}}");
  };
  for (const char* newer : {"2.1", "2.10", "3.0", "10.0"}) {
    CHECK(mentions(needs(newer), "asset.minVersion: is '" + std::string(newer) +
                                     "', but files are read as glTF 2.0"));
  }
  for (const char* older : {"2.0", "1.0", "1.9"}) CHECK(mentions(needs(older), "nothing to draw"));
  for (const char* wrong : {"", "2", "2.", ".1", "2.x", "two"}) {
    CHECK(mentions(needs(wrong), "which is not a version"));
  }
  CHECK(mentions(error("{\"asset\":{\"version\":\"2.0\"}}"), "nothing to draw"));
  CHECK(mentions(error("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(100000, '[')),
                 "nested deeper than 256"));
  CHECK(mentions(error("{\"asset\":{\"version\":\"2.0\"},\"nodes\":3}"),
                 "nodes: is not a JSON array"));
  // 1e999 overflows a double: the parser quotes it with its line and column, but does not know
  // which property it belongs to.
  CHECK(mentions(
      error("{\"asset\":{\"version\":\"2.0\"},\n  \"nodes\":[{\"translation\":[1e999,0,0]}]}"),
      "JSON, line 2, column 28: number overflow parsing '1e999'"));
}

TEST_CASE("JSON that is no UTF-8 is refused with its line, wherever it stands") {
  const auto document = [](const std::string& name, const std::string& uri,
                           const std::string& extra) {
    return bytes_of("{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [{\"name\": \"" + name +
                    "\",\n\"extras\": {\"" + extra + "\": \"" + extra +
                    "\"}}],\n\"buffers\": [{\"byteLength\": 1, \"uri\": \"" + uri + "\"}]}\n");
  };
  const auto error = [](const Bytes& bytes) { return error_of(load_gltf_memory(bytes, "")); };
  CHECK_FALSE(mentions(error(document("n", "data:,a", "e")), "JSON"));
  for (const std::string& broken : {std::string("\xff\xfe"), std::string("a\xe2\x82"),
                                    std::string("\xc0\xaf"), std::string("\xed\xa0\x80")}) {
    CAPTURE(broken);
    CHECK(mentions(error(document(broken, "data:,a", "e")), "JSON: parse error at line 2"));
    CHECK(mentions(error(document("n", "data:,a", broken)), "JSON: parse error at line 3"));
    CHECK(mentions(error(document("n", broken + ".bin", "e")), "JSON: parse error at line 4"));
  }
  CHECK(mentions(error(document("\\ud800", "data:,a", "e")), "JSON: parse error at line 2"));
}

TEST_CASE("external files come from the scene's own directory only") {
  const TemporaryDirectory temporary;
  const std::string inside = temporary.file("scene");
  std::filesystem::create_directories(inside);
  const std::string data(36, '\0');
  write(temporary.file("secret.bin"), data);
  write(inside + "/my data.bin", data);
  std::filesystem::create_symlink(temporary.file("secret.bin"), inside + "/link.bin");
  std::filesystem::create_directory(inside + "/folder");
  const auto with_uri = [&](const std::string& uri) {
    GltfBuilder b;
    b.triangle();
    b.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    write(inside + "/scene.gltf", b.document.dump());
    return error_of(load_gltf(inside + "/scene.gltf"));
  };
  CHECK(with_uri("my%20data.bin").empty());
  CHECK(with_uri("my data.bin").empty());
  CHECK(with_uri("folder/../my data.bin").empty());
  for (const char* uri :
       {"../secret.bin", "%2e%2e/secret.bin", "link.bin", "/etc/passwd", "folder", "absent.bin", "",
        "file:///etc/passwd", "http://example.com/a.bin", "my%2", "a%00b", "`id`", "~/x",
        "data:application/octet-stream;base64,QUJD!!!!", "data:;base64,QUI", "data:nothing"}) {
    INFO(uri);
    const std::string error = with_uri(uri);
    CHECK(mentions(error, "scene.gltf: buffer 0: "));
  }
  GltfBuilder memory;
  memory.triangle();
  memory.document["buffers"] = {{{"byteLength", 36}, {"uri", "my%20data.bin"}}};
  CHECK(mentions(error_of(memory.load()), "the scene itself is not a file"));
}

TEST_CASE("a data URI is read as RFC 2397 and RFC 3986 write it") {
  // The 36 bytes of a triangle, in base64 and in per cent codes.
  std::string base64, codes;
  GltfBuilder triangle;
  triangle.triangle();
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < triangle.binary.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | std::to_integer<std::uint32_t>(triangle.binary[i + k]);
    for (int shift = 18; shift >= 0; shift -= 6) base64 += kDigits[bits >> shift & 63];
  }
  const auto per_cent = [](const std::string& text) {
    constexpr const char* kHex = "0123456789abcdef";
    std::string coded;
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      coded += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
    return coded;
  };
  for (const std::byte b : triangle.binary) codes += per_cent(std::string(1, char(b)));
  const auto with_uri = [&](const std::string& uri) {
    GltfBuilder b = triangle;
    b.document["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    return b.load();
  };
  for (const std::string& uri :
       {"data:application/octet-stream;base64," + base64, "data:;base64," + base64,
        "DATA:application/gltf-buffer;BASE64," + base64, "Data:;charset=utf-8;a=b;Base64," + base64,
        "data:;base64," + per_cent(base64), "data:;base64,%41" + base64.substr(1), "data:," + codes,
        "data:text/plain;charset=us-ascii," + codes, "dAtA:;x=base64," + codes}) {
    INFO(uri);
    const auto scene = with_uri(uri);
    INFO(error_of(scene));
    REQUIRE(scene);
    CHECK(scene->meshes[0].positions[1] == Point<Object>(1, 0, 0));
  }
  for (const std::string& uri : {"data:;base64," + base64 + "%4", "data:;base64,%zz" + base64,
                                 "data:;base64" + base64, "data:;base64,%00" + base64.substr(1)}) {
    INFO(uri);
    CHECK(mentions(error_of(with_uri(uri)), "buffer 0: "));
  }
}

TEST_CASE("numbers of vertices that no index names may be anything, which is a warning") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> positions = {0, 0, 0, nan, 1, 2, 1, 0, 0, 0, 1, 0};
  const std::vector<float> texcoords = {0, 0, nan, nan, 0, 1, 1, 0};
  const auto drawn_with = [&](const std::vector<std::uint16_t>& indices) {
    GltfBuilder b;
    const std::size_t position = b.floats(positions, "VEC3", 3);
    const std::size_t texcoord = b.floats(texcoords, "VEC2", 2);
    const std::size_t index = b.accessor(b.view(indices), 5123, "SCALAR", indices.size());
    b.primitive(
        {{"attributes", {{"POSITION", position}, {"TEXCOORD_0", texcoord}}}, {"indices", index}});
    return b.load();
  };
  const auto scene = drawn_with({0, 2, 3});
  INFO(error_of(scene));
  REQUIRE(scene);
  REQUIRE_FALSE(scene->warnings.empty());
  CHECK(mentions(scene->warnings[0],
                 "3 numbers of unused vertices are not finite and were taken as 0"));
  CHECK(scene->meshes[0].positions[1] == Point<Object>(0, 1, 2));
  CHECK(mentions(error_of(drawn_with({0, 1, 2})), "element 1: is not a number (NaN)"));
}

TEST_CASE("the last element of a matrix accessor has no padding after its last column") {
  struct Case {
    const char* type;
    int component_type;
    std::size_t bytes;  // size of two elements
  };
  // glTF 2.0, section 3.6.2.4: columns start at multiples of four bytes.
  for (const Case& c : {Case{"MAT2", 5121, 14},
                        {"MAT3", 5121, 23},
                        {"MAT3", 5123, 46},
                        {"MAT2", 5123, 16},
                        {"MAT4", 5121, 32},
                        {"MAT2", 5126, 32}}) {
    CAPTURE(c.type, c.component_type, c.bytes);
    GltfBuilder b;
    b.triangle();
    const std::size_t view = b.view(std::vector<std::uint8_t>(c.bytes));
    b.accessor(view, c.component_type, c.type, 2);
    CHECK(b.load());
    b.document["bufferViews"][view]["byteLength"] = c.bytes - 1;
    CHECK(mentions(error_of(b.load()), "2 elements reach beyond"));
  }
}

TEST_CASE("a missing file and a directory are errors that name them") {
  CHECK(mentions(error_of(load_gltf("/nonexistent/duck.glb")),
                 "/nonexistent/duck.glb: there is no such file"));
  const TemporaryDirectory temporary;
  CHECK(mentions(error_of(load_gltf(temporary.path().string())), "not a regular file"));
}

TEST_CASE("real and malformed files meet their verdicts with work that is bounded") {
  const std::filesystem::path assets = GLASSBOX_ASSETS_DIR;
  std::ifstream manifest(assets / "MANIFEST.tsv");
  if (!manifest) SKIP_TEST("no assets at " << (assets / "MANIFEST.tsv").string());
  int tried = 0;
  for (std::string line; std::getline(manifest, line);) {
    std::vector<std::string> columns;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');) columns.push_back(field);
    if (columns.size() < 7) continue;
    const std::filesystem::path path = assets / columns[0];
    if (path.extension() != ".gltf" && path.extension() != ".glb") continue;
    const std::string& verdict = columns[6];
    const Allocations before = allocations();
    const auto scene = load_gltf(path.string());
    const Allocations after = allocations();
    CAPTURE(columns[0], verdict, error_of(scene));
    // For a file that loads: twice the most that any of these files takes (a small one that draws
    // one mesh many times). A file that is refused is refused while it is read.
    CHECK(after.bytes - before.bytes <
          (scene ? 256u << 20 : (1u << 20) + 100 * std::filesystem::file_size(path)));
    CHECK(after.calls - before.calls < (scene ? 60000 : 10000));
    ++tried;
    const bool empty = mentions(error_of(scene), "nothing to draw");
    if (verdict == "reject" || verdict.starts_with("reject (")) {
      CHECK_FALSE(scene);
    } else if (verdict.starts_with("accept") && verdict.find("may be empty") != std::string::npos) {
      // A file may be valid and need a newer version than is read.
      const bool newer = mentions(error_of(scene), "asset.minVersion: is '2.1'");
      CHECK((scene || empty || newer));
    } else if (verdict == "render" || verdict == "accept" || verdict.starts_with("render (")) {
      CHECK(scene);
    } else if (verdict.starts_with("render if extension")) {
      CHECK(mentions(error_of(scene), "KHR_draco_mesh_compression"));
    }
  }
  CHECK(tried > 0);
}
