#include "labs/grading/autograder.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/sources.h"
#include "labs/grading/package.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// What identifies a user of Gradescope: the id, or else the email; empty if there is neither.
std::string name_of_user(const nlohmann::json& user) {
  if (!user.is_object()) return {};
  for (const char* field : {"id", "email"}) {
    const auto found = user.find(field);
    if (found == user.end()) continue;
    if (found->is_number_integer()) return found->dump();
    if (found->is_string()) return found->get<std::string>();
  }
  return {};
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

Result<std::string> read_submitters(const fs::path& file) {
  const auto refused = [&](const std::string& cause) {
    return fail(file.string(), cause,
                "name Gradescope's submission_metadata.json, or leave --metadata out and give the "
                "submission's name with --name");
  };
  const auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  const auto users = json.is_object() ? json.find("users") : json.end();
  if (!json.is_object() || users == json.end() || !users->is_array() || users->empty())
    return refused("has no list \"users\" of those who handed in");
  std::vector<std::string> names;
  for (const auto& user : *users) {
    if (const std::string name = name_of_user(user); !name.empty()) names.push_back(name);
  }
  if (names.size() < users->size()) return refused("has a user with neither an id nor an email");
  // Gradescope promises no order for the members of a group.
  std::sort(names.begin(), names.end());
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : "+") + name;
  return all;
}

std::string run_script(int lab, const std::vector<std::string>& options, bool vary) {
  std::string words;
  for (const std::string& each : options) words += " " + each;
  if (vary) words += " --vary \"${metadata[@]}\"";
  // The folder is called "submission" for everybody, so whose it is has to be read.
  const std::string submitters = vary ? R"sh(metadata=()
if [ -e "$root/submission_metadata.json" ]; then
  metadata=(--metadata "$root/submission_metadata.json")
else
  echo "submission_metadata.json is not there: all submissions get the same hidden inputs" >&2
fi
)sh"
                                      : "";
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
{}"$root/source/bin/glassbox" lab grade "$root/submission" --one --lab {} -o "$results"{}
)sh",
                     submitters, lab, words);
}

Result<std::vector<ZipEntry>> autograder_files(const Lab& lab, const fs::path& tree,
                                               const std::vector<std::string>& options, bool vary) {
  std::vector<ZipEntry> entries{{"setup.sh", setup_script(), true},
                                {"run_autograder", run_script(lab.number, options, vary), true}};
  auto sources = program_files(tree, "glassbox/");
  if (!sources) return sources;
  for (ZipEntry& entry : *sources) entries.push_back(std::move(entry));
  return entries;
}

}  // namespace glassbox::labs::grading
