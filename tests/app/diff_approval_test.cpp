// Tests which pictures glassbox diff approves, and what it reports of a first run.
#include "tests/support/catch.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/app/picture_file_kinds.h"
#include "tests/compare/environment.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

// Folders ref and out with pictures that differ, in subfolders too.
class ManyPictures {
public:
  ManyPictures() {
    for (const char* folder : {"ref/menu", "out/menu"}) fs::create_directories(here.file(folder));
    for (const std::string& name : names) {
      add("ref/" + name, 0);
      add("out/" + name, 9);
    }
  }
  void add(const std::string& name, int change) const {
    StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
    set_sample(image, 3, 3, 0, sample_at(image, 3, 3, 0) + change);
    here.write(name, png_of(image));
  }
  Outcome diff(const std::string& options) const { return here.run("diff ref out " + options); }
  // The pictures whose references are now those of the test.
  std::vector<std::string> approved() const {
    std::vector<std::string> same;
    for (const std::string& name : names) {
      if (here.read("ref/" + name) == here.read("out/" + name)) same.push_back(name);
    }
    return same;
  }
  const std::vector<std::string> names{"a.png", "b.png", "menu/a.png", "menu/c.png"};
  const EnvironmentVariable ci{"CI", std::nullopt};
  WorkingDirectory here;
};

using Names = std::vector<std::string>;

TEST_CASE("a pattern approves what it matches; what is left decides the exit code") {
  const ManyPictures many;
  const Outcome some = many.diff("--approve-matching menu/*");
  CHECK(some.exit_code == 1);
  CHECK(many.approved() == Names{"menu/a.png", "menu/c.png"});
  CHECK(contains(some.out, "approved: ref/menu/a.png\n"));
  const Outcome rest = many.diff("--approve-matching a.png --approve-matching b.png");
  CHECK(rest.exit_code == 0);
  CHECK(many.approved() == many.names);
}

TEST_CASE("a list approves the pictures that it names") {
  const ManyPictures many;
  many.here.write("list.txt", "# glassbox diff --approve-list\na.png\nmenu/c.png\n");
  CHECK(many.diff("--approve-list list.txt").exit_code == 1);
  CHECK(many.approved() == Names{"a.png", "menu/c.png"});
}

TEST_CASE("a list comes from standard input, too, and neither way may be endless") {
  const ManyPictures many;
  const auto piped = [&](const std::string& source) {
    const std::string diff = GLASSBOX_PROGRAM + std::string(" diff ref out --approve-list -");
    return run_program("/bin/sh", {"-c", source + " | " + diff}, many.here.path());
  };
  CHECK(piped("printf 'b.png\\nmenu/a.png\\n'").exit_code == 1);
  CHECK(many.approved() == Names{"b.png", "menu/a.png"});
  const Outcome empty = piped("printf ''");
  CHECK(empty.exit_code == 2);
  CHECK(contains(empty.err, "standard input: there is no name of a picture in the list"));
  // 2^26 bytes are the most that is read.
  const Outcome endless = piped("head -c 67108865 /dev/zero | tr '\\0' '\\n'");
  CHECK(endless.exit_code == 2);
  CHECK(contains(endless.err, "standard input: has more than 67108864 bytes"));
  many.here.write("long.txt", std::string(67'108'865, '\n'));
  CHECK(contains(many.diff("--approve-list long.txt").err, "has more than 67108864 bytes"));
}

TEST_CASE("no report replaces the list of what is approved") {
  const ManyPictures many;
  many.here.write("list.txt", "a.png\n");
  for (const char* option : {"--json", "--junit", "--markdown", "--html"}) {
    INFO(option);
    const Outcome outcome =
        many.diff("--approve-list list.txt " + std::string(option) + " ./list.txt");
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "would be overwritten"));
    CHECK(many.here.read("list.txt") == "a.png\n");
    CHECK(many.approved().empty());
  }
}

TEST_CASE("what cannot be approved is named, and the rest is approved") {
  const ManyPictures many;
  many.here.write("out/a.png", "no picture");
  many.here.write("list.txt", "a.png\nmenu/d.png\nmenu/c.png\n");
  const Outcome outcome = many.diff("--approve-list list.txt");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "no picture has the name 'menu/d.png'"));
  CHECK(contains(outcome.out, "a.png: not compared"));
  CHECK(many.approved() == Names{"menu/c.png"});

  const Outcome none = many.diff("--approve-matching x*");
  CHECK(none.exit_code == 2);
  CHECK(contains(none.err, "no picture's name matches 'x*'"));
}

TEST_CASE("a reference that cannot be written is named, and the rest is approved") {
  const ManyPictures many;
  // A folder stands where the first reference should be.
  fs::remove(many.here.file("ref/a.png"));
  fs::create_directories(many.here.file("ref/a.png/x"));
  const Outcome outcome = many.diff("--approve");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "ref/a.png"));
  CHECK(many.here.read("ref/b.png") == many.here.read("out/b.png"));
  CHECK(many.here.read("ref/menu/c.png") == many.here.read("out/menu/c.png"));
}

TEST_CASE("a first run without a reference folder says so, and --approve creates it") {
  const ManyPictures many;
  fs::remove_all(many.here.file("ref"));
  const Outcome first = many.diff("");
  CHECK(first.exit_code == 2);
  CHECK(contains(first.out, "the reference folder ref does not exist yet"));
  CHECK(contains(first.out, "4 pictures: 4 new\n"));
  CHECK(!fs::exists(many.here.file("ref")));
  const Outcome approved = many.diff("--approve");
  CHECK(approved.exit_code == 0);
  CHECK(!contains(approved.out, "does not exist yet"));
  CHECK(many.approved() == many.names);
  const Outcome mistyped = many.here.run("diff ref owt");
  CHECK(mistyped.exit_code == 2);
  CHECK(contains(mistyped.err, "owt"));
}

TEST_CASE("a pattern or a list is refused for single pictures, on a server, and without names") {
  const ManyPictures many;
  many.here.write("empty.txt", "# nothing\n");
  const std::vector<std::string> refused{"diff ref/a.png out/a.png --approve-matching a*",
                                         "diff ref/a.png out/a.png --approve-list empty.txt",
                                         "diff ref out --approve-list empty.txt",
                                         "diff ref out --approve-list none.txt"};
  for (const std::string& words : refused) {
    INFO(words);
    CHECK(many.here.run(words).exit_code == 2);
  }
  const EnvironmentVariable on_server("CI", "1");
  CHECK(many.diff("--approve-matching *").exit_code == 2);
  CHECK(many.approved().empty());
}

TEST_CASE("annotations and the summary in Markdown are printed as asked") {
  const ManyPictures many;
  const Outcome annotated = many.diff("--github");
  CHECK(annotated.exit_code == 1);
  CHECK(contains(annotated.out, "::error file=ref/menu/c.png,title=picture different::"));
  const Outcome summary = many.diff("--github --markdown -");
  CHECK(summary.out.starts_with("### ref and out\n"));
  CHECK(contains(summary.err, "::error file=ref/a.png,"));
  CHECK(many.diff("--markdown s.md --json -").exit_code == 1);
  CHECK(many.here.read("s.md") == summary.out);
  CHECK(many.diff("--markdown - --json -").exit_code == 2);
  CHECK(many.diff("--markdown - --json - --junit -").exit_code == 2);
}

}  // namespace
}  // namespace glassbox::test
