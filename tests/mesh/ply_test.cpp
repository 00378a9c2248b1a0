// The contents that PLY files may have; all three formats give the same mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>

#include "tests/images/temporary_directory.h"
#include "tests/mesh/ply_builder.h"
#include "tests/support/catch.h"

#include <glassbox/images/srgb.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox::test {
namespace {

Scene loaded(const std::string& file) {
  const auto scene = load_ply_memory(file);
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene);
  return *scene;
}

// A concave arrowhead of four corners, whose last one is reflex, and a triangle; the vertices have
// all properties that are read.
PlyBuilder arrowhead(PlyFormat format) {
  PlyBuilder b(format);
  b.element("vertex", 5);
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) b.property("float", name);
  for (const char* name : {"red", "green", "blue"}) b.property("uchar", name);
  b.property("double", "s").property("double", "t");
  b.element("face", 2).list("uchar", "int", "vertex_indices");
  b.begin_data();
  const double at[5][2] = {{0, 0}, {2, 0.1}, {0, 2}, {0.5, 0.5}, {-1, 1}};
  for (int i = 0; i < 5; ++i) {
    b.floats({at[i][0], at[i][1], 0.25 * i, 0, 0, 2}).uchars({10 * i, 0, 255});
    b.doubles({0.125 * i, 0.25});
    b.end_row();
  }
  b.uchars({4}).ints({0, 1, 3, 2}).end_row();
  b.uchars({3}).ints({0, 2, 4}).end_row();
  return b;
}

TEST_CASE("PLY: text and both binary orders give the same mesh") {
  const Scene text = loaded(arrowhead(PlyFormat::kAscii).file());
  REQUIRE(text.meshes.size() == 1);
  const Mesh& mesh = text.meshes[0];
  REQUIRE(mesh.positions.size() == 5);
  CHECK(mesh.positions[1] == Point<Object>(2, 0.1f, 0.25f));
  CHECK(mesh.normals[4] == Normal<Object>(0, 0, 1));
  CHECK(mesh.texcoords[3] == TexCoord{0.375f, 0.75f});  // v = 0 is at the bottom
  CHECK(mesh.colors[2] == Rgba{decode_srgb(20), 0, 1, 1});
  REQUIRE(mesh.faces.size() == 2);
  CHECK(mesh.faces[0] == Face{0, 4});
  CHECK(mesh.corners[2] == Corner{3, 3, 3, 3});
  CHECK(text.materials[0].double_sided);
  CHECK(text.materials[0].alpha_mode == AlphaMode::kOpaque);
  CHECK(text.warnings.empty());
  for (const PlyFormat format : {PlyFormat::kLittleEndian, PlyFormat::kBigEndian}) {
    const Mesh other = loaded(arrowhead(format).file()).meshes[0];
    CHECK(other.positions == mesh.positions);
    CHECK(other.normals == mesh.normals);
    CHECK(other.texcoords == mesh.texcoords);
    CHECK(other.colors == mesh.colors);
    CHECK(other.corners == mesh.corners);
    CHECK(other.faces == mesh.faces);
  }
}

TEST_CASE("PLY: polygons keep their corners, and are triangulated like any others") {
  const Scene scene = loaded(arrowhead(PlyFormat::kBigEndian).file());
  const Triangulation triangulation = triangulate(scene.meshes[0]);
  CHECK(triangulation.triangles.size() == 3);
  CHECK(triangulation.fallback_faces.empty());
}

TEST_CASE("PLY: text becomes the nearest number of its type, and lines may end in any way") {
  const std::string unix_file =
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info nothing\nelement vertex 3\n"
      "property float x\nproperty double y\nproperty short z\nelement face 1\n"
      "property list uchar uint vertex_index\nend_header\n"
      "0.1 0.1 -3\n1e-50 +2.5 4\n  16777217 3 5\n\n3 0 1\n2\n";
  for (const std::string& ending : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
    std::string file;
    for (const char c : unix_file) file += c == '\n' ? ending : std::string(1, c);
    const Mesh mesh = loaded(file).meshes[0];
    CHECK(mesh.positions[0] == Point<Object>(0.1f, 0.1f, -3));
    CHECK(mesh.positions[1] == Point<Object>(0, 2.5f, 4));
    CHECK(mesh.positions[2] == Point<Object>(16777216, 3, 5));
    CHECK(mesh.corners[2] == Corner{2, kNone, kNone, kNone});
  }
}

TEST_CASE("PLY: faces may come before vertices, and have colours and coordinates of their own") {
  PlyBuilder b(PlyFormat::kLittleEndian);
  b.element("face", 2).list("uchar", "uint", "vertex_indices").list("uchar", "float", "texcoord");
  b.property("ushort", "red").property("ushort", "green").property("ushort", "blue");
  b.element("vertex", 4).property("float", "x").property("float", "y").property("float", "z");
  b.begin_data();
  b.uchars({3}).uints({0, 1, 2}).uchars({6}).floats({0, 0, 1, 0, 0, 1}).ushorts({65535, 0, 257});
  b.uchars({3}).uints({2, 1, 3}).uchars({0}).ushorts({0, 0, 0});
  b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const Mesh mesh = loaded(b.file()).meshes[0];
  CHECK(mesh.texcoords[1] == TexCoord{1, 1});
  CHECK(mesh.corners[1] == Corner{1, kNone, 1, 0});
  CHECK(mesh.corners[4] == Corner{1, kNone, kNone, 1});
  CHECK(mesh.colors[0] == Rgba{1, 0, decode_srgb(1), 1});
}

TEST_CASE("PLY: a face with wrong texture coordinates is counted once, however many are wrong") {
  PlyBuilder b(PlyFormat::kLittleEndian);
  b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
  b.element("face", 3).list("uchar", "uint", "vertex_indices").list("uchar", "float", "texcoord");
  b.begin_data();
  b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  b.uchars({3}).uints({0, 1, 2}).uchars({6}).floats({nan, 0, 1, nan, 0, nan});
  b.uchars({3}).uints({0, 1, 2}).uchars({6}).floats({0, 0, 1, 0, 0, 1});
  b.uchars({3}).uints({0, 1, 2}).uchars({2}).floats({0, 0});
  CHECK(loaded(b.file()).warnings ==
        std::vector<std::string>{"2 faces have texture coordinates that are not finite or do not "
                                 "fit their corners (first: face 0)"});
}

TEST_CASE("PLY: an alpha below 1 blends, and one of zero everywhere was set by nobody") {
  const auto with_alpha = [](int first, int others) {
    PlyBuilder b(PlyFormat::kAscii);
    b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
    for (const char* name : {"red", "green", "blue", "alpha"}) b.property("uchar", name);
    b.element("face", 1).list("uchar", "int", "vertex_indices");
    b.begin_data();
    for (int i = 0; i < 3; ++i) {
      b.floats({double(i), double(i * i), 0}).uchars({9, 9, 9, i == 0 ? first : others}).end_row();
    }
    b.uchars({3}).ints({0, 1, 2}).end_row();
    return loaded(b.file());
  };
  CHECK(with_alpha(255, 255).materials[0].alpha_mode == AlphaMode::kOpaque);
  CHECK(with_alpha(0, 255).materials[0].alpha_mode == AlphaMode::kBlend);
  const Scene unset = with_alpha(0, 0);
  CHECK(unset.materials[0].alpha_mode == AlphaMode::kOpaque);
  CHECK(unset.meshes[0].colors[0].a == 1);
  REQUIRE(unset.warnings.size() == 1);
  CHECK(unset.warnings[0].find("alpha") != std::string::npos);
}

TEST_CASE("PLY: what is not drawn is named, with its count") {
  PlyBuilder b(PlyFormat::kAscii);
  b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
  b.property("float", "confidence").property("float", "intensity");
  b.property("float", "nx").property("float", "ny").property("float", "nz");
  b.element("edge", 2).property("int", "vertex1").property("int", "vertex2");
  b.element("face", 3).property("uchar", "flags").list("uchar", "int", "vertex_indices");
  b.begin_data();
  b.floats({0, 0, 0, 1, 1, 0, 0, 0}).end_row();
  b.floats({1, 0, 0, 1, 1, 0, 0, 1}).end_row();
  b.floats({0, 1, 0, 1, 1}).words("nan 0 1").end_row();
  b.ints({0, 1}).end_row();
  b.ints({1, 2}).end_row();
  b.uchars({0, 2}).ints({0, 1}).end_row();
  b.uchars({0, 3}).ints({0, 1, 2}).end_row();
  b.uchars({0, 0}).end_row();
  const Scene scene = loaded(b.file());
  CHECK(scene.warnings ==
        std::vector<std::string>{
            "2 faces of fewer than three corners were left out (first: face 0)",
            "2 normals are zero or not finite and were left out (first: vertex 0)",
            "vertex properties are not drawn: confidence, intensity",
            "elements are not drawn: edge (2)", "face properties are not drawn: flags"});
  CHECK(scene.meshes[0].corners[0].normal == kNone);
  CHECK(scene.meshes[0].corners[1].normal == 1);
}

TEST_CASE("PLY: a list that has the name of a number is not read as one") {
  PlyBuilder b(PlyFormat::kAscii);
  b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
  for (const char* name : {"red", "green", "blue"}) b.list("uchar", "float", name);
  b.element("face", 1).list("uchar", "int", "vertex_indices");
  b.begin_data();
  for (int i = 0; i < 3; ++i) {
    b.floats({double(i % 2), double(i / 2), 0});
    for (int channel = 0; channel < 3; ++channel) b.uchars({1}).floats({0.5});
    b.end_row();
  }
  b.uchars({3}).ints({0, 1, 2}).end_row();
  const Scene scene = loaded(b.file());
  CHECK(scene.meshes[0].colors.empty());
  CHECK(scene.warnings ==
        std::vector<std::string>{"vertex properties are not drawn: red, green, blue"});
}

TEST_CASE("PLY: a texture that the header names is read from the file's own folder") {
  const TemporaryDirectory folder;
  const auto png = encode_png(Image<Rgba8>(2, 1, {1, 2, 3, 255}));
  REQUIRE(png);
  std::ofstream(folder.file("skin one.png"), std::ios::binary)
      .write(reinterpret_cast<const char*>(png->data()), std::streamsize(png->size()));
  const auto with_texture = [&](const std::string& name, bool coordinates) {
    PlyBuilder b(PlyFormat::kLittleEndian);
    b.comment("TextureFile " + name);
    b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
    if (coordinates) b.property("float", "u").property("float", "v");
    b.element("face", 1).list("uchar", "int", "vertex_indices");
    b.begin_data();
    for (int i = 0; i < 3; ++i) {
      b.floats({double(i), double(i * i), 0});
      if (coordinates) b.floats({0, 1});
    }
    b.uchars({3}).ints({0, 1, 2});
    std::ofstream(folder.file("a.ply"), std::ios::binary) << b.file();
    const auto scene = load_scene(folder.file("a.ply"));
    REQUIRE(scene);
    return *scene;
  };
  const Scene scene = with_texture("skin one.png", true);
  CHECK(scene.name == "a");
  CHECK(scene.warnings.empty());
  REQUIRE(scene.materials[0].texture);
  CHECK(scene.images[0].width == 2);
  for (const char* absent : {"none.png", "../skin one.png", "/etc/passwd", "a.ply"}) {
    CAPTURE(absent);
    const Scene without = with_texture(absent, true);
    CHECK_FALSE(without.materials[0].texture);
    REQUIRE(without.warnings.size() == 1);
    CHECK(without.warnings[0].find("was left out: ") != std::string::npos);
    CHECK(without.warnings[0].find("OBJ") == std::string::npos);
  }
  CHECK(with_texture("../skin one.png", true)
            .warnings[0]
            .ends_with("lies outside the directory of the PLY file"));
  CHECK(with_texture("skin one.png", false).warnings.size() == 1);
}

}  // namespace
}  // namespace glassbox::test
