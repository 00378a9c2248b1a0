// Tests which submissions are graded: folders, archives and files are, other things are reported as
// skipped, and nothing hostile succeeds.
#include "labs/grading/submission.h"

#include <archive.h>
#include <archive_entry.h>

#include "labs/grading/archive.h"
#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

namespace glassbox::test {

using namespace labs::grading;

namespace {

struct Entry {
  std::string path, text, link = {};
};

// Writes an archive with libarchive, with any paths.
void write_archive(const fs::path& file, const std::vector<Entry>& entries) {
  struct archive* writer = archive_write_new();
  const std::string name = file.string();
  if (name.ends_with(".zip")) {
    archive_write_set_format_zip(writer);
  } else {
    archive_write_set_format_pax_restricted(writer);
    if (name.ends_with("gz")) archive_write_add_filter_gzip(writer);
  }
  REQUIRE(archive_write_open_filename(writer, name.c_str()) == ARCHIVE_OK);
  for (const Entry& each : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, each.path.c_str());
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_filetype(entry, each.link.empty() ? AE_IFREG : AE_IFLNK);
    if (!each.link.empty()) archive_entry_set_symlink(entry, each.link.c_str());
    archive_entry_set_size(entry, la_int64_t(each.text.size()));
    REQUIRE(archive_write_header(writer, entry) == ARCHIVE_OK);
    if (!each.text.empty()) archive_write_data(writer, each.text.data(), each.text.size());
    archive_entry_free(entry);
  }
  REQUIRE(archive_write_close(writer) == ARCHIVE_OK);
  archive_write_free(writer);
}

std::string message_of(const Result<std::string>& read) {
  return read ? "read: " + *read : read.error().message();
}

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("folders, archives and single files are submissions; the rest is skipped with a reason") {
  const TestDirectory directory;
  const fs::path folder = directory.path / "class";
  write(folder / "ann/student.cpp", solution());
  write_archive(folder / "ann.zip", {{"student.cpp", "// not this one"}});
  fs::create_directory_symlink("ann", folder / "bob");
  write_archive(folder / "cid.zip",
                {{"lab/student.cpp", solution()}, {"__MACOSX/._student.cpp", "x"}});
  write_archive(folder / "dan.tar.gz", {{"student.cpp", solution()}});
  write(folder / "eve.cpp", solution());
  write(folder / "fay/lab5.zip", "no archive at all");
  fs::create_directories(folder / "gus");
  write_archive(folder / "gus/lab5.zip", {{"student.cpp", solution()}});
  write(folder / "hal/main.cpp", "int main() {}");
  write(folder / "grades.xlsx", "x");
  write_archive(folder / "class.csv.zip", {{"student.cpp", solution()}});
  write(folder / "index.html/student.cpp", solution());
  const Outcome outcome =
      grader({"grade", "class", "--lab", "99", "-o", "results"}, directory.path);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(has_part(outcome.err, "grades.xlsx: is neither a folder nor an archive nor a .cpp file"));
  CHECK(has_part(outcome.err, "ann.zip: another submission, ann, has the same name"));
  CHECK(has_part(outcome.err, "class.csv.zip: this name is needed for a file of the results"));
  CHECK(has_part(outcome.err, "index.html: this name is needed for a file of the results"));
  const auto result = [&](const std::string& name) {
    return read_json(directory.path / "results" / name / "results.json");
  };
  for (const char* name : {"ann", "cid", "dan", "eve", "gus"}) {
    INFO(name);
    CHECK(total(result(name)) == 10);
  }
  CHECK(result("bob").at("extra_data").at("outcome") == "file refused");
  CHECK(has_part(result("bob").at("output"), "is a link"));
  CHECK(result("fay").at("extra_data").at("outcome") == "file refused");
  CHECK(result("hal").at("extra_data").at("outcome") == "missing file");
  CHECK(has_part(result("hal").at("output"), "there is main.cpp"));
  CHECK(has_part(read(directory.path / "results/class.csv"), "bob,0,10,file refused"));
}

TEST_CASE("hostile archives are refused with the reason, and nothing of them is written anywhere") {
  const TestDirectory directory;
  const auto refused = [&](const std::string& name, const std::vector<Entry>& entries) {
    write_archive(directory.path / name, entries);
    return message_of(read_from_archive(directory.path / name, "student.cpp"));
  };
  CHECK(has_part(refused("a.zip", {{"../student.cpp", "x"}}), "has the path \"../student.cpp\""));
  CHECK(
      has_part(refused("b.tar", {{"/tmp/student.cpp", "x"}}), "has the path \"/tmp/student.cpp\""));
  CHECK(has_part(refused("c.tar", {{"a/../../b", "x"}, {"student.cpp", "x"}}),
                 "has the path \"../b\""));
  CHECK(has_part(refused("d.tar", {{"student.cpp", "", "/etc/passwd"}}), "is a link"));
  CHECK(has_part(refused("e.tar.gz", {{"student.cpp", std::string((1 << 20) + 1, ' ')}}),
                 "more than 1048576 bytes"));
  // 300 MiB of zeros, in some 300 KiB.
  std::vector<Entry> bomb(30, {"zeros", std::string(10 << 20, '\0')});
  bomb.push_back({"student.cpp", "x"});
  CHECK(has_part(refused("f.tar.gz", bomb), "more than 256 MiB"));
  CHECK(has_part(refused("g.zip", std::vector<Entry>(10001, {"a", "x"})),
                 "more than 10000 files and folders"));
  CHECK(has_part(refused("h.zip", {{"main.cpp", "x"}, {"lib/x.cpp", "x"}}),
                 "there is lib/x.cpp, main.cpp"));
  CHECK(refused("i.zip", {{"student.cpp", "x"}, {"lab/student.cpp", "y"}}) == "read: x");
  write(directory.path / "cut.zip", read(directory.path / "i.zip").substr(0, 40));
  CHECK(has_part(message_of(read_from_archive(directory.path / "cut.zip", "student.cpp")),
                 "damaged"));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(directory.path))
    files += entry.is_regular_file() ? 1U : 0U;
  CHECK(files == 10);
}

}  // namespace glassbox::test
