// Tests how the pictures of two directories are paired by name.
#include "tests/support/catch.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/pairing.h>

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

class TwoFolders {
public:
  TwoFolders() {
    fs::create_directory(ref());
    fs::create_directory(out());
  }
  std::string ref() const { return directory_.file("ref"); }
  std::string out() const { return directory_.file("out"); }
  // Makes a file "ref/..." or "out/...", with its folders.
  void add(const std::string& name, const std::string& bytes = "") const {
    const fs::path path = directory_.file(name);
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
  }
  Pairing pairs() const {
    const auto pairing = pair_directories(ref(), out());
    INFO((pairing ? "" : pairing.error().message()));
    REQUIRE(pairing);
    return *pairing;
  }

private:
  TemporaryDirectory directory_;
};

// Returns lines such as "a.png +-": the name, then whether there is a reference and a test.
std::vector<std::string> summary(const Pairing& pairing) {
  std::vector<std::string> lines;
  for (const PicturePaths& paths : pairing.pictures) {
    lines.push_back(paths.name + " " + (paths.has_reference ? '+' : '-') +
                    (paths.has_test ? '+' : '-'));
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST_CASE("pictures are paired by name, subfolders included, in order of their names") {
  const TwoFolders here;
  for (const char* name : {"ref/b.png", "ref/a.png", "ref/sub/deep/c.ppm", "ref/gone.png",
                           "out/a.png", "out/b.png", "out/sub/deep/c.ppm", "out/sub/fresh.pfm"}) {
    here.add(name);
  }
  const Pairing pairing = here.pairs();
  CHECK(summary(pairing) ==
        Lines{"a.png ++", "b.png ++", "gone.png +-", "sub/deep/c.ppm ++", "sub/fresh.pfm -+"});
  CHECK(pairing.pictures[3].reference == here.ref() + "/sub/deep/c.ppm");
  CHECK(pairing.pictures[3].test == here.out() + "/sub/deep/c.ppm");
  // The path that the missing reference would have.
  CHECK(pairing.pictures[4].reference == here.ref() + "/sub/fresh.pfm");
  CHECK(pairing.orphans.empty());
}

TEST_CASE("names do not depend on how the directories are written") {
  const TwoFolders here;
  here.add("ref/sub/a.png");
  here.add("out/sub/a.png");
  for (const char* end : {"", "/", "//", "/.", "/sub/.."}) {
    const auto pairing = pair_directories(here.ref() + end, here.out() + end);
    INFO(end);
    REQUIRE(pairing);
    CHECK(summary(*pairing) == Lines{"sub/a.png ++"});
    CHECK(fs::exists(pairing->pictures[0].reference));
  }
  const fs::path before = fs::current_path();
  fs::current_path(here.ref());
  const auto pairing = pair_directories(".", "../out");
  fs::current_path(before);
  REQUIRE(pairing);
  CHECK(summary(*pairing) == Lines{"sub/a.png ++"});
}

TEST_CASE("a picture is known by its extension, in either case, also one that is not read") {
  const TwoFolders here;
  for (const char* name :
       {"a.png", "b.PNG",  "c.Jpg", "d.JPEG", "e.bmp", "f.tga",     "g.ppm", "h.pgm",
        "i.pfm", "j.txt",  "k",     "png",    ".png",  "l.png.bak", "m.exr", "n.png~",
        "o.TIF", "p.webp", "q.gif", "r.pam",  "s.hdr", "t.pbm"}) {
    here.add(std::string("ref/") + name);
    here.add(std::string("out/") + name);
  }
  CHECK(summary(here.pairs()) == Lines{"a.png ++", "b.PNG ++", "c.Jpg ++", "d.JPEG ++", "e.bmp ++",
                                       "f.tga ++", "g.ppm ++", "h.pgm ++", "i.pfm ++", "m.exr ++",
                                       "o.TIF ++", "p.webp ++", "q.gif ++", "r.pam ++", "s.hdr ++",
                                       "t.pbm ++"});
}

TEST_CASE("a file whose name is not that of a picture is one by its bytes") {
  const TwoFolders here;
  const std::vector<std::pair<std::string, std::string>> pictures{
      {"a", "\x89PNG\r\n\x1a\nand more"}, {"b.dat", "\xff\xd8\xff\xe0"},
      {"c.1", "P6 1 1 255\nabc"},         {"d.x", "P3 1 1 255 1 2 3"},
      {"e", std::string("II*\0", 4)},     {"f", "GIF89a"}};
  const std::vector<std::pair<std::string, std::string>> others{
      {"x1.txt", "P3 is a format of text"},
      {"x2", "BMW and other cars"},
      {"x3.md", "Pfund"},
      {"x4", "P6"},
      {"x5.html", "<html>"},
      {"x6.json", "{}"}};
  for (const auto& [name, bytes] : pictures) here.add("ref/" + name, bytes);
  for (const auto& [name, bytes] : others) here.add("ref/" + name, bytes);
  here.add("out/a.png");
  CHECK(summary(here.pairs()) ==
        Lines{"a +-", "a.png -+", "b.dat +-", "c.1 +-", "d.x +-", "e +-", "f +-"});
}

TEST_CASE("names that differ in case or extension are two pictures") {
  const TwoFolders here;
  here.add("ref/a.png");
  here.add("out/A.png");
  here.add("out/a.PNG");
  here.add("out/a.ppm");
  CHECK(summary(here.pairs()) == Lines{"A.png -+", "a.PNG -+", "a.png +-", "a.ppm -+"});
}

TEST_CASE("a sidecar without its picture is an orphan") {
  const TwoFolders here;
  for (const char* name :
       {"ref/a.png", "ref/a.png.fuzzy", "ref/b.png", "ref/b.fuzzy", "ref/x.y.png", "ref/x.y.fuzzy",
        "ref/d.jpg.png", "ref/d.jpg.fuzzy", "ref/sub/c.png", "ref/sub/c.png.fuzzy", "out/a.png",
        // The orphans: their picture is missing, has another extension, or is in another folder.
        "ref/gone.png.fuzzy", "ref/lost.fuzzy", "ref/a.jpg.fuzzy", "ref/c.png.fuzzy",
        "ref/sub/a.fuzzy",
        // In the test directory sidecars are not read.
        "out/other.fuzzy"}) {
    here.add(name);
  }
  auto orphans = here.pairs().orphans;
  std::sort(orphans.begin(), orphans.end());
  CHECK(orphans == Lines{here.ref() + "/a.jpg.fuzzy", here.ref() + "/c.png.fuzzy",
                         here.ref() + "/gone.png.fuzzy", here.ref() + "/lost.fuzzy",
                         here.ref() + "/sub/a.fuzzy"});
}

TEST_CASE("links to folders are not followed, so loops end; links to pictures are pictures") {
  const TwoFolders here;
  here.add("ref/sub/a.png");
  here.add("out/sub/a.png");
  fs::create_directory_symlink(here.ref(), here.ref() + "/sub/loop");
  fs::create_directory_symlink("..", here.out() + "/sub/up");
  fs::create_symlink(here.ref() + "/sub/a.png", here.ref() + "/linked.png");
  fs::create_symlink("nowhere.png", here.ref() + "/dangling.png");
  fs::create_symlink("self.png", here.ref() + "/self.png");
  CHECK(summary(here.pairs()) == Lines{"linked.png +-", "sub/a.png ++"});
}

TEST_CASE("a folder with a picture's name is no picture") {
  const TwoFolders here;
  here.add("ref/a.png/b.png");
  here.add("out/a.png/b.png");
  CHECK(summary(here.pairs()) == Lines{"a.png/b.png ++"});
}

TEST_CASE("two directories without a picture are an error, not a success") {
  const TwoFolders here;
  here.add("ref/notes.txt");
  const auto pairing = pair_directories(here.ref(), here.out());
  REQUIRE(!pairing);
  CHECK(pairing.error().message().find(here.ref()) != std::string::npos);
  CHECK(pairing.error().message().find(here.out()) != std::string::npos);
  here.add("out/a.png");
  CHECK(summary(here.pairs()) == Lines{"a.png -+"});
}

TEST_CASE("a directory that cannot be listed is an error") {
  const TwoFolders here;
  here.add("ref/a.png");
  const std::string nowhere = here.ref() + "/nowhere";
  for (const auto& pairing : {pair_directories(here.ref(), nowhere),
                              pair_directories(here.ref() + "/a.png", here.out())}) {
    REQUIRE(!pairing);
    CHECK(pairing.error().cause.find("cannot be listed") != std::string::npos);
  }
}

TEST_CASE("a reference directory that does not exist has no pictures") {
  const TwoFolders here;
  const std::string nowhere = here.ref() + "/nowhere";
  const auto none = pair_directories(nowhere, here.out());
  REQUIRE(!none);
  CHECK(none.error().cause.find("there is no picture") != std::string::npos);
  here.add("out/a.png");
  const auto pairing = pair_directories(nowhere, here.out());
  REQUIRE(pairing);
  REQUIRE(pairing->pictures.size() == 1);
  CHECK(!pairing->pictures[0].has_reference);
  CHECK(pairing->pictures[0].reference == nowhere + "/a.png");
}

TEST_CASE("a reference directory that cannot be looked for is an error") {
  const TwoFolders here;
  here.add("out/a.png");
  const std::string endless(5000, 'x');  // longer than a file's name may be
  CHECK(may_exist(endless));
  const auto pairing = pair_directories(endless, here.out());
  REQUIRE(!pairing);
  CHECK(pairing.error().cause.find("cannot be listed") != std::string::npos);
}

TEST_CASE("names that are no text are paired, too") {
  const TwoFolders here;
  const std::string odd = "\xff\n\x1b.png";
  here.add("ref/" + odd);
  here.add("out/" + odd);
  CHECK(summary(here.pairs()) == Lines{odd + " ++"});
}

}  // namespace
}  // namespace glassbox::test
