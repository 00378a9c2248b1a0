// The seven situations of a picture test, and what glassbox diff reports in each, for every kind of
// file.
#include "tests/support/catch.h"

#include <string>
#include <vector>

#include "tests/app/picture_file_kinds.h"

#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox::test {
namespace {

constexpr int kSevenWidth = 24, kSevenHeight = 18;  // px
constexpr int kWrongX = 13, kWrongY = 7;

// Pictures of one kind: r is the reference, the others are test pictures.
class TestPictures {
public:
  explicit TestPictures(const PictureFileKind& kind) : kind_(kind) {
    const StoredImage reference = sample_picture(kind, kSevenWidth, kSevenHeight);
    write("r", reference);
    write("same", reference);
    write("up", one_step_up(reference));
    StoredImage wrong = reference;
    for (int c = 0; c < kind.channels; ++c) {
      set_sample(wrong, kWrongX, kWrongY, c, sample_at(reference, 0, 0, c));
    }
    write("wrong", wrong);
    write("shifted", shifted(reference));
    write("wider", sample_picture(kind, kSevenWidth + 1, kSevenHeight));
    const std::string whole = kind.encode(reference);
    here_.write("corrupt" + kind.extension, whole.substr(0, whole.size() / 2));
  }
  Outcome diff(const std::string& test, const std::string& options = "") const {
    return here_.run("diff r" + kind_.extension + " " + test + kind_.extension + " " + options);
  }
  std::string name(const std::string& test) const { return test + kind_.extension; }

private:
  void write(const std::string& name, const StoredImage& image) const {
    here_.write(name + kind_.extension, kind_.encode(image));
  }
  PictureFileKind kind_;
  WorkingDirectory here_;
};

void check_different(const Outcome& outcome, const std::string& name) {
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find(name + ": different: ") == 0);
  CHECK(outcome.err.empty());
}

void check_refused_by_name(const Outcome& outcome, const std::string& name) {
  check_refused(outcome, {name});
  CHECK(outcome.err.starts_with("glassbox: " + name + ": "));
}

TEST_CASE(
    "the same is 0, any difference 1, and what is missing or corrupt 2, in every kind of file") {
  for (const PictureFileKind& kind : all_kinds()) {
    INFO(kind.name);
    const TestPictures all(kind);
    const Outcome same = all.diff("same");
    CHECK(same.exit_code == 0);
    CHECK(same.out == all.name("same") + ": same\n");
    CHECK(same.err.empty());
    for (const char* test : {"up", "wrong", "shifted", "wider"}) {
      check_different(all.diff(test), all.name(test));
    }
    check_refused_by_name(all.diff("missing"), all.name("missing"));
    check_refused_by_name(all.diff("corrupt"), all.name("corrupt"));
  }
}

TEST_CASE("what is said of a difference is where it is, how large, and what may be behind it") {
  for (const PictureFileKind& kind : all_kinds()) {
    if (!kind.exact) continue;
    INFO(kind.name);
    const TestPictures all(kind);
    const char* step = kind.format == Format::kBytes    ? "1/255"
                       : kind.format == Format::kShorts ? "1/65535"
                                                        : "1 ulp";
    const Outcome up = all.diff("up");
    INFO(up.out);
    CHECK(contains(up.out, ": different: 432 of 432 pixels differ, by up to " + std::string(step) +
                               ", in 1 region; first (0, 0): "));
    if (kind.format != Format::kFloats)
      CHECK(contains(up.out, "was added to every pixel of the reference"));

    const Outcome wrong = all.diff("wrong");
    INFO(wrong.out);
    CHECK(contains(wrong.out, ": different: 1 of 432 pixels differ, by up to "));
    CHECK(contains(wrong.out, "in 1 region; first (13, 7): "));
    CHECK(!contains(wrong.out, "likely: the test is"));
    CHECK(!contains(wrong.out, "likely: every"));

    CHECK(contains(all.diff("shifted").out,
                   "likely: the test is the reference moved by (+1, +0) pixels"));
    CHECK(contains(all.diff("wider").out, "the reference has 24 x 18 pixels, the test 25 x 18"));
  }
}

TEST_CASE("a tolerance lets pass exactly what it says") {
  for (const PictureFileKind& kind : all_kinds()) {
    if (!kind.exact) continue;
    INFO(kind.name);
    const TestPictures all(kind);
    CHECK(all.diff("same", "--fuzzy 0;0").exit_code == 0);
    CHECK(all.diff("same", "--fuzzy 1;1").exit_code == 1);
    CHECK(all.diff("up", "--fuzzy maxDifference=0-1;totalPixels=0-432").exit_code == 0);
    CHECK(all.diff("up", "--fuzzy totalPixels=432;maxDifference=1").exit_code == 0);
    CHECK(all.diff("up", "--fuzzy 0-1;0-431").exit_code == 1);
    CHECK(all.diff("up", "--fuzzy 0;0-432").exit_code == 1);
    CHECK(all.diff("up", "--fuzzy 2-9;0-432").exit_code == 1);
    CHECK(all.diff("wrong", "--fuzzy 0-4294967294;1").exit_code == 0);
    CHECK(all.diff("wrong", "--fuzzy 0-4294967294;0").exit_code == 1);
    CHECK(all.diff("wider", "--fuzzy 0-4294967294;0-1000").exit_code == 1);
    CHECK(all.diff("wrong", "--ignore 13,7,1x1").exit_code == 0);
    CHECK(all.diff("wrong", "--ignore 0,0,13x18 --ignore 14,0,10x18").exit_code == 1);
    const bool floats = kind.format == Format::kFloats;
    CHECK(all.diff("up", "--max-ulp 1").exit_code == (floats ? 0 : 1));
    CHECK(all.diff("up", "--max-ulp 0").exit_code == 1);
    const Outcome passed = all.diff("up", "--fuzzy 0-1;0-432");
    CHECK(passed.out.find(all.name("up") + ": within tolerance: 432 of 432 pixels differ") == 0);
  }
}

TEST_CASE(
    "the annotation that --suggest-fuzzy prints makes the pictures pass, and no tighter one does") {
  for (const PictureFileKind& kind : all_kinds()) {
    const TestPictures all(kind);
    for (const char* test : {"same", "up", "wrong", "shifted"}) {
      const Outcome outcome = all.diff(test, "--suggest-fuzzy");
      INFO(kind.name << ", " << test << ": " << outcome.out);
      const std::string label = "  fuzzy: ";
      const auto start = outcome.out.find(label);
      REQUIRE(start != std::string::npos);
      const auto end = outcome.out.find('\n', start);
      const std::string fuzzy =
          outcome.out.substr(start + label.size(), end - start - label.size());
      CHECK(all.diff(test, "--fuzzy " + fuzzy).exit_code == 0);
      const auto tight = parse_fuzzy(fuzzy);
      REQUIRE(tight);
      Fuzzy fewer = *tight;
      if (fewer.total_pixels.highest == 0) continue;
      fewer.total_pixels = {0, fewer.total_pixels.highest - 1};
      CHECK(all.diff(test, "--fuzzy " + to_string(fewer)).exit_code == 1);
      Fuzzy smaller = *tight;
      smaller.max_difference = {0, smaller.max_difference.highest - 1};
      CHECK(all.diff(test, "--fuzzy " + to_string(smaller)).exit_code == 1);
    }
  }
}

}  // namespace
}  // namespace glassbox::test
