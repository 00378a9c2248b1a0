// Tests the prompt of glassbox step on a terminal: line editing, history and completion. The
// program runs on a pseudo-terminal.
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/app/text.h"
#include "tests/support/terminal.h"

namespace glassbox::test {
namespace {

constexpr const char* kUpKey = "\x1b[A";
constexpr const char* kLeft = "\x1b[D";

class PseudoTerminal {
public:
  PseudoTerminal(std::vector<std::string> words, const char* kind) {
    words.insert(words.begin(), GLASSBOX_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const winsize size{40, 120, 0, 0};
    child_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (child_ == 0) {
      ::setenv("TERM", kind, 1);
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    REQUIRE(child_ > 0);
  }
  ~PseudoTerminal() {
    ::close(terminal_);
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void type(const std::string& keys) const {
    REQUIRE(::write(terminal_, keys.data(), keys.size()) == ssize_t(keys.size()));
  }

  // Returns the output up to and including `end`; fails if it does not appear.
  std::string read_until(const std::string& end) {
    constexpr int kLongest = 60'000;  // ms without output
    for (;;) {
      if (const std::size_t at = seen_.find(end); at != std::string::npos) {
        const std::string text = seen_.substr(0, at + end.size());
        seen_.erase(0, text.size());
        return text;
      }
      pollfd waiting{terminal_, POLLIN, 0};
      char block[4096];
      const bool comes = ::poll(&waiting, 1, kLongest) == 1;
      const ssize_t count = comes ? ::read(terminal_, block, sizeof block) : -1;
      CAPTURE(end, seen_);
      REQUIRE(count > 0);
      seen_.append(block, std::size_t(count));
    }
  }

  // Waits until the program, which was told to end, has ended, and returns its exit code. Its last
  // output is read, because the program may wait for a reader. The end is detected from the
  // process, not from the terminal.
  int exit_code() {
    constexpr int kLongest = 60'000, kStep = 20;  // ms
    std::string last = seen_;
    for (int waited = 0; waited < kLongest; waited += kStep) {
      int status = 0;
      const pid_t ended = ::waitpid(child_, &status, WNOHANG);
      REQUIRE(ended >= 0);
      if (ended == child_) {
        child_ = 0;
        CAPTURE(last, status);
        REQUIRE(WIFEXITED(status));
        return WEXITSTATUS(status);
      }
      pollfd waiting{terminal_, POLLIN, 0};
      char block[4096];
      const bool comes = ::poll(&waiting, 1, kStep) == 1;
      const ssize_t count = comes ? ::read(terminal_, block, sizeof block) : 0;
      if (count > 0) last.append(block, std::size_t(count));
      if (count < 0) ::usleep(kStep * 1000);  // the terminal is closed, so poll no longer waits
    }
    FAIL("the program goes on after: " << last);
    return -1;
  }

private:
  int terminal_ = -1;
  pid_t child_ = -1;
  std::string seen_;
};

const std::vector<std::string> kStep{"step", "cube", "--triangle", "10", "--size", "64x48"};

TEST_CASE("arrow up recalls the last command, and it can be edited") {
  NEED_PSEUDO_TERMINAL();
  PseudoTerminal terminal(kStep, "xterm");
  terminal.read_until("object 1/10> ");
  terminal.type("vertex 1\n");
  terminal.read_until("vertex 1  x");
  terminal.read_until("object 1/10> ");
  terminal.type("world\n");
  terminal.read_until("world 2/10> ");
  terminal.type("vertex all\n");
  terminal.read_until("vertex 2  x");
  terminal.read_until("world 2/10> ");
  terminal.type(std::string(kUpKey) + kUpKey + kUpKey + "\n");  // vertex 1 again
  terminal.read_until("\n     vertex 1  x");  // the stage's text, not the line that is edited
  terminal.read_until("world 2/10> ");
  // In "triangle 1" a 1 is inserted before the last character, which gives 11.
  terminal.type("triangle 1");
  terminal.type(std::string(kLeft) + "1\n");
  terminal.read_until("  triangle 11");
  terminal.read_until("world 2/10> ");
  terminal.type("q\n");
  CHECK(terminal.exit_code() == 0);
}

TEST_CASE("the tabulator completes commands, stages, options and their words") {
  NEED_PSEUDO_TERMINAL();
  PseudoTerminal terminal(kStep, "xterm");
  terminal.read_until("object 1/10> ");
  terminal.type("frag\t\n");
  terminal.read_until("pixel centres are covered");
  terminal.read_until("fragments 9/10> ");
  terminal.type("--view-f\tax\t\n");
  terminal.read_until("\n+ ");  // the factors of look-at's matrix
  terminal.read_until("fragments 9/10> ");
  terminal.type("cl\t\t");  // matches clip and clipping
  terminal.read_until("clip clipping");
  terminal.type("\n");
  terminal.read_until("eye -> clip");
  terminal.read_until("clip 4/10> ");
  terminal.type("\x04");  // the end of the input
  CHECK(terminal.exit_code() == 0);
}

// Between two prompts the terminal edits lines itself, and turns a Control-D that is read later
// into a NUL.
TEST_CASE("the end of the input ends the prompt also where it was typed ahead of it") {
  NEED_PSEUDO_TERMINAL();
  PseudoTerminal terminal(kStep, "xterm");
  terminal.read_until("object 1/10> ");
  terminal.type(std::string(1, '\0'));
  CHECK(terminal.exit_code() == 0);
}

TEST_CASE("a terminal that can do nothing has the plain prompt") {
  NEED_PSEUDO_TERMINAL();
  PseudoTerminal terminal(kStep, "dumb");
  terminal.read_until("object 1/10> ");
  terminal.type("\n");
  terminal.read_until("world 2/10> ");
  terminal.type("q\n");
  CHECK(terminal.exit_code() == 0);
}

// Runs the same commands from a file and returns the output.
std::string prompt_output(const WorkingDirectory& here, const std::string& commands) {
  here.write("commands", commands);
  here.write("go.sh", "cd \"$(dirname \"$0\")\" && exec " GLASSBOX_PROGRAM
                      " step cube --triangle 10 --size 64x48 --interactive < commands\n");
  const Outcome outcome = run_program("/bin/sh", {here.file("go.sh")}, here.path());
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

TEST_CASE("another triangle, vertex or picked pixel within the prompt, and back to the first") {
  const WorkingDirectory here;
  const std::string changed = prompt_output(here, "triangle 4\nreset\nq\n");
  CHECK(contains(changed, "  triangle 4\n"));
  CHECK(contains(changed, "face 2 of mesh 'cube'"));
  CHECK(contains(changed.substr(changed.find("  triangle 4\n")), "  triangle 10\n"));
  CHECK(contains(prompt_output(here, "--triangle 4\nq\n"), "  triangle 4\n"));
  const std::string one = prompt_output(here, "vertex 2\nq\n"),
                    again = prompt_output(here, "vertex 2\nvertex all\nq\n");
  CHECK(!contains(one.substr(one.find("1/10>")), "vertex 0"));
  CHECK(contains(again.substr(again.find("1/10>")), "vertex 0"));
  const std::string picked = prompt_output(here, "pick 32,20\nfragments\nq\n");
  CHECK(contains(picked, "the fragment of pixel (32, 20)"));
  // The picture changes, and the picked triangle stays.
  CHECK(contains(prompt_output(here, "triangle 4\n--fov 30\nclip\nq\n"), "+ "));
}

TEST_CASE("what the prompt cannot do it says, and stays") {
  const WorkingDirectory here;
  for (const auto& [command, part] : {std::pair{"triangle 12", "the scene has 12 triangles"},
                                      {"triangle", "needs one more word: a number"},
                                      {"triangle x", "triangle"},
                                      {"vertex 3", "vertex"},
                                      {"pick 0,0", "no triangle is visible in this pixel"},
                                      {"pick 64,0", "64 x 48 pixels"},
                                      {"pick", "X,Y"},
                                      {"wold", "no stage or command of this name"}}) {
    CAPTURE(command);
    const std::string said = prompt_output(here, std::string(command) + "\nworld\nq\n");
    const std::string after = said.substr(said.find("1/10>"));
    CHECK(contains(after, part));
    CHECK(contains(after, "world 2/10>"));
  }
  CHECK(contains(prompt_output(here, "help\nq\n").substr(800), "triangle N"));
}

}  // namespace
}  // namespace glassbox::test
