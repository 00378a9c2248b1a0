// Tests masks, boxes, metrics, sidecars and wrong usage of glassbox diff.
#include "tests/support/catch.h"

#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/picture_file_kinds.h"

#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox::test {
namespace {

// The pictures a.png and b.png, which differ in the pixels (5, 5) and (20, 10), by 60 and 2 steps
// of green.
class TwoPixels {
public:
  TwoPixels() {
    StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
    for (const auto& [x, y] : {std::pair(5, 5), std::pair(20, 10)}) set_sample(image, x, y, 1, 100);
    here.write("a.png", png_of(image));
    set_sample(image, 5, 5, 1, 160);
    set_sample(image, 20, 10, 1, 102);
    here.write("b.png", png_of(image));
  }
  Outcome diff(const std::string& options = "") const {
    return here.run("diff a.png b.png " + options);
  }
  void write_mask(const std::string& name, std::vector<PixelPosition> black, int width = 24) const {
    StoredImage mask = blank(width, 18, 1, Format::kBytes);
    for (int y = 0; y < 18; ++y) {
      for (int x = 0; x < width; ++x) set_sample(mask, x, y, 0, 1);
    }
    for (const PixelPosition& at : black) set_sample(mask, at.x, at.y, 0, 0);
    here.write(name, png_of(mask));
  }
  WorkingDirectory here;
};

TEST_CASE("boxes and masks leave pixels out, alone and together") {
  const TwoPixels two;
  two.write_mask("both.png", {{5, 5}, {20, 10}});
  two.write_mask("one.png", {{5, 5}});
  two.write_mask("wide.png", {}, 25);
  CHECK(two.diff("--ignore 5,5,1x1").exit_code == 1);
  CHECK(two.diff("--ignore 5,5,1x1 --ignore 20,10,1x1").exit_code == 0);
  CHECK(two.diff("--ignore 20,10,100x100 --ignore -10,-10,16x16").exit_code == 0);
  CHECK(two.diff("--mask both.png").exit_code == 0);
  CHECK(two.diff("--mask one.png").exit_code == 1);
  CHECK(two.diff("--mask one.png --ignore 20,10,1x1").exit_code == 0);
  CHECK(contains(two.diff("--mask one.png").out, "1 of 431 pixels differ, by up to 2/255"));
  // Options may be given in any place, and repeatedly.
  CHECK(two.here
            .run("diff --ignore 5,5,1x1 a.png --ignore 20,10,1x1 b.png --metric rmse --metric psnr")
            .exit_code == 0);

  check_refused(two.diff("--mask wide.png"), {"wide.png", "25 x 18", "24 x 18"});
  check_refused(two.diff("--mask none.png"), {"none.png"});
  check_refused(two.diff("--ignore 24,0,1x1"), {"24,0,1x1", "outside"});
  check_refused(two.diff("--ignore 0,0,24x18"), {"there is nothing to compare"});
}

TEST_CASE("a metric is reported, and decides only with a limit") {
  const TwoPixels two;
  const Outcome reported = two.diff("--metric absmax,rmse,psnr --metric flip.mean");
  CHECK(reported.exit_code == 1);
  for (const char* name : {"  absmax: ", "  rmse: ", "  psnr: ", "  flip.mean: "}) {
    INFO(reported.out);
    CHECK(contains(reported.out, name));
  }
  // The values are 60/255, and sqrt((60^2 + 2^2) / (3 * 432)) / 255 = 0.0065396...
  CHECK(contains(reported.out, "absmax: 0.235294\n"));
  CHECK(two.diff("--metric rmse<0.00654").exit_code == 0);
  CHECK(two.diff("--metric rmse<0.00653").exit_code == 1);
  CHECK(two.diff("--metric absmax<=0.24,psnr>10").exit_code == 0);
  const Outcome one_fails = two.diff("--metric absmax<=0.24,psnr>100");
  CHECK(one_fails.exit_code == 1);
  CHECK(contains(one_fails.out, "psnr is "));
  CHECK(contains(one_fails.out, "not psnr>100"));
  // All requested limits have to hold.
  CHECK(two.diff("--metric absmax<=0.24 --fuzzy 0-60;0-2").exit_code == 0);
  CHECK(two.diff("--metric absmax<=0.24 --fuzzy 0-60;0-1").exit_code == 1);
  CHECK(two.diff("--metric absmax<=0.1 --fuzzy 0-60;0-2").exit_code == 1);
  CHECK(contains(two.here.run("diff a.png a.png --metric psnr").out, "psnr: inf"));
}

TEST_CASE(
    "a sidecar lets its picture pass, with its reason, and is called stale where it is too wide") {
  const TwoPixels two;
  two.here.write("a.png.fuzzy", "0-60;0-2\nreason: two ties\n");
  const Outcome exact = two.diff();
  INFO(exact.out);
  CHECK(exact.exit_code == 0);
  CHECK(contains(exact.out, "within tolerance"));
  CHECK(contains(exact.out, "tolerance: maxDifference=0-60;totalPixels=0-2"));
  CHECK(contains(exact.out, "because: two ties"));
  CHECK(!contains(exact.out, "stale"));

  two.here.write("a.png.fuzzy", "0-61;0-9\nreason: two ties\n");
  CHECK(contains(two.diff().out,
                 "note: stale: a.png.fuzzy allows more than is needed; enough is "
                 "maxDifference=0-60;totalPixels=0-2"));
  const Outcome same = two.here.run("diff a.png a.png");
  CHECK(same.exit_code == 0);
  CHECK(contains(same.out, "is not needed: delete the file"));

  const Outcome overruled = two.diff("--fuzzy 0-5;0-5");
  CHECK(overruled.exit_code == 1);
  CHECK(contains(overruled.out,
                 "note: the tolerance of a.png.fuzzy is not used, because another one is given"));

  two.here.write("a.png.fuzzy", "0-60;0-1\nreason: two ties\n");
  const Outcome failed = two.diff();
  CHECK(failed.exit_code == 1);
  CHECK(
      contains(failed.out,
               "maxDifference=60;totalPixels=2 is not within maxDifference=0-60;totalPixels=0-1"));

  two.here.write("a.png.fuzzy", "0-60;0-2\n");
  check_refused(two.diff(), {"a.png.fuzzy", "has no reason"});
  two.here.write("a.png.fuzzy", "reason: ties\nfuzzi: 0-60;0-2\n");
  check_refused(two.diff(), {"a.png.fuzzy", "line 2", "fuzzi"});
  std::filesystem::remove(two.here.file("a.png.fuzzy"));
  two.here.write("a.fuzzy", "ignore: 5,5,1x1\nignore: 20,10,1x1\nreason: clocks\n");
  CHECK(two.diff().exit_code == 0);
}

TEST_CASE("bad usage is one line that names the word, and 2") {
  const TwoPixels two;
  const auto before = two.here.names();
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"", {"REFERENCE"}},
      {"a.png", {"TEST"}},
      {"a.png b.png c.png", {"c.png"}},
      {"a.png b.png --nothing", {"--nothing"}},
      {"a.png b.png --fuzzy 1", {"--fuzzy", "'1'", "maxDifference="}},
      {"a.png b.png --fuzzy", {"--fuzzy"}},
      {"a.png b.png --max-ulp -1", {"--max-ulp"}},
      {"a.png b.png --max-ulp many", {"--max-ulp", "'many'"}},
      {"a.png b.png --metric psrn", {"--metric", "psrn", "psnr"}},
      {"a.png b.png --metric psnr<40", {"--metric", "psnr>40"}},
      {"a.png b.png --ignore 1,2,3", {"--ignore", "1,2,3"}},
      {"a.png b.png --heat warm", {"--heat", "warm", "steps|flip"}},
      {"a.png b.png --json - --junit -", {"--json", "--junit"}},
      {"a.png b.png --html -", {"--html"}},
      {"a.png b.png -o x.jpg", {"x.jpg", ".png or .ppm"}},
      {"a.png b.png --html nowhere/x.html", {"nowhere/x.html", "directory"}},
      {"a.png b.png --json x --junit ./x", {"two outputs"}},
      {"a.png nothing.png", {"nothing.png"}},
      {"nothing.png b.png", {"nothing.png"}},
      {"nothing.png neither.png", {"neither.png"}},
      {". b.png", {"b.png", "directory"}},
      {"a.png .", {"a.png", "directory"}},
      {"a.png nowhere/", {"nowhere/"}}};
  for (const auto& [words, parts] : cases) {
    INFO("glassbox diff " << words);
    check_refused(two.here.run("diff " + words), parts);
    CHECK(two.here.names() == before);
  }
}

TEST_CASE("a word with line breaks in it is refused on one line") {
  const TwoPixels two;
  for (const char* option : {"--fuzzy", "--max-ulp", "--ignore", "--metric", "--heat"}) {
    INFO(option);
    check_refused(run_program(GLASSBOX_PROGRAM, {"diff", "a.png", "b.png", option, "a\nb\x1b[2J"},
                              two.here.path()),
                  {option});
  }
}

TEST_CASE("an output never takes the place of an input") {
  const TwoPixels two;
  two.write_mask("mask.png", {});
  two.here.write("a.png.fuzzy", "0-60;0-2\nreason: ties\n");
  std::filesystem::create_symlink("b.png", two.here.file("link.png"));
  const std::string a = two.here.read("a.png"), b = two.here.read("b.png");
  const std::string mask = two.here.read("mask.png"), sidecar = two.here.read("a.png.fuzzy");
  for (const char* options :
       {"-o a.png", "-o b.png", "-o ./b.png", "-o link.png", "--html a.png", "--json b.png",
        "--junit a.png", "--mask mask.png -o mask.png", "--json a.png.fuzzy"}) {
    INFO(options);
    check_refused(two.diff(options), {"one of the files to read"});
  }
  CHECK(two.here.read("a.png") == a);
  CHECK(two.here.read("b.png") == b);
  CHECK(two.here.read("mask.png") == mask);
  CHECK(two.here.read("a.png.fuzzy") == sidecar);
}

}  // namespace
}  // namespace glassbox::test
