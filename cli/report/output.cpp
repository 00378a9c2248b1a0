#include "cli/report/output.h"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <set>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox {

std::filesystem::path whole_path(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
}

Result<void> write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    fmt::print("{}", text);
    return {};
  }
  return write_file(target, std::as_bytes(std::span(text)));
}

Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json) {
  // Names come from files and may not be valid UTF-8: invalid bytes are replaced.
  return write_text(
      target, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

Result<void> write_text_result(const std::string& path, const Result<std::string>& text) {
  return text ? write_text(path, *text) : tl::unexpected(text.error());
}

Result<void> check_extension(const std::string& path, const std::string& extension) {
  std::string found = std::filesystem::path(path).extension().string();
  for (char& c : found) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (found == extension) return {};
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return tl::unexpected(Error{path, "", "is a directory", "name a " + extension + " file in it"});
  }
  return tl::unexpected(
      Error{path, "", "this output is a " + extension + " file", "end the name in " + extension});
}

Result<void> check_distinct(const std::vector<std::string>& outputs,
                            const std::vector<std::string>& inputs) {
  std::set<std::filesystem::path> read, written;
  for (const std::string& path : inputs) read.insert(whole_path(path));
  for (const std::string& path : outputs) {
    const std::filesystem::path whole = whole_path(path);
    if (read.contains(whole)) {
      return tl::unexpected(
          Error{path, "", "is an input file, which would be overwritten", "name another output"});
    }
    if (!written.insert(whole).second) {
      return tl::unexpected(
          Error{path, "", "two outputs would go to this file", "give each its own name"});
    }
  }
  return {};
}

Result<void> check_outputs(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::error_code ignored;
    const std::filesystem::path directory = std::filesystem::path(path).parent_path();
    if (!directory.empty() && !std::filesystem::is_directory(directory, ignored)) {
      return tl::unexpected(Error{path, "", "its directory does not exist", "make it first"});
    }
    if (std::filesystem::is_directory(path, ignored)) {
      return tl::unexpected(Error{path, "", "is a directory", "name a file"});
    }
  }
  return check_distinct(paths);
}

Result<void> check_report_outputs(const std::optional<std::string>& page,
                                  const std::optional<std::string>& data) {
  return Outputs().file(page, ".html").data(data).check();
}

void Outputs::add(const std::string& path, const Result<void>& legal) {
  if (legal_ && !legal) legal_ = legal;
  paths_.push_back(path);
}

Outputs& Outputs::file(const std::optional<std::string>& path, const std::string& extension) {
  if (path) add(*path, extension.empty() ? Result<void>() : check_extension(*path, extension));
  return *this;
}

Outputs& Outputs::files(const std::pair<std::string, std::string>& paths,
                        const std::string& extension) {
  return paths.first.empty() ? *this : file(paths.first, extension).file(paths.second, extension);
}

Outputs& Outputs::picture(const std::optional<std::string>& path) {
  if (path) add(*path, check_image_path(*path));
  return *this;
}

Outputs& Outputs::data(const std::optional<std::string>& path) {
  return path == "-" ? *this : file(path);
}

Result<void> Outputs::check() const {
  return legal_ ? check_outputs(paths_) : legal_;
}

}  // namespace glassbox
