#include "labs/framework/zip.h"
#include "tests/support/catch.h"

using namespace glassbox::labs;

TEST_CASE("what goes into an archive comes out, and the same entries give the same bytes") {
  const std::vector<ZipEntry> entries{
      {"a/b.txt", "hello\n", false}, {"run", "#!/bin/sh\n", true}, {"empty", "", false}};
  const auto bytes = make_zip(entries);
  REQUIRE(bytes);
  CHECK(*bytes == *make_zip(entries));
  const auto back = read_zip(*bytes);
  REQUIRE(back);
  REQUIRE(back->size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((*back)[i].path == entries[i].path);
    CHECK((*back)[i].text == entries[i].text);
    CHECK((*back)[i].executable == entries[i].executable);
  }
}

TEST_CASE("what is no archive is refused") {
  CHECK_FALSE(read_zip(std::vector<std::byte>(100, std::byte{7})));
  CHECK_FALSE(read_zip({}));
}
