// Tests glassbox views layers: what it builds and draws of scenes whose correct pictures are known,
// and what it refuses.
#include "tests/support/catch.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/images/read.h>

#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json answer(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views layers " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

// A view a little to the right of the room's door.
const std::string kBeside = " --eye 1.75,1.62,-0.3 --look-at 0.68,1.39,-2.46 ";

}  // namespace

TEST_CASE("layers drawn from their own view are the picture that render draws, byte for byte") {
  const WorkingDirectory here;
  REQUIRE(here.run("render room --size 96x64 -o render.png").exit_code == 0);
  const Json built = answer(here, "build room --size 96x64 -o room.ldi");
  CHECK(built["covered_pixels"] == 96 * 64);
  CHECK(built["depth_complexity"] > 1.2);
  for (const char* more : {"--order depth", "--order occlusion", "--splat point --threads 3"}) {
    const Json drawn =
        answer(here, std::string("draw room.ldi -o same.png --against room ") + more);
    CHECK(drawn["against"]["wrong_pixels"] == 0);
    CHECK(drawn["pixels_without_sample"] == 0);
    CHECK(here.run("diff render.png same.png").exit_code == 0);
  }
}

TEST_CASE(
    "more layers leave fewer holes beside their view, and more of the picture right (S1-01)") {
  const WorkingDirectory here;
  std::size_t holes = 96 * 64, wrong = 96 * 64;
  for (const char* layers : {"1", "2", "10"}) {
    answer(here, std::string("build room --size 96x64 -o room.ldi --layers ") + layers);
    const Json drawn = answer(here, "draw room.ldi -o beside.png --against room" + kBeside);
    const auto now = drawn["against"]["holes"].get<std::size_t>();
    const auto wrong_now = drawn["against"]["wrong_pixels"].get<std::size_t>();
    CHECK(now < holes);
    CHECK(wrong_now < wrong);
    holes = now;
    wrong = wrong_now;
  }
  // The holes that are left are beside the first picture: fewer pixels than a hundredth.
  CHECK(holes < 96 * 64 / 100);
  const Json one = answer(here, "draw room.ldi -o one.png" + kBeside);
  const Json many = answer(here, "draw room.ldi -o many.png --threads 4" + kBeside);
  CHECK(one["samples_drawn"] == many["samples_drawn"]);
  CHECK(here.run("diff one.png many.png").exit_code == 0);
}

TEST_CASE("info says what a layered depth image has, and from where") {
  const WorkingDirectory here;
  const Json built = answer(here, "build room --size 48x32 -o room.ldi --layers 3");
  const Outcome text = here.run("info room.ldi");
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("a layered depth image of 48 x 32 pixels") != std::string::npos);
  CHECK(text.out.find("camera: perspective, at (") != std::string::npos);
  const Outcome json = here.run("info room.ldi --json -");
  REQUIRE(json.exit_code == 0);
  const Json info = Json::parse(json.out);
  for (const char* same : {"samples", "covered_pixels", "most_samples_of_a_pixel", "bytes"})
    CHECK(info[same] == built[same]);
  std::size_t samples = 0, number = 0;
  for (const auto& pixels : info["pixels_by_samples"])
    samples += ++number * pixels.get<std::size_t>();
  CHECK(samples == built["samples"]);
  CHECK(info["nearest"] < info["farthest"]);
  CHECK(here.run("info room.ldi --write a.glb").exit_code == 2);
  std::ofstream(here.file("cut.ldi")) << "glassbox-layers 1\nand no more";
  const Outcome cut = here.run("info cut.ldi");
  CHECK(cut.exit_code == 2);
  CHECK(cut.err.find("cut.ldi") != std::string::npos);
}

TEST_CASE("other views of a scene add what the camera's own does not see (S1-02)") {
  const WorkingDirectory here;
  // The cameras beside the room's come from views geometry, which writes them in the right format.
  REQUIRE(here.run("views geometry --scene room --size 96x64 --eye-separation 0.8 --cameras-out "
                   "cameras.txt")
              .exit_code == 0);
  const Json one = answer(here, "build room --size 96x64 --layers 1 -o one.ldi");
  const Json many =
      answer(here, "build room --size 96x64 --layers 1 --views cameras.txt -o many.ldi");
  CHECK(many["views"] == 3);
  CHECK(many["samples"] > one["samples"]);
  // A surface that three views see is stored once.
  CHECK(many["samples"] < 2 * one["samples"].get<std::size_t>());
  const auto holes = [&](const char* file) {
    return answer(here, std::string("draw ") + file + " -o a.png --against room" +
                            kBeside)["against"]["holes"]
        .get<std::size_t>();
  };
  CHECK(holes("many.ldi") < holes("one.ldi"));
}

TEST_CASE("a picture and its distances as files are layers") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry --scene room --size 96x64 --eye-separation 0.8 --cameras-out "
                   "cameras.txt")
              .exit_code == 0);
  std::ifstream in(here.file("cameras.txt"));
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  std::ofstream(here.file("left.txt")) << "1\nleft.png" << line.substr(line.find(' ')) << '\n';
  REQUIRE(here.run("render room --size 96x64 --seen-by left --eye-separation 0.8 -o left.png "
                   "--depth-out left.pfm")
              .exit_code == 0);
  const Json built = answer(here, "build --pictures left.txt -o left.ldi");
  CHECK(built["samples"] == 96 * 64);
  answer(here, "draw left.ldi -o same.png");
  CHECK(here.run("diff left.png same.png").exit_code == 0);
}

TEST_CASE(
    "of two samples of a pixel, the nearest and the farthest leave fewer holes than the first "
    "two") {
  const WorkingDirectory here;
  const Json first = answer(here, "build room --size 150x150 --layers 2 -o first.ldi");
  const Json ends = answer(here, "build room --size 150x150 --ends -o ends.ldi");
  CHECK(ends["most_samples_of_a_pixel"] == 2);
  CHECK(ends["samples"] == first["samples"]);
  const auto holes = [&](const char* file) {
    return answer(here, std::string("draw ") + file + " -o a.png --against room" +
                            kBeside)["against"]["holes"]
        .get<int>();
  };
  CHECK(holes("ends.ldi") < holes("first.ldi"));
}

TEST_CASE("rays from around the eye find what one view does not see (S1-03)") {
  const WorkingDirectory here;
  const Json one = answer(here, "build room --size 96x64 --layers 1 -o one.ldi");
  const Json rays =
      answer(here, "build room --size 96x64 --rays 14,8 --cube 0.6 --threads 2 -o rays.ldi");
  CHECK(rays["rays"]["cast"] == 14 * 14 * 14 * 14 * 8);
  CHECK(rays["rays"]["hits"] <= rays["rays"]["followed"]);
  CHECK(rays["rays"]["followed"] < rays["rays"]["cast"]);
  CHECK(rays["depth_complexity"] > 1);
  answer(here, "build room --size 96x64 --rays 14,8 --cube 0.6 -o same.ldi");
  std::ifstream a(here.file("rays.ldi"), std::ios::binary),
      b(here.file("same.ldi"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(a), {}};
  CHECK(bytes == std::string{std::istreambuf_iterator<char>(b), {}});
  const auto against = [&](const char* file) {
    return answer(here,
                  std::string("draw ") + file + " -o a.png --against room" + kBeside)["against"];
  };
  CHECK(against("rays.ldi")["holes"] < against("one.ldi")["holes"]);
}

TEST_CASE("frames of layers along a path are the pictures of their cameras") {
  const WorkingDirectory here;
  answer(here, "build room --size 48x32 -o room.ldi");
  std::ofstream(here.file("walk.json")) << R"({"camera_path": 1, "keyframes": [
    {"time": 0, "eye": [1.75, 1.62, -0.3], "look_at": [0.68, 1.39, -2.46]},
    {"time": 1, "eye": [1.5, 1.62, -0.3], "look_at": [0.68, 1.39, -2.46]}]})";
  const Json frames = answer(here, "draw room.ldi --frames 3 --path walk.json -o walk.png");
  CHECK(frames["frames"].size() == 3);
  answer(here, "draw room.ldi -o alone.png" + kBeside);
  CHECK(here.run("diff walk-0001.png alone.png").exit_code == 0);
  CHECK(here.run("diff walk-0003.png alone.png").exit_code == 1);
  CHECK(answer(here, "draw room.ldi --frames 2-2/4 --turntable -o turn.png")["frames"].size() == 1);
}

TEST_CASE("a page has the layers, and says when there is nowhere to write") {
  const WorkingDirectory here;
  answer(here, "build room --size 48x32 -o room.ldi");
  REQUIRE(here.run("views layers draw room.ldi --html room.html").exit_code == 0);
  std::ifstream in(here.file("room.html"));
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const char* part : {"\"manifest\"", "\"counts\"", "\"depths\"", "\"colours\""})
    CHECK(page.find(part) != std::string::npos);
}

TEST_CASE("repeated drawing tells the time of a picture, whatever draws it") {
  const WorkingDirectory here;
  answer(here, "build room --size 48x32 -o room.ldi");
  const Json drawn = answer(here, "draw room.ldi -o a.png --repeat 5 --target scalar" + kBeside);
  CHECK(drawn["times"] == 5);
  CHECK(drawn["warp_ms_lower_quartile"] <= drawn["warp_ms"]);
  answer(here, "draw room.ldi -o b.png --threads 2" + kBeside);
  CHECK(here.run("diff a.png b.png").exit_code == 0);
}

TEST_CASE(
    "--second-eye warps the right eye's picture, and the report says how far off it is (S0-06)") {
  const WorkingDirectory here;
  const std::string pair =
      "render room --size 192x108 --stereo pair --eye-separation 0.12 --window 3 ";
  REQUIRE(here.run(pair + "-o drawn.png").exit_code == 0);
  const Outcome one =
      here.run(pair + "--second-eye warp -o one.png --report report.json --json one.json");
  INFO(one.err);
  REQUIRE(one.exit_code == 0);
  CHECK(one.out.find("the right eye is warped") != std::string::npos);
  const Json told = Json::parse(std::ifstream(here.file("one.json")));
  CHECK(told["stereo"]["warped"]["layers"] == 1);
  const Json report = Json::parse(std::ifstream(here.file("report.json")))["second_eye"];
  CHECK(report["pixels"] == 192 * 108);
  CHECK(report["warped"]["wrong_pixels"] < report["left_in_its_place"]["wrong_pixels"]);
  CHECK(report["holes"] == told["stereo"]["warped"]["holes"]);
  // The left half of the picture does not change.
  const auto drawn = read_image(here.file("drawn.png")), warped = read_image(here.file("one.png"));
  REQUIRE(drawn);
  REQUIRE(warped);
  std::size_t differ = 0;
  for (int y = 0; y < 108; ++y) {
    for (int x = 0; x < 192; ++x) {
      REQUIRE(drawn->at(x, y) == warped->at(x, y));
      differ += drawn->at(192 + x, y) != warped->at(192 + x, y);
    }
  }
  CHECK(differ > 0);
  // The second eye is warped only on request.
  REQUIRE(here.run(pair + "--second-eye drawn -o same.png").exit_code == 0);
  CHECK(here.run("diff drawn.png same.png").exit_code == 0);
  for (const char* words :
       {"--second-eye warp:0", "--second-eye warp:9", "--second-eye warped",
        "--second-eye warp --eyes-by crop", "--second-eye warp --stereo-cull centre",
        "--second-eye warp --show id", "--second-eye warp:2 --samples 4"}) {
    const Outcome refused = here.run(pair + words + " -o no.png");
    INFO(words << ": " << refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(std::ranges::count(refused.err, '\n') == 1);
  }
  CHECK(here.run("render room --second-eye warp -o no.png").exit_code == 2);
  CHECK(here.run("explain room --stereo pair --second-eye warp").exit_code == 2);
}

TEST_CASE("a wall on the near plane is drawn from its own view by the program, too") {
  const WorkingDirectory here;
  std::ofstream(here.file("q.obj"))
      << "v -9 -9 -0.7\nv 9 -9 -0.7\nv 9 9 -0.7\nv -9 9 -0.7\nf 1 2 3 4\n";
  const Json built = answer(here,
                            "build q.obj --eye 0.3,0.1,0.37 --look-at 0.3,0.1,-1 --near 1.07 "
                            "--fov 60 --size 64x48 -o q.ldi");
  CHECK(built["samples"] == 64 * 48);
  CHECK(answer(here, "draw q.ldi -o a.png")["samples_drawn"] == 64 * 48);
}

TEST_CASE("more threads than processors say nothing, wherever they draw, match or carve") {
  const WorkingDirectory here;
  for (const char* words :
       {"views layers build cube --size 48x32 --rays 4 --threads 64 -o cube.ldi",
        "views layers draw cube.ldi --threads 64 -o a.png",
        "render cube --size 48x32 --stereo pair --second-eye warp --threads 64 -o a.png",
        "views match --scene cube --size 48x32 --eye-separation 0.1 --range 0,8 --threads 64 -o "
        "a.pfm"}) {
    const Outcome outcome = here.run(words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.find("TBB") == std::string::npos);
  }
}

TEST_CASE(
    "what lies behind the last layer is said to be left out, of one surface and of other views") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry --scene room --size 48x32 --eye-separation 0.8 --cameras-out "
                   "cameras.txt")
              .exit_code == 0);
  const auto left_out = [&](const std::string& words) {
    return here.run("views layers build room --size 48x32 -o room.ldi " + words).out;
  };
  CHECK(left_out("--layers 1").find("surfaces behind 1 surface, if") != std::string::npos);
  CHECK(left_out("--layers 2 --views cameras.txt").find("surfaces behind 2 surfaces, if") !=
        std::string::npos);
  CHECK(left_out("--layers 99 --views cameras.txt").find("surfaces behind") == std::string::npos);
}

TEST_CASE("a page without a picture has no use for what a picture is drawn by, and says so") {
  const WorkingDirectory here;
  answer(here, "build cube --size 24x16 -o cube.ldi");
  for (const char* option :
       {"--json out.json", "--eye 0,0,9", "--size 8x8", "--splat point", "--order occlusion",
        "--holes 1,0,1", "--threads 2", "--target scalar", "--against cube", "--repeat 2"}) {
    const Outcome outcome =
        here.run(std::string("views layers draw cube.ldi --html cube.html ") + option);
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    INFO(option << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(name + ": no picture is drawn without -o; give -o") !=
          std::string::npos);
    CHECK_FALSE(std::ifstream(here.file("cube.html")).good());
    CHECK_FALSE(std::ifstream(here.file("out.json")).good());
  }
  REQUIRE(
      here.run("views layers draw cube.ldi --html cube.html --json out.json -o a.png").exit_code ==
      0);
  CHECK(std::ifstream(here.file("cube.html")).good());
  CHECK(std::ifstream(here.file("out.json")).good());
}

TEST_CASE("a colour that is none is refused by the option that has it") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views layers draw room.ldi -o q.png --holes 2,0,0");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("--holes: needs three numbers from 0 to 1") != std::string::npos);
}

TEST_CASE("what cannot be built or drawn is refused in a line, and no file is left") {
  const WorkingDirectory here;
  REQUIRE(here.run("views layers build cube --size 24x16 -o cube.ldi").exit_code == 0);
  std::ofstream(here.file("text.ldi")) << "glassbox-layers 1\nand no more";
  for (const char* words : {"build room -o room.png",
                            "build room -o room.ldi --layers 0",
                            "build room -o room.ldi --layers 256",
                            "build room -o room.ldi --wireframe",
                            "build room -o room.ldi --samples 4",
                            "build room -o room.ldi --show depth",
                            "build nothing.glb -o room.ldi",
                            "draw none.ldi -o a.png",
                            "draw text.ldi -o a.png",
                            "draw cube.ldi -o a.gif",
                            "draw cube.ldi -o a.png --size 0x3",
                            "draw cube.ldi -o a.png --threads 0",
                            "draw cube.ldi -o a.png --against nothing.glb",
                            "draw cube.ldi -o a.png --html pp.html --against nothing.glb",
                            "draw cube.ldi -o a.png --html pp.html --eye 0,0,0 --look-at 0,0,0",
                            "draw cube.ldi -o a.png --html pp.html --frames 3 --path none.json",
                            "draw cube.ldi -o a.png --splat round",
                            "draw cube.ldi -o a.png --splat soft",
                            "draw cube.ldi",
                            "draw cube.ldi --html a.png",
                            "draw cube.ldi --html a.html --repeat 3",
                            "draw cube.ldi -o a.png --repeat 0",
                            "draw cube.ldi -o a.png --frames 3",
                            "draw cube.ldi -o a.png --frames 3 --path none.json",
                            "draw cube.ldi -o - --frames 3 --turntable",
                            "draw cube.ldi -o a.png --frames 3 --turntable --against cube",
                            "build -o room.ldi",
                            "build room --pictures text.ldi -o room.ldi",
                            "build --pictures none.txt -o room.ldi",
                            "build --pictures text.ldi -o room.ldi",
                            "build room --views none.txt -o room.ldi",
                            "build room --views text.ldi -o room.ldi",
                            "build room --epsilon 0.1 -o room.ldi",
                            "build room --views text.ldi --epsilon nan -o room.ldi",
                            "build room --rays 0 -o room.ldi",
                            "build room --rays 91 -o room.ldi",
                            "build room --rays 90,2 -o room.ldi",
                            "build room --rays 4,0 -o room.ldi",
                            "build room --rays 4,2,1 -o room.ldi",
                            "build room --rays many -o room.ldi",
                            "build room --rays 4,99999999999 -o room.ldi",
                            "build room --rays 4 --cube 0 -o room.ldi",
                            "build room --rays 4 --cube inf -o room.ldi",
                            "build room --rays 4 --cube nan -o room.ldi",
                            "build room --rays 4 --cube 1e300 -o room.ldi",
                            "build room --rays 4 --near 1e35 --far inf -o room.ldi",
                            "build room --rays 4 --layers 2 -o room.ldi",
                            "build room --rays 4 --views none.txt -o room.ldi",
                            "build room --rays 4 --shade flat -o room.ldi",
                            "build room --rays 4 --ortho 3 -o room.ldi",
                            "build room --cube 1 -o room.ldi",
                            "build room --threads 2 -o room.ldi",
                            "build --pictures none.txt --rays 4 -o room.ldi",
                            "build --pictures text.ldi --layers 2 -o room.ldi",
                            "build --pictures text.ldi --size 4x4 -o room.ldi",
                            "draw cube.ldi -o a.png --eye 0,0,0 --look-at 0,0,0"}) {
    const Outcome outcome = here.run(std::string("views layers ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("a.png")).good());
    CHECK_FALSE(std::ifstream(here.file("room.ldi")).good());
    CHECK_FALSE(std::ifstream(here.file("pp.html")).good());
  }
  const Outcome epsilon =
      here.run("views layers build room --views text.ldi --epsilon nan -o room.ldi");
  CHECK(epsilon.err.find("--epsilon") != std::string::npos);
}

}  // namespace glassbox::test
