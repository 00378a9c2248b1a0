// Tests glassbox views match: with a scene whose disparities are known, with the pictures that
// render draws, and with requests that it refuses.
#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

const std::string kPair = "--scene room --size 320x240 --eye-separation 0.2 ";

void write_pgm(const WorkingDirectory& here, const std::string& name, int width, int height) {
  const std::string size = std::to_string(width) + " " + std::to_string(height);
  here.write(
      name, "P5\n" + size + "\n255\n" + std::string(std::size_t(width) * std::size_t(height), '7'));
}

// Returns a PNG of 2 x 2 pixels, one of them half transparent.
std::string clear_png() {
  Image<Rgba8> image(2, 2, {10, 20, 30, 255});
  image.at(1, 1).a = 128;
  const auto bytes = encode_png(image);
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

// For each pixel, whether it is joined to its eight neighbours in the surface: their disparities
// differ by at most one pixel.
using PixelMask = std::vector<bool>;
PixelMask far_from_jumps(const Plane& disparity) {
  PixelMask away(disparity.values.size(), false);
  for (int y = 1; y + 1 < disparity.height; ++y) {
    for (int x = 1; x + 1 < disparity.width; ++x) {
      float least = disparity.at(x, y), greatest = least;
      for (int i = 0; i < 9; ++i) {
        const float one = disparity.at(x + i % 3 - 1, y + i / 3 - 1);
        least = std::min(least, one), greatest = std::max(greatest, one);
      }
      away[std::size_t(y * disparity.width + x)] = greatest - least <= 1;
    }
  }
  return away;
}

// Returns how many pixels, in per cent of all, differ by more than `codes` in some channel between
// two pictures of one size. With `of`, only those pixels count.
double differing(const std::string& a, const std::string& b, int codes,
                 const PixelMask* of = nullptr) {
  const auto first = read_image(a), second = read_image(b);
  REQUIRE(first);
  REQUIRE(second);
  REQUIRE(first->pixels.size() == second->pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < first->pixels.size(); ++i) {
    if (of && !(*of)[i]) continue;
    const Rgba8 &p = first->pixels[i], &q = second->pixels[i];
    count += std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) > codes;
  }
  return 100 * double(count) / double(first->pixels.size());
}

// Returns the median over a square of 20 x 20 pixels in the middle. It is infinite if half of them
// have no depth.
double median_in_the_middle(const Plane& depth) {
  std::vector<float> middle;
  for (int y = depth.height / 2 - 10; y < depth.height / 2 + 10; ++y) {
    for (int x = depth.width / 2 - 10; x < depth.width / 2 + 10; ++x) {
      middle.push_back(depth.at(x, y));
    }
  }
  std::ranges::nth_element(middle, middle.begin() + 200);
  return double(middle[200]);
}

// A replacement for OpenCV whose matcher of eight paths fails, and whose other matchers find the
// disparity 0 everywhere.
constexpr const char* kFailingOpenCv = R"py(
__version__ = "0.0"
class Zeros:
    def __init__(self, count): self.count = count
    def astype(self, kind): return self
    def tofile(self, name): open(name, "wb").write(bytes(2 * self.count))
class Matcher:
    def __init__(self, mode): self.mode = mode
    def compute(self, left, right):
        if self.mode == 1: raise ValueError("eight paths")
        return Zeros(left)
def StereoSGBM_create(mode, **more): return Matcher(mode)
def setNumThreads(count): pass
def imread(name):
    width, height = open(name, "rb").read(40).split()[1:3]
    return int(width) * int(height)
)py";

}  // namespace

TEST_CASE("the surface that views match writes is drawn again by render, as the left eye saw it") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views match " + kPair + "--ply room.ply -o d.pfm");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  // The last line that the command prints is a render command.
  const std::size_t at = outcome.out.find(" render room.ply");
  REQUIRE(at != std::string::npos);
  const std::string words = outcome.out.substr(at, outcome.out.find('\n', at) - at);
  const Outcome drawn = here.run(words + " --cull none");
  INFO(words << "\n" << drawn.err);
  REQUIRE(drawn.exit_code == 0);
  REQUIRE(here.run("render room --size 320x240 --eye-separation 0.2 --seen-by left -o left.png")
              .exit_code == 0);
  // A vertex is drawn at its pixel's centre with its colour, up to the snap and rounding of codes.
  // The pixels that differ are in the gaps at jumps, where triangles are left out, and at the
  // picture's edge.
  const PixelMask away = far_from_jumps(parse_pfm(here.read("d.pfm")));
  const double everywhere = differing(here.file("again.png"), here.file("left.png"), 2);
  const double elsewhere = differing(here.file("again.png"), here.file("left.png"), 2, &away);
  INFO(everywhere << " % of all pixels, " << elsewhere << " % away from jumps");
  CHECK(everywhere < 4);
  CHECK(elsewhere == 0);
}

TEST_CASE(
    "pictures that are not rectified are turned by their cameras, and what was lost is said") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry --scene room --size 320x240 --move 0.3,0.02,0.03 --turn -6,1,2 "
                   "--noise 0.2 --cameras-out c.txt --pair-out a.png b.png "
                   "--rectified-out ra.png rb.png --json g.json")
              .exit_code == 0);
  const auto geometry = nlohmann::json::parse(here.read("g.json"));
  CHECK(geometry["rectification"]["lost_percent"]["left"] > 0);
  CHECK(geometry["rectification"]["H_left"].size() == 3);
  const Outcome outcome = here.run(
      "views match a.png b.png --cameras c.txt --range -10,60 --rectified-out l.png r.png "
      "--depth-out d.pfm --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  // The unit is that of the world, which --cameras-out has: the baseline is |(0.3, 0.02, 0.03)|.
  CHECK(json["rectification"]["baseline"].get<double>() == Approx(0.30216).margin(1e-4));
  const Plane depth = parse_pfm(here.read("d.pfm"));
  REQUIRE(here.run("render room --size 320x240 --depth-out true.pfm -o t.png").exit_code == 0);
  // The left camera is the scene's. Rectification turns it by half of the right one's angle, three
  // degrees: the cosine reduces a depth by 0.14 %, and the middle moves by some pixels on the same
  // wall. A pixel of disparity is 1 in f B/Z, which is 4 % there: 5 % for both.
  const double turned = median_in_the_middle(depth);
  CHECK(std::abs(turned / median_in_the_middle(parse_pfm(here.read("true.pfm"))) - 1) < 0.05);
  // With the pictures and cameras exchanged, disparities are negative, and depths stay the same:
  // they are those in the other picture's middle, with the tolerance as above.
  std::istringstream cameras(here.read("c.txt"));
  std::string count, left, right;
  std::getline(cameras, count), std::getline(cameras, left), std::getline(cameras, right);
  here.write("exchanged.txt", count + "\n" + right + "\n" + left + "\n");
  REQUIRE(
      here.run("views match b.png a.png --cameras exchanged.txt --range -60,10 --depth-out e.pfm")
          .exit_code == 0);
  CHECK(std::abs(median_in_the_middle(parse_pfm(here.read("e.pfm"))) / turned - 1) < 0.05);
  CHECK(read_image(here.file("l.png"))->width == 320);
  for (const char* words :
       {"a.png b.png --cameras c.txt --truth d.pfm",
        "a.png b.png --cameras c.txt --calibration 1,1,0", "--scene room --cameras c.txt"}) {
    INFO(words);
    CHECK(here.run(std::string("views match ") + words).exit_code == 2);
  }
  // Without --pair there are no pictures to rectify.
  CHECK(here.run("views geometry --matches none.csv --rectified-out l.png r.png").exit_code == 2);
}

TEST_CASE("views match writes a page of its pair, with and without a truth") {
  const WorkingDirectory here;
  REQUIRE(here.run("views match --scene room --size 64x48 --eye-separation 0.2 --html a.html")
              .exit_code == 0);
  const std::string page = here.read("a.html");
  for (const char* id : {"disparity", "truth", "marks", "confidence", "sums", "manifest"}) {
    CHECK(page.find("id=\"" + std::string(id) + "\"") != std::string::npos);
  }
  REQUIRE(here.run("render cube --size 32x24 -o cube.png").exit_code == 0);
  REQUIRE(here.run("views match cube.png cube.png --range 0,9 --html b.html").exit_code == 0);
  CHECK(here.read("b.html").find("id=\"truth\"") == std::string::npos);
}

TEST_CASE("bench matches pairs beside OpenCV, or says that it is not there") {
  const WorkingDirectory here;
  const Outcome outcome =
      here.run("bench room --against opencv --size 64x48 --frames 1 --threads 1 --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& matchers = json["pairs"][0]["matchers"];
  if (json["peer"] == "") {
    CHECK(json["notes"][0].get<std::string>().starts_with("OpenCV is left out: "));
    CHECK(matchers.size() == 2);
  } else {
    CHECK(matchers.size() == 4);
  }
  for (const auto& one : matchers) CHECK(one["bad_percent"]["1"] <= 100);
  CHECK(here.run("bench room --against opencv --scaling pixels").exit_code == 2);
  CHECK(here.run("bench nothing.glb --against opencv --frames 1").exit_code == 2);
}

TEST_CASE("where OpenCV cannot match one pair it is asked for the next one") {
  const WorkingDirectory here;
  here.write("cv2.py", kFailingOpenCv);
  const Outcome outcome =
      here.run("bench room cube --against opencv --size 64x48 --frames 1 --threads 1 --json -");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  if (json["peer"] == "") SKIP_TEST("there is no /usr/bin/python3");
  REQUIRE(json["pairs"].size() == 2);
  for (const auto& pair : json["pairs"]) CHECK(pair["matchers"].size() == 3);
  REQUIRE(json["notes"].size() == 2);
  for (const char* scene : {"room", "cube"}) {
    const auto names_it = [&](const auto& note) {
      const std::string text = note.template get<std::string>();
      return text.starts_with("OpenCV, 8 paths did not match " + std::string(scene));
    };
    CHECK(std::ranges::any_of(json["notes"], names_it));
  }
}

TEST_CASE("eyes in one place are matched, and have no depth") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views match --scene cube --size 64x48 --eye-separation 0");
  INFO(outcome.out << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.find("median depth is") == std::string::npos);
  CHECK(outcome.out.find("depth: both eyes are in one place") != std::string::npos);
  for (const char* words : {"--depth-out d.pfm", "--ply s.ply"}) {
    const Outcome refused =
        here.run("views match --scene cube --size 64x48 --eye-separation 0 " + std::string(words));
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("--eye-separation: both eyes are in one place") != std::string::npos);
  }
  CHECK(here.names().empty());
}

TEST_CASE("a report advises nothing that the command refuses") {
  const WorkingDirectory here;
  REQUIRE(here.run("views geometry --scene room --size 64x48 --move 0.3,0.02,0.03 --turn -6,1,2 "
                   "--cameras-out c.txt --pair-out a.png b.png")
              .exit_code == 0);
  const Outcome turned = here.run("views match a.png b.png --cameras c.txt --range -10,30");
  const Outcome calibrated =
      here.run("views match a.png b.png --calibration 60,0.3,0 --range -10,30");
  REQUIRE(turned.exit_code == 0);
  REQUIRE(calibrated.exit_code == 0);
  // A true disparity map refers to the pictures before rectification. With a calibration, rows may
  // or may not be epipolar lines.
  CHECK(turned.out.find("--truth") == std::string::npos);
  CHECK(turned.out.find("epipolar lines") == std::string::npos);
  CHECK(calibrated.out.find("the check that corresponding points are on the same row") !=
        std::string::npos);
}

TEST_CASE(
    "views match finds the disparities of a scene's pair, the same for every target and threads "
    "(S2-04)") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("views match " + kPair + "-o disparity.pfm --json -");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["width"] == 320);
  // Among the pixels that both eyes see and that have texture, at most 1 % are off by more than a
  // pixel (docs/matching.md).
  const auto& textured = json["errors"]["visible_and_textured"];
  CHECK(textured["density_percent"] == 100);
  CHECK(textured["bad_percent"]["1"] < 1);
  const std::string disparity = here.read("disparity.pfm");
  for (const char* more : {"--target scalar", "--threads 1", "--threads 3"}) {
    REQUIRE(here.run("views match " + kPair + "-o again.pfm " + more).exit_code == 0);
    CHECK(here.read("again.pfm") == disparity);
  }
}

TEST_CASE("what views match cannot be asked is refused in a line, and no file is left") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 32x24 -o a.png").exit_code == 0);
  REQUIRE(here.run("render cube --size 24x32 -o other.png").exit_code == 0);
  write_pgm(here, "one.pgm", 1, 1);
  here.write("clear.png", clear_png());
  for (const char* words : {"a.png",
                            "a.png none.png",
                            "a.png other.png",
                            "one.pgm one.pgm",
                            "a.png a.png --range 5,2",
                            "a.png a.png --range 40,90",
                            "a.png a.png --range 0,1000000000",
                            "a.png a.png --cost-window 4",
                            "a.png a.png --paths 3",
                            "a.png a.png --max-mb 0",
                            "a.png a.png --truth other.png",
                            "a.png a.png --calibration 100,0,0 --depth-out d.pfm",
                            "a.png a.png --depth-out d.pfm",
                            "a.png a.png --scene cube",
                            "--scene nothing.glb",
                            "a.png a.png --method best",
                            "a.png a.png --planes 9",
                            "a.png a.png --ply d.pfm",
                            "a.png a.png --calibration 100,0,0 --ply s.ply",
                            "a.png a.png --calibration 1e-300,1e-300,1 --ply s.ply",
                            "a.png a.png --calibration 1e300,1e300,0 --depth-out d.pfm",
                            "a.png a.png --html page.txt",
                            "a.png a.png --rectified-out l.png r.png",
                            "a.png a.png --cameras none.txt",
                            "clear.png clear.png",
                            "a.png a.png --calibration 100,1,-1000 --ply s.ply"}) {
    const Outcome outcome = here.run(std::string("views match ") + words + " -o out.pfm");
    INFO(words << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("out.pfm")).good());
    CHECK_FALSE(std::ifstream(here.file("d.pfm")).good());
    CHECK_FALSE(std::ifstream(here.file("s.ply")).good());
  }
}

}  // namespace glassbox::test
