// What is in a glTF file, drawn or not: for a reader who asks what a picture lacks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/limits.h>

namespace glassbox {

// Lists are in the file's order; names are as the file has them.
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
    std::vector<std::string> attributes;  // in the order of their names
    std::size_t morph_targets = 0;
  };
  // What a texture is for: "base colour", "emission", "normal", ...
  struct TextureUse {
    std::string what;
    std::size_t materials = 0;
    bool drawn = false;  // some material of the drawn scene shows it
  };
  struct Texture {
    std::string name;
    std::uint32_t width = 0, height = 0;  // px; 0 where the file does not say, or has no such image
    std::vector<TextureUse> uses;
  };
  std::vector<Animation> animations;
  std::vector<Skin> skins;
  std::vector<Primitive> primitives;
  std::vector<Texture> textures;
};

// Of a .gltf or .glb file; images are looked up for their sizes and not decoded.
Result<GltfContents> list_gltf(const std::string& path, const LoadLimits& limits = {});

// Of a glTF file in memory. External files are looked for in `directory`; "" means that there are none at all.
Result<GltfContents> list_gltf_memory(std::span<const std::byte> bytes,
                                      const std::string& directory, const LoadLimits& limits = {});

}  // namespace glassbox
