// Tests `approve`: a test picture becomes the reference.
#include "tests/support/catch.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/compare/environment.h"
#include "tests/compare/pictures.h"
#include "tests/images/temporary_directory.h"

#include <glassbox/compare/pictures/approve.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A pair of files, a.png and b.png, that differ in one sample.
class TwoPictures {
public:
  TwoPictures() {
    StoredImage image = blank(3, 2, 3, Format::kBytes);
    REQUIRE(write_file(file("a.png"), *encode_png(image)));
    set_sample(image, 1, 1, 1, 200);
    REQUIRE(write_file(file("b.png"), *encode_png(image)));
  }
  std::string file(const std::string& name) const { return directory_.file(name); }
  const TemporaryDirectory& directory() const { return directory_; }

private:
  TemporaryDirectory directory_;
};

TEST_CASE("approving copies the test over the reference, byte for byte") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoPictures here;
  const std::string test = read(here.file("b.png"));
  REQUIRE(read(here.file("a.png")) != test);
  REQUIRE(approve_picture(here.file("a.png"), here.file("b.png")));
  CHECK(read(here.file("a.png")) == test);
  CHECK(read(here.file("b.png")) == test);
  CHECK(here.directory().names().size() == 2);
}

TEST_CASE("a reference that is not there is made, with its folders") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoPictures here;
  const std::string reference = here.file("golden/sub/new.png");
  REQUIRE(approve_picture(reference, here.file("b.png")));
  CHECK(read(reference) == read(here.file("b.png")));
}

TEST_CASE("on a server nothing is approved") {
  const TwoPictures here;
  const std::string before = read(here.file("a.png"));
  for (const char* value : {"1", "true", "0"}) {
    const EnvironmentVariable ci("CI", value);
    CHECK(on_ci_server());
    const auto done = approve_picture(here.file("a.png"), here.file("b.png"));
    REQUIRE(!done);
    CHECK(done.error().cause.find("CI") != std::string::npos);
    CHECK(!approve_picture(here.file("golden/new.png"), here.file("b.png")));
  }
  CHECK(read(here.file("a.png")) == before);
  CHECK(here.directory().names().size() == 2);
  const EnvironmentVariable empty("CI", "");
  CHECK(!on_ci_server());
}

TEST_CASE("names that end differently are refused") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoPictures here;
  for (const char* name : {"a.ppm", "a", "a.PNG", "a.png.old"}) {
    const auto done = approve_picture(here.file(name), here.file("b.png"));
    INFO(name);
    REQUIRE(!done);
    CHECK(!fs::exists(here.file(name)));
  }
}

TEST_CASE("a test that cannot be decoded does not become the reference") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoPictures here;
  const std::string before = read(here.file("a.png"));
  std::ofstream(here.file("cut.png"), std::ios::binary) << before.substr(0, before.size() / 2);
  std::ofstream(here.file("empty.png"), std::ios::binary) << "";
  for (const char* name : {"cut.png", "empty.png", "nothing.png"}) {
    const auto done = approve_picture(here.file("a.png"), here.file(name));
    INFO(name);
    REQUIRE(!done);
    CHECK(done.error().file == here.file(name));
  }
  CHECK(read(here.file("a.png")) == before);
}

TEST_CASE("a folder that cannot be made is an error") {
  const EnvironmentVariable ci("CI", std::nullopt);
  const TwoPictures here;
  const auto done = approve_picture(here.file("a.png/sub/new.png"), here.file("b.png"));
  REQUIRE(!done);
  CHECK(done.error().cause.find("cannot be created") != std::string::npos);
}

}  // namespace
}  // namespace glassbox::test
