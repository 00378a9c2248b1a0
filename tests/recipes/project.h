// A user's project: a folder with files, in whose PATH glassbox is installed.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/compare/environment.h"
#include "tests/images/temporary_directory.h"
#include "tests/support/catch.h"
#include "tests/support/contains.h"
#include "tests/support/run_program.h"

namespace glassbox::test {

class Project {
public:
  std::string path(const std::string& name) const { return directory_.file(name); }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }
  void copy(const std::string& folder_of_clone) const {
    std::filesystem::copy(std::filesystem::path(GLASSBOX_SOURCE_DIR) / folder_of_clone,
                          directory_.path());
  }
  // Draws a built-in scene of 96 x 64 pixels into a file of the project.
  void draw(const std::string& scene, const std::string& name) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    const Outcome outcome = run("glassbox", {"render", scene, "--size", "96x64", "-o", path(name)});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
  }
  // Runs a program that is looked for in PATH.
  Outcome run(const std::string& program, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), program);
    return run_program("/usr/bin/env", arguments, directory_.path().string());
  }

private:
  static std::string path_with_glassbox() {
    const char* before = std::getenv("PATH");
    return std::filesystem::path(GLASSBOX_PROGRAM).parent_path().string() + ":" +
           (before != nullptr ? before : "/usr/bin:/bin");
  }
  TemporaryDirectory directory_;
  EnvironmentVariable installed_{"PATH", path_with_glassbox()};
  EnvironmentVariable no_server_{"CI", {}};
  EnvironmentVariable no_approval_{"GLASSBOX_APPROVE", {}};
  EnvironmentVariable no_failures_{"GLASSBOX_FAILURES", {}};
  EnvironmentVariable no_program_{"GLASSBOX_PROGRAM", {}};
};

}  // namespace glassbox::test
