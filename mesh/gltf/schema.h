// What the JSON of a glTF file may contain: the part of the glTF 2.0 schema that Glassbox reads, as
// a table.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include <glassbox/base/error.h>

namespace glassbox::gltf {

struct Document {
  nlohmann::json checked;  // only the properties that Glassbox reads
  // How often each extension occurs anywhere in the file, checked or not.
  std::map<std::string, std::uint64_t> extensions;
};

// Parses the text and checks every property that Glassbox reads: its type, its range, the length of
// its array, and that an index refers to an entry that exists. The result has only these
// properties, and integers written as 3.0 are integers in it, so that its users need not check
// again. Text nested deeper than 256 levels is refused before it is parsed.
Result<Document> read_document(std::string_view text);

}  // namespace glassbox::gltf
