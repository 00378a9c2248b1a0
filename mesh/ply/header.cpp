#include <glassbox/mesh/ply/header.h>

#include <algorithm>
#include <utility>

#include <glassbox/base/utf8.h>
#include <glassbox/mesh/input/text.h>

namespace glassbox::ply {
namespace {

constexpr std::size_t kMaxHeaderBytes = std::size_t(1) << 20;
constexpr std::size_t kMaxElements = 64;
constexpr std::size_t kMaxProperties = 256;  // of one element
constexpr std::size_t kMaxTextures = 64;
constexpr std::uint64_t kMaxCount = 4294967294;  // the largest index is reserved for "none"

constexpr std::pair<std::string_view, Type> kTypes[] = {
    {"char", Type::kInt8},      {"uchar", Type::kUint8},    {"short", Type::kInt16},
    {"ushort", Type::kUint16},  {"int", Type::kInt32},      {"uint", Type::kUint32},
    {"float", Type::kFloat32},  {"double", Type::kFloat64}, {"int8", Type::kInt8},
    {"uint8", Type::kUint8},    {"int16", Type::kInt16},    {"uint16", Type::kUint16},
    {"int32", Type::kInt32},    {"uint32", Type::kUint32},  {"float32", Type::kFloat32},
    {"float64", Type::kFloat64}};

class Parser {
public:
  explicit Parser(std::string_view file) : file_(file) {}

  Result<Header> run() {
    if (auto done = take_magic(); !done) return tl::unexpected(done.error());
    for (;;) {
      if (!take_line()) {
        return refuse("the header has no 'end_header'",
                      "export the file again: it is cut short, or is not a PLY file");
      }
      obj::Words words(line_);
      const std::string_view keyword = words.next();
      if (keyword == "end_header") break;
      if (auto done = take_statement(keyword, words); !done) return tl::unexpected(done.error());
    }
    header_.data_begin = at_;
    header_.data_line = number_ + 1;
    if (!has_format_) return refuse("the header has no 'format'", "export the file again");
    if (auto done = check_counts(); !done) return tl::unexpected(done.error());
    return std::move(header_);
  }

private:
  tl::unexpected<Error> refuse(std::string cause, std::string remedy) const {
    return fail("line " + std::to_string(number_), std::move(cause), std::move(remedy));
  }

  // Reads the first line, which also shows how lines end. After the header this must be known,
  // because binary data may begin with a byte that looks like half of a line ending.
  Result<void> take_magic() {
    const std::size_t end = std::min(file_.find_first_of("\r\n"), file_.size());
    if (utf16_byte_order(file_)) {
      return fail("line 1", "is text in UTF-16, but PLY is ASCII",
                  "save the file as ASCII or UTF-8");
    }
    if (!begins_as_ply(file_) || end == file_.size()) {
      return fail("line 1", "is not 'ply'", "give a PLY file, or export a damaged one again");
    }
    ending_ =
        file_.substr(end).starts_with("\r\n") ? std::string_view("\r\n") : file_.substr(end, 1);
    at_ = end + ending_.size();
    number_ = 1;
    return {};
  }

  bool take_line() {
    const std::size_t end = file_.substr(0, kMaxHeaderBytes).find(ending_, at_);
    if (end == std::string_view::npos) return false;
    line_ = trimmed(file_.substr(at_, end - at_));
    at_ = end + ending_.size();
    ++number_;
    return true;
  }

  Result<void> take_statement(std::string_view keyword, obj::Words& words) {
    if (keyword == "format") return take_format(words);
    if (keyword == "element") return take_element(words);
    if (keyword == "property") return take_property(words);
    if (keyword == "comment") {
      if (words.next() == "TextureFile" && header_.textures.size() < kMaxTextures) {
        header_.textures.emplace_back(words.rest());
      }
      return {};
    }
    if (keyword == "obj_info" || keyword.empty()) return {};
    return refuse("has the unknown word " + in_quotes(keyword), "export the file again");
  }

  Result<void> take_format(obj::Words& words) {
    const std::string_view name = words.next(), version = words.next();
    if (name == "ascii") {
      header_.format = Format::kAscii;
    } else if (name == "binary_little_endian") {
      header_.format = Format::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = Format::kBigEndian;
    } else {
      return refuse("has the unknown format " + in_quotes(name),
                    "use ascii, binary_little_endian or binary_big_endian");
    }
    if (version != "1.0") {
      return refuse("has version " + in_quotes(version), "export the file as PLY version 1.0");
    }
    has_format_ = true;
    return {};
  }

  Result<void> take_element(obj::Words& words) {
    const std::string_view name = words.next();
    const auto count = obj::parse_integer(words.next());
    if (name.empty() || !count || *count < 0) {
      return refuse("an element needs a name and a count", "export the file again");
    }
    if (std::uint64_t(*count) > kMaxCount) {
      return refuse("has " + std::to_string(*count) + " elements, but at most " +
                        std::to_string(kMaxCount) + " are read",
                    "split the file");
    }
    if (header_.find(name) != nullptr) {
      return refuse("the element " + in_quotes(name) + " occurs twice", "export the file again");
    }
    if (header_.elements.size() >= kMaxElements) {
      return refuse("has more than " + std::to_string(kMaxElements) + " kinds of elements",
                    "remove the elements that are not needed");
    }
    header_.elements.push_back({std::string(name), std::uint64_t(*count), {}});
    return {};
  }

  Result<Type> take_type(std::string_view name) const {
    for (const auto& [word, type] : kTypes) {
      if (word == name) return type;
    }
    return refuse("has the unknown type " + in_quotes(name),
                  "use char, uchar, short, ushort, int, uint, float or double, or int8 to float64");
  }

  Result<void> take_property(obj::Words& words) {
    if (header_.elements.empty()) {
      return refuse("has a property before the first element", "export the file again");
    }
    Element& element = header_.elements.back();
    Property property;
    std::string_view type_name = words.next();
    if (type_name == "list") {
      const auto count_type = take_type(words.next());
      if (!count_type) return tl::unexpected(count_type.error());
      if (!is_integer(*count_type)) {
        return refuse("the length of a list has a type that is not an integer",
                      "export the file again");
      }
      property.count_type = *count_type;
      type_name = words.next();
    }
    const auto type = take_type(type_name);
    if (!type) return tl::unexpected(type.error());
    property.type = *type;
    property.name = std::string(words.next());
    if (property.name.empty()) return refuse("a property has no name", "export the file again");
    if (element.find({property.name})) {
      return refuse("the property " + in_quotes(property.name) + " occurs twice",
                    "export the file again");
    }
    if (element.properties.size() >= kMaxProperties) {
      return refuse("has more than " + std::to_string(kMaxProperties) + " properties",
                    "remove the properties that are not needed");
    }
    element.properties.push_back(std::move(property));
    return {};
  }

  // Nothing here overflows: an element count is below 2^32, the size of an element below 2^12
  // bytes.
  Result<void> check_counts() const {
    const std::uint64_t available = file_.size() - at_;
    std::uint64_t needed = 0;
    for (const Element& element : header_.elements) {
      std::uint64_t bytes = 0;
      for (const Property& property : element.properties) {
        bytes += header_.format == Format::kAscii
                     ? 2
                     : bytes_of(property.count_type.value_or(property.type));
      }
      needed += element.count * bytes;
      // The last number of a text file needs no blank after it.
      if (needed > available + (header_.format == Format::kAscii ? 1 : 0)) {
        return fail(
            "element " + in_quotes(element.name),
            "the " + std::to_string(element.count) +
                " of them that the header names, with the data before them, need at least " +
                std::to_string(needed) + " bytes after the header, but there are only " +
                std::to_string(available),
            "the file is cut short or damaged: export it again");
      }
    }
    return {};
  }

  std::string_view file_, ending_, line_;
  std::size_t at_ = 0;
  std::uint64_t number_ = 0;
  bool has_format_ = false;
  Header header_;
};

}  // namespace

std::optional<std::size_t> Element::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    const auto found = std::ranges::find(properties, name, &Property::name);
    if (found != properties.end()) return std::size_t(found - properties.begin());
  }
  return std::nullopt;
}

const Element* Header::find(std::string_view name) const {
  const auto found = std::ranges::find(elements, name, &Element::name);
  return found == elements.end() ? nullptr : &*found;
}

bool begins_as_ply(std::string_view file) {
  file = without_byte_order_mark(file);
  return trimmed(file.substr(0, file.find_first_of("\r\n"))) == "ply";
}

Result<Header> parse_header(std::string_view file) {
  return Parser(file).run();
}

}  // namespace glassbox::ply
