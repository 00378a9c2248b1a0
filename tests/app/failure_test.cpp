// Files that are missing, cannot be read or cannot be written give one line and exit code 2, and
// leave nothing half done.
#include "tests/support/catch.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/text.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

TEST_CASE("a scene that cannot be had is refused by name, with a remedy") {
  const WorkingDirectory here;
  std::filesystem::create_directory(here.file("folder"));
  here.write("notes.txt", "hello");
  here.write("empty.obj", "");
  here.write("empty.glb", "");
  here.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
  here.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  const auto before = here.names();
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"missing.glb", {"missing.glb", "no such file"}},
      {"folder", {"folder"}},
      {"./folder", {"directory"}},
      {"notes.txt", {"notes.txt", ".obj"}},
      {"tepot", {"did you mean 'teapot'"}},
      {"dept-ladder", {"depth-ladder"}},
      {"teapot:0", {"teapot:0", "1 to 256"}},
      {"cube:2", {"has no levels"}},
      {"empty.obj", {"empty.obj"}},
      {"empty.glb", {"empty.glb"}},
      {"nan.obj", {"nan.obj", "2"}},
      {"range.obj", {"range.obj", "4"}}};
  for (const auto& [scene, parts] : cases) {
    check_refused(here.run("render " + scene + " --size 8x8"), parts);
    check_refused(here.run("info " + scene), parts);
  }
  CHECK(here.names() == before);
}

TEST_CASE("what is printed and does not arrive is an error, and no file takes its place") {
  const WorkingDirectory here;
  if (!std::filesystem::exists("/dev/full")) SKIP_TEST("there is no /dev/full");
  for (const char* words :
       {"info cube", "info cube --json -", "--help", "explain cube --size 8x8"}) {
    INFO(words);
    const std::string command = std::string("\"$0\" ") + words;
    check_refused(in_shell(here, command + " > /dev/full"), {"standard output", "No space left"});
    check_refused(in_shell(here, command + " >&-"), {"standard output", "Bad file descriptor"});
  }
  CHECK(in_shell(here, "\"$0\" render cube --size 8x8 -o a.png >&- 2>&-").exit_code != 1);
  CHECK(here.read("a.png").starts_with("\x89PNG"));
}

TEST_CASE("a file that grows beyond its limit is an error, and nothing of it is left") {
  const WorkingDirectory here;
  const Outcome limited =
      in_shell(here, "ulimit -f 4; exec \"$0\" render teapot --size 200x200 -o a.ppm");
  check_refused(limited, {"a.ppm", "File too large", "free some space"});
  CHECK(here.names().empty());
}

// The stack of a thread takes 8 MiB of address space. How many threads oneTBB starts before the
// picture is drawn is not under our control.
TEST_CASE("with threads that cannot be started the picture is whole, or it is told what to do") {
  const WorkingDirectory here;
  const std::string picture = here.run("render room --size 320x200 -o -").out;
  for (const char* limit : {"120000", "300000", "500000"}) {
    const std::string within = std::string("ulimit -v ") + limit + "; exec \"$0\" ";
    if (in_shell(here, within + "info cube").exit_code != 0)
      SKIP_TEST("sanitizers reserve more addresses than that");
    const Outcome outcome = in_shell(here, within + "render room --size 320x200 -o - --threads 64");
    INFO(limit << " KiB: " << outcome.exit_code << " " << outcome.err);
    if (outcome.exit_code == 0) {
      CHECK(outcome.out == picture);
    } else {
      CHECK(outcome.exit_code == 1);
      CHECK(outcome.out.empty());
      CHECK((contains(outcome.err, "give fewer --threads") ||
             contains(outcome.err, "out of memory")));
    }
  }
}

// few_threads.cpp allows a program to start FEW_THREADS threads and no more.
TEST_CASE("where some threads cannot be started an output is whole, or there is none") {
  const WorkingDirectory here;
  const std::string few =
      std::string("export LD_PRELOAD='") + GLASSBOX_FEW_THREADS + "' FEW_THREADS=";
  const std::string program = "; exec timeout 60 \"$0\" ";
  if (in_shell(here, few + "100" + program + "render cube --size 8x8 -o -").exit_code != 0)
    SKIP_TEST("sanitizers want to be loaded first");
  int whole = 0;
  const std::vector<std::pair<std::string, std::string>> commands{
      {"render room --size 320x200", "a.png"},
      {"render room --size 320x200 --stereo anaglyph --samples 4", "a.png"},
      {"views match --scene room --size 200x120 --eye-separation 0.2", "a.pfm"}};
  for (const auto& [words, output] : commands) {
    const std::string command = words + " --threads 8 -o " + output;
    REQUIRE(here.run(command).exit_code == 0);
    const std::string right = here.read(output);
    for (int threads = 0; threads < 8; ++threads) {
      std::filesystem::remove(here.file(output));
      const Outcome outcome = in_shell(here, few + std::to_string(threads) + program + command);
      INFO(command << ", " << threads << " threads: " << outcome.exit_code << " " << outcome.err);
      if (outcome.exit_code == 0) {
        CHECK(here.read(output) == right);
        if (threads < 7) ++whole;
      } else {
        CHECK(outcome.exit_code == 1);
        CHECK(here.names().empty());
        CHECK(contains(outcome.err, "give fewer --threads"));
      }
    }
    std::filesystem::remove(here.file(output));
  }
  // If a worker cannot start another one, the other workers draw the picture.
  CHECK(whole > 0);
}

TEST_CASE("a GLB cut short anywhere is refused") {
  const WorkingDirectory here;
  REQUIRE(here.run("info f-glyph --write f.glb").exit_code == 0);
  const std::string whole = here.read("f.glb");
  for (const std::size_t size : {std::size_t(4), std::size_t(11), std::size_t(12), std::size_t(19),
                                 std::size_t(200), whole.size() / 2, whole.size() - 1}) {
    here.write("cut.glb", whole.substr(0, size));
    INFO(size << " of " << whole.size() << " bytes");
    check_refused(here.run("render cut.glb --size 8x8"), {"cut.glb"});
  }
  CHECK(!std::filesystem::exists(here.file("cut.png")));
}

TEST_CASE("an output that cannot be written is refused before anything is") {
  const WorkingDirectory here;
  std::filesystem::create_directory(here.file("folder.png"));
  const auto before = here.names();
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"-o x.bmp", {"x.bmp", ".png or .ppm"}},
      {"-o x", {"x", ".png or .ppm"}},
      {"-o nowhere/x.png", {"nowhere/x.png", "directory"}},
      {"-o folder.png", {"folder.png", "directory"}},
      {"--depth-out nowhere/x.pfm", {"nowhere/x.pfm"}},
      {"--id-out nowhere/x.pfm", {"nowhere/x.pfm"}},
      {"--json nowhere/x.json", {"nowhere/x.json"}},
      {"--depth-out x.png", {"x.png", ".pfm"}},
      {"--id-out -", {".pfm"}},
      {"--depth-out x.pfm --id-out ./x.pfm", {"two outputs"}}};
  for (const auto& [options, parts] : cases) {
    check_refused(here.run("render cube --size 8x8 " + options), parts);
    CHECK(here.names() == before);
  }
  check_refused(here.run("info cube --write cube.obj"), {"cube.obj", ".glb"});
  check_refused(here.run("info cube --write nowhere/cube.glb"), {"nowhere/cube.glb"});
  check_refused(here.run("info cube --json nowhere/cube.json"), {"nowhere/cube.json"});
  CHECK(here.names() == before);
}

TEST_CASE("a picture that was there before survives a run that fails") {
  const WorkingDirectory here;
  here.write("cube.png", "mine");
  check_refused(here.run("render cube --near 3 --far 2"), {"far plane"});
  CHECK(here.read("cube.png") == "mine");
}

}  // namespace
}  // namespace glassbox::test
