// Tests glassbox completion: what shells do with the scripts. Tests glassbox man: what man does
// with the page.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/text.h"
#include "tests/support/skip.h"
#include "tests/support/terminal.h"

namespace glassbox::test {
namespace {

bool is_there(const std::string& program) {
  return in_shell(WorkingDirectory(), "command -v " + program).exit_code == 0;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Writes the completion script of a shell into a working directory.
WorkingDirectory& with_script(WorkingDirectory& here, const std::string& shell) {
  const Outcome outcome = here.run("completion " + shell);
  REQUIRE(outcome.exit_code == 0);
  REQUIRE(outcome.err.empty());
  here.write("script", outcome.out);
  return here;
}

// ---- bash ----

// Returns what bash offers when the cursor is at the end of the last word. The words are those that
// bash passes to its completion function.
std::set<std::string> offered(const WorkingDirectory& here, const std::vector<std::string>& words) {
  std::string line = "source ./script; COMP_WORDS=(";
  for (const std::string& word : words) line += "'" + word + "' ";
  line += "); COMP_CWORD=" + std::to_string(words.size() - 1) +
          "; _glassbox; ((${#COMPREPLY[@]})) && printf '%s\\n' \"${COMPREPLY[@]}\"";
  const Outcome outcome = run_program("/bin/bash", {"-uc", line}, here.path());
  INFO(line << "\n" << outcome.err);
  CHECK(outcome.err.empty());
  const auto lines = lines_of(outcome.out);
  return {lines.begin(), lines.end()};
}

using Words = std::set<std::string>;

TEST_CASE("bash completes subcommands, options, choices, scenes and files") {
  WorkingDirectory here;
  with_script(here, "bash");
  here.write("robot.obj", "");
  const auto at = [&](const std::vector<std::string>& words) { return offered(here, words); };
  CHECK(at({"glassbox", "ren"}) == Words{"render"});
  CHECK(at({"glassbox", "--ver"}) == Words{"--version"});
  CHECK(at({"glassbox", "study", "re"}) == Words{"recommend", "report"});
  CHECK(at({"glassbox", "render", "--sha"}) == Words{"--shade"});
  CHECK(at({"glassbox", "render", "cube", "--shade", ""}) ==
        Words{"flat", "gouraud", "phong", "unlit"});
  CHECK(at({"glassbox", "render", "cube", "--shade", "=", "f"}) == Words{"flat"});
  CHECK(at({"glassbox", "render", "cube", "--shade", "="}).size() == 4);
  CHECK(at({"glassbox", "render", "tea"}) == Words{"teapot"});
  CHECK(at({"glassbox", "render", "ro"}) == Words{"robot.obj", "room"});
  CHECK(at({"glassbox", "render", "cube", "-o", "rob"}) == Words{"robot.obj"});
  CHECK(at({"glassbox", "render", "cube", "--camera", ""}) == Words{"none"});
  CHECK(at({"glassbox", "render", "cube", "--size", ""}).empty());
  CHECK(at({"glassbox", "render", "study", "--sha"}) == Words{"--shade"});
  CHECK(at({"glassbox", "help", "ster"}) == Words{"stereo"});
  CHECK(at({"glassbox", "completion", ""}) == Words{"bash", "fish", "zsh"});
  CHECK(at({"glassbox", "study", "run", "--qu"}) == Words{"--quick"});
  CHECK(at({"glassbox", "quux", "--sha"}).empty());
}

TEST_CASE("every option of every subcommand is in the scripts and in the manual") {
  WorkingDirectory here;
  const std::string bash = here.run("completion bash").out, zsh = here.run("completion zsh").out;
  const std::string fish = here.run("completion fish").out, man = here.run("man").out;
  for (const char* command : {"render", "info", "diff", "study run", "lab check", "bench"}) {
    const std::string help = here.run(std::string(command) + " --help").out;
    int count = 0;
    for (const std::string& line : lines_of(help)) {
      const std::size_t at = line.find("--");
      if (!line.starts_with("  -") || at == std::string::npos) continue;
      const std::string name = line.substr(at, line.find_first_of(" ,", at) - at);
      std::string in_roff;
      for (const char c : name) in_roff += c == '-' ? "\\-" : std::string(1, c);
      INFO(command << " " << name);
      CHECK(contains(bash, name));
      CHECK(contains(zsh, name + (contains(zsh, name + "[") ? "[" : "}")));
      CHECK(contains(fish, "-l " + name.substr(2) + " "));
      CHECK((name == "--help" || contains(man, "\\fB" + in_roff + "\\fR")));
      ++count;
    }
    CHECK(count > 1);
  }
  CHECK(!contains(bash + zsh + fish + man, "bench-peer"));
}

// Types the keys on a terminal made by script(1). The command that bash completes with TAB is then
// run.
TEST_CASE("the TAB key completes in an interactive bash") {
  NEED_PSEUDO_TERMINAL();
  WorkingDirectory here;
  with_script(here, "bash");
  here.write("rc",
             "source ./script\nglassbox() { printf '<%s>' \"$@\"; }\nPS1=\n"
             "bind 'set bell-style none'\n");
  here.write("keys", "glassbox ren\tcu\t--shad\tfl\t\nexit\n");
  const Outcome outcome = in_shell(
      here,
      "(sleep 1; cat keys; sleep 1) | script -qec 'bash --noprofile --rcfile rc -i' /dev/null");
  INFO(outcome.out << outcome.err);
  CHECK(contains(outcome.out, "<render><cube><--shade><flat>"));
}

// ---- zsh and fish ----

TEST_CASE("zsh reads its script without a complaint") {
  WorkingDirectory here;
  with_script(here, "zsh");
  const std::string script = here.read("script");
  CHECK(script.starts_with("#compdef glassbox\n"));
  CHECK(std::count(script.begin(), script.end(), '{') ==
        std::count(script.begin(), script.end(), '}'));
  if (!is_there("zsh")) {
    SKIP_TEST("zsh is not there: only the script's structure was looked at");
  }
  CHECK(in_shell(here, "zsh -n script").exit_code == 0);
}

TEST_CASE("the TAB key completes in an interactive zsh") {
  NEED_PSEUDO_TERMINAL();
  if (!is_there("zsh")) SKIP_TEST("zsh is not there");
  WorkingDirectory here;
  with_script(here, "zsh");
  here.write("rc",
             "autoload -U compinit; compinit -u -d ./dump\nsource ./script\nPS1=\n"
             "unsetopt beep\nglassbox() { printf '<%s>' \"$@\" }\n");
  here.write(".zshrc", "source ./rc\n");
  here.write("keys", "glassbox ren\tcu\t--shad\tfl\t\nglassbox study ru\t--qu\t\nexit\n");
  const Outcome outcome = in_shell(
      here, "(sleep 3; cat keys; sleep 2) | ZDOTDIR=. TERM=dumb script -qec 'zsh -i' /dev/null");
  INFO(outcome.out << outcome.err);
  CHECK(contains(outcome.out, "<study><run><--quick>"));
  CHECK(contains(outcome.out, "<render><cube><--shade><flat>"));
}

TEST_CASE("fish reads its script without a complaint and completes with it") {
  WorkingDirectory here;
  with_script(here, "fish");
  CHECK(contains(here.read("script"), "complete -c glassbox -f\n"));
  if (!is_there("fish")) {
    SKIP_TEST("fish is not there: only the script's lines were looked at");
  }
  const auto at = [&](const std::string& words) {
    const Outcome outcome = in_shell(
        here, "HOME=$PWD fish --no-config -c 'source ./script; complete -C \"" + words + "\"'");
    INFO(words << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    Words found;
    for (const std::string& line : lines_of(outcome.out))
      found.insert(line.substr(0, line.find('\t')));
    return found;
  };
  CHECK(at("glassbox ren") == Words{"render"});
  CHECK(at("glassbox study re") == Words{"recommend", "report"});
  CHECK(at("glassbox render --sha") == Words{"--shade"});
  CHECK(at("glassbox render cube --shade f") == Words{"flat"});
  CHECK(at("glassbox render tea") == Words{"teapot"});
  CHECK(at("glassbox render cube --size ").empty());
}

TEST_CASE("a shell that is not known is refused") {
  check_refused(WorkingDirectory().run("completion tcsh"), {"'tcsh'", "bash, zsh or fish"});
  check_refused(WorkingDirectory().run("completion"), {"SHELL"});
}

// ---- the manual ----

TEST_CASE("the manual has the sections of man pages and every subcommand") {
  const Outcome outcome = WorkingDirectory().run("man");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* part : {".TH GLASSBOX 1 ", "\n.SH NAME\n", "\n.SH SYNOPSIS\n",
                           "\n.SH DESCRIPTION\n", "\n.SH COMMANDS\n", "\n.SS \"glassbox render\"\n",
                           "\n.SS \"glassbox study run\"\n", "\n.SH EXIT STATUS\n"}) {
    INFO(part);
    CHECK(contains(outcome.out, part));
  }
  for (const std::string& line : lines_of(outcome.out)) {
    INFO(line);
    CHECK(line.find_first_of("\t") == std::string::npos);
    CHECK((!line.starts_with("'") && (!line.starts_with(".") || line.size() > 2)));
  }
}

TEST_CASE("man and groff format the manual without a warning") {
  const WorkingDirectory here;
  here.write("glassbox.1", here.run("man").out);
  if (!is_there("groff") && !is_there("man")) {
    SKIP_TEST("neither man nor groff is there: only the page's lines were looked at");
  }
  const char* line =
      is_there("groff")
          ? "groff -ww -man -Tutf8 -z glassbox.1"
          : "LC_ALL=C.UTF-8 man --warnings -l -E UTF-8 -Tutf8 -Z glassbox.1 >/dev/null";
  const Outcome outcome = in_shell(here, line);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  if (is_there("mandoc")) {
    // The page must be the same when the program is built again, so it has no date.
    const Outcome lint =
        in_shell(here, "mandoc -T lint -W warning glassbox.1 | grep -v 'missing date'");
    CHECK(lint.out.empty());
    CHECK(lint.err.empty());  // mandoc's error message if it cannot check the page at all
  }
}

}  // namespace
}  // namespace glassbox::test
