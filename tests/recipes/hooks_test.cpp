// Runs the hooks of .pre-commit-hooks.yaml as pre-commit does, and checks the file's fields. Where
// pre-commit is installed, it reads the file, too.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/recipes/project.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

const std::string kClone = GLASSBOX_SOURCE_DIR;
const std::string kHooksFile = kClone + "/.pre-commit-hooks.yaml";

using Hook = std::map<std::string, std::string>;  // a hook's fields

// Reads the part of YAML that the file needs: a list of hooks, each with fields of one line.
std::map<std::string, Hook> read_hooks() {
  static const std::regex field("(- |  )([a-z_]+): (.+)");
  std::map<std::string, Hook> hooks;
  std::string id;
  std::ifstream in(kHooksFile);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    INFO(line);
    std::smatch parts;
    REQUIRE(std::regex_match(line, parts, field));
    if (parts[1] == "- ") {
      REQUIRE(parts[2] == "id");
      id = parts[3];
    }
    REQUIRE(hooks[id].emplace(parts[2], parts[3]).second);
  }
  return hooks;
}

// Runs a hook as pre-commit does, in the user's project: the entry's words, the args that the user
// configured, and the changed files that match `files`. A script's entry is a path in the clone.
Outcome run_hook(const Project& project, const std::string& id,
                 const std::vector<std::string>& args, const std::vector<std::string>& changed) {
  const Hook hook = read_hooks().at(id);
  std::istringstream entry(hook.at("entry"));
  std::string program;
  entry >> program;
  if (hook.at("language") == "script") program = kClone + "/" + program;
  std::vector<std::string> words;
  for (std::string word; entry >> word;) words.push_back(word);
  words.insert(words.end(), args.begin(), args.end());
  if (!hook.contains("pass_filenames")) {
    const std::regex files(hook.contains("files") ? hook.at("files") : "");
    for (const std::string& file : changed) {
      if (std::regex_search(file, files)) words.push_back(file);
    }
  }
  return project.run(program, words);
}

}  // namespace

TEST_CASE("the file of hooks has the fields that pre-commit requires, and no unknown ones") {
  const auto hooks = read_hooks();
  REQUIRE(hooks.size() == 2);
  for (const auto& [id, hook] : hooks) {
    INFO(id);
    for (const char* required : {"id", "name", "description", "entry", "language"}) {
      CHECK(hook.contains(required));
    }
    CHECK((hook.at("language") == "script" || hook.at("language") == "system"));
    for (const auto& [key, value] : hook) {
      INFO(key);
      CHECK(std::regex_match(
          key, std::regex("id|name|description|entry|language|files|pass_filenames|always_run")));
      const bool is_flag = key == "pass_filenames" || key == "always_run";
      CHECK((!is_flag || value == "true" || value == "false"));
    }
  }
  const std::filesystem::path script = kClone + "/" + hooks.at("glassbox-fuzzy").at("entry");
  REQUIRE(std::filesystem::exists(script));
  CHECK((std::filesystem::status(script).permissions() & std::filesystem::perms::owner_exec) !=
        std::filesystem::perms::none);
}

TEST_CASE("pre-commit accepts the file of hooks") {
  const Project project;
  if (project.run("/bin/sh", {"-c", "command -v pre-commit"}).exit_code != 0)
    SKIP_TEST("pre-commit is not installed");
  const Outcome outcome = project.run("pre-commit", {"validate-manifest", kHooksFile});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("a file of tolerances passes its hook if it can be read and belongs to a picture") {
  const Project project;
  project.draw("cube", "a folder/cube.png");
  project.draw("cube", "teapot.png");
  const std::string fine = "max-differing: 4\nreason: a test\n";
  // Writes the file, runs the hook on it, and returns what the hook says; empty if it passes.
  const auto says = [&](const std::string& name, const std::string& text) {
    project.write(name, text);
    const Outcome outcome = run_hook(project, "glassbox-fuzzy", {}, {name, "teapot.png"});
    std::filesystem::remove(project.path(name));
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == (outcome.err.empty() ? 0 : 1));
    return outcome.err;
  };
  CHECK(says("a folder/cube.png.fuzzy", fine).empty());
  CHECK(says("a folder/cube.fuzzy", fine).empty());
  CHECK(contains(says("a folder/cube.png.fuzzy", "max-differing: 4\n"), "has no reason"));
  CHECK(contains(says("teapot.fuzzy", "max-differing: few\nreason: x\n"), "line 1"));
  CHECK(contains(says("teapot.fuzzy", fine + "mask: none.png\n"), "none.png"));
  CHECK(contains(says("tea.png.fuzzy", fine), "belongs to no picture"));
  // What lies beside a picture, and is none, has no tolerances; neither has teapot.heat.png here,
  // whose file would be teapot.heat.fuzzy.
  project.write("a folder/cube.obj", "v 0 0 0\n");
  project.write("a folder/cube", "no picture");
  CHECK(says("a folder/cube.fuzzy", fine).empty());
  CHECK(contains(says("a folder/cube.fuzzy", "garbage\n"), "cube.fuzzy"));
  CHECK(contains(says("a folder/cube.obj.fuzzy", fine), "belongs to no picture"));
  // A file that may not be written, before a picture. (This is no case for root.)
  std::filesystem::permissions(project.path("a folder/cube.obj"),
                               std::filesystem::perms::owner_read);
  CHECK(says("a folder/cube.fuzzy", fine).empty());
  project.draw("cube", "tea.heat.png");
  CHECK(contains(says("tea.fuzzy", "garbage\n"), "belongs to no picture"));
  CHECK(says("tea.heat.fuzzy", fine).empty());
  CHECK(contains(says("tea.heat.fuzzy", "garbage\n"), "tea.heat.fuzzy"));
  CHECK(contains(says("-o.fuzzy", fine), "belongs to no picture"));

  project.write("one.fuzzy", fine);
  project.write("teapot.fuzzy", fine);
  const Outcome both =
      run_hook(project, "glassbox-fuzzy", {}, {"one.fuzzy", "teapot.fuzzy", "teapot.png"});
  CHECK(both.exit_code == 1);
  CHECK(contains(both.err, "one.fuzzy"));
  CHECK_FALSE(contains(both.err, "teapot"));
  CHECK(run_hook(project, "glassbox-fuzzy", {}, {}).exit_code == 0);

  const EnvironmentVariable named("GLASSBOX_PROGRAM", "/nowhere");
  const Outcome none = run_hook(project, "glassbox-fuzzy", {}, {"teapot.fuzzy"});
  CHECK(none.exit_code == 2);
  CHECK(contains(none.err, "/nowhere"));
}

TEST_CASE("two folders pass their hook if their pictures are the same") {
  const Project project;
  project.draw("cube", "golden/cube.png");
  project.draw("cube", "out/cube.png");
  CHECK(run_hook(project, "glassbox-diff", {"golden", "out"}, {"out/cube.png"}).exit_code == 0);
  project.draw("teapot", "out/cube.png");
  const Outcome outcome = run_hook(project, "glassbox-diff", {"golden", "out"}, {"out/cube.png"});
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.out, "cube.png: different"));
  CHECK(run_hook(project, "glassbox-diff", {}, {}).exit_code == 2);  // without its args
}

}  // namespace glassbox::test
