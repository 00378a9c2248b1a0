#include <glassbox/compare/pictures/pairing.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_picture(const fs::path& path) {
  static constexpr std::array kExtensions{".png", ".jpg", ".jpeg", ".bmp",
                                          ".tga", ".ppm", ".pgm",  ".pfm"};
  return std::find(kExtensions.begin(), kExtensions.end(), lower_extension(path)) !=
         kExtensions.end();
}

tl::unexpected<Error> cannot_list(const std::string& directory, const std::error_code& error) {
  return tl::unexpected(Error{directory, "", "cannot be listed: " + error.message(),
                              "check the name and the permissions"});
}

// The names of all files below `directory`, with / between folders.
Result<std::set<std::string>> files_below(const std::string& directory) {
  std::set<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator it(directory, error);
  if (error) return cannot_list(directory, error);
  for (; it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored)) {
      names.insert(it->path().lexically_relative(directory).generic_string());
    }
    if (error) return cannot_list(directory, error);
  }
  if (error) return cannot_list(directory, error);
  return names;
}

bool has_picture(const std::string& sidecar, const std::set<std::string>& names) {
  const fs::path stem = fs::path(sidecar).replace_extension();  // teapot.png.fuzzy or teapot.fuzzy
  if (is_picture(stem) && names.count(stem.generic_string()) > 0) return true;
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return is_picture(name) && fs::path(name).replace_extension() == stem;
  });
}

std::string below(const std::string& directory, const std::string& name) {
  return (fs::path(directory) / name).string();
}

}  // namespace

Result<Pairing> pair_directories(const std::string& reference, const std::string& test) {
  const auto references = files_below(reference);
  if (!references) return tl::unexpected(references.error());
  const auto tests = files_below(test);
  if (!tests) return tl::unexpected(tests.error());

  std::map<std::string, PicturePaths> pictures;
  Pairing pairing;
  for (const std::string& name : *references) {
    if (is_picture(name)) pictures[name].has_reference = true;
    if (lower_extension(name) == ".fuzzy" && !has_picture(name, *references)) {
      pairing.orphans.push_back(below(reference, name));
    }
  }
  for (const std::string& name : *tests) {
    if (is_picture(name)) pictures[name].has_test = true;
  }
  if (pictures.empty()) {
    return tl::unexpected(
        Error{reference, "", "there is no picture in it, nor in " + test,
              "name two directories with pictures (png, jpg, bmp, tga, ppm, pgm, pfm)"});
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
