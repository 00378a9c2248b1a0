// Tests glassbox views geometry --pair without --matches: what it finds in drawn pictures whose
// cameras are known, and what it says of pictures in which nothing can be found.
#include "tests/support/catch.h"

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

// Draws a pair to a.png and b.png, and writes its cameras to c.txt.
void draw_pair(const WorkingDirectory& here) {
  const Outcome outcome = here.run(
      "views geometry --scene room --size 480x360 --move 0.4,0.1,0.1 --turn -8,2,6 --pair-out "
      "a.png b.png --cameras-out c.txt --json pair.json");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
}

Json found_in(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views geometry --pair " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

// A plain PGM whose pixels are grey(x, y).
template <class Grey>
std::string pgm(int width, int height, const Grey& grey) {
  std::ostringstream text;
  text << "P2 " << width << ' ' << height << " 255\n";
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) text << grey(x, y) << '\n';
  }
  return text.str();
}

}  // namespace

TEST_CASE("corners of two drawn pictures give their cameras, with every detector and descriptor") {
  const WorkingDirectory here;
  draw_pair(here);
  for (const std::string& words :
       {std::string(), std::string("--detect shi-tomasi"), std::string("--describe orb"),
        std::string("--describe ncc"), std::string("--detect shi-tomasi --describe orb")}) {
    INFO(words);
    const Json json = found_in(here, "a.png b.png --cameras c.txt " + words);
    CHECK(json["estimator"] == "5-point");
    // Half of the right matches are on one wall, but the others agree with the cameras as well.
    CHECK(json["pair_is"]["kind"] == "general");
    CHECK(json["found"]["corners_left"].get<int>() > 200);
    CHECK(json["matches"].size() > 50);
    CHECK(json["inliers"].get<int>() > 0.4 * double(json["matches"].size()));
    // The floor and the walls repeat themselves, so that up to six in ten matches are wrong.
    // Corners are half a pixel off, and those of coarse scales two: with a focal length of 346 px
    // the latter is a third of a degree. The baseline is a tenth of the distance, so the direction
    // of T is some ten times as uncertain.
    CHECK(json["truth"]["rotation_error_degrees"] < 0.5);
    CHECK(json["truth"]["direction_error_degrees"] < 4);
    for (const Json& match : json["matches"]) {
      CHECK(match["ratio"] <= 0.8);
      CHECK(match["distance"] >= 0);
      CHECK(match["left"][0] > 0);
      CHECK(match["left"][0] < 480);
    }
  }
}

TEST_CASE("matches that were found are written as --matches reads them") {
  const WorkingDirectory here;
  draw_pair(here);
  const Json found = found_in(here, "a.png b.png --matches-out m.csv");
  CHECK(found["E"].is_null());
  const Json read = found_in(here, "a.png b.png --matches m.csv");
  CHECK(read["F"] == found["F"]);
  CHECK(read["inliers"] == found["inliers"]);
  CHECK_FALSE(read.contains("found"));
  const Outcome printed = here.run("views geometry --pair a.png b.png --matches-out -");
  CHECK(printed.out == here.read("m.csv"));
}

TEST_CASE("the ratio test, the cross check and the window can be changed") {
  const WorkingDirectory here;
  draw_pair(here);
  const auto matches = [&](const std::string& words) {
    return found_in(here, "a.png b.png " + words)["matches"];
  };
  const std::size_t usual = matches("").size();
  CHECK(matches("--ratio 0.6").size() < usual);
  CHECK(matches("--ratio 1").size() > usual);
  CHECK(matches("--ratio 1 --no-cross-check").size() > matches("--ratio 1").size());
  CHECK(matches("--features 300").size() < usual);
  for (const Json& match : matches("--search 20")) {
    CHECK(std::abs(match["left"][0].get<double>() - match["right"][0].get<double>()) <= 20);
    CHECK(std::abs(match["left"][1].get<double>() - match["right"][1].get<double>()) <= 20);
  }
  CHECK(found_in(here, "a.png b.png --describe ncc")["found"]["search_px"] == 120);
  CHECK(found_in(here, "a.png b.png")["found"]["search_px"].is_null());
}

TEST_CASE("the text and the page say how many corners and matches there are, and how") {
  const WorkingDirectory here;
  draw_pair(here);
  const Outcome outcome =
      here.run("views geometry --pair a.png b.png --features 500 --html p.html");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  for (const char* words : {"a.png and b.png, 480 x 360\n", "in the left picture, ", "(harris)",
                            "sift, at most 0.8 times as far as the second nearest", "inliers"}) {
    CHECK(contains(unwrapped(outcome.out) + outcome.out, words));
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  const Json manifest = manifest_of(here.read("p.html"));
  CHECK(manifest["found"]["detector"] == "harris");
  CHECK(manifest["command"] ==
        "glassbox views geometry --pair a.png b.png --features 500 --draw p.html");
}

TEST_CASE("a picture and itself are from one point of view") {
  const WorkingDirectory here;
  draw_pair(here);
  const Json json = found_in(here, "a.png a.png");
  CHECK(json["pair_is"]["kind"] == "one point of view");
  CHECK(json["F"].is_null());
  CHECK(json["matches"].size() > 50);
  for (const Json& match : json["matches"]) CHECK(match["left"] == match["right"]);
}

TEST_CASE("pictures in which nothing can be found are refused in one line") {
  const WorkingDirectory here;
  draw_pair(here);
  const auto flat = [](int, int) { return 128; };
  const auto ramp = [](int x, int y) { return (x + y) / 2; };
  const auto dot = [](int x, int y) { return x / 8 == 5 && y / 8 == 5 ? 255 : 0; };
  here.write("flat.pgm", pgm(100, 80, flat));
  here.write("ramp.pgm", pgm(100, 80, ramp));
  here.write("dot.pgm", pgm(100, 80, dot));
  here.write("one.pgm", pgm(1, 1, flat));
  here.write("row.pgm", pgm(300, 2, ramp));
  here.write("clear.pam",
             "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n" +
                 std::string(4, '\1'));
  here.write("m.csv", "1 2 3 4\n");
  here.write("text.png", "no picture");
  const std::vector<std::string> before = here.names();
  struct Case {
    std::string words, cause;
  };
  for (const auto& [words, cause] : std::vector<Case>{
           {"--pair flat.pgm flat.pgm", "flat.pgm: has no corners: it shows one colour"},
           {"--pair ramp.pgm ramp.pgm", "ramp.pgm: has no corners"},
           {"--pair dot.pgm flat.pgm", "flat.pgm: has no corners"},
           {"--pair dot.pgm dot.pgm", "corners of the pictures, but 8 are needed"},
           {"--pair one.pgm one.pgm", "the pictures are 1 x 1, but a corner needs 33 x 33"},
           {"--pair row.pgm row.pgm", "the pictures are 300 x 2"},
           {"--pair a.png flat.pgm", "unequal sizes, 480 x 360 and 100 x 80"},
           {"--pair clear.pam clear.pam", "transparent pixels"},
           {"--pair a.png text.png", "text.png"},
           {"--pair a.png nowhere.png", "nowhere.png"},
           {"--pair a.png", "--pair"},
           {"--pair a.png b.png --features 7", "7 corners are too few"},
           {"--pair a.png b.png --features 10001", "10001 corners are too many"},
           {"--pair a.png b.png --features -5", "--features"},
           {"--pair a.png b.png --ratio 0", "--ratio: 0 is not above 0"},
           {"--pair a.png b.png --ratio 1.5", "--ratio"},
           {"--pair a.png b.png --ratio nan", "--ratio"},
           {"--pair a.png b.png --search 0", "--search"},
           {"--pair a.png b.png --search inf", "--search"},
           {"--pair a.png b.png --detect fast", "harris|shi-tomasi"},
           {"--pair a.png b.png --describe surf", "ncc|orb|sift"},
           {"--pair a.png b.png --estimator 5", "matrices K are known"},
           {"--pair a.png b.png --pair-out c.png d.png", "--pair-out"},
           {"--pair a.png b.png --matches-out nowhere/m.csv", "nowhere"},
           {"--pair a.png b.png --matches m.csv --ratio 0.7", "--ratio: it is only for matches"},
           {"--pair a.png b.png --matches m.csv --matches-out n.csv", "in a file already"},
           {"--scene room --describe orb", "--describe: it is only for matches"},
           {"--cameras c.txt", "matching points"},
           {"--pair a.png b.png --ratio 0.01", "but 8 are needed"}}) {
    INFO(words);
    check_refused(here.run("views geometry " + words), {cause});
    CHECK(here.names() == before);
  }
}

}  // namespace glassbox::test
