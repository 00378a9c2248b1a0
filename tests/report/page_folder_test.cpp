// The folder beside a page: what the page is told of its files, and which files are not replaced.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <glassbox/compare/report/page_folder.h>

#include "tests/images/temporary_directory.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace fs = std::filesystem;
using test::TemporaryDirectory;

std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the folder of a page lies beside it and has its name", "[report]") {
  CHECK(page_folder("report.html") == "report-files");
  CHECK(page_folder("out.dir/report.html") == "out.dir/report-files");
  CHECK(page_folder("report") == "report-files");
  CHECK(page_folder("../a.b.html") == "../a.b-files");
}

TEST_CASE("a file beside a page is a script with its samples, under an address without signs",
          "[report]") {
  const TemporaryDirectory directory;
  const std::string page = directory.file("a b#%?\xff.html");
  const auto file = write_page_file(page, 7, {{"test", "eJw="}});
  REQUIRE(file);
  CHECK(file->address == "a%20b%23%25%3F%FF-files/0007.js");
  CHECK(file->path == std::string("a b#%") + "?" + "?-files/0007.js");
  CHECK(content_of(page_folder(page) + "/0007.js") ==
        "glassboxPictures(\"" + file->stamp + "\",{\"test\":\"eJw=\"});\n");
  const auto other = write_page_file(page, 7, {{"test", "eJx="}});
  REQUIRE(other);
  CHECK(other->address == file->address);
  CHECK(other->stamp != file->stamp);
}

TEST_CASE("nothing but an earlier file of a page is replaced", "[report]") {
  const TemporaryDirectory directory;
  const std::string page = directory.file("page.html"), folder = page_folder(page);
  fs::create_directory(folder);
  std::ofstream(folder + "/0001.js", std::ios::binary) << "let own = 1;";
  std::ofstream(folder + "/0002.js", std::ios::binary) << "";
  fs::create_directory(folder + "/0003.js");
  fs::create_symlink("nowhere", folder + "/0004.js");
  for (std::size_t index = 1; index <= 4; ++index) {
    INFO("file " << index);
    const auto file = write_page_file(page, index, {{"test", "eJw="}});
    REQUIRE(!file);
    CHECK(file.error().message().find("not replaced") != std::string::npos);
  }
  CHECK(content_of(folder + "/0001.js") == "let own = 1;");
  CHECK(!fs::exists(directory.file("page-files/nowhere")));
}

TEST_CASE("the check finds what would not be replaced, up to the number of pairs", "[report]") {
  const TemporaryDirectory directory;
  const std::string page = directory.file("page.html"), folder = page_folder(page);
  CHECK(check_page_files(page, 3));
  CHECK(!fs::exists(folder));
  REQUIRE(write_page_file(page, 1, {{"test", "eJw="}}));
  std::ofstream(folder + "/0003.js", std::ios::binary) << "let own = 1;";
  CHECK(check_page_files(page, 2));
  const auto refused = check_page_files(page, 3);
  REQUIRE(!refused);
  CHECK(refused.error().message().find("0003.js") != std::string::npos);
}

TEST_CASE("files of an earlier page with more pairs are removed, and no others", "[report]") {
  const TemporaryDirectory directory;
  const std::string page = directory.file("page.html"), folder = page_folder(page);
  remove_later_page_files(page, 0);  // without a folder there is nothing to remove
  for (const std::size_t index : {1u, 2u, 3u, 12345u}) {
    REQUIRE(write_page_file(page, index, {{"test", "eJw="}}));
  }
  const std::string script = content_of(folder + "/0003.js");
  std::ofstream(folder + "/0004.js", std::ios::binary) << "let own = 1;";
  const std::vector<std::string> own{"3.js", "00003.js", "0003.js.txt", "x003.js", "-003.js"};
  for (const std::string& name : own) std::ofstream(folder + "/" + name) << script;
  remove_later_page_files(page, 2);
  for (const char* name : {"/0001.js", "/0002.js", "/0004.js"}) CHECK(fs::exists(folder + name));
  for (const std::string& name : own) CHECK(fs::exists(folder + "/" + name));
  for (const char* name : {"/0003.js", "/12345.js"}) CHECK(!fs::exists(folder + name));
}

TEST_CASE("a folder that cannot be made is an error with its path", "[report]") {
  const TemporaryDirectory directory;
  const std::string page = directory.file("page.html");
  std::ofstream(page_folder(page)) << "a file";
  for (const std::string& path : {page, directory.file("nowhere/page.html")}) {
    const auto file = write_page_file(path, 1, {{"test", "eJw="}});
    REQUIRE(!file);
    CHECK(file.error().message().find(page_folder(path)) != std::string::npos);
  }
}

}  // namespace glassbox
