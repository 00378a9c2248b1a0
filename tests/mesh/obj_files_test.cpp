#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <glassbox/mesh/obj/load.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\n";

// An uncompressed 24-bit TGA of one colour.
std::string tga(int width, int height, char blue) {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = char(width & 0xff);
  bytes[13] = char(width >> 8);
  bytes[14] = char(height & 0xff);
  bytes[15] = char(height >> 8);
  bytes[16] = 24;
  for (int i = 0; i < width * height; ++i) bytes += std::string{blue, 0, 0};
  return bytes;
}

// A directory "scene" with files, whose parent has files that must not be read. Removed at the end.
class Folder {
public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "glassbox-obj-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    parent_ = name;
    fs::create_directories(parent_ / "scene" / "sub");
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(parent_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path path(const std::string& name) const { return parent_ / "scene" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  Result<Scene> load(const LoadLimits& limits = {}) const {
    return load_obj(path("a.obj").string(), limits);
  }
  // Loads a triangle that has this line before it.
  Scene load_with(const std::string& line, const LoadLimits& limits = {}) const {
    write("a.obj", line + "\n" + kTriangle + "usemtl m\nf 1/1 2/2 3/2\n");
    auto scene = load(limits);
    INFO((scene ? std::string() : scene.error().message()));
    REQUIRE(scene);
    return std::move(*scene);
  }

private:
  fs::path parent_;
};

bool warns_of(const Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

bool has_material(const Scene& scene) {
  return scene.materials[0].base_color.g == 0;
}

}  // namespace

TEST_CASE("OBJ files: libraries and textures beside the file are read") {
  const Folder folder;
  folder.write("a.mtl", "newmtl m\nKd 1 0 0\nmap_Kd -s 2 4 -o 0.5 0.25 sub\\my picture.tga\n");
  folder.write("sub/my picture.tga", tga(2, 1, '\x07'));
  const Scene scene = folder.load_with("mtllib a.mtl");
  CHECK(scene.name == "a");
  CHECK(scene.file == folder.path("a.obj").string());
  CHECK(scene.warnings.empty());
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0].width == 2);
  CHECK(scene.images[0].pixels[1] == Rgba8{0, 0, 7, 255});
  REQUIRE(scene.textures.size() == 1);
  CHECK(scene.textures[0].sampler == Sampler{});
  CHECK(scene.materials[0].texture == 0u);
  // (u, v) becomes (2 u + 0.5, 1 - (4 v + 0.25)).
  CHECK(scene.meshes[0].texcoords[0] == TexCoord{0.5f, 0.75f});
  CHECK(scene.meshes[0].texcoords[1] == TexCoord{2.5f, -0.25f});
}

TEST_CASE("OBJ files: mtllib takes one name with blanks, several names, or escaped blanks") {
  const Folder folder;
  folder.write("with blanks.mtl", "newmtl m\nKd 1 0 0\n");
  for (const std::string line :
       {"mtllib with blanks.mtl", "mtllib with blanks.mtl # comment",
        "mtllib none.mtl with\\ blanks.mtl", "mtllib with\\ blanks.mtl  none.mtl",
        "mtllib .\\with blanks.mtl", "mtllib ./sub/../with blanks.mtl",
        "mtllib\t  with blanks.mtl \t"}) {
    CAPTURE(line);
    CHECK(has_material(folder.load_with(line)));
  }
}

TEST_CASE("OBJ files: one picture used by several materials is decoded once") {
  const Folder folder;
  folder.write("p.tga", tga(1, 1, 1));
  folder.write(
      "a.mtl",
      "newmtl m\nmap_Kd p.tga\nnewmtl n\nmap_Kd ./p.tga\nnewmtl o\nmap_Kd -clamp on p.tga\n");
  folder.write("a.obj", "mtllib a.mtl\n" + kTriangle + "usemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\n" +
                            "usemtl o\nf 1 2 3\n");
  const auto scene = folder.load();
  REQUIRE(scene);
  CHECK(scene->images.size() == 1);
  REQUIRE(scene->textures.size() == 2);
  CHECK(scene->materials[1].texture == 0u);
  CHECK(scene->materials[2].texture == 1u);
  CHECK(scene->textures[1].sampler.wrap_u == Wrap::kClampToEdge);
  CHECK(scene->textures[1].sampler.wrap_v == Wrap::kClampToEdge);
}

TEST_CASE("OBJ files: a map_d that is the map_Kd says that the picture's alpha counts") {
  const Folder folder;
  folder.write("p.tga", tga(1, 1, 1));
  folder.write("a.mtl", "newmtl m\nmap_Kd p.tga\nmap_d p.tga\n");
  CHECK(folder.load_with("mtllib a.mtl").materials[0].alpha_mode == AlphaMode::kBlend);
  folder.write("a.mtl", "newmtl m\nmap_Kd p.tga\nmap_d q.tga\n");
  const Scene scene = folder.load_with("mtllib a.mtl");
  CHECK(scene.materials[0].alpha_mode == AlphaMode::kOpaque);
  CHECK(warns_of(scene, "map_d"));
}

TEST_CASE(
    "OBJ files: a map_Ke is drawn where one table of texture coordinates does for it and map_Kd") {
  const Folder folder;
  folder.write("p.tga", tga(1, 1, 1));
  folder.write("q.tga", tga(1, 1, 2));
  folder.write("a.mtl", "newmtl m\nKd 1 0 0\nmap_Ke -s 2 4 q.tga\n");
  const Scene alone = folder.load_with("mtllib a.mtl");
  CHECK(alone.materials[0].emission == std::array<float, 3>{1, 1, 1});
  CHECK(alone.materials[0].emission_texture == 0u);
  CHECK_FALSE(alone.materials[0].texture);
  CHECK(alone.meshes[0].texcoords[1] == TexCoord{2, 0});  // v is 0.25 in the file
  folder.write("a.mtl", "newmtl m\nKe 3 0 0\nmap_Kd -s 2 4 p.tga\nmap_Ke -s 2 4 q.tga\n");
  const Scene both = folder.load_with("mtllib a.mtl");
  CHECK(both.materials[0].emission == std::array<float, 3>{3, 0, 0});
  CHECK(both.materials[0].texture == 0u);
  CHECK(both.materials[0].emission_texture == 1u);
  CHECK(both.warnings.empty());
  folder.write("a.mtl", "newmtl m\nKe 3 0 0\nmap_Kd p.tga\nmap_Ke -s 2 4 q.tga\n");
  const Scene apart = folder.load_with("mtllib a.mtl");
  CHECK(apart.materials[0].emission == std::array<float, 3>{0, 0, 0});
  CHECK_FALSE(apart.materials[0].emission_texture);
  CHECK(warns_of(apart, "(map_Ke) with other coordinates"));
}

TEST_CASE("OBJ files: nothing outside the file's directory is read") {
  const Folder folder;
  const std::string red = "newmtl m\nKd 1 0 0\n";
  folder.write("../secret.mtl", red);
  folder.write("../secret.tga", tga(1, 1, 1));
  fs::create_symlink(folder.path("../secret.mtl"), folder.path("link.mtl"));
  fs::create_directory_symlink(folder.path(".."), folder.path("up"));
  const std::string absolute = fs::canonical(folder.path("../secret.mtl")).string();
  for (const std::string& name :
       {std::string("../secret.mtl"), std::string("..\\secret.mtl"),
        std::string("sub/../../secret.mtl"), std::string("./sub/..//..\\secret.mtl"), absolute,
        "C:" + absolute, std::string("link.mtl"), std::string("up/secret.mtl"),
        std::string("..")}) {
    CAPTURE(name);
    const Scene scene = folder.load_with("mtllib " + name);
    CHECK_FALSE(has_material(scene));
    // One for the library, one for the material that it would have defined.
    CHECK(scene.warnings.size() == 2);
  }
  folder.write("a.mtl", "newmtl m\nmap_Kd ../secret.tga\n");
  const Scene scene = folder.load_with("mtllib a.mtl");
  CHECK(scene.images.empty());
  CHECK(warns_of(scene, "lies outside"));
}

TEST_CASE("OBJ files: what is missing, broken or no file is left out with a warning") {
  const Folder folder;
  CHECK(warns_of(folder.load_with("mtllib none.mtl"), "'none.mtl' does not exist"));
  CHECK(warns_of(folder.load_with("mtllib sub"), "not a regular file"));
  REQUIRE(mkfifo(folder.path("pipe.mtl").c_str(), 0600) == 0);
  CHECK(warns_of(folder.load_with("mtllib pipe.mtl"), "not a regular file"));
  folder.write("broken.png", "\x89PNG\r\n\x1a\n");
  folder.write("a.mtl", "newmtl m\nmap_Kd broken.png\n");
  const Scene scene = folder.load_with("mtllib a.mtl");
  CHECK(scene.images.empty());
  CHECK(warns_of(scene, "'broken.png' was left out"));
}

TEST_CASE("OBJ files: limits count all files and all pictures together") {
  const Folder folder;
  folder.write("p.tga", tga(30, 10, 1));
  folder.write("q.tga", tga(30, 10, 2));
  folder.write("a.mtl", "newmtl m\nmap_Kd p.tga\nnewmtl n\nmap_Kd q.tga\n");
  const std::string more = "mtllib a.mtl\nv 0 0 0\nusemtl n\np 1\n";
  LoadLimits limits;
  limits.max_image_pixels = 600;
  CHECK(folder.load_with(more, limits).images.size() == 2);
  limits.max_image_pixels = 599;
  CHECK(folder.load_with(more, limits).images.size() == 1);
  limits = {};
  limits.max_image_side = 29;
  CHECK(folder.load_with(more, limits).images.empty());
  limits = {};
  limits.max_file_bytes = 1500;  // one picture has 918 bytes
  CHECK(folder.load_with(more, limits).images.size() == 1);
  limits.max_file_bytes = 50;
  CHECK_FALSE(folder.load(limits));
}

TEST_CASE("OBJ files: a path that is no readable file is an error that names it") {
  const Folder folder;
  REQUIRE(mkfifo(folder.path("pipe.obj").c_str(), 0600) == 0);
  for (const std::string name : {"none.obj", "sub", "pipe.obj"}) {
    const auto scene = load_obj(folder.path(name).string());
    REQUIRE_FALSE(scene);
    CHECK(scene.error().file == folder.path(name).string());
    CHECK_FALSE(scene.error().remedy.empty());
  }
  folder.write("a.obj", "v 0 0 0\nf 1 2 3\n");
  const auto scene = folder.load();
  REQUIRE_FALSE(scene);
  CHECK(scene.error().message().starts_with(folder.path("a.obj").string() + ": line 2: "));
}

}  // namespace glassbox
