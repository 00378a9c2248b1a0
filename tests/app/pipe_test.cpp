// Tests pictures on standard output and scenes from standard input.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/skip.h"
#include "tests/support/terminal.h"

#include <glassbox/mesh/formats/load_memory.h>

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_CASE("-o - writes to standard output what a file would hold, and nothing else") {
  const WorkingDirectory here;
  REQUIRE(here.run("render room --size 40x30 -o a.png").exit_code == 0);
  REQUIRE(here.run("render room --size 40x30 -o a.ppm").exit_code == 0);
  const Outcome png = here.run("render room --size 40x30 -o -");
  CHECK(png.exit_code == 0);
  CHECK(png.out == here.read("a.png"));
  CHECK(png.err.empty());
  CHECK(here.run("render room --size 40x30 -o - --format png").out == png.out);
  CHECK(here.run("render room --size 40x30 -o - --format ppm").out == here.read("a.ppm"));
  CHECK(sorted_names(here) == std::vector<std::string>{"a.png", "a.ppm"});
}

TEST_CASE("with -o - what is asked for in words goes to standard error or to files") {
  const WorkingDirectory here;
  const std::string plain = here.run("render cube --size 16x16 -o -").out;
  const Outcome stats = here.run("render cube --size 16x16 -o - --stats");
  CHECK(stats.out == plain);
  CHECK(contains(stats.err, "depth test"));
  const Outcome json = here.run("render cube --size 16x16 -o - --json j.json --depth-out d.pfm");
  CHECK(json.out == plain);
  CHECK(nlohmann::json::parse(here.read("j.json"))["image"] == "-");
  CHECK(parse_pfm(here.read("d.pfm")).width == 16);
  const Outcome stereo = here.run("render forest --size 32x16 -o - --stereo anaglyph");
  CHECK(stereo.out.starts_with("\x89PNG"));
  CHECK(stereo.err.empty());
}

TEST_CASE("standard output takes one thing") {
  const WorkingDirectory here;
  check_refused(here.run("render cube -o - --json -"), {"--json -", "standard output"});
  check_refused(here.run("render cube --frames 3 --turntable -o -"), {"-o -", "several frames"});
  check_refused(here.run("render cube --format ppm"), {"--format", "-o -"});
  check_refused(here.run("render cube -o a.png --format ppm"), {"--format"});
  check_refused(here.run("render cube --frames 3 --turntable --format ppm"), {"--format"});
  check_refused(here.run("render cube -o - --format jpg"), {"png|ppm"});
  CHECK(here.names().empty());
}

TEST_CASE("no picture goes to a terminal") {
  NEED_PSEUDO_TERMINAL();
  const WorkingDirectory here;
  // script(1) of the package bsdutils gives the program a terminal.
  const Outcome terminal =
      in_shell(here, "script -qec \"$0 render cube --size 8x8 -o -\" /dev/null </dev/null");
  CHECK(terminal.exit_code == 2);
  CHECK(contains(terminal.out, "standard output is a terminal"));
  CHECK(!contains(terminal.out, "PNG\r"));
}

TEST_CASE("a picture that cannot be written to the end is an error") {
  const WorkingDirectory here;
  if (!fs::exists("/dev/full")) SKIP_TEST("there is no /dev/full");
  const Outcome full = in_shell(here, "\"$0\" render cube --size 64x64 -o - > /dev/full");
  check_refused(full, {"standard output", "No space left"});
}

TEST_CASE("a scene is read from standard input, whatever its format") {
  const WorkingDirectory here;
  REQUIRE(here.run("info f-glyph --write f.glb").exit_code == 0);
  here.write("t.obj", kTriangle);
  here.write("mark.obj", "\xef\xbb\xbf" + kTriangle);
  for (const char* file : {"f.glb", "t.obj"}) {
    INFO(file);
    const std::string options = " --size 40x30 -o - --format ppm";
    const Outcome piped = in_shell(here, std::string("\"$0\" render - ") + options + " < " + file);
    INFO(piped.err);
    CHECK(piped.exit_code == 0);
    CHECK(piped.err.empty());
    CHECK(piped.out == here.run(std::string("render ") + file + options).out);
  }
  const Outcome nameless = in_shell(here, "\"$0\" render - --size 8x8 -o - < t.obj");
  CHECK(!contains(nameless.out, "glassbox scene"));  // the command would not render it again
  CHECK(contains(here.run("render t.obj --size 8x8 -o -").out, "glassbox scene"));
  CHECK(in_shell(here, "cat t.obj | \"$0\" info -").exit_code == 0);
  CHECK(in_shell(here, "\"$0\" render - --size 8x8 < mark.obj").exit_code == 0);
  CHECK(fs::exists(here.file("stdin.png")));
}

TEST_CASE("info lists what is in glTF from a pipe as from a file") {
  const WorkingDirectory here;
  REQUIRE(here.run("info f-glyph --write f.glb").exit_code == 0);
  const auto after_title = [](const std::string& out) { return out.substr(out.find('\n')); };
  const std::string listed = after_title(here.run("info f.glb").out);
  CHECK(contains(listed, "1 primitive in the file: COLOR_0, NORMAL, POSITION"));
  CHECK(after_title(in_shell(here, "\"$0\" info - < f.glb").out) == listed);
  const Outcome json = in_shell(here, "\"$0\" info - --json - < f.glb");
  CHECK(contains(json.out, "COLOR_0"));
}

TEST_CASE("every command that takes a scene takes it from standard input") {
  const WorkingDirectory here;
  REQUIRE(here.run("info cube --write c.glb").exit_code == 0);
  for (const char* words :
       {"info -", "info - --json -", "explain - --size 16x16", "stereo - --size 32x32",
        "pixel - --size 16x16 --at 8,8", "why - --size 16x16 --triangle 0",
        "step - --size 16x16 --triangle 0", "inspect - --size 16x16 -o p.html",
        "trace - --size 16x16 -o r.npz", "render - --size 16x16 --frames 2 --turntable -o f.png"}) {
    const Outcome outcome = in_shell(here, std::string("\"$0\" ") + words + " < c.glb");
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(!outcome.out.empty());
  }
}

TEST_CASE("what comes through a pipe names no other files") {
  const WorkingDirectory here;
  here.write("e.gltf",
             R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "e.bin"}]})");
  here.write("e.bin", std::string(36, '\0'));
  check_refused(in_shell(here, "\"$0\" render - -o a.png < e.gltf"),
                {"standard input", "buffer", "'e.bin' is external", "embed"});
  here.write("m.mtl", "newmtl red\nKd 1 0 0\n");
  here.write("m.obj", "mtllib m.mtl\nusemtl red\n" + kTriangle);
  const Outcome library = in_shell(here, "\"$0\" render - --size 8x8 -o b.png < m.obj");
  CHECK(library.exit_code == 0);
  CHECK(contains(library.err, "material libraries are not read"));
}

TEST_CASE("standard input that is no scene is refused") {
  const WorkingDirectory here;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"\"$0\" render - < /dev/null", "the input is empty"},
      {"printf '\\001\\000\\002' | \"$0\" info -", "neither GLB nor glTF nor OBJ nor PLY"},
      {"printf '   \\n' | \"$0\" info -", "neither"},
      {"printf 'v 0 0 0\\nf 1 2 3\\n' | \"$0\" info -", "standard input: line 2"},
      {"printf '{\"asset\": ' | \"$0\" info -", "standard input"},
      {"printf 'glTF' | \"$0\" render -", "standard input"},
      {"printf 'f 1 2 3\\n' | \"$0\" step - --triangle 0 --interactive", "--interactive"},
      {"\"$0\" render - <&-", "standard input: cannot be read"}};
  for (const auto& [line, part] : cases) {
    INFO(line);
    check_refused(in_shell(here, line), {part});
  }
  CHECK(here.names().empty());
}

TEST_CASE("no scene is read from a terminal") {
  NEED_PSEUDO_TERMINAL();
  const WorkingDirectory here;
  const Outcome terminal = in_shell(here, "script -qec \"$0 info -\" /dev/null < /dev/null");
  CHECK(terminal.exit_code == 2);
  CHECK(contains(terminal.out, "standard input: is a terminal"));
  CHECK(here.names().empty());
}

TEST_CASE("bytes from memory have the limits of a file") {
  const auto bytes = std::as_bytes(std::span(kTriangle));
  LoadLimits limits;
  CHECK(load_scene_memory(bytes, limits));
  limits.max_file_bytes = kTriangle.size() - 1;
  const auto refused = load_scene_memory(bytes, limits);
  REQUIRE(!refused);
  CHECK(contains(refused.error().cause, "the most that is read"));
}

}  // namespace
}  // namespace glassbox::test
