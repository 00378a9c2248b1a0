// Checks that Glassbox can be built on another release of Debian than this one, as far as this one
// can tell: the names of packages with their alternatives, the versions that are required, and
// CMake's messages about the build's own files.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/compare/environment.h"
#include "tests/images/temporary_directory.h"
#include "tests/support/catch.h"
#include "tests/support/contains.h"
#include "tests/support/run_program.h"

namespace glassbox::test {

namespace {

namespace fs = std::filesystem;

const fs::path kClone = GLASSBOX_SOURCE_DIR;

std::string read_whole(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A clone with these lines in packages.txt, on a machine where dpkg reports the packages
// `installed` and apt also knows the packages `known`.
class Machine {
public:
  Machine(const std::string& packages, const std::string& installed, const std::string& known) {
    fs::create_directories(root() / "cmake");
    fs::create_directories(root() / "bin");
    write("cmake/packages.txt", packages);
    fs::copy_file(kClone / "cmake/setup.sh", root() / "cmake/setup.sh");
    // dpkg-query prints a line for each of the requested packages that is installed, and fails if
    // one of them is not.
    program("dpkg-query",
            "for name in " + installed +
                "; do\n  case \" $* \" in\n"
                "  *\" $name \"*) echo \"$name installed\" ;;\n  esac\ndone\nexit 1\n");
    program("apt-cache", "case \" " + known + " \" in\n*\" $2 \"*) exit 0 ;;\nesac\nexit 100\n");
  }

  // Returns what one of the functions of setup.sh prints.
  std::string says(const std::string& function) const {
    const Outcome outcome =
        run_program("/bin/sh",
                    {"-euc", "root=$PWD; PATH=$PWD/bin:$PATH; . cmake/setup.sh; printf '%s ' $(" +
                                 function + ")"},
                    root().string());
    CHECK(outcome.err.empty());
    return outcome.out;
  }

private:
  fs::path root() const { return directory_.path(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root() / name) << text;
  }
  void program(const std::string& name, const std::string& text) const {
    write("bin/" + name, "#!/bin/sh\n" + text);
    fs::permissions(root() / "bin" / name, fs::perms::owner_all);
  }
  TemporaryDirectory directory_;
};

const std::string kPackages =
    "# names\n\n[some]\none # the first\nold-1 | new-2  # two names\nc++3\n[x]\ny\n";

// Returns what is wrong with a line of packages.txt, or an empty text.
std::string complaint_of(const std::string& line) {
  static const std::regex fine(
      R"((\[[a-z0-9]+\]|[a-z0-9][a-z0-9+.-]+( \| [a-z0-9][a-z0-9+.-]+)*)?( *#.*)?)");
  return std::regex_match(line, fine) ? "" : "no package, packages or [section]: " + line;
}

// Returns the find_package(...), find_dependency(...) and pkg_check_modules(...) of a text that
// would reject a later version of the package, or that a later CMake would reject.
std::vector<std::string> narrow_requests(const std::string& text) {
  static const std::regex request(R"((find_package|find_dependency|pkg_check_modules)\(([^)]*)\))");
  static const std::regex versioned(R"(^\s*\S+\s+[0-9].*)");
  static const std::regex bounded(R"([<=]|\bEXACT\b)");
  static const std::regex boost(R"(^\s*Boost\b(?![\s\S]*\bCONFIG\b))");
  static const std::regex removed(R"(^\s*(PythonInterp|PythonLibs|CUDA)\b)");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), request), end; at != end; ++at) {
    const std::string what = (*at)[2].str();
    // Which version of Glassbox itself is required is for its users to choose.
    const bool own = what.starts_with("glassbox ");
    if (!own && (std::regex_search(what, versioned) || std::regex_search(what, bounded) ||
                 std::regex_search(what, boost) || std::regex_search(what, removed)))
      found.push_back(at->str());
  }
  return found;
}

std::vector<fs::path> cmake_files() {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(kClone), end; at != end; ++at) {
    const std::string name = at->path().filename().string();
    if (at.depth() == 0 && (name == "build" || name == "out" || name == ".git"))
      at.disable_recursion_pending();
    else if (name == "CMakeLists.txt" || name.ends_with(".cmake") || name.ends_with(".cmake.in"))
      files.push_back(at->path());
  }
  return files;
}

}  // namespace

TEST_CASE("a line of packages is read with its alternatives as one word") {
  CHECK(Machine(kPackages, "", "").says("packages_of some") == "one old-1|new-2 c++3 ");
  CHECK(Machine(kPackages, "", "").says("packages_of x some") == "y one old-1|new-2 c++3 ");
}

TEST_CASE("packages are missing where none of their alternatives is installed") {
  CHECK(Machine(kPackages, "", "").says("missing_packages some") == "one old-1|new-2 c++3 ");
  CHECK(Machine(kPackages, "one new-2", "").says("missing_packages some") == "c++3 ");
  CHECK(Machine(kPackages, "c++3 old-1", "").says("missing_packages some") == "one ");
  CHECK(Machine(kPackages, "one old-1 new-2 c++3", "").says("missing_packages some") == " ");
  // A part of a name is not the same name.
  CHECK(Machine(kPackages, "on old c++", "").says("missing_packages some") ==
        "one old-1|new-2 c++3 ");
}

TEST_CASE("of alternatives the first that apt knows is installed") {
  const auto chosen = [](const std::string& known) {
    return Machine(kPackages, "", known).says("install_command $(missing_packages some)");
  };
  const std::string start = "apt-get install --no-install-recommends -y ";
  CHECK(chosen("one old-1 c++3") == start + "one old-1 c++3 ");
  CHECK(chosen("one new-2 c++3") == start + "one new-2 c++3 ");
  CHECK(chosen("one old-1 new-2 c++3") == start + "one old-1 c++3 ");
  // Where apt knows no alternative, the command names the first one, and apt reports that it does
  // not know it. The same holds for packages without alternatives.
  CHECK(chosen("") == start + "one old-1 c++3 ");
}

TEST_CASE("the lists of packages are well formed") {
  CHECK(complaint_of("libclang-rt-14-dev | libclang-rt-19-dev  # why").empty());
  for (const char* wrong :
       {"a|b", "aa |", "| aa", "aa, bb", "aa bb", "aa || bb", "[two words]", "Caps"}) {
    INFO(wrong);
    CHECK(!complaint_of(wrong).empty());
  }
  std::istringstream lines(read_whole(kClone / "cmake/packages.txt"));
  int read = 0;
  for (std::string line; std::getline(lines, line); ++read) CHECK(complaint_of(line) == "");
  CHECK(read > 40);
}

TEST_CASE("no version of a library is refused because it is later than the one here") {
  CHECK(narrow_requests("find_package(TinyGLTF 2.7 CONFIG REQUIRED)").size() == 1);
  CHECK(narrow_requests("find_dependency(TBB 2021)\nfind_package(fmt EXACT)").size() == 2);
  CHECK(narrow_requests("pkg_check_modules(hwy REQUIRED libhwy<1.1)").size() == 1);
  CHECK(narrow_requests("find_package(Boost REQUIRED)").size() == 1);
  CHECK(
      narrow_requests("find_package(Boost\n CONFIG REQUIRED) find_package(glassbox 0.1)").empty());
  std::size_t asked = 0;
  for (const fs::path& file : cmake_files()) {
    const std::string text = read_whole(file);
    INFO(file.string());
    CHECK(narrow_requests(text) == std::vector<std::string>());
    asked += text.find("find_package(") != std::string::npos ? 1u : 0u;
  }
  CHECK(asked > 8);
}

TEST_CASE("CMake configures the project without a warning, of what is deprecated neither") {
  const TemporaryDirectory build;
  const auto configure = [&](std::vector<std::string> words) {
    words.insert(words.end(),
                 {"-S", GLASSBOX_SOURCE_DIR, "-B", build.path().string(), "-G", "Ninja", "-Wdev",
                  "-Wdeprecated", "-DCMAKE_CXX_COMPILER=" GLASSBOX_COMPILER});
    return run_program(GLASSBOX_CMAKE, words, "/");
  };
  const Outcome fine = configure({});
  INFO(fine.out << fine.err);
  CHECK(fine.exit_code == 0);
  CHECK(fine.err.empty());
  CHECK(fine.out.find("CMake Warning") == std::string::npos);
  CHECK(fine.out.find("Deprecation") == std::string::npos);
}

TEST_CASE("ccache takes objects with -g from no other clone, whatever the user's settings say") {
  const TemporaryDirectory project;
  std::ofstream(project.file("CMakeLists.txt"))
      << "cmake_minimum_required(VERSION 3.25)\nproject(launcher LANGUAGES CXX)\ninclude(\""
      << (kClone / "cmake/options.cmake").string()
      << "\")\nmessage(\"${CMAKE_CXX_COMPILER_LAUNCHER}\")\n";
  const EnvironmentVariable no_launcher("CMAKE_CXX_COMPILER_LAUNCHER", {});
  // In place of ccache there is a program that prints its environment.
  const Outcome configured =
      run_program(GLASSBOX_CMAKE,
                  {"-S", ".", "-B", "build", "-G", "Ninja", "-DGLASSBOX_CCACHE=/usr/bin/env",
                   "-DCMAKE_CXX_COMPILER=" GLASSBOX_COMPILER},
                  project.path().string());
  INFO(configured.err);
  REQUIRE(configured.exit_code == 0);
  std::vector<std::string> words;
  std::istringstream in(configured.err.substr(0, configured.err.find('\n')));
  for (std::string word; std::getline(in, word, ';');) words.push_back(word);
  REQUIRE(words.size() > 2);

  // ccache obeys the variable that comes last of these two.
  const EnvironmentVariable on("CCACHE_HASHDIR", "1"), off("CCACHE_NOHASHDIR", "1");
  const Outcome run = run_program(words.front(), {words.begin() + 1, words.end()}, "/");
  CHECK(contains(run.out, "CCACHE_HASHDIR=1\n"));
  CHECK_FALSE(contains(run.out, "CCACHE_NOHASHDIR="));
}

// Editors read more settings of devcontainer.json than this test knows. It checks that the file is
// JSON and that the files it names exist.
TEST_CASE("the container for editors in a cloud installs what the launcher would") {
  const fs::path folder = kClone / ".devcontainer";
  const auto settings = nlohmann::json::parse(read_whole(folder / "devcontainer.json"));
  CHECK(settings["postCreateCommand"] == "./glassbox");
  const nlohmann::json& build = settings["build"];
  CHECK(fs::exists(folder / build["dockerfile"].get<std::string>()));
  CHECK(fs::exists(folder / build["context"].get<std::string>() / "cmake/setup.sh"));
  const std::string text = read_whole(folder / "Containerfile");
  CHECK(text.find("FROM debian:trixie\n") != std::string::npos);
  CHECK(text.find("install_packages needed tests") != std::string::npos);
}

}  // namespace glassbox::test
