// Builds small glTF files in memory: a JSON document and the bytes of its only buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include <glassbox/mesh/gltf/load.h>

namespace glassbox::test {

using nlohmann::json;
using Bytes = std::vector<std::byte>;

inline Bytes bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return Bytes(bytes.begin(), bytes.end());
}

struct GltfBuilder {
  json document = {{"asset", {{"version", "2.0"}}}};
  Bytes binary;

  // Appends the numbers to the buffer. Returns the index of their buffer view.
  template <class T>
  std::size_t view(const std::vector<T>& numbers, std::size_t stride = 0) {
    while (binary.size() % 4 != 0) binary.push_back(std::byte(0));
    const std::size_t offset = binary.size();
    const auto bytes = std::as_bytes(std::span(numbers));
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    json described = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}};
    if (stride != 0) described["byteStride"] = stride;
    document["bufferViews"].push_back(described);
    return document["bufferViews"].size() - 1;
  }

  // Adds an accessor of a view; `more` adds properties to it or replaces them. Returns its index.
  std::size_t accessor(std::size_t view, int component_type, const char* type, std::size_t count,
                       const json& more = json::object()) {
    json described = {
        {"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}};
    described.update(more);
    document["accessors"].push_back(described);
    return document["accessors"].size() - 1;
  }

  std::size_t floats(const std::vector<float>& numbers, const char* type, std::size_t width) {
    return accessor(view(numbers), 5126, type, numbers.size() / width);
  }

  // Adds a mesh of one primitive, and a node of the scene that draws it. Returns the primitive.
  json& primitive(const json& described) {
    document["meshes"].push_back({{"primitives", {described}}});
    document["nodes"].push_back({{"mesh", document["meshes"].size() - 1}});
    return document["meshes"].back()["primitives"][0];
  }

  // Adds the positions of one triangle and a primitive that draws them. Returns the primitive.
  json& triangle() {
    const std::size_t positions = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    return primitive({{"attributes", {{"POSITION", positions}}}});
  }

  Bytes glb() const {
    json complete = document;
    if (!complete.contains("buffers") && !binary.empty())
      complete["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = complete.dump();
    while (text.size() % 4 != 0) text += ' ';
    Bytes padded = binary;
    while (padded.size() % 4 != 0) padded.push_back(std::byte(0));
    Bytes file;
    const auto word = [&file](std::size_t value) {
      for (int i = 0; i < 4; ++i) file.push_back(std::byte(value >> (8 * i) & 0xff));
    };
    const auto chunk = [&](std::size_t type, const Bytes& data) {
      word(data.size());
      word(type);
      file.insert(file.end(), data.begin(), data.end());
    };
    word(0x46546c67);
    word(2);
    word(12 + 8 + text.size() + (padded.empty() ? 0 : 8 + padded.size()));
    chunk(0x4e4f534a, bytes_of(text));
    if (!padded.empty()) chunk(0x004e4942, padded);
    return file;
  }

  Result<Scene> load(const LoadLimits& limits = {}) const {
    return load_gltf_memory(glb(), "", limits);
  }
};

// The message of the error, or "" if there is none.
inline std::string error_of(const Result<Scene>& scene) {
  return scene ? std::string() : scene.error().message();
}

inline bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace glassbox::test
