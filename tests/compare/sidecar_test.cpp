// Tests reading the sidecar, the file NAME.fuzzy beside a reference.
#include "tests/support/catch.h"
#include "tests/support/contains.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/sidecar.h>

namespace glassbox::test {
namespace {

Sidecar parsed(const std::string& text) {
  const auto sidecar = parse_sidecar("golden/a.png.fuzzy", text);
  INFO(text << (sidecar ? "" : sidecar.error().message()));
  REQUIRE(sidecar);
  return *sidecar;
}

Error refused(const std::string& text) {
  const auto sidecar = parse_sidecar("golden/a.png.fuzzy", text);
  INFO(text);
  REQUIRE(!sidecar);
  CHECK(sidecar.error().file == "golden/a.png.fuzzy");
  CHECK(!sidecar.error().remedy.empty());
  return sidecar.error();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

TEST_CASE("every key of a sidecar is read") {
  const Sidecar sidecar = parsed(
      "# teapot\n"
      "\n"
      "fuzzy: maxDifference=0-1;totalPixels=0-4\n"
      "max-ulp: 3\n"
      "metric: psnr>40, rmse\n"
      "metric: flip.mean<0.05\n"
      "ignore: 1,2,3x4\n"
      "ignore: 5,6,7x8\n"
      "mask: masks/a.png\n"
      "reason: four pixels: ties\n");
  CHECK(sidecar.path == "golden/a.png.fuzzy");
  CHECK(sidecar.tolerance.fuzzy == Fuzzy{{0, 1}, {0, 4}});
  CHECK(sidecar.tolerance.max_ulp == 3u);
  REQUIRE(sidecar.metrics.size() == 3);
  CHECK(to_string(sidecar.metrics[0]) == "psnr>40");
  CHECK(to_string(sidecar.metrics[1]) == "rmse");
  CHECK(to_string(sidecar.metrics[2]) == "flip.mean<0.05");
  CHECK(sidecar.ignore == std::vector<PixelBox>{{1, 2, 3, 4}, {5, 6, 7, 8}});
  CHECK(sidecar.mask == "golden/masks/a.png");
  CHECK(sidecar.reason == "four pixels: ties");
}

TEST_CASE("a line without a key is the annotation") {
  const Sidecar sidecar = parsed("maxDifference=0-1;totalPixels=0-4\nreason: ties");
  CHECK(sidecar.tolerance.fuzzy == Fuzzy{{0, 1}, {0, 4}});
  CHECK(sidecar.reason == "ties");
}

TEST_CASE("blanks, comments, other line ends and a byte order mark do not matter") {
  for (const char* text :
       {"fuzzy: 1;2\nreason: why", "\r\n  fuzzy :  1 ; 2  \r\n\treason:\twhy \t\r\n",
        "# a: b\n   # reason: no\nfuzzy:1;2\n\n\nreason:why\n", "reason: why\nfuzzy: 1;2\n",
        "\xef\xbb\xbf"
        "fuzzy: 1;2\nreason: why\n"}) {
    const Sidecar sidecar = parsed(text);
    CHECK(sidecar.tolerance.fuzzy == Fuzzy{{1, 1}, {2, 2}});
    CHECK(sidecar.reason == "why");
  }
}

TEST_CASE("a mask may be anywhere if its path is absolute") {
  CHECK(parsed("mask: /masks/a.png\nreason: why").mask == "/masks/a.png");
}

TEST_CASE("a sidecar without a reason is refused") {
  for (const char* text : {"", "# reason: none\n", "fuzzy: 1;2\n", "fuzzy: 1;2\nreason:\n",
                           "fuzzy: 1;2\nreason:   \n"}) {
    CHECK(contains(refused(text).message(), "reason"));
  }
}

TEST_CASE("a line that is not understood is refused with its number") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"reason: why\nfuzy: 1;2\n", {"line 2", "'fuzy'", "max-ulp"}},
      {"reason: why\n\n# comment\nFuzzy: 1;2\n", {"line 4", "'Fuzzy'"}},
      {"reason: why\nfuzzy: 1\n", {"line 2", "not a tolerance"}},
      {"reason: why\n0-1\n", {"line 2", "not a tolerance"}},
      {"max-ulp: -1\nreason: why\n", {"line 1", "ulps"}},
      {"metric: psrn>40\nreason: why\n", {"line 1", "psrn"}},
      {"metric: psnr<40\nreason: why\n", {"line 1"}},
      {"metric:\nreason: why\n", {"line 1"}},
      {"ignore: 1,2\nreason: why\n", {"line 1", "box"}},
      {"mask:\nreason: why\n", {"line 1", "mask"}},
      {": 1;2\nreason: why\n", {"line 1", "unknown key"}},
      {"just words\nreason: why\n", {"line 1"}},
      {"\xff\xfe\x00\nreason: why\n", {"line 1"}}};
  for (const auto& [text, parts] : cases) {
    const std::string message = refused(text).message();
    for (const std::string& part : parts) {
      INFO(message << "\nexpected: " << part);
      CHECK(contains(message, part));
    }
  }
}

TEST_CASE("what can be said once only is refused the second time") {
  for (const char* text :
       {"fuzzy: 0-1;0-4\n0-9;0-9\nreason: why", "max-ulp: 1\nmax-ulp: 9\nreason: why",
        "mask: a.png\nmask: b.png\nreason: why", "reason: why\nreason: why else"}) {
    const Error error = refused(text);
    CHECK(error.place == "line 2");
    CHECK(contains(error.cause, "twice"));
  }
}

TEST_CASE("hostile text is shown without what a terminal would obey") {
  const std::string message = refused("\x1b[2J\x07: 1\nreason: why\n").message();
  CHECK(message.find_first_of("\x1b\x07") == std::string::npos);
  const Sidecar sidecar = parsed("reason: a\x1b[31mb\x01\n");
  CHECK(sidecar.reason.find_first_of("\x1b\x01") == std::string::npos);
  CHECK(parsed("reason: " + std::string(60000, 'x')).reason.size() < 1100);
}

TEST_CASE("a sidecar has the reference's name, with or without its extension") {
  const TemporaryDirectory here;
  const auto none = find_sidecar(here.file("a.png"));
  REQUIRE(none);
  CHECK(!none->has_value());

  write(here.file("a.png.fuzzy"), "1;2\nreason: full\n");
  write(here.file("b.fuzzy"), "1;2\nreason: stem\n");
  const auto full = find_sidecar(here.file("a.png"));
  REQUIRE(full);
  REQUIRE(full->has_value());
  CHECK((*full)->reason == "full");
  CHECK((*full)->path == here.file("a.png.fuzzy"));
  const auto stem = find_sidecar(here.file("b.png"));
  REQUIRE(stem);
  REQUIRE(stem->has_value());
  CHECK((*stem)->reason == "stem");

  write(here.file("a.fuzzy"), "1;2\nreason: stem\n");
  const auto both = find_sidecar(here.file("a.png"));
  REQUIRE(!both);
  CHECK(both.error().file == here.file("a.png.fuzzy"));
  CHECK(contains(both.error().message(), "keep one of the two"));
}

TEST_CASE("a sidecar that cannot be read is an error and not none") {
  const TemporaryDirectory here;
  write(here.file("large.png.fuzzy"), "reason: why\n#" + std::string(70000, '-'));
  const auto large = find_sidecar(here.file("large.png"));
  REQUIRE(!large);
  CHECK(contains(large.error().message(), "65536"));

  std::filesystem::create_directory(here.file("folder.png.fuzzy"));
  CHECK(!find_sidecar(here.file("folder.png")));

  write(here.file("broken.png.fuzzy"), "fuzzy: 1;2\n");
  const auto broken = find_sidecar(here.file("broken.png"));
  REQUIRE(!broken);
  CHECK(contains(broken.error().message(), "has no reason"));
}

}  // namespace
}  // namespace glassbox::test
