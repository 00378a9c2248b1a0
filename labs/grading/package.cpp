#include "labs/grading/package.h"

#include <algorithm>

#include <fmt/format.h>

#include "labs/framework/sources.h"
#include "labs/framework/student_version.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// The parts that the program is built from.
constexpr const char* kProgram[] = {
    "app",    "base",     "cli",    "cmake",          "compare",
    "exact",  "html",     "images", "include",        "inspect",
    "labs",   "matrices", "mesh",   "pipeline",       "raster",
    "render", "study",    "views",  "CMakeLists.txt", "CMakePresets.json",
    "LICENSE"};
// Other files that students read, try and start.
constexpr const char* kStudentExtras[] = {"debug", "docs", "examples", "glassbox", "README.md"};

bool is_excluded(const fs::path& relative) {
  const std::string path = relative.generic_string();
  // docs/lab_faults.md names every hidden check and the faults that the check finds.
  return relative.filename().string().starts_with('.') || path.starts_with("images/golden/") ||
         path == "docs/lab_faults.md";
}

Result<ZipEntry> entry_of(const fs::path& tree, const fs::path& relative,
                          const std::string& prefix) {
  const fs::path file = tree / relative;
  auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  std::error_code error;
  const bool executable =
      (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
  return ZipEntry{prefix + relative.generic_string(), std::move(*text), executable};
}

// Adds the files of a part, in any order. Links are ignored: the build makes the links in include/
// where they are missing.
Result<void> add_part(const fs::path& tree, const char* part, std::vector<fs::path>& files) {
  std::error_code error;
  if (!fs::exists(tree / part, error)) {
    return fail(tree.string(), fmt::format("is not a clone of glassbox: it has no {}", part),
                "use the glassbox program that was built in a clone of the repository");
  }
  if (fs::is_regular_file(tree / part, error)) files.emplace_back(part);
  fs::recursive_directory_iterator entry(tree / part, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    const fs::path relative = entry->path().lexically_relative(tree);
    if (entry->is_regular_file() && !is_excluded(relative)) files.push_back(relative);
  }
  return {};
}

template <class Parts>
Result<std::vector<fs::path>> files_of(const fs::path& tree, const Parts& parts) {
  std::vector<fs::path> files;
  for (const char* part : parts) {
    if (const auto added = add_part(tree, part, files); !added)
      return tl::unexpected(added.error());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<std::vector<ZipEntry>> entries_of(const fs::path& tree, const std::vector<fs::path>& files,
                                         const std::string& prefix) {
  std::vector<ZipEntry> entries;
  for (const fs::path& file : files) {
    auto entry = entry_of(tree, file, prefix);
    if (!entry) return tl::unexpected(entry.error());
    entries.push_back(std::move(*entry));
  }
  return entries;
}

}  // namespace

Result<std::vector<ZipEntry>> program_files(const fs::path& tree, const std::string& prefix) {
  const auto files = files_of(tree, kProgram);
  if (!files) return tl::unexpected(files.error());
  return entries_of(tree, *files, prefix);
}

Result<std::vector<ZipEntry>> students_files(const fs::path& tree) {
  const std::string prefix = "glassbox/";
  auto program = program_files(tree, prefix);
  if (!program) return program;
  const auto extras = files_of(tree, kStudentExtras);
  if (!extras) return tl::unexpected(extras.error());
  auto more = entries_of(tree, *extras, prefix);
  if (!more) return more;
  std::vector<ZipEntry> entries;
  for (auto* each : {&*program, &*more}) {
    for (ZipEntry& entry : *each) {
      if (is_lab_path(entry.path.substr(prefix.size()))) {
        auto kept = student_version(entry.path, entry.text);
        if (!kept) return tl::unexpected(kept.error());
        if (!*kept) continue;
        entry.text = std::move(**kept);
      }
      entries.push_back(std::move(entry));
    }
  }
  // The build makes the program for students if this file exists (cmake/options.cmake).
  entries.push_back({prefix + "cmake/for-students",
                     "This glassbox has the labs without solutions, hidden checks and grading.\n"});
  return entries;
}

}  // namespace glassbox::labs::grading
