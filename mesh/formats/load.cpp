#include <glassbox/mesh/formats/load.h>

#include <filesystem>
#include <system_error>

#include <glassbox/base/ascii_case.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/gltf/load.h>
#include <glassbox/mesh/obj/load.h>
#include <glassbox/mesh/ply/load.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

bool is_plain_word(const std::string& text) {
  return text.find_first_of("/\\.") == std::string::npos;
}

std::string lower_case_extension(const std::string& path) {
  return lower_case(fs::path(path).extension().string());
}

tl::unexpected<Error> refuse(const std::string& file, std::string cause, std::string remedy) {
  return tl::unexpected<Error>(Error{file, {}, std::move(cause), std::move(remedy)});
}

// Checks that a path is a readable file before a loader opens it.
Result<void> check_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    const bool missing = !error || error == std::errc::no_such_file_or_directory;
    return refuse(path, missing ? "there is no such file" : "cannot be opened: " + error.message(),
                  "check the path, or name a built-in scene: " + list_builtins());
  }
  if (fs::is_directory(status))
    return refuse(path, "is a directory", "name a .gltf, .glb, .obj or .ply file in it");
  return {};
}

}  // namespace

bool is_gltf_name(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".gltf" || extension == ".glb";
}

Result<Scene> load_scene(const std::string& name_or_path, const LoadLimits& limits) {
  if (name_or_path.empty()) {
    return fail("scene", "the name is empty",
                "name a file or a built-in scene: " + list_builtins());
  }
  std::error_code ignored;
  const bool is_there = fs::exists(name_or_path, ignored);
  if (find_builtin(name_or_path) != nullptr || (is_plain_word(name_or_path) && !is_there)) {
    return make_builtin(name_or_path);
  }

  if (const Result<void> file = check_file(name_or_path); !file)
    return tl::unexpected(file.error());
  const std::string extension = lower_case_extension(name_or_path);
  if (is_gltf_name(name_or_path)) return load_gltf(name_or_path, limits);
  if (extension == ".obj") return load_obj(name_or_path, limits);
  if (extension == ".ply") return load_ply(name_or_path, limits);
  return refuse(
      name_or_path,
      extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
      "scenes are read from .gltf, .glb, .obj and .ply files; built-in scenes are " +
          list_builtins());
}

}  // namespace glassbox
