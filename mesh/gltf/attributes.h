// Vertex attributes of a primitive: the accessor types that each attribute may have, and its
// numbers.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/gltf/asset.h>

namespace glassbox::gltf {

enum class Semantic {
  kPosition,
  kNormal,
  kTexCoord,
  kColor,
  kJoints,
  kWeights,
  kPositionDelta,
  kNormalDelta,
  kIndices
};

struct Attribute {
  std::size_t accessor = 0;
  std::size_t width = 0;        // components per vertex
  std::vector<double> numbers;  // finite
};

// The attributes of one primitive, or of one of its morph targets.
class Attributes {
public:
  // `place` ("mesh 2, primitive 0") is the beginning of the place in every error. `count` is the
  // number of vertices that every attribute must have. `used` says which of them something is drawn
  // with; an empty list says that all are.
  Attributes(Asset& asset, const std::map<std::string, int>& accessors, std::string place,
             std::size_t count, const std::vector<bool>& used)
      : asset_(asset),
        accessors_(accessors),
        place_(std::move(place)),
        count_(count),
        used_(used) {}

  bool has(const std::string& name) const { return accessors_.contains(name); }

  // Checks type, component type and count, reads the numbers, and refuses numbers that are not
  // finite, naming the vertex. In a vertex that is not used they become 0, with a warning. Returns
  // nothing where the primitive has no such attribute.
  Result<std::optional<Attribute>> read(const std::string& name, Semantic semantic) const;

private:
  Asset& asset_;
  const std::map<std::string, int>& accessors_;
  std::string place_;
  std::size_t count_;
  const std::vector<bool>& used_;
};

// An error where glTF does not allow the accessor's type for this use (with KHR_mesh_quantization
// if the file uses it).
Result<void> check_form(const Asset& asset, std::size_t accessor, Semantic semantic);

// Whether the bytes of the accessor are in the file. Buffers without data are legal; primitives
// that need them are not drawn.
bool has_data(const Asset& asset, std::size_t accessor);

}  // namespace glassbox::gltf
