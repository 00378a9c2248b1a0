// The parts of a glTF document that are read: names, types and ranges of the properties of every
// kind of object.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace glassbox::gltf {

inline constexpr double kLargestInteger = 0x1p53;  // larger integers may have no exact double
inline constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Type {
  kBoolean,
  kInteger,
  kNumber,
  kString,
  kObject,      // `refers_to` names its table
  kIndex,       // into the top-level array `refers_to`
  kDictionary,  // any names, the values are indices into `refers_to`
  kPresence,    // anything; only its presence matters
};

struct Property {
  const char* name;
  Type type;
  const char* refers_to = "";
  bool required = false;
  bool array = false;
  std::size_t min_items = 0;
  std::size_t max_items = kUnlimited;
  double low = -kInfinity;
  double high = kInfinity;
  std::vector<const char*> words = {};  // kString: the allowed values, where there is a list

  Property as_required() const {
    Property copy = *this;
    copy.required = true;
    return copy;
  }
  Property list(std::size_t least = 0, std::size_t most = kUnlimited) const {
    Property copy = *this;
    copy.array = true;
    copy.min_items = least;
    copy.max_items = most;
    return copy;
  }
  Property within(double least, double most) const {
    Property copy = *this;
    copy.low = least;
    copy.high = most;
    return copy;
  }
  Property one_of(std::vector<const char*> allowed) const {
    Property copy = *this;
    copy.words = std::move(allowed);
    return copy;
  }
};

// The tables by the names that Property::refers_to uses; the document itself is "document".
using Tables = std::map<std::string, std::vector<Property>, std::less<>>;

const Tables& schema_tables();

}  // namespace glassbox::gltf
