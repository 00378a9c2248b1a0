// Tests glassbox diff with directories of pictures, and approval.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/picture_file_kinds.h"
#include "tests/compare/environment.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

class TwoFolders {
public:
  TwoFolders() {
    for (const char* folder : {"ref/sub", "out/sub"}) fs::create_directories(here.file(folder));
  }
  // Adds the sample picture with `change` added to the red sample of pixel (3, 3).
  void add(const std::string& name, int change = 0) const {
    StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
    set_sample(image, 3, 3, 0, sample_at(image, 3, 3, 0) + change);
    here.write(name, png_of(image));
  }
  Outcome diff(const std::string& options = "") const {
    return here.run("diff ref out " + options);
  }
  bool exists(const std::string& name) const { return fs::exists(here.file(name)); }
  WorkingDirectory here;
};

TEST_CASE("directories of the same pictures are one line and 0") {
  const TwoFolders two;
  for (const char* name : {"ref/a.png", "out/a.png", "ref/sub/b.png", "out/sub/b.png"})
    two.add(name);
  two.here.write("ref/notes.txt", "not a picture");
  const Outcome outcome = two.diff();
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "2 pictures: 2 same\n");
  CHECK(outcome.err.empty());
}

TEST_CASE("every picture that does not pass has a line, and the worst of them the exit code") {
  const TwoFolders two;
  for (const char* name : {"ref/a.png", "out/a.png", "ref/sub/b.png", "ref/gone.png",
                           "out/sub/fresh.png", "ref/bad.png", "ref/loose.png"}) {
    two.add(name);
  }
  two.add("out/sub/b.png", 3);
  CHECK(two.diff("--ignore 0,0,1x1").exit_code == 2);
  two.add("out/loose.png", 1);
  two.here.write("ref/loose.png.fuzzy", "0-1;0-1\nreason: loose\n");
  two.here.write("ref/old.png.fuzzy", "0-1;0-1\nreason: forgotten\n");
  two.here.write("out/bad.png", "no picture");
  const Outcome outcome = two.diff();
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(!contains(outcome.out, "a.png: same"));
  CHECK(contains(outcome.out, "sub/b.png: different: 1 of 432 pixels differ, by up to 3/255"));
  CHECK(contains(outcome.out, "gone.png: missing: out/gone.png: there is no such picture"));
  CHECK(contains(outcome.out, "sub/fresh.png: new: ref/sub/fresh.png: there is no such reference"));
  CHECK(contains(outcome.out, "bad.png: not compared: out/bad.png: not a PNG"));
  CHECK(contains(outcome.out, "loose.png: within tolerance"));
  CHECK(contains(outcome.out, "note: ref/old.png.fuzzy belongs to no picture"));
  CHECK(contains(
      outcome.out,
      "6 pictures: 1 same, 1 within tolerance, 1 different, 1 missing, 1 new, 1 not compared\n"));

  for (const char* name : {"ref/gone.png", "out/sub/fresh.png", "ref/bad.png", "out/bad.png"}) {
    fs::remove(two.here.file(name));
  }
  CHECK(two.diff().exit_code == 1);
  CHECK(two.diff("--fuzzy 0-3;0-1").exit_code == 0);
}

TEST_CASE("directories without pictures, and a directory against a file, are refused") {
  const TwoFolders two;
  const Outcome empty = two.diff();
  CHECK(empty.exit_code == 2);
  CHECK(contains(empty.err, "there is no picture in it"));
  CHECK(std::count(empty.err.begin(), empty.err.end(), '\n') == 1);
  two.add("ref/a.png");
  CHECK(two.here.run("diff ref ref/a.png").exit_code == 2);
  CHECK(two.here.run("diff ref/a.png ref").exit_code == 2);
}

TEST_CASE("heat maps of a directory go to a folder, one for each picture that differs") {
  const TwoFolders two;
  for (const char* name :
       {"ref/a.png", "out/a.png", "ref/b.png", "ref/sub/c.png", "ref/gone.png"}) {
    two.add(name);
  }
  two.add("out/b.png", 1);
  two.add("out/sub/c.png", 2);
  // A picture of the same name with another extension has a heat map of its own.
  const StoredImage floats = sample_picture({"", "", 1, Format::kFloats, {}});
  two.here.write("ref/b.pfm", pfm_of(floats));
  two.here.write("out/b.pfm", pfm_of(one_step_up(floats)));
  CHECK(two.diff("-o heat").exit_code == 2);
  CHECK(two.exists("heat/b.png.heat.png"));
  CHECK(two.exists("heat/b.pfm.heat.png"));
  CHECK(two.exists("heat/sub/c.png.heat.png"));
  CHECK(!two.exists("heat/a.png.heat.png"));
  CHECK(!two.exists("heat/gone.png.heat.png"));

  // FLIP cannot compare floats, but the other pictures must be compared all the same.
  const Outcome flip = two.diff("-o flip --heat flip");
  INFO(flip.err);
  CHECK(contains(flip.err, "b.pfm"));
  CHECK(contains(flip.out, "5 pictures"));
  CHECK(two.exists("flip/b.png.heat.png"));
  CHECK(!two.exists("flip/b.pfm.heat.png"));
}

TEST_CASE("heat maps do not become pictures to compare, and no report replaces a picture") {
  const TwoFolders two;
  two.add("ref/a.png");
  two.add("out/a.png", 1);
  const std::string before = two.here.read("out/a.png");
  for (const char* options : {"-o ref", "-o out", "-o out/", "-o out/sub/..", "-o out/a.png",
                              "--html out/a.png", "--json ref/a.png", "--junit ./out/a.png"}) {
    INFO(options);
    const Outcome outcome = two.diff(options);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK(two.here.read("out/a.png") == before);
  CHECK(fs::directory_iterator(two.here.file("ref/sub")) == fs::directory_iterator());
}

TEST_CASE("approving makes the tests the references, and then they are the same") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoFolders two;
  for (const char* name : {"ref/a.png", "out/a.png", "ref/b.png", "out/sub/deep.png"})
    two.add(name);
  two.add("out/b.png", 9);
  fs::create_directories(two.here.file("out/new"));
  two.add("out/new/c.png");
  const Outcome outcome = two.diff("--approve");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "approved: ref/b.png\n"));
  CHECK(contains(outcome.out, "approved: ref/new/c.png\n"));
  CHECK(contains(outcome.out, "approved: ref/sub/deep.png\n"));
  CHECK(!contains(outcome.out, "approved: ref/a.png\n"));
  CHECK(two.here.read("ref/b.png") == two.here.read("out/b.png"));
  const Outcome again = two.diff();
  CHECK(again.exit_code == 0);
  CHECK(again.out == "4 pictures: 4 same\n");
}

TEST_CASE("approving deletes nothing and takes nothing that is broken") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoFolders two;
  for (const char* name : {"ref/a.png", "ref/gone.png", "ref/bad.png"}) two.add(name);
  two.add("out/a.png", 9);
  two.here.write("out/bad.png", "no picture");
  const std::string bad = two.here.read("ref/bad.png");
  CHECK(two.diff("--approve").exit_code == 2);
  CHECK(two.exists("ref/gone.png"));
  CHECK(two.here.read("ref/bad.png") == bad);
  CHECK(two.here.read("ref/a.png") == two.here.read("out/a.png"));
}

TEST_CASE("a single picture is approved, new or different, and nothing is complained about") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoFolders two;
  two.add("ref/a.png");
  two.add("out/a.png", 9);
  const Outcome different = two.here.run("diff ref/a.png out/a.png --approve");
  CHECK(different.exit_code == 0);
  CHECK(contains(different.out, "approved: ref/a.png\n"));
  const Outcome fresh = two.here.run("diff golden/new/a.png out/a.png --approve");
  INFO(fresh.out << fresh.err);
  CHECK(fresh.exit_code == 0);
  CHECK(fresh.err.empty());
  CHECK(two.here.read("golden/new/a.png") == two.here.read("out/a.png"));
  CHECK(two.here.run("diff ref/b.ppm out/a.png --approve").exit_code == 2);
  CHECK(!two.exists("ref/b.ppm"));
  CHECK(two.here.run("diff ref/a.png out/none.png --approve").exit_code == 2);
}

TEST_CASE("on a server --approve is refused before anything is read") {
  const EnvironmentVariable ci("CI", "1");
  const TwoFolders two;
  two.add("ref/a.png");
  two.add("out/a.png", 9);
  two.add("out/new.png");
  const std::string before = two.here.read("ref/a.png");
  for (const char* words :
       {"diff ref out --approve --json x.json", "diff ref/a.png out/a.png --approve",
        "diff ref/new.png out/new.png --approve"}) {
    const Outcome outcome = two.here.run(words);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, "CI"));
  }
  CHECK(two.here.read("ref/a.png") == before);
  CHECK(!two.exists("ref/new.png"));
  CHECK(!two.exists("x.json"));
}

}  // namespace
}  // namespace glassbox::test
