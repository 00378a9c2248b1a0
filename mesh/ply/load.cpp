#include <glassbox/mesh/ply/load.h>

#include <filesystem>
#include <string>

#include <glassbox/images/decode.h>
#include <glassbox/mesh/input/directory.h>
#include <glassbox/mesh/input/files.h>
#include <glassbox/mesh/ply/build.h>

namespace glassbox {
namespace {

// Adds the first texture that the header names, if it can be read.
void add_texture(const std::vector<std::string>& names, obj::Directory directory,
                 const LoadLimits& limits, Scene& scene, obj::Warnings& warnings) {
  if (names.empty()) return;
  const auto leave_out = [&](const std::string& why) {
    warnings.add("the texture " + in_quotes(names.front()) + " was left out: " + why);
  };
  if (names.size() > 1) {
    warnings.add(std::to_string(names.size() - 1) + " textures beside the first are not drawn");
  }
  if (scene.meshes.front().texcoords.empty()) return leave_out("there are no texture coordinates");
  const auto path = directory.find(names.front());
  if (!path) return leave_out(path.error().cause);
  const auto bytes = directory.read(*path);
  if (!bytes) return leave_out(bytes.error().cause);
  auto image = decode_image(*bytes, {limits.max_image_pixels, limits.max_image_side});
  if (!image) return leave_out(image.error().cause);
  scene.images.push_back(std::move(*image));
  scene.textures.push_back({0, {}});
  scene.materials.front().texture = 0;
}

Result<Scene> load_bytes(std::string_view bytes, obj::Directory directory,
                         const LoadLimits& limits) {
  const auto header = ply::parse_header(bytes);
  if (!header) return tl::unexpected(header.error());
  obj::Warnings warnings;
  auto built = ply::build_mesh(bytes, *header, limits, warnings);
  if (!built) return tl::unexpected(built.error());
  Scene scene;
  Material& material = scene.materials.emplace_back();
  material.name = "default";
  material.double_sided = true;
  if (built->translucent) material.alpha_mode = AlphaMode::kBlend;
  scene.meshes.push_back(std::move(built->mesh));
  scene.nodes.emplace_back();
  scene.instances.push_back({0, 0});
  add_texture(header->textures, std::move(directory), limits, scene, warnings);
  scene.warnings = warnings.take();
  return scene;
}

}  // namespace

Result<Scene> load_ply(const std::string& path, const LoadLimits& limits) {
  return naming_file(path, [&]() -> Result<Scene> {
    const auto bytes = gltf::read_whole_file(path, limits.max_file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto scene = load_bytes(text, obj::Directory(path, "PLY", limits.max_file_bytes), limits);
    if (!scene) return scene;
    scene->name = std::filesystem::path(path).stem().string();
    scene->file = path;
    return scene;
  });
}

Result<Scene> load_ply_memory(std::string_view bytes, const LoadLimits& limits) {
  if (bytes.size() > limits.max_file_bytes) {
    return fail(
        "",
        "has more than " + std::to_string(limits.max_file_bytes) + " bytes, the most that is read",
        "use a smaller file (in the library: LoadLimits::max_file_bytes)");
  }
  return naming_file("", [&] { return load_bytes(bytes, obj::Directory(), limits); });
}

}  // namespace glassbox
