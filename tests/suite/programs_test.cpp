// Compares the programs that the project and its tests start with the packages that the launcher
// installs. It finds a program that is on a machine only by chance.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "tests/images/temporary_directory.h"
#include "tests/suite/program_words.h"
#include "tests/support/run_program.h"
#include "tests/support/skip.h"

namespace glassbox::test {

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GLASSBOX_SOURCE_DIR;

struct Program {
  std::string package, from;  // the columns of programs.tsv, which explains them
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, Program> table() {
  std::map<std::string, Program> programs;
  std::istringstream lines(text_of(kRoot / "tests/suite/programs.tsv"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream fields(line);
    std::string name;
    Program program;
    REQUIRE(std::getline(fields, name, '\t'));
    REQUIRE(std::getline(fields, program.package, '\t'));
    REQUIRE(std::getline(fields, program.from));
    REQUIRE(programs.emplace(name, program).second);
  }
  return programs;
}

// Returns the packages of each section of cmake/packages.txt.
std::map<std::string, Words> sections() {
  std::map<std::string, Words> all;
  std::istringstream lines(text_of(kRoot / "cmake/packages.txt"));
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word;
    if (!(words >> word)) continue;
    if (word.front() == '[') {
      section = word.substr(1, word.size() - 2);
    } else {
      do {
        if (word != "|") all[section].insert(word);
      } while (words >> word);
    }
  }
  return all;
}

// Returns the paths of all files below the root, except those that a build makes.
std::vector<std::string> sources() {
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator at(kRoot), end; at != end; ++at) {
    const std::string name = at->path().filename().string();
    if (at.depth() == 0 && (name == "build" || name == "out" || name == ".git")) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file()) {
      files.push_back(at->path().lexically_relative(kRoot).generic_string());
    }
  }
  return files;
}

Words words_of(const std::string& file, const std::string& text) {
  const std::string extension = fs::path(file).extension().string();
  if (extension == ".cpp" || extension == ".h") return cpp_words(text);
  if (extension == ".cmake" || fs::path(file).filename() == "CMakeLists.txt")
    return cmake_words(text);
  if (extension == ".mjs") return javascript_words(text);
  if (extension == ".sh" || text.starts_with("#!/bin/sh") ||
      text.starts_with("#!/usr/bin/env bash"))
    return shell_words(text);
  return {};
}

// Returns the file that a shell would run, or an empty path.
fs::path found_in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream places(std::string(path != nullptr ? path : "") + ":/usr/bin:/bin");
  for (std::string place; std::getline(places, place, ':');) {
    const fs::path file = fs::path(place) / program;
    std::error_code error;
    if (!place.empty() && fs::is_regular_file(file, error)) return file;
  }
  return {};
}

bool may_use_everything(const std::string& file) {
  return file == "tests/run.sh" || file.starts_with("tests/arm64/") ||
         file.starts_with("tests/browser/") || file.starts_with("tests/chroots/") ||
         file.starts_with("tests/peers/");
}

// Returns what is wrong with the file's use of a program, or an empty text. A word that is neither
// in the table nor a program on this machine is taken for an ordinary word.
std::string complaint(const std::string& file, const std::string& program,
                      const std::map<std::string, Program>& programs, bool is_here) {
  const auto found = programs.find(program);
  if (found == programs.end())
    return is_here ? file + " starts " + program + ", which tests/suite/programs.tsv lacks" : "";
  const std::string& from = found->second.from;
  if (from == "all" || from == "arm64" || from == "browser" || from == "node") {
    if (!may_use_everything(file))
      return file + " starts " + program + ", which ./glassbox test does not install";
  }
  return "";
}

Outcome dpkg_query(const std::vector<std::string>& words) {
  return run_program("/usr/bin/dpkg-query", words, "/");
}

// Returns the files to which Debian's alternatives can set `name`, for any current setting: for
// "awk" those of mawk and gawk. `options` give the folders of update-alternatives.
std::vector<std::string> alternatives_of(const std::string& name,
                                         std::vector<std::string> options = {}) {
  options.insert(options.end(), {"--list", name});
  std::vector<std::string> files;
  std::istringstream lines(run_program("/usr/bin/update-alternatives", options, "/").out);
  for (std::string line; std::getline(lines, line);) files.push_back(line);
  return files;
}

// Returns the file's path and those that its links lead to, each of them also in the other one of
// /bin and /usr/bin.
std::vector<std::string> names_of(fs::path file) {
  std::vector<std::string> names;
  for (int i = 0; i < 8; ++i) {
    const std::string name = fs::absolute(file).lexically_normal().string();
    names.push_back(name);
    names.push_back(name.starts_with("/usr/") ? name.substr(4) : "/usr" + name);
    if (!fs::is_symlink(file)) break;
    file = file.parent_path() / fs::read_symlink(file);
  }
  return names;
}

// Returns the package of each file that belongs to one.
std::multimap<std::string, std::string> owners_of(const std::vector<std::string>& files) {
  std::vector<std::string> words{"-S"};
  words.insert(words.end(), files.begin(), files.end());
  std::multimap<std::string, std::string> owners;
  std::istringstream lines(dpkg_query(words).out);
  // A line is "package, another: /usr/bin/name"; the lines about diversions name no package that
  // could be in the table.
  for (std::string line; std::getline(lines, line);) {
    const auto colon = line.find(": /");
    if (colon == std::string::npos) continue;
    std::istringstream packages(line.substr(0, colon));
    for (std::string package; std::getline(packages >> std::ws, package, ',');)
      owners.emplace(line.substr(colon + 2), package.substr(0, package.find(':')));
  }
  return owners;
}

}  // namespace

TEST_CASE("every program that a source starts is in the table of programs") {
  const auto programs = table();
  std::size_t found = 0;
  for (const std::string& file : sources()) {
    // The examples in that file are made up.
    if (file == "tests/suite/words_test.cpp") continue;
    for (const std::string& word : words_of(file, text_of(kRoot / file))) {
      found += programs.contains(word) ? 1u : 0u;
      CHECK(complaint(file, word, programs, !found_in_path(word).empty()) == "");
    }
  }
  CHECK(found > 60);
}

TEST_CASE("a program that is here by chance, or that the tests do not install, is complained of") {
  const std::map<std::string, Program> programs{{"sh", {"dash", "base"}},
                                                {"clang++", {"clang", "all"}}};
  CHECK(complaint("a.cpp", "sh", programs, true).empty());
  CHECK(complaint("a.cpp", "cowsay", programs, false).empty());
  CHECK(complaint("a.cpp", "cowsay", programs, true).find("cowsay") != std::string::npos);
  CHECK(complaint("a.cpp", "clang++", programs, false).find("clang++") != std::string::npos);
  CHECK(complaint("tests/run.sh", "clang++", programs, true).empty());
}

TEST_CASE("every program of the table comes from a package that is installed when it is needed") {
  const auto packages = sections();
  for (const auto& [name, program] : table()) {
    INFO(name << " of " << program.package << ", " << program.from);
    if (program.from == "base" || program.from == "optional") continue;
    REQUIRE(packages.contains(program.from));
    // The list names Debian's pkgconf by its other name, pkg-config.
    const std::string listed = program.package == "pkgconf-bin" ? "pkg-config" : program.package;
    CHECK(packages.at(program.from).contains(listed));
  }
}

TEST_CASE("a program of several packages is of each of them, whichever is chosen") {
  if (!fs::exists("/usr/bin/update-alternatives")) SKIP_TEST("no dpkg here");
  const TemporaryDirectory scratch;
  const std::string folder = scratch.path().string();
  const std::vector<std::string> here{"--altdir", folder + "/chosen", "--admindir",
                                      folder + "/kept"};
  for (const char* each : {"/chosen", "/kept"}) fs::create_directory(folder + each);
  for (const std::string each : {"/mawk", "/gawk"}) {
    std::ofstream(folder + each) << "#!/bin/sh\n";
    std::vector<std::string> words = here;
    words.insert(words.end(), {"--log", "/dev/null", "--install", folder + "/awk", "awk",
                               folder + each, each == "/gawk" ? "10" : "5"});
    REQUIRE(run_program("/usr/bin/update-alternatives", words, "/").exit_code == 0);
  }
  CHECK(fs::canonical(folder + "/awk") == folder + "/gawk");
  std::vector<std::string> found = alternatives_of("awk", here);
  std::ranges::sort(found);
  CHECK(found == std::vector{folder + "/gawk", folder + "/mawk"});
  CHECK(alternatives_of("sed", here).empty());
}

TEST_CASE("Debian's packages have the programs that the table says") {
  if (!fs::exists("/usr/bin/dpkg-query")) SKIP_TEST("no dpkg here");
  const auto programs = table();
  std::map<std::string, std::vector<std::string>> files;
  std::vector<std::string> all;
  for (const auto& [name, program] : programs) {
    for (const char* place : {"/usr/bin", "/bin"}) {
      const fs::path file = fs::path(place) / name;
      if (!fs::exists(file)) continue;
      for (const std::string& each : names_of(file)) files[name].push_back(each);
    }
    for (const std::string& each : alternatives_of(name)) files[name].push_back(each);
    all.insert(all.end(), files[name].begin(), files[name].end());
  }
  const auto owners = owners_of(all);
  int asked = 0;
  for (const auto& [name, program] : programs) {
    INFO(name << " of " << program.package << ", " << program.from);
    const Outcome package =
        dpkg_query({"-W", "-f", "${db:Status-Status} ${Essential} ${Priority}", program.package});
    // While another package is being installed, a package whose triggers have still to run has
    // another status although it is installed.
    if (!package.out.starts_with("installed") && !package.out.starts_with("triggers-")) {
      CHECK((program.from != "base" && program.from != "needed"));
      continue;
    }
    // apt is excepted: the launcher installs with it, and its priority differs between releases.
    if (program.from == "base" && program.package != "apt") {
      CHECK((package.out.find(" yes ") != std::string::npos ||
             package.out.find("required") != std::string::npos));
    }
    ++asked;
    CHECK(std::ranges::any_of(files[name], [&, &package = program.package](const auto& file) {
      const auto [first, last] = owners.equal_range(file);
      return std::any_of(first, last, [&](const auto& owner) { return owner.second == package; });
    }));
  }
  CHECK(asked > 30);
}

TEST_CASE("CMake is told everywhere which build program to use: its own choice may not be there") {
  int found = 0;
  for (const std::string& file : sources()) {
    if (file == "tests/suite/programs_test.cpp") continue;
    std::istringstream lines(text_of(kRoot / file));
    for (std::string line; std::getline(lines, line);) {
      if (line.find("cmake -S ") == std::string::npos &&
          line.find("${CMAKE_COMMAND} -S ") == std::string::npos)
        continue;
      INFO(file << ": " << line);
      CHECK(line.find("-G ") != std::string::npos);
      ++found;
    }
  }
  CHECK(found >= 3);
}

TEST_CASE("the sources that start programs by themselves are those that are known") {
  // After each source, the programs that it starts: itself again, or those that its caller or the
  // table names.
  const Words known{
      "cli/process/process.cpp",              // the compiler, the runner that it has made, gnuplot
      "compare/testing/run_diff.cpp",         // glassbox, which compares
      "labs/grading/grade_class.cpp",         // itself, for each submission
      "labs/grading/process.cpp",             // bwrap, the compiler, the runner
      "study/bench/peer_process.cpp",         // itself, as a peer
      "tests/app/step_prompt_test.cpp",       // the program, on a pseudo-terminal
      "tests/labs/drawing/command_test.cpp",  // the program, which is ended
      "tests/labs/grading/class_test.cpp",    // parallel
      "tests/report/junit_test.cpp",          // xmllint
      "tests/support/run_program.h",          // what its callers name
  };
  Words found;
  for (const std::string& file : sources()) {
    const std::string extension = fs::path(file).extension().string();
    if ((extension == ".cpp" || extension == ".h") && launches(text_of(kRoot / file)) &&
        file != "tests/suite/words_test.cpp")
      found.insert(file);
  }
  CHECK(found == known);
}

}  // namespace glassbox::test
