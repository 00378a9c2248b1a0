#include <glassbox/mesh/gltf/schema.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 256;
// Entries of one top-level array. An entry of a few characters becomes a record of some hundred bytes.
constexpr std::size_t kMaxEntries = std::size_t(1) << 18;
constexpr double kLargestInteger = 0x1p53;  // integers beyond have no exact double
constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Type {
  kBoolean,
  kInteger,
  kNumber,
  kString,
  kObject,      // `of` names its table
  kIndex,       // into the top-level array `of`
  kDictionary,  // any names, the values are indices into `of`
  kPresence,    // anything; only that it is there matters
};

struct Property {
  const char* name;
  Type type;
  const char* of = "";
  bool required = false;
  bool array = false;
  std::size_t min_items = 0;
  std::size_t max_items = kAny;
  double low = -kInfinity;
  double high = kInfinity;
  std::vector<const char*> words = {};  // kString: the values allowed, where there is a list

  Property needed() const {
    Property copy = *this;
    copy.required = true;
    return copy;
  }
  Property list(std::size_t least = 0, std::size_t most = kAny) const {
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

Property boolean(const char* name) {
  return {name, Type::kBoolean};
}
Property number(const char* name) {
  return {name, Type::kNumber};
}
Property integer(const char* name) {
  return Property{name, Type::kInteger}.within(0, kLargestInteger);
}
Property string(const char* name) {
  return {name, Type::kString};
}
Property object(const char* name, const char* of) {
  return {name, Type::kObject, of};
}
Property index(const char* name, const char* of) {
  return {name, Type::kIndex, of};
}
Property dictionary(const char* name, const char* of) {
  return {name, Type::kDictionary, of};
}
Property presence(const char* name) {
  return {name, Type::kPresence};
}

using Tables = std::map<std::string, std::vector<Property>, std::less<>>;

// glTF 2.0, section 5, and the extensions' own schemas. Numbers of the specification: 5120 .. 5126 component types,
// 9728 .. filters, 10497, 33071, 33648 wrap modes.
const Tables& tables() {
  const double kMaxCount = 4294967294.0;  // the largest index is kept for "none"
  static const Tables all = {
      {"document",
       {object("asset", "asset").needed(), string("extensionsUsed").list(),
        string("extensionsRequired").list(), object("extensions", "document.extensions"),
        index("scene", "scenes"), object("accessors", "accessor").list(),
        object("buffers", "buffer").list(), object("bufferViews", "bufferView").list(),
        object("cameras", "camera").list(), object("images", "image").list(),
        object("materials", "material").list(), object("meshes", "mesh").list(),
        object("nodes", "node").list(), object("samplers", "sampler").list(),
        object("scenes", "scene").list(), object("skins", "skin").list(),
        object("textures", "texture").list()}},
      {"asset", {string("version").needed(), string("minVersion")}},
      {"document.extensions", {object("KHR_lights_punctual", "lights")}},
      {"lights", {object("lights", "light").list().needed()}},
      {"light",
       {string("name"), string("type").one_of({"directional", "point", "spot"}).needed(),
        number("color").list(3, 3).within(0, kInfinity), number("intensity").within(0, kInfinity),
        number("range").within(std::numeric_limits<double>::min(), kInfinity),
        object("spot", "spot")}},
      // The greatest outer angle is pi/2.
      {"spot",
       {number("innerConeAngle").within(0, 1.5707963267948966),
        number("outerConeAngle").within(0, 1.5707963267948968)}},
      {"accessor",
       {string("name"), index("bufferView", "bufferViews"), integer("byteOffset"),
        integer("componentType").within(5120, 5126).needed(), boolean("normalized"),
        integer("count").within(0, kMaxCount).needed(),
        string("type").one_of({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}).needed(),
        object("sparse", "sparse")}},
      {"sparse",
       {integer("count").within(0, 2147483647).needed(),
        object("indices", "sparse.indices").needed(), object("values", "sparse.values").needed()}},
      {"sparse.indices",
       {index("bufferView", "bufferViews").needed(), integer("byteOffset").within(0, 2147483647),
        integer("componentType").within(5121, 5125).needed()}},
      {"sparse.values",
       {index("bufferView", "bufferViews").needed(), integer("byteOffset").within(0, 2147483647)}},
      {"buffer",
       {string("name"), string("uri"), integer("byteLength").within(1, kLargestInteger).needed()}},
      {"bufferView",
       {string("name"), index("buffer", "buffers").needed(), integer("byteOffset"),
        integer("byteLength").within(1, kLargestInteger).needed(),
        integer("byteStride").within(4, 252)}},
      {"camera",
       {string("name"), string("type").one_of({"perspective", "orthographic"}).needed(),
        object("perspective", "perspective"), object("orthographic", "orthographic")}},
      {"perspective",
       {number("yfov").needed(), number("znear").needed(), number("zfar"), number("aspectRatio")}},
      {"orthographic",
       {number("xmag").needed(), number("ymag").needed(), number("znear").needed(),
        number("zfar").needed()}},
      {"image",
       {string("name"), string("uri"), string("mimeType"), index("bufferView", "bufferViews")}},
      {"sampler",
       {string("name"), integer("magFilter").within(9728, 9729),
        integer("minFilter").within(9728, 9987), integer("wrapS").within(10497, 33648),
        integer("wrapT").within(10497, 33648)}},
      {"texture", {string("name"), index("sampler", "samplers"), index("source", "images")}},
      {"material",
       {string("name"), object("pbrMetallicRoughness", "pbr"),
        string("alphaMode").one_of({"OPAQUE", "MASK", "BLEND"}),
        number("alphaCutoff").within(0, kInfinity), boolean("doubleSided"),
        object("extensions", "material.extensions"), object("extras", "material.extras")}},
      {"pbr",
       {number("baseColorFactor").list(4, 4).within(0, 1),
        object("baseColorTexture", "textureInfo"), number("metallicFactor").within(0, 1),
        number("roughnessFactor").within(0, 1), object("metallicRoughnessTexture", "textureInfo")}},
      {"textureInfo",
       {index("index", "textures").needed(), integer("texCoord").within(0, 2147483647),
        object("extensions", "textureInfo.extensions")}},
      {"textureInfo.extensions", {object("KHR_texture_transform", "textureTransform")}},
      {"textureTransform",
       {number("offset").list(2, 2), number("scale").list(2, 2), number("rotation"),
        integer("texCoord").within(0, 2147483647)}},
      {"material.extensions", {presence("KHR_materials_unlit")}},
      {"material.extras", {object("glassbox", "material.glassbox")}},
      {"material.glassbox",
       {number("specular").list(3, 3).within(0, 1).needed(),
        integer("shininess").within(1, 1024).needed()}},
      {"mesh",
       {string("name"), object("primitives", "primitive").list().needed(),
        number("weights").list()}},
      {"primitive",
       {dictionary("attributes", "accessors").needed(), index("indices", "accessors"),
        index("material", "materials"), integer("mode").within(0, 6),
        dictionary("targets", "accessors").list(), object("extensions", "primitive.extensions")}},
      {"primitive.extensions", {presence("KHR_draco_mesh_compression")}},
      {"node",
       {string("name"), index("children", "nodes").list(), index("camera", "cameras"),
        index("mesh", "meshes"), index("skin", "skins"), number("matrix").list(16, 16),
        number("rotation").list(4, 4), number("scale").list(3, 3), number("translation").list(3, 3),
        number("weights").list(), object("extensions", "node.extensions")}},
      {"node.extensions", {object("KHR_lights_punctual", "node.light")}},
      {"node.light", {index("light", "lights").needed()}},
      {"scene", {string("name"), index("nodes", "nodes").list()}},
      {"skin",
       {string("name"), index("inverseBindMatrices", "accessors"), index("skeleton", "nodes"),
        index("joints", "nodes").list(1).needed()}},
  };
  return all;
}

// "accessor 7, sparse.count": the top-level entry, then the way down from it.
struct Place {
  std::string entry;
  std::string path;

  Place below(const std::string& name) const {
    return {entry, path.empty() ? name : path + "." + name};
  }
  Place item(std::size_t i) const { return {entry, path + "[" + std::to_string(i) + "]"}; }
  std::string text() const {
    if (entry.empty()) return path;
    return path.empty() ? entry : entry + ", " + path;
  }
};

class Checker {
public:
  explicit Checker(const json& document) : document_(document) {}

  Result<json> check() { return check_object(document_, "document", {}); }

private:
  static tl::unexpected<Error> refuse(const Place& place, std::string cause) {
    return fail(place.text(), std::move(cause), "correct the file or export it again");
  }

  // How many entries the top-level array has that an index is to name.
  std::size_t entries(std::string_view array) const {
    const json* at = &document_;
    const auto descend = [&at](const char* name) {
      if (!at) return;
      const auto found = at->is_object() ? at->find(name) : at->end();
      at = at->is_object() && found != at->end() ? &*found : nullptr;
    };
    if (array == "lights") {
      for (const char* name : {"extensions", "KHR_lights_punctual", "lights"}) descend(name);
    } else {
      descend(std::string(array).c_str());
    }
    return at && at->is_array() ? at->size() : 0;
  }

  Result<json> check_object(const json& value, std::string_view table, const Place& place) {
    if (!value.is_object()) return refuse(place, "is not a JSON object");
    json checked = json::object();
    for (const Property& property : tables().find(table)->second) {
      const auto found = value.find(property.name);
      const bool top = table == "document" || table == "lights";
      if (found == value.end()) {
        if (property.required) return refuse(place, "has no '" + std::string(property.name) + "'");
        continue;
      }
      Result<json> member = property.array
                                ? check_array(*found, property, place.below(property.name), top)
                                : check_value(*found, property, place.below(property.name));
      if (!member) return member;
      checked[property.name] = std::move(*member);
    }
    return checked;
  }

  Result<json> check_array(const json& value, const Property& property, const Place& place,
                           bool top) {
    if (!value.is_array()) return refuse(place, "is not a JSON array");
    if (value.size() < property.min_items || value.size() > property.max_items) {
      return refuse(place, "has " + std::to_string(value.size()) + " items");
    }
    if (top && value.size() > kMaxEntries) {
      return refuse(place, "has " + std::to_string(value.size()) + " entries, more than " +
                               std::to_string(kMaxEntries));
    }
    json checked = json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool named = top && property.type == Type::kObject;
      const Place item = named ? Place{entry(property.of, i), ""} : place.item(i);
      Result<json> member = check_value(value[i], property, item);
      if (!member) return member;
      checked.push_back(std::move(*member));
    }
    return checked;
  }

  Result<json> check_value(const json& value, const Property& property, const Place& place) {
    switch (property.type) {
      case Type::kBoolean:
        if (!value.is_boolean()) return refuse(place, "is neither true nor false");
        return value;
      case Type::kNumber:
        return check_number(value, property, place);
      case Type::kInteger:
        return check_integer(value, property.low, property.high, place);
      case Type::kString:
        return check_string(value, property, place);
      case Type::kObject:
        return check_object(value, property.of, place);
      case Type::kIndex:
        return check_index(value, property.of, place);
      case Type::kDictionary:
        return check_dictionary(value, property, place);
      case Type::kPresence:
        return json::object();
    }
    return json();
  }

  Result<json> check_number(const json& value, const Property& property, const Place& place) {
    if (!value.is_number()) return refuse(place, "is not a number");
    const double number = value.get<double>();
    if (!(number >= property.low && number <= property.high) || !std::isfinite(number)) {
      return refuse(place, "is " + value.dump() + ", out of its range");
    }
    return json(number);
  }

  Result<json> check_integer(const json& value, double low, double high, const Place& place) {
    if (!value.is_number()) return refuse(place, "is not a number");
    const double number = value.get<double>();
    if (number != std::floor(number))
      return refuse(place, "is " + value.dump() + ", not an integer");
    if (!(number >= low && number <= high))
      return refuse(place, "is " + value.dump() + ", out of its range");
    return json(static_cast<std::uint64_t>(number));
  }

  Result<json> check_string(const json& value, const Property& property, const Place& place) {
    if (!value.is_string()) return refuse(place, "is not a string");
    if (property.words.empty()) return value;
    for (const char* word : property.words) {
      if (value.get_ref<const std::string&>() == word) return value;
    }
    return refuse(place, "is " + in_quotes(value.get_ref<const std::string&>()) +
                             ", which glTF does not know");
  }

  Result<json> check_index(const json& value, std::string_view array, const Place& place) {
    const Result<json> index = check_integer(value, 0, kLargestInteger, place);
    if (!index) return index;
    const std::size_t count = entries(array);
    if (index->get<std::size_t>() >= count) {
      return refuse(place, "names entry " + value.dump() + " of '" + std::string(array) +
                               "', which has " + std::to_string(count));
    }
    return index;
  }

  Result<json> check_dictionary(const json& value, const Property& property, const Place& place) {
    if (!value.is_object()) return refuse(place, "is not a JSON object");
    json checked = json::object();
    for (const auto& [name, member] : value.items()) {
      Result<json> index = check_index(member, property.of, place.below(printable(name)));
      if (!index) return index;
      checked[name] = std::move(*index);
    }
    return checked;
  }

  const json& document_;
};

// Whether brackets nest deeper than kMaxDepth anywhere outside strings.
bool too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

Result<void> check_version(const json& asset) {
  // Minor versions are compatible with 2.0 by definition, unless the file says which one it needs.
  const std::string version = asset["version"];
  if (!version.starts_with("2.")) {
    return fail("asset.version", "is " + in_quotes(version),
                "only glTF 2 can be read: convert the file");
  }
  return {};
}

}  // namespace

Result<json> read_document(std::string_view text) {
  if (too_deep(text)) {
    return fail("JSON", "is nested deeper than " + std::to_string(kMaxDepth) + " levels",
                "remove the nesting");
  }
  // The parser would skip a byte order mark, which glTF forbids.
  if (text.starts_with("\xef\xbb\xbf")) {
    return fail("JSON", "begins with a byte order mark", "save the file as UTF-8 without one");
  }
  json document;
  try {
    document = json::parse(text);
  } catch (const json::exception& error) {
    // Without the parser's own name for the error ("[json.exception.parse_error.101] parse error at line 1 ..."), and
    // without the bytes that it quotes where they may not be UTF-8.
    std::string what = error.what();
    if (const std::size_t name_end = what.find("] "); name_end != std::string::npos)
      what.erase(0, name_end + 2);
    for (char& c : what) {
      if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    }
    return fail("JSON", printable(what, 200), "the file is no glTF, or damaged: export it again");
  }
  Result<json> checked = Checker(document).check();
  if (!checked) return checked;
  if (const auto version = check_version((*checked)["asset"]); !version)
    return tl::unexpected(version.error());
  return checked;
}

}  // namespace glassbox::gltf
