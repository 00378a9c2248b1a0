#include <glassbox/compare/pictures/pairing.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <system_error>

#include <glassbox/images/format.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

bool is_sidecar(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".fuzzy";
}

bool has_picture_name(const fs::path& path) {
  return is_picture_extension(path.extension().string());
}

// Whether a file without a picture's extension is a picture by its first bytes. Those of some
// formats are two letters, which a text can begin with, too: they need a whole header.
bool has_picture_bytes(const fs::path& path) {
  std::array<char, kFormatBytes> start{};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), std::streamsize(start.size()));
  const auto bytes = std::as_bytes(std::span(start)).first(std::size_t(file.gcount()));
  const auto format = picture_format_of(bytes);
  if (!format) return false;
  const bool may_be_text = format->format == PictureFormat::kBmp ||
                           format->format == PictureFormat::kPnm ||
                           format->format == PictureFormat::kPfm;
  if (!may_be_text) return true;
  const auto whole = read_file(path.string());
  return whole && stored_header(*whole).has_value();
}

tl::unexpected<Error> cannot_list(const std::string& directory, const std::error_code& error) {
  return tl::unexpected(Error{directory, "", "cannot be listed: " + error.message(),
                              "check the name and the permissions"});
}

// The names of files below a directory, with / between folders.
struct Files {
  std::set<std::string> pictures, sidecars;
};

Result<Files> files_below(const std::string& directory) {
  Files files;
  std::error_code error;
  fs::recursive_directory_iterator it(directory, error);
  if (error) return cannot_list(directory, error);
  for (; it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored)) {
      const fs::path& path = it->path();
      const std::string name = path.lexically_relative(directory).generic_string();
      if (is_sidecar(path)) {
        files.sidecars.insert(name);
      } else if (has_picture_name(path) || has_picture_bytes(path)) {
        files.pictures.insert(name);
      }
    }
    if (error) return cannot_list(directory, error);
  }
  if (error) return cannot_list(directory, error);
  return files;
}

bool has_picture(const std::string& sidecar, const std::set<std::string>& pictures) {
  const fs::path stem = fs::path(sidecar).replace_extension();  // teapot.png.fuzzy or teapot.fuzzy
  if (pictures.count(stem.generic_string()) > 0) return true;
  return std::any_of(pictures.begin(), pictures.end(), [&](const std::string& name) {
    return fs::path(name).replace_extension() == stem;
  });
}

std::string below(const std::string& directory, const std::string& name) {
  return (fs::path(directory) / name).string();
}

}  // namespace

bool may_exist(const std::string& path) {
  std::error_code error;
  return fs::status(path, error).type() != fs::file_type::not_found;
}

Result<Pairing> pair_directories(const std::string& reference, const std::string& test) {
  const bool has_references = may_exist(reference);
  const Result<Files> references = has_references ? files_below(reference) : Files();
  if (!references) return tl::unexpected(references.error());
  const auto tests = files_below(test);
  if (!tests) return tl::unexpected(tests.error());

  std::map<std::string, PicturePaths> pictures;
  Pairing pairing;
  for (const std::string& name : references->pictures) pictures[name].has_reference = true;
  for (const std::string& name : tests->pictures) pictures[name].has_test = true;
  for (const std::string& name : references->sidecars) {
    if (!has_picture(name, references->pictures)) pairing.orphans.push_back(below(reference, name));
  }
  if (pictures.empty()) {
    const std::string cause = has_references ? "there is no picture in it, nor in " + test
                                             : "does not exist, and there is no picture in " + test;
    return tl::unexpected(
        Error{reference, "", cause, "name two directories with pictures, such as PNG files"});
  }
  for (auto& [name, paths] : pictures) {
    paths.name = name;
    paths.reference = below(reference, name);
    paths.test = below(test, name);
    pairing.pictures.push_back(std::move(paths));
  }
  return pairing;
}

}  // namespace glassbox
