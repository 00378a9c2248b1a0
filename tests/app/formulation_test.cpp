// Tests --view-from, --projection and --cull-stage: the slides' other ways to the same picture, and
// what step and explain report about them.
#include <algorithm>
#include <string>
#include <vector>

#include <glassbox/images/read.h>
#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Image<Rgba8> picture_by_formulation(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("render " + words + " -o p.png");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return read_image(here.file("p.png")).value();
}

int differing_pixels(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += !(a.pixels[i] == b.pixels[i]);
  return count;
}

const std::vector<std::string> kForms{"--view-from axis-angle", "--projection frustum",
                                      "--projection t_pers", "--projection alpha_beta",
                                      "--view-from axis-angle --projection t_pers"};

TEST_CASE("every formulation draws the same picture but for a pixel in ten thousand (S3-14)") {
  const WorkingDirectory here;
  for (const char* scene : {"teapot", "room", "forest"}) {
    const std::string words = std::string(scene) + " --size 320x180 ";
    const Image<Rgba8> usual = picture_by_formulation(here, words);
    CHECK(differing_pixels(usual, picture_by_formulation(
                                      here, words + "--view-from uvn --projection perspective")) ==
          0);
    for (const std::string& form : kForms) {
      const int count = differing_pixels(usual, picture_by_formulation(here, words + form));
      INFO(scene << " " << form << ": " << count << " pixels");
      // A matrix entry that becomes a neighbouring float moves a vertex by 2^-24 of the picture's
      // width. That changes the snap of a coordinate only if it is this close to the border between
      // two snapped positions: with 10^4 vertices, about 10^4 * 2 * 320 * 256 * 2^-24, or 100,
      // coordinates change, each by 2^-8 of a pixel.
      CHECK(count <= 320 * 180 / 10000);
    }
  }
}

TEST_CASE("both engines draw a formulation alike, and the commands about pictures take it") {
  const WorkingDirectory here;
  for (const std::string& form : kForms) {
    const std::string words = "room --size 96x64 " + form;
    CHECK(differing_pixels(picture_by_formulation(here, words),
                           picture_by_formulation(here, words + " --engine staged")) == 0);
    CHECK(here.run("pixel " + words + " --at 40,30").exit_code == 0);
    CHECK(here.run("why " + words + " --triangle 3").exit_code == 0);
    CHECK(here.run("explain " + words).exit_code == 0);
  }
  const std::string eyes = "teapot --size 96x64 --stereo pair --projection alpha_beta";
  CHECK(differing_pixels(picture_by_formulation(here, eyes),
                         picture_by_formulation(here, eyes + " --engine staged")) == 0);
}

TEST_CASE("a formulation that the lens or the depth does not allow is refused in one line") {
  const WorkingDirectory here;
  for (const char* words :
       {"--projection t_pers --ortho 4", "--projection frustum --ortho 4",
        "--projection alpha_beta --depth d32r", "--projection t_pers --frustum -1,2,-1,1 --near 3",
        "--projection watt", "--view-from euler"}) {
    const Outcome outcome = here.run(std::string("render cube --size 8x8 ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE(
    "step shows the perspective matrix in two steps, and what a projection without depth loses") {
  const WorkingDirectory here;
  const std::string out = here.run("step cube --size 320x180 --triangle 10 --vertex 0").out;
  CHECK(contains(unwrapped(out), "makes the viewing pyramid regular"));
  CHECK(contains(out, "the pyramid becomes the box"));
  CHECK(contains(out, "their product is clip_from_eye, bit for bit"));
  CHECK(contains(out, "onto the view plane z = d = 3.02165292"));
  CHECK(contains(out, "z_s is d at every vertex"));
  CHECK(contains(out, "NDC's x and y"));
  CHECK_FALSE(contains(out, "is the same except for rounding"));

  const std::string parallel = here.run("step cube --size 320x180 --triangle 10 --ortho 4").out;
  CHECK(contains(parallel, "T_ort = diag(1, 1, 0, 1)"));
  CHECK(contains(parallel, "z is lost"));
  CHECK_FALSE(contains(parallel, "the pyramid becomes the box"));

  const std::string beside =
      here.run("step cube --triangle 10 --eye 0,0,5 --frustum -1,2,-1,1 --near 2").out;
  CHECK(contains(beside, "a shear centres it on the gaze"));
}

TEST_CASE(
    "step shows the factors of the formulation asked for, and how far it is from the usual one") {
  const WorkingDirectory here;
  const std::string start = "step cube --size 320x180 --triangle 10 --vertex 0 ";
  const std::string turned = here.run(start + "--view-from axis-angle").out;
  for (const char* part :
       {"T(-eye)", "R(a, theta): ", "R_z(roll): ", "their product has the same bits",
        "[U; V; N] T(-eye) is the same except for rounding"}) {
    INFO(part);
    CHECK(contains(turned, part));
  }
  const std::string watt = here.run(start + "--projection t_pers").out;
  CHECK(contains(watt, "the slides' T_pers"));
  CHECK(contains(
      watt, "the usual matrix of this lens is the same except for rounding: entries differ by up"));
  const std::string foley = here.run(start + "--projection alpha_beta").out;
  CHECK(contains(foley, "alpha = f/(f-n)"));
  const std::string window = here.run(start + "--projection frustum").out;
  CHECK(contains(window, "made as glFrustum"));
}

// ---- --cull-stage ----

TEST_CASE("culling in object space draws the same bytes, and says how many faces it found") {
  const WorkingDirectory here;
  for (const char* scene : {"teapot", "room", "forest"}) {
    const std::string words = std::string(scene) + " --size 160x90 ";
    const Image<Rgba8> usual = picture_by_formulation(here, words);
    for (const char* engine : {"tile", "staged"}) {
      CHECK(differing_pixels(usual, picture_by_formulation(
                                        here, words + "--cull-stage object --engine " + engine)) ==
            0);
    }
  }
  const Outcome outcome =
      here.run("render teapot --size 160x90 --cull back --cull-stage object --stats -o p.png");
  CHECK(contains(outcome.out, "cull in object space"));
  CHECK(contains(outcome.out, "turned away for certain"));
}

TEST_CASE("explain has the decision about culling in object space where it was asked for") {
  const WorkingDirectory here;
  const auto decision = [&](const std::string& words) -> Json {
    const Outcome outcome = here.run("explain teapot --size 96x64 --json - " + words);
    INFO(outcome.err);
    const Json draws = Json::parse(outcome.out).at("plan").at("draws");
    for (const Json& d : draws.at(0).at("decisions")) {
      if (d.at("stage") == "culling in object space") return d;
    }
    return {};
  };
  CHECK(decision("").is_null());
  const Json asked = decision("--cull-stage object --cull back");
  CHECK(asked.at("needed") == true);
  CHECK(contains(asked.at("because"), "decided by the snapped area"));
  CHECK(contains(asked.at("numbers"), "triangles"));
  const Json both = decision("--cull-stage object --cull none");
  CHECK(both.at("needed") == false);
  CHECK(contains(both.at("because"), "both sides"));
}

TEST_CASE("step says of a triangle whether it is culled before clipping, and by which number") {
  const WorkingDirectory here;
  const std::string start = "step cube --size 160x90 --cull back --cull-stage object --triangle ";
  int removed = 0, kept = 0;
  for (int i = 0; i < 12; ++i) {
    const std::string out = here.run(start + std::to_string(i)).out;
    CHECK(contains(out, "culling in object space, before clipping"));
    removed += contains(unwrapped(out), "the triangle is removed");
    kept += contains(unwrapped(out), "so the sign of the snapped area decides");
    // A triangle that is removed is one that is culled on the screen.
    CHECK(contains(unwrapped(out), "the triangle is removed") ==
          contains(unwrapped(out), "piece is culled"));
  }
  CHECK(removed == 6);
  CHECK(kept == 6);
  const std::string both_sides =
      "step cube --size 160x90 --cull none --cull-stage object --triangle 0";
  CHECK(contains(here.run(both_sides).out, "not culled in object space"));
}

}  // namespace
}  // namespace glassbox::test
