// Tests glassbox inspect: the contents of the page, and what is refused. How the page is used is
// tested by tests/browser/inspect_tests.mjs.
#include "tests/support/catch.h"

#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"
#include "tests/support/manifest.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

std::size_t rows_of(const Json& manifest, const std::string& column) {
  for (const Json& entry : manifest["columns"]) {
    if (entry[0] == column) return entry[2];
  }
  FAIL("no column " << column);
  return 0;
}

TEST_CASE("inspect writes one page that names nothing outside of itself") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("inspect teapot:4 --size 64x48 --pixel 32,24 -o page.html");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("page.html: ") == 0);
  CHECK(here.names() == std::vector<std::string>{"page.html"});
  const std::string page = here.read("page.html");
  for (const char* foreign : {"http://", "https://", "src=", "@import", "url("}) {
    INFO(foreign);
    CHECK(page.find(foreign) == std::string::npos);
  }
  CHECK(page.find("default-src 'none'") != std::string::npos);
}

TEST_CASE("the counts of the page are those of glassbox render") {
  const WorkingDirectory here;
  const Outcome rendered = here.run("render room --size 80x60 -o p.png --engine staged --json -");
  REQUIRE(rendered.exit_code == 0);
  REQUIRE(here.run("inspect room --size 80x60 -o p.html").exit_code == 0);
  const Json stages = Json::parse(rendered.out)["stages"], page = manifest_of(here.read("p.html"));
  for (const auto& [name, value] : stages.items()) {
    if (name != "ms") CHECK(page["stages"][name] == value);
  }
  CHECK(rows_of(page, "fragment.x") == stages["covered"]);
  CHECK(rows_of(page, "written.r") == stages["written"]);
  CHECK(rows_of(page, "triangle.number") ==
        std::size_t(stages["triangles"]) - std::size_t(stages["degenerate"]));
  CHECK(rows_of(page, "cut.number") == stages["clipped"]);
}

TEST_CASE("the page repeats its own command line") {
  const WorkingDirectory here;
  REQUIRE(
      here.run("inspect cube --size 40x30 --shade flat --rect 10,10,20,20 -o a.html").exit_code ==
      0);
  const std::string first = here.read("a.html");
  std::string command = manifest_of(first)["command"];
  REQUIRE(command.find("inspect cube --size 40x30 --shade flat") != std::string::npos);
  command = command.substr(command.find("inspect"));
  REQUIRE(here.run(command).exit_code == 0);
  Json again = manifest_of(here.read("a.html")), before = manifest_of(first);
  again["stages"].erase("ms");
  before["stages"].erase("ms");
  CHECK(again == before);
}

TEST_CASE("names in the scene are text, whatever is in them") {
  const WorkingDirectory here;
  here.write("a.obj", "o </script><script>alert(1)\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  REQUIRE(here.run("inspect a.obj --size 32x32 -o p.html").exit_code == 0);
  CHECK(here.read("p.html").find("alert(1)</script>") == std::string::npos);
  CHECK(here.read("p.html").find("</script><script>alert") == std::string::npos);
}

TEST_CASE("inspect refuses what it cannot show, says what to do, and writes nothing") {
  const WorkingDirectory here;
  const auto refuses = [&](const std::string& words, const std::string& reason) {
    const Outcome outcome = here.run("inspect " + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(reason) != std::string::npos);
    CHECK(here.names().empty());
  };
  const std::string small = "teapot:4 --size 64x48 -o p.html ";
  refuses(small + "--rect 0,0,65,1", "the picture has 64 x 48 pixels");
  refuses(small + "--rect 5,5,5,6", "X0 < X1 and Y0 < Y1");
  refuses(small + "--rect 5,5,6.5,6", "whole pixels");
  refuses(small + "--rect 5,5,6", "X0,Y0,X1,Y1");
  refuses(small + "--rect 0,0,9,9 --pixel 9,9", "outside --rect");
  refuses(small + "--max-triangles 10", "--rect X0,Y0,X1,Y1");
  refuses(small + "--max-fragments 10", "smaller --size");
  refuses("teapot:4 --size 64x48 -o p.png", ".html");
  refuses("teapot:4 --size 64x48 -o none/p.html", "none");
  refuses("nothing-here.glb -o p.html", "nothing-here.glb");
}

TEST_CASE("a rectangle makes a page of what would be too much") {
  const WorkingDirectory here;
  REQUIRE(here.run("inspect teapot --size 64x48 --max-triangles 900 --rect 30,20,34,24 -o p.html")
              .exit_code == 0);
  const Json page = manifest_of(here.read("p.html"));
  CHECK(rows_of(page, "triangle.number") <= 900);
  CHECK(rows_of(page, "fragment.x") > 0);
  CHECK(page["records_complete"] == true);
  CHECK(rows_of(page, "record.depth") == rows_of(page, "fragment.x"));
  CHECK(here.run("inspect teapot --size 64x48 --max-triangles 900 -o q.html").exit_code == 2);
}

}  // namespace
}  // namespace glassbox::test
