// Tests a students' program as a student uses it, and the sources that it is built from.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/grading/package.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A directory that is removed with the object.
struct StudentsDirectory {
  fs::path path = fs::temp_directory_path() / fmt::format("glassbox-students-{}", getpid());
  StudentsDirectory() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~StudentsDirectory() { fs::remove_all(path); }
};

// The program with the files of an installation: the files that it hands out are found beside it.
class Installed {
public:
  Installed() {
    const fs::path prefix = directory_.path / "installed";
    fs::create_directories(prefix / "bin");
    fs::create_directories(prefix / "share/glassbox");
    fs::copy_file(STUDENTS_PROGRAM, prefix / "bin/glassbox");
    fs::create_directory_symlink(STUDENTS_LABS, prefix / "share/glassbox/labs");
    // Students' files must do with the headers that are installed for them.
    const auto installed = test::run_program("/usr/bin/env",
                                             {"cmake", "--install", BUILD, "--component",
                                              "student-headers", "--prefix", prefix.string()},
                                             directory_.path.string());
    REQUIRE(installed.exit_code == 0);
  }
  const fs::path& path() const { return directory_.path; }
  test::Outcome run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"XDG_CACHE_HOME=" + (directory_.path / "cache").string(),
                                 (directory_.path / "installed/bin/glassbox").string(), "lab"});
    return test::run_program("/usr/bin/env", words, directory_.path.string());
  }

private:
  StudentsDirectory directory_;
};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Returns the names of the files in the folder.
std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE(
    "a student lists, starts, checks and draws with a program that has nothing hidden in it") {
  const Installed glassbox;
  const auto list = glassbox.run({"list"});
  CHECK(list.exit_code == 0);
  for (const Lab& lab : all_labs()) CHECK(says(list.out, lab.title));
  REQUIRE(glassbox.run({"start", "7", "mine"}).exit_code == 0);
  CHECK(names_in(glassbox.path() / "mine").count("student.cpp") == 1);

  const auto check = glassbox.run({"check", "mine"});
  INFO(check.out << check.err);
  CHECK(check.exit_code == 1);
  CHECK(says(check.out, "not written yet"));
  CHECK(says(check.out, "Hidden checks can give 33.33 points more."));
  // The starter gives answers, although wrong ones.
  const auto render = glassbox.run({"render", "mine", "cube", "--size", "32x18", "-o", "cube.png"});
  INFO(render.out << render.err);
  CHECK(render.exit_code == 1);
  CHECK(fs::exists(glassbox.path() / "cube.png"));
  CHECK(glassbox.run({"quiz", "2"}).exit_code == 0);
}

TEST_CASE("what grades and hands out is unknown to a students' program, as are hidden checks") {
  const Installed glassbox;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
    const auto outcome = glassbox.run(words);
    INFO(words.front() << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(says(outcome.err, why));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  };
  refused({"check", "mine", "--hidden"}, "there is no option '--hidden'");
  for (const char* word : {"grade", "export", "gradescope", "package", "collect"})
    refused({word, "7"}, fmt::format("there is no subcommand '{}'", word));
  for (const auto& entry : fs::recursive_directory_iterator(STUDENTS_LABS)) {
    INFO(entry.path());
    CHECK(entry.path().filename() != "faults.json");
  }
}

TEST_CASE("the students' package has every file that it is built of") {
  const StudentsDirectory directory;
  const auto entries = grading::students_files(GLASSBOX_SOURCE_DIR);
  REQUIRE(entries);
  std::set<std::string> there;
  for (const ZipEntry& entry : *entries) {
    there.insert(entry.path);
    const fs::path file = directory.path / entry.path;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << entry.text;
  }
  // CMake refuses a list of sources if one of them is missing.
  const auto configured = test::run_program(
      "/usr/bin/env", {"cmake", "--preset", "release", "-B", (directory.path / "build").string()},
      (directory.path / "glassbox").string());
  INFO(configured.err);
  REQUIRE(configured.exit_code == 0);
  CHECK(says(read_text_file(directory.path / "build/CMakeCache.txt").value(),
             "GLASSBOX_STUDENT:BOOL=ON"));
  // A header is named from the top, from the folder of raster's lanes, or from the including file's
  // folder. Pages are written by the build.
  const std::regex include("(?:^|\n)#include (?:\"|<glassbox/)([^\">]+)[\">]");
  const std::regex written("\\w+_page\\.h");
  std::size_t headers = 0;
  for (const ZipEntry& entry : *entries) {
    const fs::path path = entry.path;
    if (path.extension() != ".h" && path.extension() != ".cpp") continue;
    for (std::sregex_iterator at(entry.text.begin(), entry.text.end(), include), end; at != end;
         ++at) {
      const std::string name = (*at)[1];
      if (std::regex_match(name, written)) continue;
      INFO(entry.path << " includes " << name);
      ++headers;
      const auto is_at = [&](const fs::path& place) {
        return there.count((place / name).lexically_normal().generic_string()) == 1;
      };
      const bool found = is_at("glassbox") || is_at("glassbox/include/glassbox") ||
                         is_at("glassbox/raster/lanes") || is_at(path.parent_path());
      CHECK(found);
    }
  }
  CHECK(headers > 1000);
}
