#include <glassbox/compare/report/page_folder.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCall = "glassboxPictures(";

// Bytes that are not letters, digits or "-._~" are written as %XX (RFC 3986, 2.1).
std::string percent_encoded(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  std::string out;
  for (const char c : text) {
    if (kPlain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

// Whether the file is one that write_page_file wrote, or none.
bool may_be_replaced(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return true;
  if (!fs::is_regular_file(path, error)) return false;
  std::array<char, kCall.size()> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), std::streamsize(start.size()));
  return std::string_view(start.data(), start.size()) == kCall;
}

std::string file_name(std::size_t index) {
  return fmt::format("{:04}.js", index);
}

// The index of the file with this name; 0 if it is no name of such a file.
std::size_t index_of(const std::string& name) {
  std::size_t index = 0;
  std::from_chars(name.data(), name.data() + name.size(), index);
  return name == file_name(index) ? index : 0;
}

Result<void> check_page_file(const fs::path& path) {
  if (may_be_replaced(path)) return {};
  return tl::unexpected(Error{path.string(), "", "this is no file of a page: it is not replaced",
                              "move it away, or give the page another name"});
}

Result<void> make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (fs::is_directory(folder, error)) return {};
  return tl::unexpected(Error{folder, "", "the folder of the page's pictures cannot be made",
                              "give the page another name, or make its directory writable"});
}

}  // namespace

std::string page_folder(const std::string& page) {
  return fs::path(page).replace_extension().string() + "-files";
}

Result<void> check_page_files(const std::string& page, std::size_t count) {
  const fs::path folder = page_folder(page);
  for (std::size_t index = 1; index <= count; ++index) {
    if (auto legal = check_page_file(folder / file_name(index)); !legal) return legal;
  }
  return {};
}

Result<PageFile> write_page_file(const std::string& page, std::size_t index,
                                 const nlohmann::ordered_json& blobs) {
  const std::string folder = page_folder(page);
  if (auto made = make_folder(folder); !made) return tl::unexpected(made.error());
  const std::string name = file_name(index);
  const fs::path path = fs::path(folder) / name;
  if (auto legal = check_page_file(path); !legal) return tl::unexpected(legal.error());
  const std::string data = blobs.dump();
  const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(data.data()), data.size());
  const std::string own_folder = fs::path(folder).filename().string();
  PageFile file{percent_encoded(own_folder) + "/" + name, printable(own_folder, 400) + "/" + name,
                fmt::format("{:08x}", sum)};
  const std::string text = fmt::format("{}\"{}\",{});\n", kCall, file.stamp, data);
  const auto written = write_file(path.string(), std::as_bytes(std::span(text)));
  if (!written) return tl::unexpected(written.error());
  return file;
}

void remove_later_page_files(const std::string& page, std::size_t last) {
  std::error_code error;
  std::vector<fs::path> later;
  for (fs::directory_iterator entry(page_folder(page), error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (index_of(path.filename().string()) > last && may_be_replaced(path)) later.push_back(path);
  }
  for (const fs::path& path : later) fs::remove(path, error);
}

}  // namespace glassbox
