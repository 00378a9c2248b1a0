#include <cctype>
#include <string>

#include <glassbox/mesh/obj/load.h>
#include <glassbox/mesh/obj/mtl.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

// The material "m" when this MTL text follows "newmtl m".
Material material(const std::string& statements) {
  const auto scene = load_obj_memory("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n",
                                     "newmtl m\n" + statements + "\n");
  REQUIRE(scene);
  REQUIRE(scene->materials.size() == 1);
  return scene->materials[0];
}

Scene with_usemtl(const std::string& name, const std::string& mtl) {
  auto scene = load_obj_memory("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + name + "\nf 1 2 3\n", mtl);
  REQUIRE(scene);
  return std::move(*scene);
}

using Rgb = std::array<float, 3>;

}  // namespace

TEST_CASE("MTL: colours are linear factors, clamped to [0, 1]") {
  CHECK(material("Kd 0.25 0.5 1").base_color == Rgba{0.25f, 0.5f, 1, 1});
  CHECK(material("Kd 0.25").base_color == Rgba{0.25f, 0.25f, 0.25f, 1});
  CHECK(material("Kd 20 -1 1e30").base_color == Rgba{1, 0, 1, 1});
  CHECK(material("Ks 0.25 0.5 1").specular == Rgb{0.25f, 0.5f, 1});
  CHECK(material("").base_color == Rgba{1, 1, 1, 1});
  CHECK(material("").specular == Rgb{0, 0, 0});
  CHECK(material("Kd nan 0 0\nKd spectral a.rfl\nKd").base_color == Rgba{1, 1, 1, 1});
}

TEST_CASE("MTL: what a surface emits may be brighter than white, and unlit ones emit nothing") {
  CHECK(material("Ke 0.25 0.5 4").emission == Rgb{0.25f, 0.5f, 4});
  CHECK(material("Ke 2").emission == Rgb{2, 2, 2});
  CHECK(material("Ke -1 0 1").emission == Rgb{0, 0, 1});
  CHECK(material("").emission == Rgb{0, 0, 0});
  CHECK(material("Ke nan 0 0").emission == Rgb{0, 0, 0});
  CHECK(material("Ke 1 1 1\nillum 0").emission == Rgb{0, 0, 0});
  // The texture is missing: without it the whole surface would emit light.
  CHECK(material("Ke 1 1 1\nmap_Ke a.png").emission == Rgb{0, 0, 0});
}

TEST_CASE("MTL: textures that are not drawn are named once for each kind, with their number") {
  const Scene scene =
      with_usemtl("m", "newmtl m\nmap_Bump -bm 2 a.png\nmap_Ks b.png\nnewmtl n\nmap_Bump c.png\n");
  REQUIRE(scene.warnings.size() == 2);
  CHECK(scene.warnings[0].find("not drawn: map_Bump (2)") != std::string::npos);
  CHECK(scene.warnings[1].find("not drawn: map_Ks (1)") != std::string::npos);
}

TEST_CASE("MTL: keywords and options may be written in any case, names may not") {
  // A file of every statement that is read, and what becomes of it.
  const std::string file =
      "newmtl M\nKd 0.25 0.5 1\nKs 0.5 0.25 1\nKe 1 2 3\nNs 30\nd 0.5\nillum 2\n"
      "map_Kd -s 2 2 -clamp on a.png\nmap_Bump b.png\nKa 1 1 1\nTf 1 1 1\n";
  const auto in_case = [&](int (*change)(int)) {
    std::string text = file;
    for (std::size_t line = 0; line < text.size(); line = text.find('\n', line) + 1) {
      for (std::size_t i = line; text[i] != ' '; ++i) text[i] = char(change(text[i]));
    }
    return with_usemtl("M", text);
  };
  const Scene as_written = with_usemtl("M", file);
  REQUIRE(as_written.materials[0].base_color == Rgba{0.25f, 0.5f, 1, 0.5f});
  for (const Scene& scene : {in_case(std::toupper), in_case(std::tolower)}) {
    const Material &a = as_written.materials[0], &b = scene.materials[0];
    CHECK(b.name == "M");
    CHECK(b.base_color == a.base_color);
    CHECK(b.specular == a.specular);
    CHECK(b.emission == a.emission);
    CHECK(b.shininess == a.shininess);
    CHECK(b.alpha_mode == a.alpha_mode);
    REQUIRE(scene.warnings.size() == as_written.warnings.size());
  }
  CHECK(with_usemtl("m", file).materials[0].base_color == Rgba{1, 1, 1, 1});
  const obj::MapStatement map = obj::parse_map("-O 0.5 -S 2 -CLAMP ON a.png");
  CHECK(map.offset[0] == 0.5f);
  CHECK(map.scale[0] == 2);
  CHECK(map.clamp);
}

TEST_CASE("MTL: unknown statements and those of no material are named, not passed over") {
  const Scene scene =
      with_usemtl("m", "Kd 1 0 0\nnewmtl m\nKdd 1 0 0\nmap_Diffuse a.png\nNi 1.5\nPr 0.5\n");
  CHECK(scene.warnings ==
        std::vector<std::string>{
            "1 statement of 'the MTL text' stands before the first newmtl and was ignored (first "
            "in line 1)",
            "2 unknown statements of 'the MTL text' were ignored, 'Kdd' among them (first in line "
            "3)"});
}

TEST_CASE("MTL: exponents are rounded into 1 .. 1024") {
  CHECK(material("Ns 30.5").shininess == 31);
  CHECK(material("Ns 30.49").shininess == 30);
  CHECK(material("Ns 0").shininess == 1);
  CHECK(material("Ns -5").shininess == 1);
  CHECK(material("Ns 1e30").shininess == 1024);
}

TEST_CASE("MTL: d is opacity, Tr is transparency, d counts where both stand") {
  CHECK(material("d 1").alpha_mode == AlphaMode::kOpaque);
  CHECK(material("d 0.75").alpha_mode == AlphaMode::kBlend);
  CHECK(material("d 0.75").base_color.a == 0.75f);
  CHECK(material("Tr 0.25").base_color.a == 0.75f);
  CHECK(material("d 0.5\nTr 0.25").base_color.a == 0.5f);
  CHECK(material("Tr 0.25\nd 0.5").base_color.a == 0.5f);
  CHECK(material("d -halo 0.5").base_color.a == 0.5f);
  CHECK(material("d 7").base_color.a == 1);
  CHECK(material("d 7").alpha_mode == AlphaMode::kOpaque);
}

TEST_CASE("MTL: illum 0 is unlit and illum 1 has no highlight") {
  CHECK(material("illum 0").unlit);
  CHECK_FALSE(material("illum 2").unlit);
  CHECK(material("Ks 1 1 1\nillum 1").specular == Rgb{0, 0, 0});
  CHECK(material("Ks 1 1 1\nillum 2").specular == Rgb{1, 1, 1});
  CHECK(material("Ks 1 1 1").specular == Rgb{1, 1, 1});
}

TEST_CASE("MTL: names may hold blanks and hashes, and end in a comment") {
  const std::string mtl =
      "newmtl Red Color\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\nnewmtl Material #26\nKd 0 0 1\n"
      "  newmtl   plain # comment\nKd 1 1 0\n";
  CHECK(with_usemtl("Red Color", mtl).materials[0].base_color == Rgba{1, 0, 0, 1});
  CHECK(with_usemtl("  Red Color \t", mtl).materials[0].base_color == Rgba{1, 0, 0, 1});
  CHECK(with_usemtl("Red Color # yes", mtl).materials[0].base_color == Rgba{1, 0, 0, 1});
  CHECK(with_usemtl("Material #26", mtl).materials[0].base_color == Rgba{0, 0, 1, 1});
  CHECK(with_usemtl("plain", mtl).materials[0].base_color == Rgba{1, 1, 0, 1});
}

TEST_CASE("MTL: a material that is not defined is a default one with a warning") {
  const Scene scene = with_usemtl("nowhere", "newmtl m\nKd 1 0 0\n");
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].name == "nowhere");
  CHECK(scene.materials[0].base_color == Rgba{1, 1, 1, 1});
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0].find("'nowhere' is not defined") != std::string::npos);
}

TEST_CASE("MTL: of two materials with one name the first counts, with a warning") {
  const Scene scene = with_usemtl("m", "newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n");
  CHECK(scene.materials[0].base_color == Rgba{1, 0, 0, 1});
  CHECK(scene.warnings.size() == 1);
}

TEST_CASE("MTL: options of a map may leave arguments out and stand on either side of the name") {
  const obj::MapStatement map = obj::parse_map("-o 0.1 -s 2 3 -clamp on -mm 0 1 my file.png");
  CHECK(map.file == "my file.png");
  CHECK(map.offset == std::array<float, 2>{0.1f, 0});
  CHECK(map.scale == std::array<float, 2>{2, 3});
  CHECK(map.clamp);
  CHECK(obj::parse_map("-colorspace sRGB -o 0.1 diffuse.jpg").file == "diffuse.jpg");
  CHECK(obj::parse_map("-imfchan r bump 2.jpg  -bm 1.5").file == "bump 2.jpg");
  CHECK(obj::parse_map("a  b.png").file == "a  b.png");
  CHECK(obj::parse_map("texture #1.png").file == "texture #1.png");
  CHECK(obj::parse_map("-s 1 2 3 -clamp off 7").file == "7");
  CHECK_FALSE(obj::parse_map("-clamp off 7").clamp);
  CHECK(obj::parse_map("-s 4 5").file == "5");
  CHECK(obj::parse_map("-texture.png").file == "-texture.png");
  CHECK(obj::parse_map("").file.empty());
  CHECK(obj::parse_map("-clamp").file.empty());
}

TEST_CASE("MTL: a texture that is not there is left out with a warning") {
  const Scene scene = with_usemtl("m", "newmtl m\nKd 1 0 0\nmap_Kd a.png\n");
  CHECK_FALSE(scene.materials[0].texture);
  CHECK(scene.materials[0].base_color == Rgba{1, 0, 0, 1});
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0].find("'a.png' does not exist") != std::string::npos);
}

}  // namespace glassbox
