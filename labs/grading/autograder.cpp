#include "labs/grading/autograder.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// What the program is built of; neither its tests nor its documents.
constexpr const char* kParts[] = {"app",    "base",  "cmake",          "images",
                                  "labs",   "mesh",  "pipeline",       "raster",
                                  "render", "study", "CMakeLists.txt", "CMakePresets.json",
                                  "LICENSE"};

bool left_out(const fs::path& relative) {
  const std::string path = relative.generic_string();
  return relative.filename().string().starts_with('.') || path.starts_with("images/golden/");
}

Result<ZipEntry> entry_of(const fs::path& file, const std::string& as) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) return fail(file.string(), "cannot be read", "check the clone's permissions");
  std::error_code error;
  const bool executable =
      (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
  return ZipEntry{as, text.str(), executable};
}

}  // namespace

std::string setup_script() {
  return R"sh(#!/usr/bin/env bash
# Run once, when Gradescope builds the autograder's image: installs what glassbox needs and builds it.
set -euo pipefail
source=${GLASSBOX_AUTOGRADER:-/autograder}/source
root=$source/glassbox
. "$root/cmake/setup.sh"
mkdir -p "$root/build"
install_packages needed
cmake -S "$root" -B "$source/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF
cmake --build "$source/build" --target glassbox_program
mkdir -p "$source/bin"
ln -sf ../build/app/glassbox "$source/bin/glassbox"
# The solutions are in here. Submissions run as another user, who cannot enter.
chmod -R go-rwx "$source"
)sh";
}

std::string run_script(int lab, const std::vector<std::string>& options) {
  std::string words;
  for (const std::string& each : options) words += " " + each;
  return fmt::format(R"sh(#!/usr/bin/env bash
# Run for every submission: grades /autograder/submission/student.cpp into /autograder/results/results.json.
root=${{GLASSBOX_AUTOGRADER:-/autograder}}
results=$root/results/results.json
mkdir -p "$root/results"
# There is a valid result whatever happens from here on.
cat >"$results.part" <<'JSON'
{{"score": 0, "output": "grading did not finish", "tests": []}}
JSON
mv "$results.part" "$results"
"$root/source/bin/glassbox" lab grade "$root/submission" --one --lab {} -o "$results"{}
)sh",
                     lab, words);
}

Result<std::vector<ZipEntry>> autograder_files(const Lab& lab, const fs::path& tree,
                                               const std::vector<std::string>& options) {
  std::vector<ZipEntry> entries{{"setup.sh", setup_script(), true},
                                {"run_autograder", run_script(lab.number, options), true}};
  std::vector<fs::path> files;
  for (const char* part : kParts) {
    std::error_code error;
    if (!fs::exists(tree / part, error)) {
      return fail(tree.string(), fmt::format("is no clone of glassbox: it has no {}", part),
                  "run this from the program that a clone has built");
    }
    if (fs::is_regular_file(tree / part, error)) files.emplace_back(part);
    fs::recursive_directory_iterator entry(tree / part, error), end;
    for (; !error && entry != end; entry.increment(error)) {
      const fs::path relative = entry->path().lexically_relative(tree);
      if (entry->is_regular_file() && !left_out(relative)) files.push_back(relative);
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    auto entry = entry_of(tree / file, "glassbox/" + file.generic_string());
    if (!entry) return tl::unexpected(entry.error());
    entries.push_back(std::move(*entry));
  }
  return entries;
}

}  // namespace glassbox::labs::grading
