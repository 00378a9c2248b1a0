// Tests the commands that draw a scene with the user's own matrices: --model, --view, --proj.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/step_run.h"

#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>

namespace glassbox::test {
namespace {

// The textbook's camera for the cube, in OpenGL's conventions, for pictures of 320 x 180.
const Rows kCubeView = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
const Rows kCubeProjection = book::perspective_gl(book::radians(45), 320.0 / 180, 0.5, 50);

void write_matrices(const WorkingDirectory& here) {
  here.write("view.txt", plain_rows(kCubeView));
  here.write("proj.txt", plain_rows(kCubeProjection));
}

Outcome run(const WorkingDirectory& here, const std::string& words) {
  Outcome outcome = here.run(words);
  INFO(words << "\n" << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return outcome;
}

std::string refused(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run(words);
  CAPTURE(words, outcome.out);
  REQUIRE(outcome.exit_code == 2);
  return outcome.err;
}

}  // namespace

TEST_CASE("render draws a mesh with the user's matrices as with the same camera") {
  const WorkingDirectory here;
  write_matrices(here);
  run(here, "render cube --view view.txt --proj proj.txt -o own.png");
  run(here,
      "render cube --eye 3,2,5 --look-at 0,0,0 --fov 45 --near 0.5 --far 50 --size 320x180 "
      "-o camera.png");
  // --proj has the shape 16 : 9, and the height without --size is 720.
  run(here, "render cube --view view.txt --proj proj.txt --size 320x180 -o small.png");
  // The matrices were printed with nine digits: a float.
  const Outcome same = here.run("diff camera.png small.png --json -");
  const Json json = Json::parse(same.out);
  CHECK(same.exit_code <= 1);
  CHECK(json["pictures"][0]["differences"]["differing_pixels"].get<int>() < 30);
  const Outcome info = run(here, "render cube --view view.txt --proj proj.txt --json - -o big.png");
  CHECK(Json::parse(info.out)["width"] == 1280);
  CHECK(contains(info.err, "--proj is taken as a matrix for OpenGL"));
}

TEST_CASE("every command that looks at a picture takes the user's matrices") {
  const WorkingDirectory here;
  write_matrices(here);
  const std::string matrices = " --view view.txt --proj proj.txt --size 320x180";
  const std::string commands[] = {"step cube --triangle 0",
                                  "pixel cube --at 160,90",
                                  "why cube --triangle 0",
                                  "inspect cube -o page.html",
                                  "trace cube -o trace.json",
                                  "explain cube",
                                  "stereo cube"};
  for (const std::string& command : commands) run(here, command + matrices);
  const Outcome step = run(here, "step cube --triangle 10" + matrices);
  CHECK(contains(step.out, "your view matrix, view.txt, read by rows"));
  CHECK(contains(step.out, "to the clip space of OpenGL"));
  CHECK(contains(step.out, "to Glassbox's clip space: z = (z + w)/2"));
}

TEST_CASE("the model matrix places the scene, after its nodes") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("model.txt", plain_rows(book::translation(0, 100, 0)));
  const std::string camera = " --view view.txt --proj proj.txt --size 64x36";
  const Outcome seen = run(here, "render cube -o a.png --json -" + camera);
  const Outcome away = run(here, "render cube -o b.png --json - --model model.txt" + camera);
  CHECK(Json::parse(seen.out)["stages"]["covered"].get<int>() > 0);
  CHECK(Json::parse(away.out)["stages"]["covered"].get<int>() == 0);
}

TEST_CASE("a picture's recipe has the matrices themselves, in place of their files") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("view.txt", numbers(kCubeView, true, "%.9g"));
  run(here,
      "render cube --view view.txt --view-order columns --proj proj.txt --size 64x36 -o a.png");
  const auto bytes = read_file(here.file("a.png")).value();
  const auto recipe = recipe_of(read_png_text(bytes).value());
  REQUIRE(recipe);
  std::string words = "render " + recipe->scene + " -o b.png";
  for (const std::string& option : recipe->options) words += " " + option;
  CHECK_FALSE(contains(words, ".txt"));
  run(here, words);
  CHECK(read_file(here.file("b.png")).value() == bytes);
}

TEST_CASE("matrices and what contradicts them are refused with the option's name") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("short.txt", "1 2 3");
  here.write("nan.txt", "1 0 0 0  0 1 0 0  0 0 nan 0  0 0 -1 0");
  here.write("flat.txt", "1 0 0 0  1 0 0 0  0 0 1 0  0 0 -1 0");
  here.write("row.txt", plain_rows(book::transposed(book::translation(1, 2, 3))));
  const std::pair<const char*, const char*> calls[] = {
      {"render cube --view none.txt", "--view: no such file"},
      {"render cube --proj short.txt", "--proj: has 3 numbers, but a matrix has 16"},
      {"render cube --proj nan.txt", "--proj: the entry in row 2, column 2 is not a finite number"},
      {"render cube --proj flat.txt", "no eye"},
      {"render cube --model row.txt", "give --model-order columns"},
      {"render cube --model proj.txt", "give the projection as --proj"},
      {"render cube --view view.txt --eye 1,2,3", "--eye: the pose is also given by --view"},
      {"render cube --proj proj.txt --fov 40", "--fov: the camera is also given by --proj"},
      {"render cube --view 1,0,0,0,0,2,0,0,0,0,1,-5,0,0,0,1", "--view: its axes are not"},
  };
  for (const auto& [call, message] : calls) {
    CAPTURE(call);
    CHECK(contains(refused(here, call), message));
  }
  const auto from_proj = [&](const std::string& words) {
    return in_shell(here, GLASSBOX_PROGRAM " " + words + " < proj.txt").err;
  };
  CHECK(contains(from_proj("render - --proj -"), "the scene and a matrix are both standard input"));
  CHECK(contains(from_proj("render cube --view - --proj -"),
                 "several matrices are read from standard input"));
}

TEST_CASE("what was chosen for the matrices is said: the dialect, a stretched picture, a mirror") {
  const WorkingDirectory here;
  write_matrices(here);
  const Outcome stretched =
      run(here, "render cube --view view.txt --proj proj.txt --size 180x180 -o a.png");
  CHECK(contains(stretched.err, "stretches what --proj draws by 0.56"));
  here.write("left.txt", plain_rows(book::product(book::scaling(-1, 1, 1), kCubeProjection)));
  const Outcome mirrored = run(here, "render cube --view view.txt --proj left.txt -o a.png");
  CHECK(contains(mirrored.err, "the matrices mirror the scene"));
  const Outcome front =
      run(here, "render cube --view view.txt --proj left.txt --front ccw -o b.png");
  CHECK_FALSE(contains(front.err, "the matrices mirror the scene"));
}

TEST_CASE("why names the likeliest mistake of the matrices where nothing is seen") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("transposed.txt", plain_rows(book::transposed(kCubeView)));
  here.write("pose.txt", plain_rows(book::rigid_inverse(kCubeView)));
  here.write("left.txt",
             plain_rows(book::perspective_d3d_left(book::radians(45), 320.0 / 180, 0.5, 50)));
  const std::pair<const char*, const char*> mistakes[] = {
      {"--view transposed.txt --proj proj.txt", "transpose-view"},
      {"--view pose.txt --proj proj.txt", "invert-view"},
      {"--view view.txt --proj left.txt", "eye-hand"},
  };
  for (const auto& [words, id] : mistakes) {
    CAPTURE(words);
    const Outcome outcome = run(here, "why cube --size 320x180 --json - " + std::string(words));
    const Json json = Json::parse(outcome.out);
    REQUIRE(json.contains("matrices"));
    CHECK(json["matrices"]["visible"] == 0);
    CHECK(json["matrices"]["alternatives"][0]["id"] == id);
    CHECK(contains(run(here, "why cube --size 320x180 " + std::string(words)).out, "LIKELY"));
  }
  const Outcome good = run(here, "why cube --view view.txt --proj proj.txt --size 320x180");
  CHECK_FALSE(contains(good.out, "LIKELY"));
}

TEST_CASE("points come from tables and from a scene's vertices") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("points.csv",
             "VTX, IDX, Position.x, Position.y, Position.z\n0, 0, 0, 0, 0\n1, 1, 1, 1, 1\n");
  const std::string camera = " --view view.txt --proj proj.txt --json -";
  const Json table = Json::parse(run(here, "step --points points.csv" + camera).out);
  const Json typed = Json::parse(run(here, "step --point 0,0,0 --point 1,1,1" + camera).out);
  CHECK(table["points"] == typed["points"]);
  here.write("box.obj", "v 0 0 0\nv 1 1 1\nv 1 0 0\nf 1 2 3\n");
  const Json vertices = Json::parse(run(here, "step box.obj --vertices 0,1" + camera).out);
  CHECK(vertices["points"] == typed["points"]);
  CHECK(contains(refused(here, "step box.obj --vertices 7 --proj proj.txt"),
                 "the scene has 3 vertices; give numbers from 0 to 2"));
  CHECK(contains(refused(here, "step --vertices 7 --proj proj.txt"), "name a scene"));
  CHECK(contains(refused(here, "step --points none.csv --proj proj.txt"), "none.csv"));
}

TEST_CASE("a program's clip positions are compared, and a matrix left out is named") {
  const WorkingDirectory here;
  write_matrices(here);
  here.write("model.txt", plain_rows(book::translation(0, 0.5, 0)));
  here.write("in.csv", "x,y,z\n0,0,0\n1,1,1\n-1,0.5,0.25\n");
  const Rows mvp = book::product(kCubeProjection, kCubeView);
  std::string out = "gl_Position.x,gl_Position.y,gl_Position.z,gl_Position.w\n";
  for (const book::Vector3& p : {book::Vector3{0, 0, 0}, {1, 1, 1}, {-1, 0.5, 0.25}}) {
    for (std::size_t row = 0; row < 4; ++row) {
      char number[40];
      std::snprintf(number, sizeof number, "%.5f%s",
                    mvp[row][0] * p[0] + mvp[row][1] * p[1] + mvp[row][2] * p[2] + mvp[row][3],
                    row == 3 ? "\n" : ",");
      out += number;
    }
  }
  here.write("out.csv", out);
  const std::string words = "step --points in.csv --clip out.csv --view view.txt --proj proj.txt";
  CHECK(contains(run(here, words).out, "are those of your matrices, at all 3 points"));
  const Outcome wrong = run(here, words + " --model model.txt");
  CHECK(
      contains(wrong.out, "3 of 3 clip positions of your program are not those of your matrices"));
  CHECK(contains(wrong.out, "explained by: it leaves out the model matrix"));
  CHECK(contains(refused(here, "step --point 0,0,0 --clip out.csv --proj proj.txt"),
                 "there are 1 point and 3 clip positions"));
}

}  // namespace glassbox::test
