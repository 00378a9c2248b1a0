#include <glassbox/mesh/formats/load_memory.h>

#include <algorithm>
#include <string>
#include <string_view>

#include <glassbox/base/utf8.h>
#include <glassbox/mesh/gltf/load.h>
#include <glassbox/mesh/obj/load.h>
#include <glassbox/mesh/ply/header.h>
#include <glassbox/mesh/ply/load.h>

namespace glassbox {

std::optional<SceneFormat> format_of(std::span<const std::byte> bytes) {
  constexpr std::size_t kBeginning = 1024;
  std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                        std::min(bytes.size(), kBeginning));
  if (text.starts_with("glTF")) return SceneFormat::kGlb;
  std::string converted;
  if (const auto order = utf16_byte_order(text)) text = converted = utf8_of_utf16(text, *order);
  if (ply::begins_as_ply(text) && text.find_first_of("\r\n") != std::string_view::npos)
    return SceneFormat::kPly;
  if (text.find('\0') != std::string_view::npos) return std::nullopt;
  text = without_byte_order_mark(text);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return std::nullopt;
  return text[start] == '{' ? SceneFormat::kGltf : SceneFormat::kObj;
}

Result<Scene> load_scene_memory(std::span<const std::byte> bytes, const LoadLimits& limits) {
  if (bytes.empty()) return fail("", "the input is empty", "give a glTF, GLB, OBJ or PLY file");
  if (bytes.size() > limits.max_file_bytes) {
    return fail(
        "",
        "has more than " + std::to_string(limits.max_file_bytes) + " bytes, the most that is read",
        "use a smaller file (in the library: LoadLimits::max_file_bytes)");
  }
  const std::optional<SceneFormat> format = format_of(bytes);
  if (!format) {
    return fail("", "is neither GLB nor glTF nor OBJ nor PLY",
                "give a file in one of these formats");
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  switch (*format) {
    case SceneFormat::kObj:
      return load_obj_alone(text, limits);
    case SceneFormat::kPly:
      return load_ply_memory(text, limits);
    case SceneFormat::kGlb:
    case SceneFormat::kGltf:
      break;
  }
  return load_gltf_memory(bytes, "", limits);
}

}  // namespace glassbox
