// Tests mistyped words, and the ways to ask for help.
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/sessions.h"
#include "tests/app/text.h"

#include <glassbox/base/closest_word.h>

namespace glassbox::test {
namespace {

TEST_CASE("a mistyped word is answered with the one that was probably meant") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"render teapot --sise 100x100", {"no option '--sise'", "did you mean --size?"}},
      {"render --sise 100x100 teapot", {"'--sise'", "did you mean --size?"}},
      {"render --sise=100x100", {"no option '--sise'", "did you mean --size?"}},
      {"render -size 100x100", {"did you mean --size?"}},
      {"render teapot --Shade flat", {"did you mean --shade?"}},
      {"render teapot --turn --frames 3", {"did you mean --turntable?"}},
      {"rendr teapot", {"no subcommand 'rendr'", "did you mean render?"}},
      {"rendr --size 10x10 teapot", {"did you mean render?"}},
      {"study rnu D-4", {"no subcommand 'rnu'", "did you mean run?", "glassbox study --help"}},
      {"lab strat 5 folder", {"did you mean start?"}},
      {"lab start 5 folder --zipp", {"glassbox lab start --help"}},
      {"teapot", {"did you mean glassbox render teapot?"}},
      {"--size 10x10", {"no option '--size' here", "did you mean glassbox render --size?"}},
      {"help rendr", {"did you mean render?"}},
      {"help study rnu", {"did you mean run?"}}};
  for (const auto& [words, parts] : cases) {
    INFO(words);
    check_refused(WorkingDirectory().run(words), parts);
  }
}

TEST_CASE("what is like nothing there is gets no suggestion") {
  for (const char* words : {"render teapot --bogus", "render teapot --x", "render teapot extra",
                            "quux", "help quux", "study quux"}) {
    const Outcome outcome = WorkingDirectory().run(words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(!contains(outcome.err, "did you mean"));
  }
}

TEST_CASE("what is missing or there twice is said in plain words") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"render cube --size", "--size: its value, WxH, is missing; glassbox render --help"},
      {"render cube -o", "--output: its value, FILE|-, is missing; "},
      {"render cube --size 8x8 --size 9x9", "--size: is given more than once; "},
      {"inspect cube --max-triangles -1", "--max-triangles"},
      {"lab", "a subcommand is missing; the subcommands are list, start, "},
      {"study", "scene, recommend and stiffness; glassbox study --help"}};
  for (const auto& [words, part] : cases) {
    INFO(words);
    check_refused(WorkingDirectory().run(words), {part});
  }
}

TEST_CASE("an empty word is no name of a file") {
  const WorkingDirectory here;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"render", "cube", "--size", "8x8", "--output", ""},
        {"diff", "a.png", "b.png", "--html", ""},
        {"study", "report", "a.json", "--svg", ""}}) {
    const Outcome outcome = run_program(GLASSBOX_PROGRAM, words, here.path());
    check_refused(outcome, {words[words.size() - 2] + ": the name is empty"});
    CHECK(here.names().empty());
  }
}

TEST_CASE("words are repeated in the order in which they were typed") {
  const Outcome outcome = WorkingDirectory().run("render cube one two three");
  check_refused(outcome, {"'one'"});
  CHECK(!contains(outcome.err, "three two"));
}

TEST_CASE("the nearest word is at most two letters and a third of itself away") {
  const std::vector<std::string> words{"size", "show", "shade", "stereo", "stereo-cull"};
  CHECK(closest_word("sise", words) == "size");
  CHECK(closest_word("SIZE", words) == "size");
  CHECK(closest_word("shde", words) == "shade");
  CHECK(closest_word("setreo", words) == "stereo");
  CHECK(closest_word("rnu", {"run", "list"}) == "run");
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("abcd", "badc") == 2);
  CHECK(closest_word("stereo-c", words) == "stereo-cull");  // the only one that begins so
  CHECK(!closest_word("ste", words));                       // two begin so
  CHECK(!closest_word("s", words));
  CHECK(!closest_word("width", words));
  CHECK(!closest_word("", words));
  CHECK(!closest_word(std::string(100000, 's'), words));
}

TEST_CASE("help NAME shows what NAME --help shows, for every subcommand") {
  const WorkingDirectory here;
  for (const char* name : {"render", "info", "step", "diff", "study", "study run", "lab",
                           "lab start", "help", "completion", "man"}) {
    INFO(name);
    const Outcome asked = here.run(std::string("help ") + name);
    const Outcome option = here.run(std::string(name) + " --help");
    CHECK(asked.exit_code == 0);
    CHECK(asked.err.empty());
    CHECK(asked.out == option.out);
    CHECK(contains(asked.out, std::string("Usage: glassbox ") + name));
  }
  CHECK(here.run("help").out == here.run("--help").out);
}

TEST_CASE("the version has a short option, -V") {
  const WorkingDirectory here;
  const Outcome brief = here.run("-V");
  CHECK(brief.exit_code == 0);
  CHECK(brief.out == here.run("--version").out);
  CHECK(contains(brief.out, "glassbox "));
}

TEST_CASE("docs/command_line.md shows what the program says of commands that are not right") {
  std::ifstream page(std::string(GLASSBOX_SOURCE_DIR) + "/docs/command_line.md");
  auto sessions = sessions_of(page);
  // tests/docs/pages_test.cpp runs the page's table of a mesh.
  std::erase_if(sessions, [](const Session& session) {
    return session.command.starts_with("glassbox info ");
  });
  REQUIRE(sessions.size() == 4);
  for (const Session& session : sessions) {
    INFO(session.command);
    const WorkingDirectory here;
    const Outcome outcome = here.run(session.command.substr(std::string("glassbox ").size()));
    CHECK(outcome.err == session.output);
    if (contains(session.output, "note:")) {  // an ignored option is not an error
      CHECK(outcome.exit_code == 0);
    } else {
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.out.empty());
      CHECK(here.names().empty());
    }
  }
}

TEST_CASE("no byte that a terminal obeys is printed, wherever the word with it stands") {
  const WorkingDirectory here;
  const std::string red = "\033[31m\r\007";
  here.write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  here.write("bad" + red + ".obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const std::string& words :
       {"render x" + red + ".glb",
        "render bad" + red + ".obj",
        "info x" + red,
        red,
        "render cube --" + red,
        "render cube --size " + red,
        "render cube --shade " + red,
        "render cube --camera " + red,
        "render cube -o " + red,
        "render cube -o " + red + "/x.png",
        "render cube --frames 2 --path " + red + ".json",
        "render cube --frames " + red,
        "render good.obj --size 8x8 -o p" + red + ".png",
        "diff " + red + " b.png",
        "inspect cube --size 8x8 -o p" + red + ".html",
        "lab start " + red + " folder",
        "render cube --size 8x8 --frames 2 --turntable -o f" + red + ".png",
        "stereo cube --size 16x16 --html s" + red + ".html",
        "help " + red,
        "study run " + red,
        "completion " + red}) {
    // Blanks separate the words, and a carriage return counts as one.
    std::string one_word = words;
    std::erase(one_word, '\r');
    const Outcome outcome = here.run(one_word);
    INFO(words << ": " << outcome.err);
    for (const std::string& text : {outcome.out, outcome.err}) {
      CHECK(text.find_first_of("\033\r\007") == std::string::npos);
    }
    CHECK(!(outcome.out + outcome.err).empty());
  }
}

TEST_CASE("an output that is a directory is called one") {
  const WorkingDirectory here;
  std::filesystem::create_directory(here.file("out"));
  for (const char* words :
       {"render teapot -o out", "render teapot -o out/", "render teapot -o ./nowhere/",
        "inspect teapot -o out", "stereo teapot --html out", "info teapot --write out",
        "render teapot --depth-out out"}) {
    INFO(words);
    check_refused(here.run(words), {"is a directory"});
  }
  CHECK(contains(here.run("render teapot:4 -o out").err, "name a file in it: out/teapot.png"));
}

}  // namespace
}  // namespace glassbox::test
