#include "views/klt/cube_header.h"

#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <map>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/printable.h>
#include <glassbox/base/trimmed.h>

namespace glassbox::views {

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = char(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Reads lines "name = value"; a value in braces may span several lines.
Result<std::map<std::string, std::string>> fields_of(std::string_view text) {
  std::map<std::string, std::string> fields;
  std::size_t at = text.find('\n');
  int line = 1;
  while (at != std::string_view::npos && at < text.size()) {
    ++line;
    const std::size_t end = std::min(text.find('\n', at + 1), text.size());
    const std::string_view row = text.substr(at + 1, end - at - 1);
    at = end;
    const std::size_t equals = row.find('=');
    if (trimmed(row).empty() || trimmed(row).front() == ';') continue;
    if (equals == std::string_view::npos) {
      return fail(fmt::format("line {}", line), "is not of the form 'name = value'",
                  "write one property of the cube in each line");
    }
    std::string value(trimmed(row.substr(equals + 1)));
    if (!value.empty() && value.front() == '{' && value.back() != '}') {
      const std::size_t brace = text.find('}', at);
      if (brace == std::string_view::npos)
        return fail(fmt::format("line {}", line), "has a '{' that is not closed", "add a '}'");
      value += text.substr(at, brace + 1 - at);
      at = std::min(text.find('\n', brace), text.size());
    }
    if (value.size() > 1 && value.front() == '{')
      value = std::string(trimmed(value.substr(1, value.size() - 2)));
    fields[lower(trimmed(row.substr(0, equals)))] = value;
  }
  return fields;
}

using Fields = std::map<std::string, std::string>;

Result<std::uint64_t> number_in(const Fields& fields, const std::string& name, std::uint64_t least,
                                std::uint64_t most, std::optional<std::uint64_t> usual) {
  const auto found = fields.find(name);
  if (found == fields.end()) {
    if (usual) return *usual;
    return fail("'" + name + "'", "is missing", "add a line '" + name + " = ...'");
  }
  const std::string& text = found->second;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    return fail("'" + name + "'",
                fmt::format("must be a whole number from {} to {}, but is {}", least, most,
                            in_quotes(text)),
                "write the value that is true of the data file");
  }
  return value;
}

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    names.emplace_back(trimmed(std::string_view(text).substr(at, comma - at)));
    at = comma + 1;
  }
  return names;
}

template <class Integer>
Integer integer_at(const std::byte* bytes, bool big_endian) {
  Integer value = 0;
  for (std::size_t k = 0; k < sizeof(Integer); ++k) {
    const std::size_t place = big_endian ? sizeof(Integer) - 1 - k : k;
    value = Integer(value | Integer(Integer(bytes[k]) << (8 * place)));
  }
  return value;
}

double sample_at(const std::byte* bytes, CubeType type, bool big) {
  switch (type) {
    case CubeType::kByte:
      return double(std::uint8_t(*bytes));
    case CubeType::kInt16:
      return double(std::int16_t(integer_at<std::uint16_t>(bytes, big)));
    case CubeType::kInt32:
      return double(std::int32_t(integer_at<std::uint32_t>(bytes, big)));
    case CubeType::kFloat:
      return double(std::bit_cast<float>(integer_at<std::uint32_t>(bytes, big)));
    case CubeType::kDouble:
      return std::bit_cast<double>(integer_at<std::uint64_t>(bytes, big));
    case CubeType::kUint16:
      return double(integer_at<std::uint16_t>(bytes, big));
    case CubeType::kUint32:
      return double(integer_at<std::uint32_t>(bytes, big));
  }
  return 0;
}

std::optional<CubeType> type_of(std::uint64_t number) {
  for (const CubeType type : {CubeType::kByte, CubeType::kInt16, CubeType::kInt32, CubeType::kFloat,
                              CubeType::kDouble, CubeType::kUint16, CubeType::kUint32}) {
    if (std::uint64_t(type) == number) return type;
  }
  return std::nullopt;
}

std::optional<Interleave> interleave_of(const std::string& name) {
  if (name == "bsq") return Interleave::kBsq;
  if (name == "bil") return Interleave::kBil;
  if (name == "bip") return Interleave::kBip;
  return std::nullopt;
}

}  // namespace

std::uint64_t CubeHeader::bytes_of_sample() const {
  switch (type) {
    case CubeType::kByte:
      return 1;
    case CubeType::kInt16:
    case CubeType::kUint16:
      return 2;
    case CubeType::kInt32:
    case CubeType::kUint32:
    case CubeType::kFloat:
      return 4;
    case CubeType::kDouble:
      return 8;
  }
  return 1;
}

Result<CubeHeader> parse_cube_header(std::string_view text) {
  if (trimmed(text.substr(0, std::min(text.find('\n'), text.size()))) != "ENVI")
    return fail("line 1", "is not 'ENVI'", "give a header in ENVI's format");
  const auto fields = fields_of(text);
  if (!fields) return tl::unexpected(fields.error());
  constexpr std::uint64_t kMaxSide = 16384, kMaxOffset = std::uint64_t(1) << 32;
  CubeHeader header;
  std::uint64_t type = 0, order = 0;
  struct Number {
    const char* name;
    std::uint64_t* target;
    std::uint64_t least, most;
    std::optional<std::uint64_t> usual;
  };
  for (const Number& number :
       {Number{"samples", &header.width, 1, kMaxSide, {}},
        Number{"lines", &header.height, 1, kMaxSide, {}},
        Number{"bands", &header.bands, 1, kMaxBands, {}}, Number{"data type", &type, 1, 15, {}},
        Number{"header offset", &header.offset, 0, kMaxOffset, 0},
        Number{"byte order", &order, 0, 1, 0}}) {
    const auto value = number_in(*fields, number.name, number.least, number.most, number.usual);
    if (!value) return tl::unexpected(value.error());
    *number.target = *value;
  }
  const auto known = type_of(type);
  if (!known) {
    return fail("'data type'", fmt::format("{} is not supported", type),
                "save the cube as type 1, 2, 3, 4, 5, 12 or 13: bytes, whole numbers or floats");
  }
  header.type = *known;
  header.big_endian = order == 1;
  if (const auto found = fields->find("interleave"); found != fields->end()) {
    const auto interleave = interleave_of(lower(found->second));
    if (!interleave)
      return fail("'interleave'", "is " + in_quotes(found->second) + ", which is not known",
                  "write bsq, bil or bip");
    header.interleave = *interleave;
  }
  if (const auto found = fields->find("band names"); found != fields->end()) {
    header.names = names_in(found->second);
    if (header.names.size() != header.bands) {
      return fail(
          "'band names'",
          fmt::format("has {} names, but there are {} bands", header.names.size(), header.bands),
          "name all bands, or none");
    }
  }
  return header;
}

std::string cube_header_text(const Bands& bands) {
  std::string names;
  for (const Band& band : bands.bands) {
    if (!names.empty()) names += ", ";
    // Characters that would end a name in the list are replaced by blanks.
    for (const char c : band.name) names += c == ',' || c == '{' || c == '}' || c == '\n' ? ' ' : c;
  }
  return fmt::format(
      "ENVI\nsamples = {}\nlines = {}\nbands = {}\nheader offset = 0\ndata type = 5\n"
      "interleave = bsq\nbyte order = 0\nband names = {{{}}}\n",
      bands.width, bands.height, bands.count(), names);
}

std::vector<std::byte> cube_bytes(const Bands& bands) {
  std::vector<std::byte> bytes;
  bytes.reserve(bands.pixels() * bands.bands.size() * sizeof(double));
  for (const Band& band : bands.bands) {
    for (const double sample : band.samples) {
      const auto bits = std::bit_cast<std::uint64_t>(sample);
      for (int k = 0; k < 8; ++k) bytes.push_back(std::byte(bits >> (8 * k) & 255));
    }
  }
  return bytes;
}

Result<void> check_cube_size(const CubeHeader& header, std::uint64_t bytes) {
  if (bytes >= header.bytes() && bytes - header.bytes() <= kMaxTrailingBytes) return {};
  return fail("the cube",
              fmt::format("has {} bytes, but its header requires {}", bytes, header.bytes()),
              "give the complete file, or the header that belongs to it");
}

Result<Bands> decode_cube(const CubeHeader& header, std::span<const std::byte> bytes) {
  if (const auto enough = check_cube_size(header, bytes.size()); !enough)
    return tl::unexpected(enough.error());
  const std::uint64_t size = header.bytes_of_sample();
  Bands bands{int(header.width), int(header.height), {}};
  for (std::uint64_t b = 0; b < header.bands; ++b) {
    Band band{header.names.empty() ? fmt::format("band {}", b + 1) : header.names[b],
              std::vector<double>(bands.pixels())};
    for (std::uint64_t y = 0; y < header.height; ++y) {
      for (std::uint64_t x = 0; x < header.width; ++x) {
        const std::uint64_t place =
            header.interleave == Interleave::kBsq   ? (b * header.height + y) * header.width + x
            : header.interleave == Interleave::kBil ? (y * header.bands + b) * header.width + x
                                                    : (y * header.width + x) * header.bands + b;
        band.samples[y * header.width + x] =
            sample_at(bytes.data() + header.offset + place * size, header.type, header.big_endian);
      }
    }
    bands.bands.push_back(std::move(band));
  }
  return bands;
}

}  // namespace glassbox::views
