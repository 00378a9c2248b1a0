#include <glassbox/mesh/gltf/schema.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <glassbox/base/counted.h>
#include <glassbox/base/utf8.h>
#include <glassbox/mesh/gltf/schema_tables.h>
#include <glassbox/mesh/gltf/text.h>
#include <glassbox/mesh/input/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 256;
// The largest number of entries of one top-level array. An entry of a few characters becomes a
// record of some hundred bytes.
constexpr std::size_t kMaxEntries = std::size_t(1) << 18;

// A place such as "accessor 7, sparse.count": the top-level entry, then the path below it.
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
  // "3", "at least 1" or "at most 16": the numbers of items that a list may have.
  static std::string wanted_items(const Property& property) {
    const std::string least = std::to_string(property.min_items);
    if (property.min_items == property.max_items) return least;
    if (property.max_items == kUnlimited) return "at least " + least;
    return "from " + least + " to " + std::to_string(property.max_items);
  }
  // "from 0 to 1", "at least 0", "at most 1" or "finite".
  static std::string wanted_range(double low, double high) {
    const auto text = [](double bound) {
      const bool is_integer = bound == std::floor(bound) && std::abs(bound) <= kLargestInteger;
      return is_integer ? std::to_string(std::int64_t(bound)) : json(bound).dump();
    };
    if (std::isfinite(low) && std::isfinite(high)) return "from " + text(low) + " to " + text(high);
    if (std::isfinite(low)) return "at least " + text(low);
    return std::isfinite(high) ? "at most " + text(high) : "finite";
  }

  static tl::unexpected<Error> refuse(const Place& place, std::string cause) {
    return fail(place.text(), std::move(cause), "correct the file or export it again");
  }

  // The number of entries in the document's top-level array of this name.
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
    for (const Property& property : schema_tables().find(table)->second) {
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
      return refuse(place, "has " + std::to_string(value.size()) + " items, but must have " +
                               wanted_items(property));
    }
    if (top && value.size() > kMaxEntries) {
      return refuse(place, "has " + std::to_string(value.size()) + " entries, more than " +
                               std::to_string(kMaxEntries));
    }
    json checked = json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool named = top && property.type == Type::kObject;
      const Place item = named ? Place{entry(property.refers_to, i), ""} : place.item(i);
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
        return check_object(value, property.refers_to, place);
      case Type::kIndex:
        return check_index(value, property.refers_to, place);
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
      return refuse(place, "is " + value.dump() + ", but must be " +
                               wanted_range(property.low, property.high));
    }
    return json(number);
  }

  Result<json> check_integer(const json& value, double low, double high, const Place& place) {
    if (!value.is_number()) return refuse(place, "is not a number");
    const double number = value.get<double>();
    if (number != std::floor(number))
      return refuse(place, "is " + value.dump() + ", not an integer");
    if (!(number >= low && number <= high))
      return refuse(place, "is " + value.dump() + ", but must be " + wanted_range(low, high));
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
                               "', which has " + counted(count, "entry", "entries") +
                               " (numbers start at 0)");
    }
    return index;
  }

  Result<json> check_dictionary(const json& value, const Property& property, const Place& place) {
    if (!value.is_object()) return refuse(place, "is not a JSON object");
    json checked = json::object();
    for (const auto& [name, member] : value.items()) {
      Result<json> index = check_index(member, property.refers_to, place.below(printable(name)));
      if (!index) return index;
      checked[name] = std::move(*index);
    }
    return checked;
  }

  const json& document_;
};

// Whether brackets outside strings are nested deeper than kMaxDepth.
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

// Counts how often each extension is used in `value`. Extras are skipped: they belong to the
// application that wrote the file and may contain anything.
void count_extensions(const json& value, std::map<std::string, std::uint64_t>& counts) {
  if (value.is_array()) {
    for (const json& item : value) count_extensions(item, counts);
  }
  if (!value.is_object()) return;
  for (const auto& [name, member] : value.items()) {
    if (name == "extras") continue;
    count_extensions(member, counts);
    if (name != "extensions" || !member.is_object()) continue;
    for (const auto& [extension, described] : member.items()) ++counts[extension];
  }
}

// The two numbers of "2.0".
std::optional<std::pair<std::int64_t, std::int64_t>> version_numbers(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const auto major = obj::parse_integer(text.substr(0, point));
  const auto minor = obj::parse_integer(text.substr(std::min(point + 1, text.size())));
  if (!major || !minor) return std::nullopt;
  return std::pair(*major, *minor);
}

Result<void> check_version(const json& asset) {
  // A file of a minor version such as 2.1 can be read as 2.0 by definition, unless it requires a
  // newer version itself (glTF 2.0, section 3.2).
  const std::string needed = asset.value("minVersion", "2.0");
  const auto numbers = version_numbers(needed);
  if (!numbers) {
    return fail("asset.minVersion", "is " + in_quotes(needed) + ", which is not a version",
                "write two numbers with a point between them, such as 2.0");
  }
  if (*numbers > std::pair<std::int64_t, std::int64_t>(2, 0)) {
    return fail("asset.minVersion", "is " + in_quotes(needed) + ", but files are read as glTF 2.0",
                "export the file as glTF 2.0");
  }
  const std::string version = asset["version"];
  if (!version.starts_with("2.")) {
    return fail("asset.version", "is " + in_quotes(version),
                "only glTF 2 can be read: convert the file to glTF 2");
  }
  return {};
}

}  // namespace

namespace {

// The parser reports the place of an error except for a number that is too large for double, which
// it only quotes. Returns ", line 3, column 17" for the first such number.
std::string place_of_number(std::string_view text, std::string_view what) {
  constexpr std::string_view kOverflow = "number overflow parsing '";
  if (!what.starts_with(kOverflow)) return "";
  const std::string_view number =
      what.substr(kOverflow.size(), what.rfind('\'') - kOverflow.size());
  const std::size_t at = text.find(number);
  if (number.empty() || at == std::string_view::npos) return "";
  const std::string_view before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = at - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0: the first line
  return ", line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace

Result<Document> read_document(std::string_view text) {
  if (too_deep(text)) {
    return fail("JSON", "is nested deeper than " + std::to_string(kMaxDepth) + " levels",
                "put fewer lists and objects inside each other");
  }
  if (utf16_byte_order(text)) {
    return fail("JSON", "is text in UTF-16, but glTF is UTF-8",
                "save the file as UTF-8 without a byte order mark");
  }
  // The parser would skip a byte order mark, which glTF forbids.
  if (text.starts_with("\xef\xbb\xbf")) {
    return fail("JSON", "begins with a byte order mark", "save the file as UTF-8 without one");
  }
  json document;
  try {
    document = json::parse(text);
  } catch (const json::exception& error) {
    // Remove the parser's own name for the error ("[json.exception.parse_error.101] parse error at
    // line 1 ..."), and the bytes that it quotes where they may not be UTF-8.
    std::string what = error.what();
    if (const std::size_t name_end = what.find("] "); name_end != std::string::npos)
      what.erase(0, name_end + 2);
    for (char& c : what) {
      if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    }
    return fail("JSON" + place_of_number(text, what), printable(what, 200),
                "the file is not glTF, or damaged: export it again");
  }
  Result<json> checked = Checker(document).check();
  if (!checked) return tl::unexpected(checked.error());
  if (const auto version = check_version((*checked)["asset"]); !version)
    return tl::unexpected(version.error());
  Document read{std::move(*checked), {}};
  count_extensions(document, read.extensions);
  return read;
}

}  // namespace glassbox::gltf
