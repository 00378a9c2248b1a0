// Runs the command lines of docs/ as they are written: each must print the output that the page
// shows below it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/app/sessions.h"
#include "tests/docs/shell.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"

namespace glassbox::test {
namespace {

// Lines of a page that begin with `begin`; "" means all.
struct Lines {
  const char* page;
  const char* begin;
  const char* why;
  bool are(const std::string& of, const std::string& line) const {
    return of == page && line.starts_with(begin);
  }
};

const std::vector<Lines> kRunElsewhere{
    {"docs/tour.md", "", "tests/docs/readme_test.cpp, in the order of the page"},
    {"docs/step.md", "", "tests/app/step_test.cpp replays the page"},
    {"docs/why.md", "", "tests/app/why_test.cpp replays the page"},
    {"docs/benchmark.md", "", "minutes of measuring; tests/study/bench has every option, smaller"},
    {"docs/command_line.md", "glassbox render teapot --size 320x180 --frames",
     "tests/app/turntable_test.cpp"},
    {"docs/command_line.md", "glassbox render forest --size 160x90",
     "tests/app runs the page's path"},
    {"docs/trace.md", "glassbox trace", "tests/app/trace_test.cpp, with what NumPy makes of it"},
    {"docs/grading.md", "", "compiles submissions; tests/labs/grading"},
    {"docs/labs.md", "glassbox lab check", "compiles a lab; tests/labs/framework"},
    {"docs/labs.md", "glassbox lab start ~/lab40", "tests/labs/framework/outside_test.cpp"},
    {"docs/labs.md", "glassbox lab grade", "tests/labs/framework/outside_test.cpp"},
    {"docs/labs.md", "glassbox lab watch", "does not end; tests/labs/framework"},
    {"docs/labs.md", "glassbox lab render",
     "compiles a lab; tests/labs/drawing, and the handouts' own"},
    {"docs/labs.md", "glassbox lab stiff", "compiles a lab; tests/labs/drawing"},
    {"docs/labs.md", "glassbox lab measure", "compiles a lab; tests/labs/drawing"},
    {"docs/metrics.md", "glassbox diff REFERENCE TEST", "with two files, below"},
    {"docs/slides.md", "", "below, a deck every day"},
    {"docs/study.md", "glassbox study run --resume", "20 minutes"},
    {"docs/study.md", "glassbox study report --from", "of the line above it"},
};

// Lines that only the hidden test runs, because they take more than a second or two.
const std::vector<Lines> kLong{
    {"docs/extremes.md", "", "all cases"},
    {"docs/stereo.md", "glassbox stereo ", "three reports"},
    {"docs/stereo.md", "glassbox render forest --size 320x180", "40 pairs"},
    {"docs/study.md", "glassbox study run D-4", "measures"},
    {"docs/study.md", "glassbox study scene", "measures"},
    {"docs/study.md", "glassbox study recommend", "measures"},
};

// Lines that end with an exit code other than 0.
struct Ends {
  Lines lines;
  int exit_code;
};
const std::vector<Ends> kEnds{
    {{"docs/command_line.md", "glassbox render teapot --sise", "a slip"}, 2},
    {{"docs/labs.md", "glassbox lab quiz 2 TTT", "not all of them are true"}, 1},
    {{"docs/command_line.md", "glassbox rendr", "a slip"}, 2},
    {{"docs/command_line.md", "glassbox render teapot --size 8x8 -o .", "a folder"}, 2},
    {{"docs/diff.md", "glassbox diff images/golden/shade-gouraud", "the pictures differ"}, 1},
    {{"docs/conventions.md", "glassbox render teapot --", "refused, as the page says"}, 2},
};

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_listed(const std::vector<Lines>& list, const std::string& page, const std::string& line) {
  return std::ranges::any_of(list, [&](const Lines& lines) { return lines.are(page, line); });
}

int exit_code_of(const std::string& page, const std::string& line) {
  for (const Ends& ends : kEnds) {
    if (ends.lines.are(page, line)) return ends.exit_code;
  }
  return 0;
}

std::vector<std::string> pages() {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(tree() / "docs")) {
    if (entry.path().extension() == ".md")
      all.push_back("docs/" + entry.path().filename().string());
  }
  std::ranges::sort(all);
  return all;
}

// Removes blanks at the ends of lines, and the lines about times and the machine.
std::string comparable(const std::string& text) {
  std::istringstream in(text);
  std::string kept;
  for (std::string line; std::getline(in, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    if (line.find(" ms") != line.npos || line.starts_with("the tile engine, ")) continue;
    kept += line + "\n";
  }
  while (kept.ends_with("\n\n")) kept.pop_back();
  return kept;
}

// Returns the first block of JSON in a page: the camera path that the page's session uses.
std::string first_json(const std::string& page) {
  std::string text;
  bool in_block = false;
  for (const std::string& line : lines_of(page)) {
    if (in_block && line.starts_with("```")) break;
    if (in_block) text += line + "\n";
    in_block = in_block || line == "```json";
  }
  return text;
}

// Adds the files that the pages assume: a reader's own model, and the camera path of
// docs/stereo.md.
void add_files(const Clone& clone) {
  REQUIRE(clone.run("glassbox info teapot:4 --write model.glb").exit_code == 0);
  clone.write("walk.json", first_json("docs/stereo.md"));
}

void check_line(const Clone& clone, const std::string& page, const ShellLine& line) {
  const Outcome outcome = clone.run(line.text);
  CAPTURE(page, line.text, outcome.out, outcome.err);
  CHECK(outcome.exit_code == exit_code_of(page, line.text));
  if (!line.has_output) return;
  CAPTURE(line.output);
  CHECK(matches_session(comparable(outcome.out + outcome.err), comparable(line.output)));
}

// Runs the lines of the long list, or all other lines that are run here. Returns how many.
int run_lines(bool long_ones) {
  const Clone clone;
  add_files(clone);
  int count = 0;
  for (const std::string& page : pages()) {
    for (const ShellLine& line : shell_lines(page)) {
      if (is_listed(kRunElsewhere, page, line.text)) continue;
      if (is_listed(kLong, page, line.text) != long_ones) continue;
      check_line(clone, page, line);
      ++count;
    }
  }
  return count;
}

const std::vector<std::string> kDecks{"## S0", "## S1", "## S2", "## S3", "## S4"};

// Runs the lines of a deck in docs/slides.md, which make the page's pictures again.
void run_deck(const std::string& deck) {
  namespace fs = std::filesystem;
  const Clone clone;
  const fs::path pictures = fs::path(clone.root()) / "docs/slides";
  fs::create_directories(pictures);
  int count = 0;
  for (const ShellLine& line : shell_lines("docs/slides.md")) {
    if (!line.section.starts_with(deck)) continue;
    check_line(clone, "docs/slides.md", line);
    ++count;
  }
  CAPTURE(deck);
  CHECK(count >= 10);
  for (const auto& made : fs::directory_iterator(pictures)) {
    CAPTURE(made.path().filename());
    CHECK(bytes_of(made.path()) == bytes_of(tree() / "docs/slides" / made.path().filename()));
  }
}

}  // namespace

TEST_CASE(
    "docs/slides.md: the lines of a deck, another one every day, print and draw what it has") {
  const test::DailyShare share(kDecks.size());
  INFO(share.text());
  for (std::size_t i = 0; i < kDecks.size(); ++i) {
    if (share.includes(i, kDecks.size())) run_deck(kDecks[i]);
  }
}

TEST_CASE("docs/slides.md: the lines of all decks print and draw what it has", "[.long]") {
  for (const std::string& deck : kDecks) run_deck(deck);
}

TEST_CASE("the command lines of docs/ run, and print what stands below them") {
  CHECK(run_lines(false) >= 15);
}

TEST_CASE("the command lines of docs/ that take longer run, too", "[.long]") {
  CHECK(run_lines(true) >= 8);
}

TEST_CASE("docs/metrics.md: its lines run with two pictures for REFERENCE and TEST") {
  const Clone clone;
  int count = 0;
  for (const ShellLine& line : shell_lines("docs/metrics.md")) {
    const std::string names = "REFERENCE TEST";
    const std::size_t at = line.text.find(names);
    if (at == std::string::npos) continue;
    std::string words = line.text;
    words.replace(at, names.size(),
                  "images/golden/shade-gouraud.png images/golden/shade-phong.png");
    const Outcome outcome = clone.run(words);
    CAPTURE(words, outcome.out, outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.find("psnr") != std::string::npos);
    ++count;
  }
  CHECK(count == 2);
}

TEST_CASE("no line is listed that the pages do not have any more") {
  for (const auto* list : {&kRunElsewhere, &kLong}) {
    for (const Lines& lines : *list) {
      CAPTURE(lines.page, lines.begin);
      const auto of_page = shell_lines(lines.page);
      CHECK(std::ranges::any_of(
          of_page, [&](const ShellLine& line) { return lines.are(lines.page, line.text); }));
    }
  }
  for (const Ends& ends : kEnds) {
    const auto of_page = shell_lines(ends.lines.page);
    CHECK(std::ranges::any_of(of_page, [&](const ShellLine& line) {
      return ends.lines.are(ends.lines.page, line.text);
    }));
  }
}

TEST_CASE("what stands below a command is compared, but for times") {
  CHECK(comparable("a.png: 4 ms\nsame \n\n") == comparable("a.png: 5 ms\nsame\n"));
  CHECK(comparable("same\n") != comparable("different\n"));
  const Clone clone;
  const Outcome outcome = clone.run("glassbox diff images/golden/cube.png images/golden/cube.png");
  CHECK(matches_session(comparable(outcome.out), "images/golden/cube.png: same\n"));
  CHECK_FALSE(matches_session(comparable(outcome.out), "images/golden/cube.png: different\n"));
}

TEST_CASE("every command of docs/gallery.md makes the golden image beside it, but for its size") {
  const std::vector<std::string> commands = lines_of("images/golden/commands.txt");
  const std::string program = "| `glassbox ", folder = "](../images/golden/";
  int count = 0;
  for (const std::string& line : lines_of("docs/gallery.md")) {
    const std::size_t image = line.find(folder);
    if (!line.starts_with(program) || image == std::string::npos) continue;
    const std::string words = line.substr(program.size(), line.find("` |") - program.size());
    const std::size_t name = image + folder.size();
    const std::string made =
        line.substr(name, line.find(')', name) - name) + "\t" + words + " --size ";
    CAPTURE(made);
    CHECK(std::ranges::count_if(commands, [&](const std::string& command) {
            return command.starts_with(made) && command.find(' ', made.size()) == command.npos;
          }) == 1);
    ++count;
  }
  CHECK(count >= 30);
}

}  // namespace glassbox::test
