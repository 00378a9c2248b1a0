// Tests glassbox views geometry: with scenes whose true cameras are known, with the files that it
// writes, and with requests that it refuses.
#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/manifest.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// Options for a general pair of cameras with half a pixel of noise and 30 % outliers.
const std::string kNoisy =
    "--scene room --size 640x480 --move 0.5,0.1,0.2 --turn -10,3,5 --noise 0.5 --outliers 0.3 ";

Json geometry_of(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views geometry " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

using Rows = std::array<std::array<double, 3>, 3>;
using Row3 = std::array<double, 3>;

double constraint(const Rows& f, const std::vector<double>& left,
                  const std::vector<double>& right) {
  const Row3 l{left[0], left[1], 1}, r{right[0], right[1], 1};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum += r[i] * f[i][k] * l[k];
  }
  return sum;
}

// Returns the length of F e, or of F^T e if `transposed`, for a matrix and a vector of length 1:
// its distance from 0.
double image_of(const Rows& f, const Row3& e, bool transposed) {
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (transposed ? f[k][i] : f[i][k]) * e[k];
    squares += sum * sum;
  }
  return std::sqrt(squares);
}

bool has_omission(const Json& json, const std::string& words) {
  return std::ranges::any_of(json.at("left_out"), [&](const Json& one) {
    const std::string line =
        one.at("what").get<std::string>() + ": " + one.at("why").get<std::string>();
    return line.find(words) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("exact matches give the cameras of all three scenarios back (S2-02, S2-09, C-105)") {
  const WorkingDirectory here;
  for (const std::string& words :
       {std::string("--eye-separation 0.3"),
        std::string("--arrangement converging --eye-separation 0.5 --window 4"),
        std::string("--move 0.5,0.1,0.2 --turn -10,3,5")}) {
    INFO(words);
    const Json json = geometry_of(here, "--scene room --size 320x240 " + words);
    CHECK(json["estimator"] == "5-point");
    CHECK(json["pair_is"]["kind"] == "general");
    CHECK(json["inliers"] == 500);
    // Coordinates are floats of some hundred pixels, off by at most 2^-16 px, and the focal length
    // is 290 px: each is off by 3e-6 degrees.
    CHECK(json["truth"]["rotation_error_degrees"] < 1e-4);
    CHECK(json["truth"]["direction_error_degrees"] < 1e-3);
    CHECK(json["residuals"]["sampson"]["largest_px"] < 1e-4);
    int in_front = 0, chosen = 0;
    REQUIRE(json["four_poses"].size() == 4);
    for (const Json& pose : json["four_poses"]) {
      chosen += pose["chosen"].get<bool>();
      in_front += pose["in_front"].get<int>();
      if (pose["chosen"].get<bool>()) CHECK(pose["in_front"] == 500);
    }
    CHECK(chosen == 1);
    CHECK(in_front == 500);
    CHECK(has_omission(json, "|T|"));
  }
}

TEST_CASE(
    "of parallel eyes E is that of the slides, and epipolar lines are scan lines (S2-06, E4)") {
  const WorkingDirectory here;
  const Json json = geometry_of(here, "--scene room --size 320x240 --eye-separation 0.3");
  const Rows e = json["E"], other = json["E_of_shift"];
  // R = 1 and T = (1, 0, 0): S has -1 and 1 in its lower right corner, and [t]x R is the same with
  // the opposite sign.
  const Rows expected{{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(e[i][k] - expected[i][k]) < 1e-6);
      CHECK(std::abs(other[i][k] + expected[i][k]) < 1e-6);
    }
  }
  const Row3 left = json["epipoles"]["left"];
  CHECK(std::abs(std::abs(left[0]) - 1) < 1e-6);
  CHECK(std::abs(left[2]) < 1e-6);
}

TEST_CASE("with noise and outliers every estimator finds the cameras (S2-12, C-99)") {
  const WorkingDirectory here;
  for (const std::string& estimator : {std::string("8"), std::string("7"), std::string("5")}) {
    INFO(estimator);
    const Json json = geometry_of(here, kNoisy + "--estimator " + estimator);
    CHECK(json["estimator"] == estimator + "-point");
    // A coordinate is off by 0.5 px with a focal length of 461 px, which is a sixteenth of a
    // degree; 330 matches average it.
    CHECK(json["truth"]["rotation_error_degrees"] < 0.2);
    CHECK(json["truth"]["direction_error_degrees"] < 1);
    const Json& outliers = json["truth"]["outliers"];
    CHECK(outliers["planted"] == 151);
    // One in 200 outliers is near its epipolar line by chance, within 2 px of some 400. Among
    // the other matches 4.6 % are beyond two sigma.
    CHECK(outliers["kept"] <= 5);
    CHECK(outliers["lost_matches"] < 349 / 10);
    CHECK(json["threshold_px"] == 1.0);
    CHECK(json["samples"] >= json["samples_wanted"]);
    CHECK(json["system"]["condition_raw"] >
          100 * json["system"]["condition_normalised"].get<double>());
    // The rms of Sampson's distance is sigma, minus what the threshold cuts off.
    CHECK(std::abs(json["residuals"]["sampson"]["rms_px"].get<double>() - 0.45) < 0.05);
  }
}

TEST_CASE("F, its residuals and its epipoles belong together") {
  const WorkingDirectory here;
  const Json json = geometry_of(here, kNoisy);
  const Rows f = json["F"];
  CHECK(image_of(f, json["epipoles"]["left"], false) < 1e-12);
  CHECK(image_of(f, json["epipoles"]["right"], true) < 1e-12);
  int inliers = 0;
  for (const Json& match : json["matches"]) {
    const auto left = match["left"].get<std::vector<double>>();
    const auto right = match["right"].get<std::vector<double>>();
    double slope = 0;  // squared gradient of p_r^T F p_l in all four coordinates
    for (std::size_t i = 0; i < 2; ++i) {
      slope += std::pow(f[i][0] * left[0] + f[i][1] * left[1] + f[i][2], 2);
      slope += std::pow(f[0][i] * right[0] + f[1][i] * right[1] + f[2][i], 2);
    }
    const double distance = std::abs(constraint(f, left, right)) / std::sqrt(slope);
    CHECK(std::abs(distance - match["sampson_px"].get<double>()) < 1e-6 * (1 + distance));
    CHECK(match["inlier"].get<bool>() == (distance <= 1.0));
    inliers += match["inlier"].get<bool>();
  }
  CHECK(json["inliers"] == inliers);
}

TEST_CASE("what --scene writes, --matches and --cameras read, and find the same in it") {
  const WorkingDirectory here;
  const Json scene =
      geometry_of(here, kNoisy + "--matches-out m.csv --cameras-out c.txt --pair-out a.png b.png");
  const Json files =
      geometry_of(here, "--pair a.png b.png --matches m.csv --cameras c.txt --sigma 0.5");
  for (const char* name : {"F", "E", "pose", "inliers", "samples", "epipoles", "system", "width"}) {
    INFO(name);
    CHECK(files[name] == scene[name]);
  }
  // The reader replaces the matrix by the nearest rotation, which costs some roundings of numbers
  // up to 1.
  const Rows read = files["truth"]["R"], drawn = scene["truth"]["R"];
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(std::abs(read[i / 3][i % 3] - drawn[i / 3][i % 3]) < 16 * 0x1p-53);
  // First without pictures, then without cameras too, which still gives F.
  CHECK(geometry_of(here, "--matches m.csv --cameras c.txt --sigma 0.5")["F"] == scene["F"]);
  const Json bare = geometry_of(here, "--matches m.csv --sigma 0.5");
  CHECK(bare["estimator"] == "8-point");
  CHECK(bare["E"].is_null());
  CHECK(bare["pose"].is_null());
  CHECK(has_omission(bare, "K is unknown"));
  CHECK(std::abs(bare["inliers"].get<int>() - scene["inliers"].get<int>()) < 10);
  CHECK(here.run("views geometry --scene room --size 160x120 --count 20 --matches-out -")
            .out.starts_with("x_left,y_left,x_right,y_right\n"));
}

TEST_CASE("of a file of many cameras those of the pictures' names count") {
  const WorkingDirectory here;
  const Json scene =
      geometry_of(here, kNoisy + "--matches-out m.csv --cameras-out c.txt --pair-out a.png b.png");
  std::istringstream lines(here.read("c.txt"));
  std::string count, left, right;
  std::getline(lines, count);
  std::getline(lines, left);
  std::getline(lines, right);
  std::string third = right;
  third.replace(0, 1, "c");
  here.write("three.txt", "3\n" + third + "\n" + right + "\n" + left + "\n");
  const std::string words = "--matches m.csv --sigma 0.5 --cameras three.txt ";
  CHECK(geometry_of(here, words + "--pair a.png b.png")["pose"] == scene["pose"]);
  CHECK(here.run("views geometry " + words).exit_code == 2);
  CHECK(here.run("views geometry " + words + "--pair a.png x.png").exit_code == 2);
}

TEST_CASE(
    "two cameras are told apart by the pictures' names, and by their order where there are none") {
  const WorkingDirectory here;
  geometry_of(here, kNoisy + "--matches-out m.csv --cameras-out c.txt --pair-out a.png b.png");
  std::istringstream lines(here.read("c.txt"));
  std::string count, left, right;
  std::getline(lines, count), std::getline(lines, left), std::getline(lines, right);
  here.write("swapped.txt", count + "\n" + right + "\n" + left + "\n");
  for (const char* name : {"x.png", "y.png"})
    here.write(name, here.read(name[0] == 'x' ? "a.png" : "b.png"));
  const std::string words = "--matches m.csv --sigma 0.5 ";
  const auto truth = [&](const std::string& more) {
    return geometry_of(here, words + more)["truth"];
  };
  const Json right_way = truth("--pair a.png b.png --cameras c.txt");
  CHECK(truth("--pair a.png b.png --cameras swapped.txt") == right_way);
  CHECK(truth("--pair x.png y.png --cameras c.txt") == right_way);
  CHECK(truth("--cameras c.txt") == right_way);
  CHECK(truth("--cameras swapped.txt") != right_way);
  const Outcome half = here.run("views geometry " + words + "--pair a.png y.png --cameras c.txt");
  CHECK(half.exit_code == 2);
  CHECK(half.err.find("c.txt: none of its 2 cameras is for 'y.png'") != std::string::npos);
}

TEST_CASE(
    "a turned camera, a plane and one point of view are named, not estimated (C-101, C-102)") {
  const WorkingDirectory here;
  const std::string turned = "--scene room --size 320x240 --turn 8,0,0";
  for (const std::string& words :
       {turned, turned + " --noise 0.5", turned + " --estimator 8 --noise 0.3",
        std::string("--scene room --size 320x240 --eye-separation 0")}) {
    INFO(words);
    const Json json = geometry_of(here, words);
    CHECK(json["pair_is"]["kind"] == "one point of view");
    CHECK(json["F"].is_null());
    CHECK(json["pose"].is_null());
    CHECK(has_omission(json, "C-101"));
  }
  const std::string plane =
      "--scene checker --size 320x240 --eye 0,2,4 --look-at 0,0,-2 --eye-separation 0.3 --window "
      "5 ";
  for (const std::string& noise : {std::string(), std::string("--noise 0.3 ")}) {
    const Json eight = geometry_of(here, plane + noise + "--estimator 8");
    CHECK(eight["pair_is"]["kind"] == "a plane");
    CHECK(eight["pose"].is_null());
    CHECK(has_omission(eight, "C-102"));
  }
  const Json five = geometry_of(here, plane + "--estimator 5");
  CHECK(five["pair_is"]["kind"] == "a plane");
  CHECK(five["truth"]["rotation_error_degrees"] < 0.01);
}

TEST_CASE("the right camera from a plane, at every seed, with the model and the reason (C-102)") {
  const WorkingDirectory here;
  const std::string plane =
      "--scene checker --size 320x240 --eye 0,2,4 --look-at 0,0,-2 --move 0.5,0.1,0.2 --turn "
      "-5,2,1 --noise ";
  struct Noise {
    std::string px;
    double rotation, direction;  // the largest errors, degrees
  };
  for (const auto& [px, rotation, direction] :
       {Noise{"0", 1e-4, 1e-3}, Noise{"0.3", 0.5, 2}, Noise{"0.3 --outliers 0.4", 0.5, 2}}) {
    for (int seed = 1; seed <= 10; ++seed) {
      const Json json = geometry_of(here, plane + px + " --seed " + std::to_string(seed));
      INFO(px << ", seed " << seed);
      CHECK(json["pair_is"]["kind"] == "a plane");
      CHECK(json["model"]["name"] == "plane");
      CHECK(json["plane"]["decided_by"] == "points in front of both cameras");
      CHECK(json["second_pose"].is_null());
      CHECK(json["truth"]["rotation_error_degrees"] < rotation);
      CHECK(json["truth"]["direction_error_degrees"] < direction);
      const Json& solutions = json["plane"]["solutions"];
      REQUIRE(solutions.size() == 2);
      CHECK(solutions[0]["behind"] == 0);
      CHECK(solutions[1]["behind"] > 25);
      // The camera is 2 above the plane, and |T| is the square root of 0.3.
      CHECK(std::abs(solutions[0]["distance"].get<double>() - 2 / std::sqrt(0.3)) < 0.1);
    }
  }
  const std::string text = unwrapped(here.run("views geometry " + plane + "0.3").out);
  CHECK(contains(text, "of 500 matches agree with one homography"));
  CHECK(contains(text, "points are in front of both cameras in the chosen one, and"));
  const Json general = geometry_of(here, kNoisy);
  CHECK(general["model"]["name"] == "general");
  CHECK(general["plane"].is_null());
}

TEST_CASE("a camera that moves towards a wall has two possible poses, and both are reported") {
  const WorkingDirectory here;
  const std::string wall =
      "--scene checker --size 320x240 --eye 0.2,5,0.3 --look-at 0,0,-2 --move 0.05,0,1.5 --turn "
      "3,2,1 --noise 0.1 ";
  const Json json = geometry_of(here, wall + "--draw page.html");
  CHECK(json["model"]["name"] == "plane");
  CHECK(json["plane"]["decided_by"] == "nothing");
  REQUIRE(json["second_pose"].is_object());
  CHECK(has_omission(json, "which of two poses is right"));
  // One of them is right.
  const double first = json["truth"]["direction_error_degrees"];
  const double second = json["truth"]["second_pose"]["direction_error_degrees"];
  CHECK(std::min(first, second) < 2);
  CHECK(manifest_of(here.read("page.html"))["second_pose"] == json["second_pose"]);
  const std::string text = here.run("views geometry " + wall).out;
  for (const char* words : {"second R", "second T", "of the second pose"}) {
    CHECK(contains(text, words));
  }
  CHECK(contains(unwrapped(text), "nothing decides between them"));
}

TEST_CASE("far points with noise do not count as a critical surface if K is known (C-103)") {
  const WorkingDirectory here;
  for (int seed = 1; seed <= 5; ++seed) {
    const Json json = geometry_of(
        here,
        "--scene teapot --size 640x480 --move 0.5,0.1,0.2 --turn -10,3,5 --noise 0.5 --seed " +
            std::to_string(seed));
    CHECK(json["pair_is"]["kind"] == "general");
    CHECK(json["truth"]["rotation_error_degrees"] < 1);
  }
}

TEST_CASE("points on a ruled quadric through both centres are named (C-103)") {
  // The surface x^2 - x + y Z = 0 contains both camera centres, (0, 0, 0) and (1, 0, 0), but not
  // the line between them.
  const WorkingDirectory here;
  constexpr double kFocal = 800;
  std::ostringstream matches;
  matches.precision(17);
  for (int i = 0; i < 60; ++i) {
    const double x = -1.5 + 4.0 * (i % 8) / 7, z = 4 + 4.0 * (i / 8) / 7 + 0.01 * (i % 5);
    const double y = -(x * x - x) / z;
    matches << kFocal * x / z + 320 << ' ' << kFocal * y / z + 240 << ' '
            << kFocal * (x - 1) / z + 320 << ' ' << kFocal * y / z + 240 << '\n';
  }
  here.write("quadric.csv", matches.str());
  here.write("c.txt",
             "2\na 800 0 320 0 800 240 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n"
             "b 800 0 320 0 800 240 0 0 1 1 0 0 0 1 0 0 0 1 -1 0 0\n");
  const Json json = geometry_of(here, "--matches quadric.csv --cameras c.txt --sigma 0.1");
  CHECK(json["pair_is"]["kind"] == "a critical surface");
  CHECK(json["F"].is_null());
  CHECK(has_omission(json, "C-103"));
}

TEST_CASE(
    "the text has what the slides and the other textbooks call E, the law, and what is left out") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views geometry " + kNoisy);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* words :
       {"room, 640 x 480\n", "visible in the right one", "500, 151 of them outliers", "E = R S",
        "[t]x R", "log(1 - 0.99)/log(1 - 0.", "epipoles  left (", "Sampson's distance", "(chosen)",
        "rotation off by", "condition", "left out\n  - |T|"}) {
    INFO(words << " in\n" << outcome.out);
    CHECK(outcome.out.find(words) != std::string::npos);
  }
  CHECK(contains(unwrapped(outcome.out), "with normalised points"));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  // With almost only outliers, matches may agree by chance, and the report must state that.
  CHECK(
      has_omission(geometry_of(here, "--scene room --size 320x240 --outliers 0.97"), "by chance"));
}

TEST_CASE(
    "the page has both pictures, the report and the line that makes it, and takes names for text") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views geometry " + kNoisy + "--count 40 --draw page.html");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.find("page.html: open it in a browser") != std::string::npos);
  const std::string page = here.read("page.html");
  CHECK(page.find("content=\"default-src 'none'; img-src data:;") != std::string::npos);
  CHECK(page.find("http:") == page.find("http://www.w3.org/2000/svg"));
  CHECK(page.find("https:") == std::string::npos);
  const Json manifest = manifest_of(page), json = geometry_of(here, kNoisy + "--count 40");
  for (const char* name : {"F", "E", "pose", "matches", "left_out", "truth", "four_poses"})
    CHECK(manifest[name] == json[name]);
  CHECK(manifest["all_matches"] == 40);
  CHECK(manifest["command"] ==
        "glassbox views geometry --scene room --move 0.5,0.1,0.2 --turn -10,3,5 --noise 0.5 "
        "--outliers 0.3 --count 40 --size 640x480 --draw page.html");
  for (const char* side : {"left", "right"}) {
    CHECK(manifest["pictures"][side].get<std::string>().starts_with(
        "data:image/png;base64,iVBORw0KGgo"));
  }
  REQUIRE(here.run("views geometry " + kNoisy + "--matches-out m.csv --pair-out a.png b.png")
              .exit_code == 0);
  const std::string name = "<img src=x>.png";
  here.write(name, here.read("a.png"));
  const Outcome named = run_program(
      GLASSBOX_PROGRAM,
      {"views", "geometry", "--pair", name, "b.png", "--matches", "m.csv", "--draw", "named.html"},
      here.path());
  INFO(named.err);
  REQUIRE(named.exit_code == 0);
  CHECK(here.read("named.html").find("<img src=x>") == std::string::npos);
  CHECK(manifest_of(here.read("named.html"))["picture_names"]["left"] == name);
}

TEST_CASE("the page of very many matches has some of them, and says so") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry --scene room --size 320x240 --move 0.4,0,0 --count 2500 --draw "
                   "page.html")
              .exit_code == 0);
  const Json manifest = manifest_of(here.read("page.html"));
  CHECK(manifest["all_matches"] == 2500);
  CHECK(manifest["matches"].size() == 2000);
}

TEST_CASE("what has no geometry, and what contradicts itself, is refused in one line (C-104)") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry " + kNoisy +
                   "--matches-out m.csv --cameras-out c.txt --pair-out a.png b.png")
              .exit_code == 0);
  REQUIRE(here.run("render cube --size 32x32 -o small.png").exit_code == 0);
  std::string few, same, line, one_left;
  for (int i = 1; i <= 12; ++i) {
    if (i < 8) few += std::to_string(i) + " 2 " + std::to_string(i * i) + " 4\n";
    same += "10 20 30 40\n";
    line += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(i + 1) + " 3\n";
    one_left += "5 5 " + std::to_string(i * i) + " " + std::to_string(i) + "\n";
  }
  here.write("few.csv", few);
  here.write("same.csv", same);
  here.write("line.csv", line);
  here.write("one_left.csv", one_left);
  here.write("inf.csv", same + "1 2 3 inf\n");
  here.write("empty.csv", "");
  std::string cameras = here.read("c.txt");
  const std::size_t focal = cameras.find(' ') + 1;
  here.write("no_k.txt", cameras.replace(focal, cameras.find(' ', focal) - focal, "0"));
  const std::vector<std::string> before = here.names();
  struct Case {
    std::string words, cause;
  };
  for (const auto& [words, cause] : std::vector<Case>{
           {"", "matching points"},
           {"--matches few.csv", "few.csv: the matches: there are 7, but 8 are needed"},
           {"--matches same.csv", "only 1 of the 12 are different"},
           {"--matches line.csv", "line.csv: the matches: the relation between the two pictures"},
           {"--matches one_left.csv", "cannot be computed from these 12 matches"},
           {"--matches inf.csv", "inf.csv: line 13: 'inf' is not a finite number"},
           {"--matches empty.csv", "there are 0"},
           {"--matches nowhere.csv", "nowhere.csv"},
           {"--matches m.csv --estimator 5", "matrices K are known"},
           {"--matches m.csv --estimator 6", "8|7|5"},
           {"--matches m.csv --cameras no_k.txt",
            "no_k.txt: line 2: the intrinsic matrix K is wrong"},
           {"--matches m.csv --cameras m.csv", "m.csv: line 1"},
           {"--matches m.csv --pair a.png small.png", "unequal sizes, 640 x 480 and 32 x 32"},
           {"--matches m.csv --pair a.png m.csv", "m.csv"},
           {"--matches m.csv --size 64x64", "--size"},
           {"--matches m.csv --noise 1", "--noise"},
           {"--matches m.csv --matches-out n.csv", "--matches-out"},
           {"--matches m.csv --sigma 0", "--sigma"},
           {"--matches m.csv --threshold nan", "--threshold"},
           {"--matches m.csv --confidence 1", "--confidence"},
           {"--matches m.csv --seed -1", "--seed"},
           {"--scene room --matches m.csv", "given as files too"},
           {"--scene room --ortho 3", "no centre"},
           {"--scene room --outliers 1", "--outliers"},
           {"--scene room --noise -1", "--noise"},
           {"--scene room --count 7", "too few"},
           {"--scene room --seen-by left", "both pictures"},
           {"--scene room --eye-separation -1", "exchanges the eyes"},
           {"--scene room --arrangement arbitrary", "position of the second camera"},
           {"--scene room --arrangement converging --move 1,0,0", "with --arrangement converging"},
           {"--scene room --move 1,0,0 --window 3", "place the cameras"},
           {"--scene room --turn 1e9,0,0", "more than a full turn"},
           {"--scene room --turn 180,0,0 --size 64x48", "8 are needed"},
           {"--scene room --arrangement converging --eye-separation 0.1 --window inf", "finite"},
           {"--scene room --size 1x1", "8 are needed"},
           {"--scene room --json nowhere/x.json", "nowhere"},
           {"--scene room --draw page.txt", ".html"},
           {"--scene room --draw nowhere/page.html", "nowhere"},
           {"--scene room --draw a.html --json a.html", "two outputs"},
           {"--scene room --draw a.html --size 16384x1024", "too large"},
           {"--matches m.csv --draw a.html", "add --pair"},
           {"--scene room --pair-out a.png a.txt", "a.txt"},
           {"--scene room --matches-out x --json x", "two outputs"},
           {"--scene room --matches-out - --json -", "standard output"}}) {
    INFO(words);
    check_refused(here.run("views geometry " + words), {cause});
    CHECK(here.names() == before);
  }
}

}  // namespace glassbox::test
