// Tests which submissions are graded: folders, archives and files are, other things are reported as
// skipped, and nothing hostile succeeds.
#include "labs/grading/submission.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

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

std::string message_of(const Result<SubmittedFile>& read) {
  return read ? "read: " + read->text : read.error().message();
}

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void append_number(std::string& bytes, std::uint32_t number, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

// The check sum of the PNG and RAR formats.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

// A block of a RAR archive: its check sum, then type, flags, size and the rest.
std::string rar_block(int type, std::uint32_t flags, const std::string& rest) {
  std::string block;
  append_number(block, static_cast<std::uint32_t>(type), 1);
  append_number(block, flags, 2);
  append_number(block, static_cast<std::uint32_t>(7 + rest.size()), 2);
  block += rest;
  std::string sum;
  append_number(sum, crc32(block) & 0xffff, 2);
  return sum + block;
}

// A RAR archive (version 4) with one file, which is stored as it is. No free program writes one.
std::string rar_of(const std::string& path, const std::string& text) {
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string rest;
  append_number(rest, size, 4);  // packed
  append_number(rest, size, 4);  // unpacked
  append_number(rest, 3, 1);     // made on Unix
  append_number(rest, crc32(text), 4);
  append_number(rest, 0x56a35b6a, 4);  // a date
  append_number(rest, 20, 1);          // the version that is needed
  append_number(rest, 0x30, 1);        // stored
  append_number(rest, static_cast<std::uint32_t>(path.size()), 2);
  append_number(rest, 0100644, 4);
  return std::string("Rar!\x1a\x07\0", 7) + rar_block(0x73, 0, std::string(6, '\0')) +
         rar_block(0x74, 0x8000, rest + path) + text + rar_block(0x7b, 0x4000, "");
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
  write_archive(folder / "ida.tar", {{"lab/student.cpp", solution()}});
  write(folder / "ida.cpp", "int x = ;");
  write(folder / "grades.xlsx", "x");
  write_archive(folder / "class.csv.zip", {{"student.cpp", solution()}});
  write(folder / "index.html/student.cpp", solution());
  const Outcome outcome =
      grader({"grade", "class", "--lab", "99", "-o", "results"}, directory.path);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 1);  // because something was skipped
  CHECK(has_part(outcome.err, "grades.xlsx: is neither a folder nor an archive nor a .cpp file"));
  CHECK(has_part(outcome.err, "3 entries of class were skipped"));
  CHECK(has_part(outcome.err, "class.csv.zip: this name is needed for a file of the results"));
  CHECK(has_part(outcome.err, "index.html: this name is needed for a file of the results"));
  const auto result = [&](const std::string& name) {
    return read_json(directory.path / "results" / name / "results.json");
  };
  for (const char* name : {"ann", "cid", "dan", "eve", "gus"}) {
    INFO(name);
    CHECK(total(result(name)) == 10);
  }
  // Two submissions of one student: the folder is taken, and the student reads so.
  CHECK(has_part(result("ann").at("output"), "There is also ann.zip, which is not graded"));
  CHECK(has_part(result("ida").at("output"), "There is also ida.cpp, which is not graded"));
  CHECK(total(result("ida")) == 10);
  CHECK(result("bob").at("extra_data").at("outcome") == "file refused");
  CHECK(has_part(result("bob").at("output"), "is a link"));
  CHECK(result("fay").at("extra_data").at("outcome") == "file refused");
  CHECK(result("hal").at("extra_data").at("outcome") == "missing file");
  CHECK(has_part(result("hal").at("output"), "there is main.cpp"));
  CHECK(has_part(read(directory.path / "results/class.csv"), "bob,0,10,file refused"));
}

TEST_CASE(
    "student.cpp is found at any depth and by its variants, by one rule in folders and archives") {
  const TestDirectory directory;
  struct Choice {
    std::vector<std::string> paths;
    std::string taken;  // empty: none of them
    bool is_noted = true;
  };
  const std::vector<Choice> choices{
      {{"student.cpp"}, "student.cpp", false},
      {{"a/b/c/d/student.cpp", "a/readme.txt"}, "a/b/c/d/student.cpp", false},
      {{"a/Student.cpp"}, "a/Student.cpp"},
      {{"STUDENT.CPP"}, "STUDENT.CPP"},
      {{"student (1).cpp"}, "student (1).cpp"},
      {{"Student(12).cpp"}, "Student(12).cpp"},
      {{"student-3.cpp"}, "student-3.cpp"},
      // in the fewest folders, whatever the name is
      {{"a/student.cpp", "student (1).cpp"}, "student (1).cpp"},
      // the exact name, then another case, then the highest number, as a number
      {{"student (2).cpp", "Student.cpp", "student.cpp"}, "student.cpp"},
      {{"student (2).cpp", "Student.cpp"}, "Student.cpp"},
      {{"student (2).cpp", "student (10).cpp", "student (9).cpp"}, "student (10).cpp"},
      {{"b/student.cpp", "a/student.cpp"}, "a/student.cpp"},
      // what systems and editors make is not looked at
      {{"__MACOSX/student.cpp", ".git/student.cpp", "a/student.cpp"}, "a/student.cpp", false},
      {{"student.cpp/student.cpp"}, "student.cpp/student.cpp", false},
      {{"mystudent.cpp", "student.cpp.bak", "student (x).cpp", "student 1.cpp", "student.h"}, ""},
      {{".git/student.cpp"}, ""},
  };
  int i = 0;
  for (const Choice& each : choices) {
    const std::string name = std::to_string(i++);
    std::vector<Entry> entries;
    for (const std::string& path : each.paths) {
      write(directory.path / name / path, path);
      entries.push_back({path, path});
    }
    // The order in an archive does not matter.
    write_archive(directory.path / (name + ".zip"), entries);
    std::reverse(entries.begin(), entries.end());
    write_archive(directory.path / (name + ".tar"), entries);
    for (const char* end : {"", ".zip", ".tar"}) {
      const auto read = read_submission(directory.path / (name + end));
      INFO(name + end << ": " << message_of(read));
      if (each.taken.empty()) {
        CHECK(has_part(message_of(read), "student.cpp: is missing"));
        continue;
      }
      REQUIRE(read);
      CHECK(read->text == each.taken);
      CHECK(read->note.empty() != each.is_noted);
      if (!each.is_noted) continue;
      CHECK(has_part(read->note, "Graded: " + each.taken + ".\n"));
      for (const std::string& path : each.paths)
        CHECK(has_part(read->note, "Graded: " + path) == (path == each.taken));
    }
  }
}

TEST_CASE("of several archives in a folder the first by the rule that has student.cpp is read") {
  const TestDirectory directory;
  const fs::path ann = directory.path / "ann";
  fs::create_directories(ann / "deep/er");
  write_archive(ann / "deep/er/lab.tar.gz", {{"x/student.cpp", "deep"}});
  CHECK(message_of(read_submission(ann)) == "read: deep");
  write_archive(ann / "lab5 (2).zip", {{"student.cpp", "second"}});
  write_archive(ann / "lab5 (10).zip", {{"student.cpp", "tenth"}});
  CHECK(message_of(read_submission(ann)) == "read: tenth");
  write_archive(ann / "lab5.zip", {{"main.cpp", "x"}});
  write(ann / "lab5.7z", "damaged");
  const auto read = read_submission(ann);
  CHECK(message_of(read) == "read: tenth");
  for (const char* other : {"lab5.7z", "lab5.zip", "lab5 (2).zip", "deep/er/lab.tar.gz"})
    CHECK(has_part(read->note, other));
  CHECK(has_part(read->note, "Graded: lab5 (10).zip.\n"));
  CHECK_FALSE(has_part(read->note.substr(read->note.find("Not graded")), "lab5 (10).zip"));
  // A file in the folder itself comes before every archive.
  write(ann / "deep/student.cpp", "file");
  CHECK(message_of(read_submission(ann)) == "read: file");
  // If no archive has it, the first one says why.
  write(directory.path / "bob/lab5.zip", "damaged");
  write_archive(directory.path / "bob/other.zip", {{"main.cpp", "x"}});
  CHECK(has_part(message_of(read_submission(directory.path / "bob")), "lab5.zip: is damaged"));
}

TEST_CASE("the archives of a folder are few, and have together what one may have") {
  const TestDirectory directory;
  const fs::path ann = directory.path / "ann", bob = directory.path / "bob";
  fs::create_directories(ann);
  fs::create_directories(bob);
  for (std::size_t i = 0; i + 1 < kMaxArchives; ++i)
    write_archive(ann / fmt::format("a{}.zip", i), {{"main.cpp", "x"}});
  write_archive(ann / "b.zip", {{"student.cpp", "b"}});
  CHECK(message_of(read_submission(ann)) == "read: b");
  write_archive(ann / "a.zip", {{"main.cpp", "x"}});
  CHECK(has_part(message_of(read_submission(ann)), "student.cpp: is missing"));
  const std::vector<Entry> half(13, {"zeros", std::string(10 << 20, '\0')});
  write_archive(bob / "a.tar.gz", half);
  write_archive(bob / "c.zip", {{"student.cpp", "c"}});
  CHECK(message_of(read_submission(bob)) == "read: c");
  write_archive(bob / "b.tar.gz", half);
  CHECK(has_part(message_of(read_submission(bob)), "student.cpp: is missing"));
}

TEST_CASE("a submission's name is that of its archive without the ending, in any case") {
  const TestDirectory directory;
  for (const char* name :
       {"ann.zip", "ann.TAR.GZ", "ann.tar", "ann.Tar.xz", "ann.TGZ", "ann.cpp"}) {
    write(directory.path / name, "x");
    CHECK(submission_name(directory.path / name) == "ann");
  }
}

TEST_CASE("of two entries with the same path the last one counts, as unzip does") {
  const TestDirectory directory;
  const auto text = [&](const std::string& name, const std::vector<Entry>& entries) {
    write_archive(directory.path / name, entries);
    return message_of(read_from_archive(directory.path / name, "student.cpp"));
  };
  const std::vector<Entry> twice{{"student.cpp", "old"}, {"a.txt", "x"}, {"./student.cpp", "new"}};
  for (const char* name : {"a.zip", "a.tar", "a.tar.gz"}) CHECK(text(name, twice) == "read: new");
  CHECK(has_part(text("b.tar", {{"student.cpp", "old"}, {"student.cpp", "", "/etc/passwd"}}),
                 "is a link"));
  CHECK(text("c.tar", {{"student.cpp", "", "/etc/passwd"}, {"student.cpp", "new"}}) == "read: new");
  CHECK(text("d.tar", {{"student.cpp", std::string((1 << 20) + 1, ' ')}, {"student.cpp", "new"}}) ==
        "read: new");
  // A file that is not taken may be anything.
  CHECK(text("e.tar", {{"student.cpp", "x"}, {"a/student.cpp", "", "/etc/passwd"}}) == "read: x");
}

TEST_CASE("RAR archives are read") {
  const TestDirectory directory;
  write(directory.path / "ann.rar", rar_of("lab5/student.cpp", "int x;\n"));
  CHECK(message_of(read_submission(directory.path / "ann.rar")) == "read: int x;\n");
  CHECK(submission_name(directory.path / "ann.rar") == "ann");
  write(directory.path / "bob.rar", "no archive at all");
  CHECK(has_part(message_of(read_submission(directory.path / "bob.rar")), "is damaged"));
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
