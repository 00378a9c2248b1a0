#include <glassbox/mesh/obj/load.h>

#include <filesystem>
#include <system_error>

#include <glassbox/images/read.h>
#include <glassbox/mesh/input/directory.h>
#include <glassbox/mesh/input/files.h>
#include <glassbox/mesh/obj/build.h>
#include <glassbox/mesh/obj/materials.h>
#include <glassbox/mesh/obj/parse.h>
#include <glassbox/mesh/obj/smoothing.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

struct MtlText {
  std::string_view text;
  bool is_all = true;  // true: no library that the OBJ text names is missing
};

// The common steps of reading from a file and from memory. If `mtl` is given, it is the only
// library.
Result<Scene> load_text(std::string_view text, const MtlText* mtl, obj::Directory directory,
                        const LoadLimits& limits) {
  obj::Warnings warnings;
  auto tables = obj::parse_obj(text, limits, warnings);
  if (!tables) return tl::unexpected(tables.error());
  obj::add_group_normals(*tables);
  Scene scene;
  obj::MaterialMaker materials(scene, directory, limits, warnings);
  if (mtl != nullptr) {
    materials.add_library(mtl->text, "the MTL text");
    if (!mtl->is_all && !tables->libraries.empty()) {
      warnings.add(
          "material libraries are not read, because the OBJ text is not a file beside them: faces "
          "are drawn without their materials");
    }
  } else {
    for (const std::string& names : tables->libraries) materials.read_libraries(names);
  }
  obj::build_meshes(*tables, materials, scene, warnings);
  scene.warnings = warnings.take();
  return scene;
}

Result<std::vector<std::byte>> read_obj(const std::string& path, const LoadLimits& limits) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return fail("", "there is no such file", "check the path");
  // Reading a pipe or device might never end.
  if (!fs::is_regular_file(status)) {
    return fail("", "is not a regular file", "give the path of a file");
  }
  return read_file(path, limits.max_file_bytes);
}

}  // namespace

Result<Scene> load_obj(const std::string& path, const LoadLimits& limits) {
  return naming_file(path, [&]() -> Result<Scene> {
    const auto bytes = read_obj(path, limits);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto scene =
        load_text(text, nullptr, obj::Directory(path, "OBJ", limits.max_file_bytes), limits);
    if (!scene) return scene;
    scene->name = fs::path(path).stem().string();
    scene->file = path;
    return scene;
  });
}

Result<Scene> load_obj_memory(std::string_view obj_text, std::string_view mtl,
                              const LoadLimits& limits) {
  if (obj_text.size() > limits.max_file_bytes || mtl.size() > limits.max_file_bytes) {
    return fail(
        "",
        "has more than " + std::to_string(limits.max_file_bytes) + " bytes, the most that is read",
        "use a smaller file (in the library: LoadLimits::max_file_bytes)");
  }
  const MtlText library{mtl, true};
  return naming_file("", [&] { return load_text(obj_text, &library, obj::Directory(), limits); });
}

Result<Scene> load_obj_alone(std::string_view obj_text, const LoadLimits& limits) {
  const MtlText nothing{{}, false};
  return naming_file("", [&] { return load_text(obj_text, &nothing, obj::Directory(), limits); });
}

}  // namespace glassbox
