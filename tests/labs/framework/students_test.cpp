// Tests the files that students are given: none of them contains a solution, a hidden check or a
// planted fault.
#include "labs/framework/student_version.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/framework/strip_solution.h"
#include "labs/framework/zip.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// Returns names of functions and inputs that a text has between the markers and nowhere outside
// them.
std::set<std::string> hidden_words(const std::string& text) {
  const auto words_of = [](const std::string& code) {
    std::set<std::string> words;
    std::string word;
    for (const char c : code + " ") {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        word += c;
      } else {
        if (word.size() > 3 && word.find('_') != std::string::npos) words.insert(word);
        word.clear();
      }
    }
    return words;
  };
  const auto stripped = strip_solution(text, "a text");
  REQUIRE(stripped);
  const auto kept = words_of(*stripped);
  std::set<std::string> hidden;
  for (const std::string& word : words_of(text)) {
    if (kept.count(word) == 0) hidden.insert(word);
  }
  return hidden;
}

// Returns the package that the program makes.
std::vector<ZipEntry> package() {
  const fs::path file =
      fs::temp_directory_path() / fmt::format("glassbox-package-{}.zip", getpid());
  const auto outcome = test::run_program(
      GLASSBOX_PROGRAM, {"lab", "package", "--students", "-o", file.string()}, "/");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string text = read_text_file(file).value();
  fs::remove(file);
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  const auto entries = read_zip({first, first + text.size()});
  REQUIRE(entries);
  return *entries;
}

bool is_in(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Returns the quoted names of the labs' hidden checks, and the functions that make their inputs.
std::set<std::string> secrets() {
  const Sources sources = find_sources().value();
  std::set<std::string> all;
  for (const Lab& lab : all_labs()) {
    for (const Check& check : lab.checks) {
      if (check.hidden) all.insert("\"" + check.name + "\"");
    }
    for (const char* file : {"cases.h", "runner.cpp"}) {
      const auto words = hidden_words(read_text_file(sources.labs / lab.folder / file).value());
      all.insert(words.begin(), words.end());
    }
  }
  return all;
}

}  // namespace

TEST_CASE("the students' package has no line of a solution, no hidden check and no planted fault") {
  const auto entries = package();
  const Sources sources = find_sources().value();
  const auto secret = secrets();
  CHECK(secret.size() > 100);
  std::size_t starters = 0;
  for (const ZipEntry& entry : entries) {
    INFO(entry.path);
    CHECK_FALSE(is_in(entry.path, "faults.json"));
    CHECK_FALSE(is_in(entry.path, "lab_faults.md"));  // names hidden checks, and what they find
    CHECK_FALSE(is_in(entry.path, "/tests/"));
    if (!is_in(entry.path, "glassbox/labs/")) continue;
    if (is_in(entry.path, "/framework/") || is_in(entry.path, "/grading/")) continue;
    CHECK_FALSE(is_in(entry.text, "hidden_check("));
    CHECK_FALSE(is_in(entry.text, "// BEGIN "));
    for (const std::string& word : secret) {
      INFO(word);
      // Other hidden words are not searched for, because they may be ordinary words in another lab.
      if (word[0] == '"') CHECK_FALSE(is_in(entry.text, word));
    }
    if (fs::path(entry.path).filename() != "student.cpp") continue;
    ++starters;
    const std::string folder = fs::path(entry.path).parent_path().filename().string();
    CHECK(find_leaks(solution_text(sources, folder).value(), entry.text).empty());
  }
  CHECK(starters == all_labs().size());
  for (const Lab& lab : all_labs()) {
    const std::string folder = "glassbox/labs/" + lab.folder + "/";
    for (const char* file : {"cases.h", "runner.cpp"}) {
      const auto found = std::find_if(entries.begin(), entries.end(), [&](const ZipEntry& entry) {
        return entry.path == folder + file;
      });
      REQUIRE(found != entries.end());
      for (const std::string& word :
           hidden_words(read_text_file(sources.labs / lab.folder / file).value())) {
        INFO(folder << file << ": " << word);
        CHECK_FALSE(is_in(found->text, word));
      }
    }
  }
}

TEST_CASE("the judges that students get are built without the names of hidden checks") {
  const std::string archive = read_text_file(JUDGES_FOR_STUDENTS).value();
  const std::string own = read_text_file(JUDGES).value();
  std::size_t names = 0, found = 0;
  for (const Lab& lab : all_labs()) {
    for (const Check& check : lab.checks) {
      INFO(check.name);
      ++names;
      // A compiler may store a text as numbers, so that not every name is found as it is written.
      if (is_in(own, check.name)) ++found;
      if (check.hidden) CHECK_FALSE(is_in(archive, check.name));
    }
  }
  CHECK(found > names * 9 / 10);
}

TEST_CASE("of a hidden check students get that its task has one") {
  const auto kept =
      student_version("labs/77-x/checks.cpp",
                      "  check(\"a\", \"1.1\", \"eye\", as, b),\n  hidden_check(\"with "
                      "(a \\\" bracket\", \"1.2\", \"eye\", "
                      "more(), f),\n  x\n");
  REQUIRE(kept);
  CHECK(**kept ==
        "  check(\"a\", \"1.1\", \"eye\", as, b),\n  hidden_check_placeholder(\"1.2\"),\n  x\n");
  CHECK_FALSE(student_version("labs/77-x/checks.cpp", "hidden_check(name, task)"));
  CHECK_FALSE(student_version("labs/77-x/checks.cpp", "hidden_check(\"a\", \"b\""));
  CHECK(student_version("labs/77-x/faults.json", "[]").value() == std::nullopt);
  CHECK(*student_version("labs/77-x/handout.md", "hidden_check(").value() == "hidden_check(");
}
