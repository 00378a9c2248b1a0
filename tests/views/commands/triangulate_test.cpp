// Tests glassbox views triangulate: against the scene's own geometry, with the files that views
// geometry writes, and with requests that it refuses.
#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/manifest.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;
using Triple = std::array<double, 3>;

const std::string kPair = "--scene room --size 320x240 --move 0.5,0.1,0.2 --turn -10,3,5 ";

Json points_of(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views triangulate " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

double distance(const Triple& a, const Triple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The pixel of a world point, K R (X - c), and its depth.
Triple pixel_of(const Json& camera, const Triple& point) {
  const auto k = camera["K"].get<std::array<Triple, 3>>();
  const auto r = camera["R"].get<std::array<Triple, 3>>();
  const auto c = camera["centre"].get<Triple>();
  Triple at{}, pixel{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) at[i] += r[i][j] * (point[j] - c[j]);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) pixel[i] += k[i][j] * at[j] / at[2];
  }
  pixel[2] = at[2];
  return pixel;
}

// The numbers of a binary PLY file without colours. The machine has the least significant byte
// first.
std::vector<float> floats_after_header(const std::string& ply) {
  const std::string data = ply.substr(ply.find("end_header\n") + 11);
  std::vector<float> numbers(data.size() / sizeof(float));
  std::memcpy(numbers.data(), data.data(), numbers.size() * sizeof(float));
  return numbers;
}

// Two cameras side by side, 1 apart, with a focal length of 100 px and the centre at (50, 40).
const std::string kSideBySide =
    "2\na 100 0 50 0 100 40 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n"
    "b 100 0 50 0 100 40 0 0 1 1 0 0 0 1 0 0 0 1 -1 0 0\n";

}  // namespace

TEST_CASE(
    "a match with simple numbers has the ray, the distances and the point of the slide (S2-05)") {
  const WorkingDirectory here;
  here.write("c.txt", kSideBySide);
  // The point (1, 0, 10): pixels at x = 60 and 50.
  here.write("m.csv", "60 40 50 40\n");
  for (const char* method : {"midpoint", "linear", "optimal"}) {
    INFO(method);
    const Json json = points_of(
        here, std::string("--matches m.csv --cameras c.txt --sigma 0.5 ") + "--method " + method);
    const Json& match = json["matches"][0];
    CHECK(match["state"] == "in front of both cameras");
    CHECK(distance(match["point"], {1, 0, 10}) < 1e-12);
    CHECK(match["left_ray"]["origin"] == Json({0, 0, 0}));
    CHECK(match["right_ray"]["origin"] == Json({1, 0, 0}));
    CHECK(distance(match["left_ray"]["direction"],
                   {1 / std::sqrt(101.0), 0, 10 / std::sqrt(101.0)}) < 1e-15);
    CHECK(distance(match["right_ray"]["direction"], {0, 0, 1}) < 1e-15);
    CHECK(std::abs(match["t_left"].get<double>() - std::sqrt(101.0)) < 1e-12);
    CHECK(std::abs(match["t_right"].get<double>() - 10) < 1e-12);
    CHECK(match["gap"].get<double>() < 1e-12);
    CHECK(json["baseline"] == 1);
    // sigma_Z = Z^2 sqrt(2) sigma/(f B) = 0.707 (S2-13); the longest axis has this depth.
    const Triple axis = match["ellipsoid"]["axes"][0];
    const double half = match["ellipsoid"]["half_axes"][0];
    double variance = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = match["ellipsoid"]["axes"][i][2].get<double>() *
                          match["ellipsoid"]["half_axes"][i].get<double>();
      variance += part * part;
    }
    CHECK(std::abs(std::sqrt(variance) - 100 * std::sqrt(2.0) * 0.5 / 100) < 1e-3);
    CHECK(std::abs(axis[2]) * half > 0.7);
  }
}

TEST_CASE("exact matches of a scene give points that both pictures show where the match is") {
  const WorkingDirectory here;
  for (const char* method : {"midpoint", "linear", "optimal"}) {
    INFO(method);
    const Json json = points_of(here, kPair + "--method " + method);
    CHECK(json["method"] == method);
    CHECK(json["matches"].size() == 500);
    CHECK(json["counts"]["in front of both cameras"] == 500);
    CHECK(json["residuals_above_3_sigma"] == 0);
    for (const Json& match : json["matches"]) {
      for (const char* side : {"left", "right"}) {
        const Triple pixel = pixel_of(json["cameras"][side], match["point"]);
        CHECK(pixel[2] > 0);
        // Coordinates are floats of some hundred pixels, off by at most 2^-16 px.
        CHECK(std::hypot(pixel[0] - match[side][0].get<double>(),
                         pixel[1] - match[side][1].get<double>()) < 1e-4);
      }
    }
  }
}

TEST_CASE("what views geometry writes, views triangulate reads, and finds the scene's points") {
  const WorkingDirectory here;
  const std::string noisy = kPair + "--noise 0.5 --outliers 0.1 --count 60 --seed 3 ";
  REQUIRE(here.run("views geometry " + noisy +
                   "--matches-out m.csv --cameras-out c.txt --pair-out a.png b.png")
              .exit_code == 0);
  const Json scene = points_of(here, noisy);
  const Json files =
      points_of(here, "--pair a.png b.png --matches m.csv --cameras c.txt --sigma 0.5");
  CHECK(scene["sigma_px"] == 0.5);
  CHECK(files["counts"] == scene["counts"]);
  REQUIRE(files["matches"].size() == scene["matches"].size());
  for (std::size_t i = 0; i < files["matches"].size(); ++i) {
    const Json &read = files["matches"][i], &drawn = scene["matches"][i];
    INFO("match " << i + 1);
    CHECK(read["left"] == drawn["left"]);
    CHECK(read["state"] == drawn["state"]);
    // The reader makes R a rotation again, and c from t, which costs some roundings.
    if (drawn["state"] == "in front of both cameras")
      CHECK(distance(read["point"], drawn["point"]) < 1e-9);
  }
  // A tenth of the matches is wrong; few of them are near their epipolar line by chance.
  CHECK(scene["residuals_above_3_sigma"] >= 4);
  CHECK(scene["residuals_above_3_sigma"] <= 8);
}

TEST_CASE("the optimal method has the least residuals, and each method says its covariance") {
  const WorkingDirectory here;
  const std::string noisy = kPair + "--noise 1 --count 100 ";
  const Json best = points_of(here, noisy + "--method optimal");
  CHECK(best["covariance"] == "sigma^2 (J^T J)^-1");
  const auto residual = [](const Json& match) {
    return std::hypot(match["reprojection_px"][0].get<double>(),
                      match["reprojection_px"][1].get<double>());
  };
  for (const char* method : {"midpoint", "linear"}) {
    const Json other = points_of(here, noisy + "--method " + method);
    CHECK(other["covariance"].get<std::string>().starts_with("sigma^2 B B^T"));
    double sum = 0, least = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      const double found = residual(other["matches"][i]), known = residual(best["matches"][i]);
      CHECK(found >= known * (1 - 1e-6) - 1e-9);
      sum += found;
      least += known;
    }
    CHECK(sum > least);
  }
}

TEST_CASE("points that are nowhere to be seen are named, counted and left out of the PLY file") {
  const WorkingDirectory here;
  here.write("c.txt", kSideBySide);
  here.write("m.csv",
             "60 40 50 40\n"    // in front
             "50 40 60 40\n"    // behind both
             "60 40 60 40\n"    // at infinity
             "60 40 59.5 40\n"  // nearly parallel
             "60 40 60.5 40\n"  // nearly parallel, and behind
             "70 50 40 50\n");  // in front
  const std::string files = "--matches m.csv --cameras c.txt --sigma 0.5 ";
  const Outcome outcome = here.run("views triangulate " + files + "--points-out p.ply --match 3");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string text = unwrapped(outcome.out);
  CHECK(contains(text,
                 "points 2 in front of both cameras, 1 behind both cameras, 2 rays nearly "
                 "parallel (of these 1 behind a camera), 1 at infinity"));
  CHECK(contains(text, "behind a camera: the rays are closest where the camera does not look"));
  CHECK(contains(text, "match 3: at infinity"));
  CHECK(contains(text, "direction (0.0995037, 0, 0.995037)"));
  CHECK(contains(text, "p.ply: 2 of 6 matches"));
  const std::string ply = here.read("p.ply");
  CHECK(contains(ply, "element vertex 2\n"));
  CHECK_FALSE(contains(ply, "uchar red"));
  const std::vector<float> numbers = floats_after_header(ply);
  REQUIRE(numbers.size() == 6);
  const std::vector<double> expected{1, 0, 10, 2.0 / 3, 1.0 / 3, 10.0 / 3};
  for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(numbers[i] - expected[i]) < 1e-6);

  REQUIRE(here.run("views triangulate " + files + "--points-out p.csv").exit_code == 0);
  std::istringstream lines(here.read("p.csv"));
  std::string line;
  std::getline(lines, line);
  CHECK(line.starts_with("match,x_left,y_left,x_right,y_right,state,x,y,z,t_left,t_right,gap"));
  const auto fields = std::count(line.begin(), line.end(), ',');
  int rows = 0;
  for (; std::getline(lines, line); ++rows)
    CHECK(std::count(line.begin(), line.end(), ',') == fields);
  CHECK(rows == 6);
  const Json json = points_of(here, files);
  CHECK(json["matches"][2]["point"].is_null());
  CHECK(json["matches"][2]["t_left"].is_null());
  CHECK(json["matches"][1]["in_front_of"] == Json({{"left", false}, {"right", false}}));
  CHECK(json["nearly_parallel_and_behind"] == 1);
}

TEST_CASE("points have the colours of the left picture, where it is known") {
  const WorkingDirectory here;
  REQUIRE(here.run("views triangulate " + kPair + "--count 50 --points-out p.ply").exit_code == 0);
  const std::string ply = here.read("p.ply");
  CHECK(contains(ply, "element vertex 50\n"));
  CHECK(contains(ply, "property uchar red"));
  const std::string data = ply.substr(ply.find("end_header\n") + 11);
  CHECK(data.size() == 50 * (3 * 4 + 3));
  // The room has more than one colour.
  std::set<std::string> colors;
  for (std::size_t at = 12; at < data.size(); at += 15) colors.insert(data.substr(at, 3));
  CHECK(colors.size() > 5);
}

TEST_CASE("the text is 100 columns wide, and its table as long as asked for") {
  const WorkingDirectory here;
  const std::string words = "views triangulate " + kPair + "--noise 0.7 --outliers 0.3 --match 7 ";
  const Outcome outcome = here.run(words);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(line.size() <= 100);
  }
  CHECK(contains(outcome.out, "(490 more;"));
  CHECK(contains(outcome.out, "\nmatch 7: "));
  CHECK(contains(here.run(words + "--rows 3").out, "(497 more;"));
  CHECK_FALSE(contains(here.run(words + "--rows 500").out, "more;"));
  CHECK(here.run(words).out == outcome.out);
}

TEST_CASE("the page has the report, the first matches, and the line that makes it") {
  const WorkingDirectory here;
  const std::string words = kPair + "--noise 0.5 --count 30";
  const Outcome outcome = here.run("views triangulate " + words + " --html page.html");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "page.html: open it in a browser"));
  const std::string page = here.read("page.html");
  CHECK(page.find("content=\"default-src 'none'; img-src data:;") != std::string::npos);
  CHECK(page.find("https:") == std::string::npos);
  const Json manifest = manifest_of(page), json = points_of(here, words);
  for (const char* name : {"cameras", "matches", "counts", "medians", "method"})
    CHECK(manifest[name] == json[name]);
  CHECK(manifest["all_matches"] == 30);
  CHECK(contains(manifest["command"].get<std::string>(), "views triangulate"));
  CHECK(contains(manifest["command"].get<std::string>(), "--noise 0.5"));
}

TEST_CASE("cameras in one place, no match and impossible numbers are refused in one line") {
  const WorkingDirectory here;
  here.write("c.txt", kSideBySide);
  here.write("m.csv", "60 40 50 40\n");
  here.write("empty.csv", "");
  here.write("heading.csv", "x_left,y_left,x_right,y_right\n");
  here.write("nan.csv", "60 40 50 40\nnan 1 2 3\n");
  here.write("nan2.csv", "60 40 nan 40\n");
  here.write("huge.csv", "60 40 50 40\n1e300 1 2 3\n");
  here.write("three.csv", "60 40 50\n");
  std::string same = kSideBySide;
  same.replace(same.rfind("-1 0 0"), 2, "0");
  here.write("same.txt", same);
  here.write("one.txt", "1\na 100 0 50 0 100 40 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n");
  std::string far = kSideBySide;
  here.write("far.txt", far.replace(far.rfind("-1 0 0"), 2, "-1e300"));
  std::string focal = kSideBySide;
  here.write("focal.txt", focal.replace(focal.find("100"), 3, "1e-200"));
  const std::vector<std::string> before = here.names();
  struct Case {
    std::string words, cause;
  };
  for (const auto& [words, cause] : std::vector<Case>{
           {"", "matching points"},
           {"--matches m.csv", "--cameras: without the cameras there are no rays"},
           {"--cameras c.txt", "matching points"},
           {"--matches empty.csv --cameras c.txt", "empty.csv: the matches: there are none"},
           {"--matches heading.csv --cameras c.txt", "heading.csv: the matches: there are none"},
           {"--matches nan.csv --cameras c.txt", "nan.csv: line 2"},
           {"--matches nan2.csv --cameras c.txt", "nan2.csv: line 1: 'nan' is not a finite"},
           {"--matches huge.csv --cameras c.txt", "huge.csv: match 2: 1e+300 px is not possible"},
           {"--matches three.csv --cameras c.txt", "three.csv: line 1: a match needs 4 numbers"},
           {"--matches nowhere.csv --cameras c.txt", "nowhere.csv"},
           {"--matches m.csv --cameras m.csv", "m.csv: line 1"},
           {"--matches m.csv --cameras same.txt", "same.txt: the cameras: both are in one place"},
           {"--matches m.csv --cameras one.txt", "it has 1 cameras"},
           {"--matches m.csv --cameras far.txt", "far.txt: the right camera: its centre"},
           {"--matches m.csv --cameras focal.txt", "focal.txt: the left camera: its matrix K"},
           {"--matches m.csv --cameras c.txt --match 2", "there is no match 2"},
           {"--matches m.csv --cameras c.txt --match 0", "there is no match 0"},
           {"--matches m.csv --cameras c.txt --sigma 0", "--sigma"},
           {"--matches m.csv --cameras c.txt --sigma nan", "--sigma"},
           {"--matches m.csv --cameras c.txt --method best", "midpoint|linear|optimal"},
           {"--matches m.csv --cameras c.txt --rows -1", "--rows"},
           {"--matches m.csv --cameras c.txt --size 64x64", "--size"},
           {"--matches m.csv --cameras c.txt --noise 1", "--noise"},
           {"--matches m.csv --cameras c.txt --points-out p.obj", ".ply"},
           {"--matches m.csv --cameras c.txt --points-out m.csv", "m.csv: is an input file"},
           {"--matches m.csv --cameras c.txt --points-out no/p.ply", "directory"},
           {"--matches m.csv --cameras c.txt --html p.txt", ".html"},
           {"--scene room --matches m.csv", "given as files too"},
           {"--scene room --size 64x48 --eye-separation 0", "both are in one place"},
           {"--scene room --size 64x48 --turn 3,0,0", "both are in one place"},
           {"--scene room --ortho 3", "no centre"}}) {
    INFO(words);
    check_refused(here.run("views triangulate " + words), {cause});
  }
  CHECK(here.names() == before);
}

TEST_CASE("the help has an example, and the example runs") {
  const WorkingDirectory here;
  const std::string help = here.run("views triangulate --help").out;
  CHECK(contains(help, "glassbox views triangulate --scene room --eye-separation 0.3 --noise 0.5"));
  CHECK(here.run("views triangulate --scene room --size 160x120 --eye-separation 0.3 --noise 0.5")
            .exit_code == 0);
}

}  // namespace glassbox::test
