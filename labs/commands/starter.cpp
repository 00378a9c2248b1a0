#include "labs/commands/starter.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/drawing/drawing.h"
#include "labs/framework/strip_solution.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

// {0} is the lab's folder, {1} the folder with glassbox's headers.
constexpr const char* kCMakeLists = R"(cmake_minimum_required(VERSION 3.20)
project({0} CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Debug)
endif()

# The headers of glassbox: of an installed one, or of the one that made this folder.
find_package(glassbox CONFIG QUIET)
set(GLASSBOX_INCLUDE "{1}" CACHE PATH "The folder that has glassbox/base/spaces.h")

add_executable(runner student.cpp runner.cpp labs/framework/runner_main.cpp)
target_include_directories(runner PRIVATE ${{CMAKE_CURRENT_SOURCE_DIR}})
if(EXISTS "${{GLASSBOX_INCLUDE}}/glassbox/base/spaces.h")
  target_include_directories(runner SYSTEM PRIVATE "${{GLASSBOX_INCLUDE}}")
elseif(glassbox_FOUND)
  get_target_property(headers glassbox::base INTERFACE_INCLUDE_DIRECTORIES)
  target_include_directories(runner SYSTEM PRIVATE ${{headers}})
else()
  message(FATAL_ERROR "glassbox is not found: give -DGLASSBOX_INCLUDE=FOLDER or -DCMAKE_PREFIX_PATH=FOLDER")
endif()
# A product and a sum are two roundings, as in the pipeline.
target_compile_options(runner PRIVATE -ffp-contract=off -Wall -Wextra -Wno-unused-parameter)
)";

// The settings choose Ninja, as glassbox itself does: CMake would choose make, which is not
// installed everywhere.
constexpr const char* kPresets = R"({
  "version": 2,
  "configurePresets": [
    {
      "name": "ninja",
      "displayName": "Debug build, with Ninja",
      "generator": "Ninja",
      "binaryDir": "${sourceDir}/build"
    },
    {
      "name": "make",
      "displayName": "The same, with make",
      "generator": "Unix Makefiles",
      "binaryDir": "${sourceDir}/build"
    }
  ]
}
)";

constexpr const char* kLaunch = R"({
  "version": "0.2.0",
  "configurations": [
    {
      "name": "One case of a check",
      "type": "cppdbg",
      "request": "launch",
      "program": "${workspaceFolder}/build/runner",
      "args": ["--check", "${input:check}", "--case", "${input:case}"],
      "cwd": "${workspaceFolder}",
      "MIMode": "gdb",
      "preLaunchTask": "build"
    }
  ],
  "inputs": [
    {
      "id": "check",
      "type": "pickString",
      "description": "Which check",
      "options": @CHECKS@
    },
    {
      "id": "case",
      "type": "promptString",
      "description": "Which case, from 0",
      "default": "0"
    }
  ]
}
)";

constexpr const char* kTasks = R"({
  "version": "2.0.0",
  "tasks": [
    {
      "label": "build",
      "type": "shell",
      "command": "cmake --preset $(command -v ninja >/dev/null && echo ninja || echo make) && cmake --build build",
      "group": {"kind": "build", "isDefault": true},
      "problemMatcher": "$gcc"
    },
    {
      "label": "check",
      "type": "shell",
      "command": "glassbox lab check .",
      "group": {"kind": "test", "isDefault": true},
      "problemMatcher": "$gcc"
    }@RENDER@
}
)";

// For a lab that draws: a picture with the student's functions.
constexpr const char* kRenderTask = R"(,
    {
      "label": "render",
      "type": "shell",
      "command": "glassbox lab render . ${input:scene} --size 640x360 -o picture.png",
      "problemMatcher": "$gcc"
    }
  ],
  "inputs": [
    {
      "id": "scene",
      "type": "promptString",
      "description": "Which scene: cube, teapot, room, another built-in one, or a file",
      "default": "teapot"
    }
  ])";

std::string replaced(std::string text, const std::string& mark, const std::string& by) {
  return text.replace(text.find(mark), mark.size(), by);
}

// The tasks of the editor: build, check and, if the lab draws, render.
std::string tasks_json(bool draws) {
  return replaced(kTasks, "@RENDER@", draws ? kRenderTask : "\n  ]");
}

std::string launch_json(const labs::Lab& lab) {
  auto names = nlohmann::json::array();
  for (const labs::Check& check : lab.checks) {
    if (!check.hidden) names.push_back(check.name);
  }
  return replaced(kLaunch, "@CHECKS@", names.dump());
}

std::string lab_json(const labs::Lab& lab) {
  const nlohmann::ordered_json json{
      {"lab", lab.folder}, {"number", lab.number}, {"title", lab.title}};
  return json.dump(2) + "\n";
}

// The text of docs/references.md. It is next to the labs if these are installed or were copied for
// students, and otherwise in docs/ of the repository.
std::string references(const labs::Sources& sources) {
  for (const fs::path& place :
       {sources.labs / "references.md", sources.labs.parent_path() / "docs/references.md"}) {
    if (const auto text = labs::read_text_file(place)) return *text;
  }
  return {};
}

// The rows of the table of codes, such as "| C-38 | an edge shared ... |", for the codes that the
// handout cites.
std::string rows_of_codes(const std::string& handout, const std::string& references) {
  static const std::regex row(R"(\| ((?:[A-Z]\d?-|E|B\.|SPEC\s)[\d.]+) \|.*)");
  std::istringstream lines(references);
  // A row may link to a page that is not in the student's folder, so each link is replaced by its
  // text.
  static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
  std::string rows;
  for (std::string line; std::getline(lines, line);) {
    std::smatch parts;
    if (!std::regex_match(line, parts, row)) continue;
    // The code must be a whole word, not the beginning of a longer code.
    std::string pattern = R"(\b)" +
                          std::regex_replace(parts[1].str(), std::regex(R"(\.)"), R"(\.)") +
                          R"((?![\w.-]*\d))";
    if (std::regex_search(handout, std::regex(pattern)))
      rows += std::regex_replace(line, link, "$1") + "\n";
  }
  return rows;
}

// Adds the meanings of the codes to the handout, because a student has no other page that explains
// them.
void add_codes(const labs::Sources& sources, std::vector<SourceFile>& files) {
  for (SourceFile& file : files) {
    if (file.path != "handout.md") continue;
    const std::string rows = rows_of_codes(file.text, references(sources));
    if (rows.empty()) continue;
    // Rows about sources have three columns; other rows have two.
    static const std::regex three(R"(\|[^|\n]*\|[^|\n]*\|[^|\n]*\|)");
    const bool wide = std::regex_search(rows, three);
    file.text += "\n## What the codes stand for\n\n";
    file.text += wide ? "| code | what it says | |\n| --- | --- | --- |\n"
                      : "| code | what it says |\n| --- | --- |\n";
    file.text += rows;
  }
}

// Adds the handout, and the pictures and meshes in its folder.
Result<void> add_handout(const fs::path& folder, std::vector<SourceFile>& files) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::string extension = at->path().extension().string();
    static const std::set<std::string> handed_out{".md",  ".png", ".svg",  ".jpg", ".ppm",
                                                  ".obj", ".mtl", ".gltf", ".glb"};
    if (handed_out.count(extension) != 0 && at->is_regular_file(error)) found.push_back(at->path());
  }
  std::sort(found.begin(), found.end());
  for (const fs::path& path : found) {
    auto text = labs::read_text_file(path);
    if (!text) return tl::unexpected(text.error());
    files.push_back({path.lexically_relative(folder).generic_string(), std::move(*text)});
  }
  return {};
}

}  // namespace

Result<std::vector<SourceFile>> make_starter(const labs::Sources& sources, const labs::Lab& lab) {
  std::vector<SourceFile> files;
  if (const auto added = add_handout(sources.folder_of(lab.folder), files); !added)
    return tl::unexpected(added.error());
  add_codes(sources, files);
  const auto solution = labs::solution_text(sources, lab.folder);
  if (!solution) return tl::unexpected(solution.error());
  auto stubs = labs::strip_solution(*solution, lab.folder + "/student.cpp");
  if (!stubs) return tl::unexpected(stubs.error());
  if (const auto leaks = labs::find_leaks(*solution, *stubs); !leaks.empty()) {
    return tl::unexpected(Error{lab.folder + "/student.cpp", fmt::format("line {}", leaks[0].line),
                                "a line of the solution would be handed out: " + leaks[0].text,
                                "check the markers around it"});
  }
  files.push_back({"student.cpp", std::move(*stubs)});
  auto support = labs::support_files(sources, lab.folder, false);
  if (!support) return tl::unexpected(support.error());
  for (SourceFile& file : *support) files.push_back(std::move(file));
  files.push_back(
      {"CMakeLists.txt", fmt::format(kCMakeLists, lab.folder, sources.include.generic_string())});
  files.push_back({"CMakePresets.json", kPresets});
  files.push_back({".vscode/launch.json", launch_json(lab)});
  files.push_back({".vscode/tasks.json",
                   tasks_json(sources.outside.empty() && drawing_of(lab.number).has_value())});
  files.push_back({".gitignore", "build/\n"});
  files.push_back({"lab.json", lab_json(lab)});
  return files;
}

}  // namespace glassbox::labs
