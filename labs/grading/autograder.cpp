#include "labs/grading/autograder.h"

#include <fmt/format.h>

#include "labs/grading/package.h"

namespace glassbox::labs::grading {

namespace fs = std::filesystem;

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
{{"score": 0, "output": "grading did not finish", "tests": [], "extra_data": {{"outcome": "grading did not finish", "score": 0}}}}
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
  auto sources = program_files(tree, "glassbox/");
  if (!sources) return sources;
  for (ZipEntry& entry : *sources) entries.push_back(std::move(entry));
  return entries;
}

}  // namespace glassbox::labs::grading
