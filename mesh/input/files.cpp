#include <glassbox/mesh/input/files.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <system_error>

#include <glassbox/base/ascii_case.h>
#include <glassbox/base/printable.h>

namespace glassbox::gltf {
namespace {

namespace fs = std::filesystem;

// The value of a base64 digit, or 64.
std::uint32_t base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return std::uint32_t(c - 'A');
  if (c >= 'a' && c <= 'z') return std::uint32_t(c - 'a') + 26;
  if (c >= '0' && c <= '9') return std::uint32_t(c - '0') + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return 64;
}

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') return unsigned(c - '0');
  if (c >= 'a' && c <= 'f') return unsigned(c - 'a') + 10;
  if (c >= 'A' && c <= 'F') return unsigned(c - 'A') + 10;
  return std::nullopt;
}

// "Box%20With%20Spaces.bin" -> "Box With Spaces.bin"; nothing where a per cent sign does not begin
// a code.
std::optional<std::string> percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text += uri[i];
      continue;
    }
    if (uri.size() - i < 3) return std::nullopt;
    const auto high = hex_digit(uri[i + 1]);
    const auto low = hex_digit(uri[i + 2]);
    if (!high || !low) return std::nullopt;
    text += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return text;
}

// Whether the URI has a scheme (RFC 3986): a letter, then letters, digits, '+', '-' or '.', then
// ':'.
bool has_scheme(std::string_view uri) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (uri.empty() || !letter(uri[0])) return false;
  for (const char c : uri) {
    if (c == ':') return true;
    if (!letter(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') return false;
  }
  return false;
}

// A data URI (RFC 2397): the scheme, a media type with its parameters, a comma, the data. Scheme
// and "base64" may be in any case, and any character may be a per cent code (RFC 3986).
constexpr std::string_view kDataScheme = "data:";

bool is_data_uri(std::string_view uri) {
  return equal_ignoring_case(uri.substr(0, kDataScheme.size()), kDataScheme);
}

Result<Bytes> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    return fail("", "the data URI has no comma before its data",
                "write data:application/octet-stream;base64,...");
  }
  const std::string_view header = uri.substr(0, comma), data = uri.substr(comma + 1);
  constexpr std::string_view kBase64 = ";base64";
  const bool in_base64 =
      header.size() >= kBase64.size() &&
      equal_ignoring_case(header.substr(header.size() - kBase64.size()), kBase64);
  // Nearly all data URIs are long and without per cent codes: these are not copied.
  if (in_base64 && data.find('%') == std::string_view::npos) return decode_base64(data);
  const std::optional<std::string> text = percent_decoded(data);
  if (!text) {
    return fail("", "the data URI has a per cent sign without two hexadecimal digits after it",
                "encode the data in base64");
  }
  if (in_base64) return decode_base64(*text);
  const auto bytes = std::as_bytes(std::span(*text));
  return Bytes(bytes.begin(), bytes.end());
}

// Whether `path` is below `directory`; both are canonical.
bool is_inside(const fs::path& path, const fs::path& directory) {
  const auto [in_directory, in_path] =
      std::mismatch(directory.begin(), directory.end(), path.begin(), path.end());
  return in_directory == directory.end() && in_path != path.end();
}

}  // namespace

Result<Bytes> read_whole_file(const std::string& path, std::uint64_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return fail("", "there is no such file", "check the path");
  if (!fs::is_regular_file(status))
    return fail("", "is not a regular file", "give the path of a file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return fail("", "cannot be read", "check that the file may be read");
  if (size > max_bytes) {
    return fail("",
                "has " + std::to_string(size) + " bytes, but at most " + std::to_string(max_bytes) +
                    " may be read",
                "use a smaller file (in the library: LoadLimits::max_file_bytes)");
  }
  std::ifstream stream(path, std::ios::binary);
  Bytes bytes(size);
  if (!stream || !stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size))) {
    return fail("", "cannot be read", "check that the file may be read");
  }
  return bytes;
}

Result<Bytes> decode_base64(std::string_view text) {
  const auto refuse = [](std::string cause) {
    return fail("", std::move(cause), "encode the data again, padded and without spaces");
  };
  if (text.size() % 4 != 0)
    return refuse("the base64 data is not in whole groups of four characters");
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t group = 0; group < text.size(); group += 4) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool pad = group + i >= text.size() - padding;
      const std::uint32_t digit = pad ? 0 : base64_digit(text[group + i]);
      if (digit == 64)
        return refuse("character " + std::to_string(group + i) +
                      " of the base64 data is not a base64 digit");
      bits = bits << 6 | digit;
    }
    for (const int shift : {16, 8, 0}) bytes.push_back(std::byte(bits >> shift & 0xff));
  }
  for (; padding > 0; --padding) bytes.pop_back();
  return bytes;
}

Result<std::shared_ptr<const Bytes>> Resources::read(std::string_view uri) {
  if (is_data_uri(uri)) {
    auto bytes = decode_data_uri(uri);
    if (!bytes) return tl::unexpected(bytes.error());
    total_bytes_ += bytes->size();
    return std::make_shared<const Bytes>(std::move(*bytes));
  }
  const auto refuse = [&](const std::string& cause) {
    return fail("", "the URI " + in_quotes(uri) + " " + cause,
                "name a file beside the scene by a relative path");
  };
  if (has_scheme(uri))
    return refuse("begins with the name of a protocol, and data: is the only one that is read");
  const std::optional<std::string> decoded = percent_decoded(uri);
  if (!decoded) return refuse("has a per cent sign without two hexadecimal digits after it");
  if (decoded->empty()) return refuse("is empty");
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(decoded->begin(), decoded->end(), control))
    return refuse("has control characters");
  if (decoded->front() == '/' || decoded->front() == '\\') return refuse("is an absolute path");
  return read_inside_directory(*decoded);
}

Result<std::shared_ptr<const Bytes>> Resources::read_inside_directory(const std::string& relative) {
  const std::string named = "the file " + in_quotes(relative) + " ";
  if (directory_.empty()) {
    return fail("",
                named + "is external, and cannot be found because the scene itself is not a file",
                "embed the data in the scene");
  }
  std::error_code error;
  const fs::path root = fs::canonical(directory_, error);
  if (error) return fail("", "the scene's directory cannot be found", "check the path");
  const fs::path path = fs::canonical(root / relative, error);
  if (error) return fail("", named + "does not exist", "put it where the scene names it");
  if (!is_inside(path, root)) {
    return fail("", named + "lies outside the scene's directory", "copy it into the directory");
  }
  const auto known = files_.find(path.string());
  if (known != files_.end()) return known->second;
  auto bytes = read_whole_file(
      path.string(), limits_.max_file_bytes - std::min(limits_.max_file_bytes, total_bytes_));
  if (!bytes) return fail("", named + bytes.error().cause, bytes.error().remedy);
  total_bytes_ += bytes->size();
  return files_[path.string()] = std::make_shared<const Bytes>(std::move(*bytes));
}

}  // namespace glassbox::gltf
