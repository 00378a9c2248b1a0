// Runs the tiny grader and reads what it wrote.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace glassbox::test {

namespace fs = std::filesystem;

// A directory that is removed with the object.
struct TestDirectory {
  fs::path path;
  TestDirectory() {
    std::string name = (fs::temp_directory_path() / "glassbox-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path = name;
    // Submissions run as other users, which must be able to reach the files in it.
    fs::permissions(path, fs::perms(0755));
  }
  ~TestDirectory() {
    std::error_code error;
    fs::remove_all(path, error);
  }
  TestDirectory(const TestDirectory&) = delete;
  TestDirectory& operator=(const TestDirectory&) = delete;
};

inline void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline nlohmann::json read_json(const fs::path& path) {
  return nlohmann::json::parse(read(path), nullptr, false);
}

// Returns the points of results.json, which are stored where students do not see them.
inline double total(const nlohmann::json& results) {
  return results.at("extra_data").at("score").get<double>();
}

// The code around a submission is compiled once for all tests, except where a test uses a kit of
// its own.
inline const TestDirectory shared_kit;
enum class KitChoice { kShared, kOwn };

inline Outcome grader(std::vector<std::string> arguments, const fs::path& directory,
                      const std::function<void(pid_t)>& meanwhile = {},
                      KitChoice kit = KitChoice::kShared) {
  const bool named = std::find(arguments.begin(), arguments.end(), "--kit") != arguments.end();
  if (kit == KitChoice::kShared && arguments.front() == "grade" && !named)
    arguments.insert(arguments.end(), {"--kit", (shared_kit.path / "kit").string()});
  arguments.insert(arguments.begin(), "lab");
  return run_program(TINY_GRADER, arguments, directory.string(), meanwhile);
}

inline std::string solution() {
  return read(TINY_SOLUTION);
}

// Returns a student.cpp with these function bodies.
inline std::string submission(const std::string& twice, const std::string& reciprocal) {
  return "#include \"student.h\"\ndouble twice(double x) { " + twice +
         " }\ndouble reciprocal(double x) { " + reciprocal + " }\n";
}

}  // namespace glassbox::test
