// Tests glassbox diff --html with its pictures in files beside the page.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/picture_file_kinds.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

// Folders ref and out with a picture that differs, one that is the same, and a new one, all too
// large to be whole in a page with files beside it.
class ThreePairs {
public:
  ThreePairs() {
    fs::create_directories(here.file("ref"));
    fs::create_directories(here.file("out"));
    StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}}, 200, 100);
    for (const char* name : {"ref/changed.png", "ref/same.png", "out/same.png", "out/new.png"}) {
      here.write(name, png_of(image));
    }
    set_sample(image, 3, 3, 0, sample_at(image, 3, 3, 0) + 1);
    here.write("out/changed.png", png_of(image));
  }
  Outcome diff(const std::string& options) const { return here.run("diff ref out " + options); }
  std::vector<std::string> files_in(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(here.file(folder))) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  WorkingDirectory here;
};

void check_refused_without_page(const ThreePairs& three, const std::string& options,
                                const std::string& part) {
  INFO(options);
  const Outcome outcome = three.diff(options);
  CHECK(outcome.exit_code == 2);
  INFO(outcome.err);
  CHECK(contains(outcome.err, part));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(!fs::exists(three.here.file("page.html")));
}

TEST_CASE("with --html-files, pairs with something to see have a file beside the page") {
  const ThreePairs three;
  CHECK(three.diff("--html page.html --html-files").exit_code == 2);
  CHECK(three.files_in("page-files") == std::vector<std::string>{"0001.js", "0002.js"});
  const std::string page = three.here.read("page.html");
  CHECK(contains(page, "page-files/0001.js"));
  CHECK(contains(page, "page-files/0002.js"));
  const std::string file = three.here.read("page-files/0001.js");

  // The same pictures give the same bytes.
  CHECK(three.diff("--html page.html --html-files").exit_code == 2);
  CHECK(three.here.read("page.html") == page);
  CHECK(three.here.read("page-files/0001.js") == file);
}

TEST_CASE("without --html-files, there is only the page") {
  const ThreePairs three;
  CHECK(three.diff("--html page.html").exit_code == 2);
  CHECK(!fs::exists(three.here.file("page-files")));
}

TEST_CASE("the folder beside the page replaces nothing that is not its own") {
  const ThreePairs three;
  check_refused_without_page(three, "--html-files", "--html");
  check_refused_without_page(three, "--html page.html/x.html --html-files", "page.html");
  fs::create_directories(three.here.file("page-files"));
  three.here.write("page-files/0001.js", "let own = 1;");
  check_refused_without_page(three, "--html page.html --html-files", "0001.js");
  CHECK(three.here.read("page-files/0001.js") == "let own = 1;");
  fs::remove_all(three.here.file("page-files"));
  three.here.write("page-files", "a file");
  check_refused_without_page(three, "--html page.html --html-files", "page-files");
}

TEST_CASE("a file that no page wrote stops everything, and the earlier page stays whole") {
  const ThreePairs three;
  REQUIRE(three.diff("--html page.html --html-files").exit_code == 2);
  const std::string page = three.here.read("page.html");
  const std::string first = three.here.read("page-files/0001.js");
  three.here.write("page-files/0002.js", "let own = 1;");
  StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}}, 200, 100);
  set_sample(image, 9, 9, 0, sample_at(image, 9, 9, 0) + 1);
  three.here.write("out/changed.png", png_of(image));
  const Outcome outcome = three.diff("--html page.html --html-files --json report.json");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "0002.js"));
  CHECK(three.here.read("page.html") == page);
  CHECK(three.here.read("page-files/0001.js") == first);
  CHECK(three.here.read("page-files/0002.js") == "let own = 1;");
  CHECK(!fs::exists(three.here.file("report.json")));
}

TEST_CASE("no other report has the name of the folder beside the page, or lies in it") {
  const ThreePairs three;
  for (const char* option : {"--json", "--junit", "--markdown"}) {
    check_refused_without_page(
        three, "--html page.html --html-files " + std::string(option) + " page-files",
        "page-files: two outputs would go to this file");
    CHECK(!fs::exists(three.here.file("page-files")));
  }
  fs::create_directory(three.here.file("page-files"));
  check_refused_without_page(three, "--html page.html --html-files --json page-files/0001.js",
                             "lies in the folder of the page's pictures");
  // The same folder is where the command runs.
  const Outcome inside = run_program(
      GLASSBOX_PROGRAM,
      {"diff", "../ref", "../out", "--html", "../page.html", "--html-files", "--json", "0001.js"},
      three.here.file("page-files"));
  CHECK(inside.exit_code == 2);
  CHECK(contains(inside.err, "lies in the folder of the page's pictures"));
  CHECK(three.files_in("page-files").empty());
}

TEST_CASE("the folder beside the page is not a folder that is compared") {
  const WorkingDirectory here;
  for (const char* folder : {"ref", "page-files"}) fs::create_directories(here.file(folder));
  here.write("ref/a.png", png_of(sample_picture({"", "", 3, Format::kBytes, {}})));
  for (const char* order : {"ref page-files", "page-files ref"}) {
    const Outcome outcome =
        here.run("diff " + std::string(order) + " --html page.html --html-files");
    INFO(order << "\n" << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "one of the directories to compare"));
  }
}

}  // namespace
}  // namespace glassbox::test
