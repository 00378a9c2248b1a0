// Tests glassbox views klt: it reads bands, writes components and a globe, and refuses wrong
// requests.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json klt_answer(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views klt " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("the generated planet's bands come back from files, and its clouds go round a globe") {
  const WorkingDirectory here;
  const Json made =
      klt_answer(here, "clouds:128 --components 2 -o klt --globe globe.glb --html klt.html");
  CHECK(made["holds"] == true);
  CHECK(made["bands"].size() == 5);
  CHECK(made["kept"] == 2);
  CHECK(made["clouds"]["component"] > made["clouds"]["best_band"]);
  CHECK(here.read("klt.html").find("id=\"component4\"") != std::string::npos);
  CHECK(here.run("render globe.glb --size 64x64 -o globe.png").exit_code == 0);
  std::string bands;
  for (int b = 1; b <= 5; ++b) bands += "klt/band" + std::to_string(b) + ".png ";
  const Json read = klt_answer(here, bands + "--components 2");
  CHECK(read["components"] == made["components"]);
  CHECK(read["mse"] == made["mse"]);
  // Components are uncorrelated, so that their own principal axes are the coordinate axes.
  const Json again = klt_answer(here, "klt/components.hdr");
  CHECK(again["components"][0]["vector"][0] == Approx(1));
  CHECK(again["trace"].get<double>() ==
        Approx(made["trace"].get<double>() - made["dropped"].get<double>()));
  // Bands that are made from two components have only two components.
  CHECK(klt_answer(here, "klt/again.hdr --components 2")["dropped"] < 1e-6);
}

TEST_CASE("components of one eigenvalue are said to be a space") {
  const WorkingDirectory here;
  // Every pair of 0 and 1 occurs once.
  here.write("a.pgm", std::string("P5\n4 1\n255\n") + std::string("\0\1\0\1", 4));
  here.write("b.pgm", std::string("P5\n4 1\n255\n") + std::string("\0\0\1\1", 4));
  const Outcome outcome = here.run("views klt a.pgm b.pgm");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("only the space that they span") != std::string::npos);
  CHECK(outcome.out.find("the reconstruction equals the bands, except for rounding") !=
        std::string::npos);
}

TEST_CASE("bands that cannot be taken apart are refused in a line, and no file is left") {
  const WorkingDirectory here;
  here.write("one.pgm", "P5\n1 1\n255\nx");
  here.write("two.pgm", "P5\n2 1\n255\nxy");
  here.write("bad.hdr", "ENVI\nsamples = 2\n");
  here.write("short.pgm", "P5\n20 10\n255\nxy");
  here.write("huge.pgm", "P5\n99999 99999\n255\nxy");
  here.write("text.png", "no picture");
  // Two floats, the second one a NaN; and a cube that would fill the memory.
  here.write("nan.hdr", "ENVI\nsamples = 2\nlines = 1\nbands = 1\ndata type = 4\n");
  here.write("nan.img", std::string("\0\0\x80\x3f\0\0\xc0\x7f", 8));
  here.write("huge.hdr", "ENVI\nsamples = 16384\nlines = 16384\nbands = 512\ndata type = 5\n");
  here.write("huge.img", "xy");
  std::filesystem::create_directory(here.file("folder"));
  for (const char* words : {"nothing.png",
                            "one.pgm",
                            "one.pgm two.pgm",
                            "bad.hdr",
                            "clouds:15",
                            "clouds:17",
                            "clouds:x",
                            "clouds two.pgm",
                            "clouds:64 --components 0",
                            "clouds:64 --components 6",
                            "two.pgm --components 2",
                            "clouds:64 --globe a.obj",
                            "clouds:64 --html a.txt",
                            "clouds:64 --globe nowhere/a.glb",
                            "two.pgm --max-mb 0",
                            "clouds:2048 --html a.html",
                            "clouds:4096 --max-mb 100",
                            "folder",
                            "short.pgm",
                            "huge.pgm",
                            "text.png",
                            "nan.hdr",
                            "huge.hdr",
                            "two.pgm --html nowhere/a.html",
                            "two.pgm --html folder",
                            "two.pgm --json folder",
                            "two.pgm two.pgm --components -1"}) {
    INFO(words);
    const Outcome outcome = here.run(std::string("views klt ") + words + " -o out");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(here.file("out")));
  }
  // The given folder is a file.
  const Outcome outcome = here.run("views klt two.pgm -o one.pgm");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("one.pgm: is not a folder") != std::string::npos);
  // 4096 x 2048 doubles are 64 MB. Five bands, two components and again five bands are 768 MB.
  CHECK(here.run("views klt clouds:4096 --max-mb 767").err.find("--max-mb 769") !=
        std::string::npos);
}

TEST_CASE("no output of klt is an input or another output") {
  const WorkingDirectory here;
  klt_answer(here, "clouds:32 -o ki");
  const std::string before = here.read("ki/components.img");
  for (const char* words : {"ki/components.hdr -o ki --components 1",
                            "ki/components.hdr -o ./ki/../ki", "ki/again.hdr -o ki",
                            "ki/component1.png -o ki", "ki/component1.png --json ki/component1.png",
                            "ki/components.hdr -o out --json ki/components.img"}) {
    const Outcome outcome = here.run(std::string("views klt ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("is an input file, which would be overwritten") != std::string::npos);
  }
  CHECK(here.read("ki/components.img") == before);
  const Outcome twice = here.run("views klt clouds:32 -o ki --json ki/band1.png");
  CHECK(twice.exit_code == 2);
  CHECK(twice.err.find("two outputs would go to this file") != std::string::npos);
}

TEST_CASE("one band, and bands that do not vary, have components") {
  const WorkingDirectory here;
  here.write("two.pgm", "P5\n2 1\n255\nxy");
  here.write("flat.pgm", "P5\n2 1\n255\nxx");
  const Json one = klt_answer(here, "two.pgm");
  CHECK(one["kept"] == 1);
  CHECK(one["components"][0]["eigenvalue"] == 0.25);
  const Json flat = klt_answer(here, "flat.pgm flat.pgm -o out --globe a.glb --html a.html");
  CHECK(flat["trace"] == 0);
  CHECK(flat["holds"] == true);
  CHECK(flat["components"][0]["share"] == 0);
}

}  // namespace glassbox::test
