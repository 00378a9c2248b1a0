// A glTF file in memory: its description by tinygltf, and the bytes that the description refers to.
#pragma once

#include <tiny_gltf.h>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/input/files.h>
#include <glassbox/mesh/limits.h>

namespace glassbox::gltf {

struct Asset {
  // Every index refers to an entry that exists (schema.h). Buffers and images are not in the model.
  tinygltf::Model model = {};
  nlohmann::json document;  // the checked document; for extensions, extras and images
  // The data of each buffer; null if the file has no data for it.
  std::vector<std::shared_ptr<const Bytes>> buffers = {};
  Resources resources;
  LoadLimits limits;
  // The size of the file and its buffers; memory use is kept proportional to it.
  std::uint64_t bytes = 0;
  std::vector<std::string> extensions = {};

  // A warning about many places, stated in one sentence.
  struct RepeatedWarning {
    std::string text, first_place;
    std::uint64_t places = 0, amount = 0;
  };
  std::vector<std::string> warnings;
  std::vector<RepeatedWarning> repeated = {};

  // Whether the file lists the extension as used or required.
  bool uses(const std::string& extension) const;
  void warn(std::string text);  // identical warnings are kept once
  // Adds the warning "PLACE and 4 more: TEXT", where {} in the text is replaced by the sum of the
  // amounts.
  void warn_at(const std::string& place, const std::string& text, std::uint64_t amount = 0);
  std::vector<std::string> all_warnings() const;
};

// The extensions that are supported. Other extensions are errors if required, warnings if only
// used.
bool is_supported(const std::string& extension);

// The member at the end of the path, or null.
const nlohmann::json* find(const nlohmann::json& value, std::initializer_list<const char*> path);

// Reads the bytes of a file into its checked parts. Accessors and images are not checked yet.
Result<Asset> open_asset(std::span<const std::byte> bytes, const std::string& directory,
                         const LoadLimits& limits);

// Reads a file, and the files in its directory that it names, into its checked parts.
Result<Asset> open_asset(const std::string& path, const LoadLimits& limits);

// The bytes of a buffer view; an error where its buffer has no data.
Result<std::span<const std::byte>> view_bytes(const Asset& asset, std::size_t buffer_view);

// The file of an image of the document, given by its URI or its buffer view.
struct ImageFile {
  std::shared_ptr<const Bytes> owner;  // null: the asset owns the bytes
  std::span<const std::byte> bytes;
};
Result<ImageFile> image_file(Asset& asset, const nlohmann::json& image);

}  // namespace glassbox::gltf
