#include <glassbox/mesh/formats/load.h>

#include <filesystem>
#include <fstream>

#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

// A folder that is removed when the test ends.
class TemporaryFolder {
public:
  TemporaryFolder() : path_(fs::temp_directory_path() / "glassbox_load_test") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  std::string path() const { return path_.string(); }

private:
  fs::path path_;
};

constexpr const char* kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_CASE("a plain word is a built-in scene, with or without a level") {
  CHECK(load_scene("cube").value().name == "cube");
  CHECK(load_scene("teapot:3").value().name == "teapot");
  CHECK(load_scene("depth-ladder").value().name == "depth-ladder");
}

TEST_CASE("a path is read according to its extension, in either case") {
  const TemporaryFolder folder;
  for (const char* name : {"a.obj", "b.OBJ"}) {
    const Result<Scene> scene = load_scene(folder.write(name, kTriangleObj));
    REQUIRE(scene.has_value());
    REQUIRE(scene->meshes.size() == 1);
    CHECK(scene->meshes[0].faces.size() == 1);
  }
}

TEST_CASE("a PLY file is read by its extension, and a folder's hint names it") {
  const TemporaryFolder folder;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Result<Scene> scene = load_scene(folder.write("scan.PLY", ply));
  REQUIRE(scene.has_value());
  CHECK(scene->name == "scan");
  CHECK(scene->meshes[0].faces.size() == 1);
  CHECK(load_scene(folder.path() + "/.").error().remedy.find(".ply") != std::string::npos);
}

TEST_CASE("what cannot be loaded is refused with file, cause and remedy") {
  const TemporaryFolder folder;
  const auto message = [](const std::string& name) {
    const Result<Scene> scene = load_scene(name);
    REQUIRE_FALSE(scene.has_value());
    CHECK_FALSE(scene.error().remedy.empty());
    return scene.error().message();
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(contains(message("teapott"), "did you mean 'teapot'?"));
  CHECK(contains(message("bunny"),
                 "teapot, cube, sphere, forest, room, checker, thicket, f-glyph, depth-ladder"));
  CHECK(contains(message("./teapot"), "./teapot: there is no such file"));
  CHECK(contains(message("no/such/duck.glb"), "no/such/duck.glb: there is no such file"));
  CHECK(contains(message(folder.path() + "/teapot.obj/x"), "there is no such file"));
  CHECK(contains(message(folder.write("mesh.stl", "solid")), "unknown extension '.stl'"));
  CHECK(contains(message(folder.write("teapot", "?")), "has no extension"));
  CHECK(contains(message(folder.path() + "/."), "is a directory"));
  CHECK(contains(message(""), "the name is empty"));
  std::filesystem::create_directory("folder_without_extension");
  CHECK(contains(message("folder_without_extension"), "is a directory"));
  std::filesystem::remove("folder_without_extension");
}

}  // namespace
}  // namespace glassbox::test
