#include "labs/framework/sources.h"

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "labs/framework/strip_solution.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// All parts of a text that are between `start` and `end`.
std::vector<std::string> between(const std::string& text, const std::string& start, char end) {
  std::vector<std::string> names;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const std::size_t first = at + start.size();
    const std::size_t last = text.find(end, first);
    if (last != std::string::npos) names.push_back(text.substr(first, last - first));
  }
  return names;
}

// The names of the framework's files that a text includes.
std::vector<std::string> framework_includes(const std::string& text) {
  return between(text, "#include \"labs/framework/", '"');
}
std::vector<std::string> library_includes(const std::string& text) {
  return between(text, "#include <glassbox/", '>');
}

}  // namespace

Result<Sources> find_sources() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  std::vector<Sources> places;
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path();
    places.push_back({prefix / "share/glassbox/labs", prefix / "include", {}});
  }
  places.push_back({GLASSBOX_LABS_SOURCE, GLASSBOX_LABS_INCLUDE, {}});
  for (const Sources& place : places) {
    if (is_file(place.labs / "framework/runner_main.cpp") &&
        is_file(place.include / "glassbox/base/spaces.h"))
      return place;
  }
  return fail("labs",
              "the files of the labs are found neither beside the program nor in its source tree",
              "install glassbox again (cmake --install), or build it in its source tree");
}

Result<std::string> read_text_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || is_file(path) == false)
    return fail(path.string(), "cannot be read", "check that the file is there and readable");
  return text.str();
}

Result<void> write_if_changed(const fs::path& path, const std::string& text) {
  if (is_file(path)) {
    if (const auto before = read_text_file(path); before && *before == text) return {};
  }
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file)
    return fail(path.string(), "cannot be written", "check the directory's permissions and space");
  return {};
}

Result<std::string> solution_text(const Sources& sources, const std::string& folder) {
  return read_text_file(sources.folder_of(folder) / "student.cpp");
}

Result<std::vector<SourceFile>> support_files(const Sources& sources, const std::string& folder,
                                              bool with_hidden) {
  struct Wanted {
    fs::path from;
    std::string as;
  };
  std::vector<Wanted> wanted;
  for (const char* name : {"student.h", "cases.h", "runner.cpp"})
    wanted.push_back({sources.folder_of(folder) / name, name});
  // A lab may have generated inputs, in one file or several.
  std::error_code error;
  std::set<std::string> generators;
  for (fs::directory_iterator entry(sources.folder_of(folder), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("generators") && name.ends_with(".h")) generators.insert(name);
  }
  for (const std::string& name : generators)
    wanted.push_back({sources.folder_of(folder) / name, name});
  const auto want_of_framework = [&](const std::string& name) {
    wanted.push_back({sources.labs / "framework" / name, "labs/framework/" + name});
  };
  want_of_framework("runner_main.cpp");
  std::vector<SourceFile> files;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    auto text = read_text_file(wanted[i].from);
    if (text && !with_hidden) text = strip_solution(*text, wanted[i].from.string());
    if (!text) return tl::unexpected(text.error());
    files.push_back({wanted[i].as, std::move(*text)});
    for (const std::string& name : framework_includes(files.back().text)) {
      if (seen.insert(name).second) want_of_framework(name);
    }
  }
  return files;
}

Result<std::vector<SourceFile>> library_headers(const Sources& sources,
                                                const std::vector<SourceFile>& files) {
  std::vector<std::string> wanted;
  std::set<std::string> seen;
  const auto want_includes_of = [&](const std::string& text) {
    for (const std::string& name : library_includes(text)) {
      if (seen.insert(name).second) wanted.push_back(name);
    }
  };
  for (const SourceFile& file : files) want_includes_of(file.text);
  std::vector<SourceFile> headers;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    auto header = read_text_file(sources.include / "glassbox" / wanted[i]);
    if (!header) return tl::unexpected(header.error());
    headers.push_back({"glassbox/" + wanted[i], std::move(*header)});
    want_includes_of(headers.back().text);
  }
  return headers;
}

}  // namespace glassbox::labs
