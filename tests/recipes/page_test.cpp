// Checks that docs/image_tests.md shows the files that the tests run.
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

std::string read(const std::string& name) {
  std::ifstream in(std::string(GLASSBOX_SOURCE_DIR) + "/" + name, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("docs/image_tests.md shows the recipes as they are") {
  const std::string page = read("docs/image_tests.md");
  int shown = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(GLASSBOX_SOURCE_DIR "/examples/image_tests")) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().filename().string();
    INFO(name);
    CHECK(page.find("\n" + read("examples/image_tests/" + name) + "```\n") != std::string::npos);
    ++shown;
  }
  CHECK(shown == 4);
}

}  // namespace glassbox::test
