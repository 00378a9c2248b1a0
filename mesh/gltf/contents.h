// The contents of a glTF file, drawn or not: for users who want to know what is missing in a
// picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>

namespace glassbox {

// Lists are in the file's order; names are unchanged from the file.
struct GltfContents {
  struct Animation {
    std::string name;
    std::size_t channels = 0;
  };
  struct Skin {
    std::string name;
    std::size_t joints = 0;
  };
  struct Primitive {
    std::size_t mesh = 0, primitive = 0;
    std::string mesh_name;
    std::vector<std::string> attributes;  // sorted by name
    std::size_t morph_targets = 0;
  };
  // The purpose of a texture: "base colour", "emission", "normal", ...
  struct TextureUse {
    std::string what;
    std::size_t materials = 0;
    bool drawn = false;  // whether a material of the drawn scene shows it
  };
  struct Texture {
    std::string name;
    // The size in pixels; 0 if the file does not give the size or has no such image.
    std::uint32_t width = 0, height = 0;
    std::vector<TextureUse> uses;
  };
  std::vector<Animation> animations;
  std::vector<Skin> skins;
  std::vector<Primitive> primitives;
  std::vector<Texture> textures;
};

// Lists a .gltf or .glb file. Images are opened only to find their sizes, and not decoded.
Result<GltfContents> list_gltf(const std::string& path, const LoadLimits& limits = {});

// Lists a glTF file in memory. External files are searched in `directory`; "" means that there are
// none.
Result<GltfContents> list_gltf_memory(std::span<const std::byte> bytes,
                                      const std::string& directory, const LoadLimits& limits = {});

}  // namespace glassbox
