// Tests glassbox lab render and lab watch as a student uses them.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/sources.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A lab's folder that contains its solution with a part replaced.
class Folder {
public:
  explicit Folder(std::string number = "6", std::string name = "06-rasterisation")
      : name_(std::move(name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    REQUIRE(run({"lab", "start", number, "mine"}).exit_code == 0);
  }
  ~Folder() { fs::remove_all(path_); }

  void write(const std::string& find, const std::string& replace) const {
    std::string text = solution_text(find_sources().value(), name_).value();
    const std::size_t at = text.find(find);
    REQUIRE(at != std::string::npos);
    text.replace(at, find.size(), replace);
    std::ofstream(path_ / "mine/student.cpp") << text;
  }
  test::Outcome run(const std::vector<std::string>& words) const {
    return test::run_program(GLASSBOX_PROGRAM, words, path_.string());
  }
  test::Outcome render(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"lab", "render", "mine", "cube", "--size", "48x32"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  const fs::path& path() const { return path_; }

private:
  std::string name_;
  fs::path path_ = fs::temp_directory_path() / fmt::format("glassbox-lab-render-{}", getpid());
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("lab render says what is wrong where, as text, JSON and a page, and by its exit code") {
  const Folder folder;
  folder.write("+ 0.5)", "+ 0.5) + (pixels > 24 ? 9 : 0)");
  const auto wrong = folder.render({"--json", "out.json", "--html", "out.html", "-o", "out.png"});
  CAPTURE(wrong.out, wrong.err);
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "stage snap (snap)"));
  CHECK(has(wrong.out, "at most 0 is allowed"));
  const auto json = nlohmann::json::parse(read_text_file(folder.path() / "out.json").value());
  CHECK(json["right"] == false);
  CHECK(json["first_record"]["stage"] == "snap");
  CHECK(json["first_record"]["yours"].get<double>() -
            json["first_record"]["reference"].get<double>() ==
        9);
  CHECK(json["first_pixel"]["yours"] != json["first_pixel"]["reference"]);
  const std::string page = read_text_file(folder.path() / "out.html").value();
  CHECK(has(page, "\"student\":"));
  CHECK(has(page, "id=\"reference\""));
  CHECK(fs::exists(folder.path() / "out.png"));

  // If the functions cannot draw, there is no picture, and one line gives the reason.
  folder.write("std::int32_t snap(", "int missing_semicolon = 1\nstd::int32_t snap(");
  const auto broken = folder.render({"-o", "none.png"});
  CHECK(broken.exit_code == 1);
  CHECK(has(broken.out, "student.cpp:"));
  CHECK_FALSE(fs::exists(folder.path() / "none.png"));
  folder.write("std::int32_t snap(float pixels) {",
               "std::int32_t snap(float pixels) {\n  if (pixels > 24) throw 5;");
  const auto throwing = folder.render({"-o", "none.png"});
  CAPTURE(throwing.out);
  CHECK(throwing.exit_code == 1);
  CHECK(has(throwing.out, "snap: threw something"));
  CHECK(has(throwing.out, "triangle"));
  CHECK_FALSE(fs::exists(folder.path() / "none.png"));
}

TEST_CASE("lab render and lab stiff hand the assembler nothing that a compiler did not write") {
  const Folder folder("2", "02-affine");
  folder.write("all = matrix_of(step) * all;",
               "all = matrix_of(step) * all;\n  asm(\".incbin \\\"/etc/hostname\\\"\");");
  for (const auto& outcome :
       {folder.render({"-o", "none.png"}), folder.run({"lab", "stiff", "mine"})}) {
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(has(outcome.out, "that no compiler writes"));
  }
  CHECK_FALSE(fs::exists(folder.path() / "none.png"));
}

TEST_CASE("lab render refuses what it cannot draw with a line") {
  const Folder folder;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--wireframe"},
                                               {"-o", "x.gif"},
                                               {"-o", "q.png", "--json", "q.png"},
                                               {"--json", "a.json", "-o", "."}}) {
    const auto outcome = folder.render(more);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK(folder.run({"lab", "render", ".", "cube"}).exit_code == 2);
}

TEST_CASE("a submission without lab.json is drawn, and checked, as of the lab that --lab names") {
  const Folder folder;
  folder.write("+ 0.5)", "+ 0.5)");
  fs::create_directories(folder.path() / "ann");
  fs::copy_file(folder.path() / "mine/student.cpp", folder.path() / "ann/student.cpp");
  const auto unknown = folder.run({"lab", "render", "ann", "cube"});
  CHECK(unknown.exit_code == 2);
  CHECK(has(unknown.err, "--lab"));
  const auto drawn =
      folder.run({"lab", "render", "ann", "cube", "--lab", "6", "--size", "48x32", "-o", "a.png"});
  CAPTURE(drawn.out, drawn.err);
  CHECK(drawn.exit_code == 0);
  CHECK(fs::exists(folder.path() / "a.png"));
  const auto checked = folder.run({"lab", "check", "ann", "--lab", "rasterisation"});
  CHECK(checked.exit_code == 0);
  CHECK(has(checked.out, "Hidden checks can give"));
  const auto other = folder.run({"lab", "check", "mine", "--lab", "5"});
  CHECK(other.exit_code == 2);
  CHECK(has(other.err, "mine/lab.json says that it is lab 06-rasterisation"));
  // The submission's folder does not change.
  CHECK(std::distance(fs::directory_iterator(folder.path() / "ann"), fs::directory_iterator()) ==
        1);
}

TEST_CASE("a folder that is drawn brings no program of its own") {
  const Folder folder;
  folder.write("+ 0.5)", "+ 0.5)");
  const auto render = [&](const std::string& name) {
    return test::run_program(
        "/usr/bin/env",
        {"XDG_CACHE_HOME=" + (folder.path() / "cache").string(), GLASSBOX_PROGRAM, "lab", "render",
         name, "cube", "--size", "48x32", "-o", "a.png"},
        folder.path().string());
  };
  REQUIRE(render("mine").exit_code == 0);
  CHECK_FALSE(fs::exists(folder.path() / "mine/build"));
  // What is kept for a folder that was not drawn for a month is removed, and nothing else is.
  const fs::path labs = folder.path() / "cache/glassbox/labs";
  for (const char* name : {"recent", "old"}) fs::create_directories(labs / name);
  fs::last_write_time(labs / "old", fs::file_time_type::clock::now() - std::chrono::hours(24 * 31));
  REQUIRE(render("mine").exit_code == 0);
  CHECK(fs::exists(labs / "recent"));
  CHECK_FALSE(fs::exists(labs / "old"));
  fs::remove(labs / "recent");
  // A wrong student.cpp brings the program of the right one, with everything that would say that it
  // has been made from this student.cpp.
  fs::path kept;
  for (const auto& entry : fs::directory_iterator(folder.path() / "cache/glassbox/labs"))
    kept = entry.path() / "drawing";
  const fs::path brought = folder.path() / "ann/build/check/drawing";
  fs::create_directories(brought.parent_path());
  fs::copy(kept, brought, fs::copy_options::recursive);
  fs::copy_file(folder.path() / "mine/lab.json", folder.path() / "ann/lab.json");
  folder.write("+ 0.5)", "+ 0.5) + (pixels > 24 ? 9 : 0)");
  fs::copy_file(folder.path() / "mine/student.cpp", folder.path() / "ann/student.cpp");
  std::ofstream(brought / "student-key")
      << read_text_file(kept / "key").value()
      << read_text_file(folder.path() / "ann/student.cpp").value();
  const auto drawn = render("ann");
  CAPTURE(drawn.out, drawn.err);
  CHECK(drawn.exit_code == 1);
  CHECK(has(drawn.out, "stage snap (snap)"));
}

TEST_CASE("without a home directory nobody else's cache is used") {
  const Folder folder;
  folder.write("+ 0.5)", "+ 0.5)");
  const fs::path place = folder.path() / "tmp";
  fs::create_directories(place);
  const auto draw = [&] {
    return test::run_program(
        "/usr/bin/env",
        {"-u", "XDG_CACHE_HOME", "-u", "HOME", "TMPDIR=" + place.string(), GLASSBOX_PROGRAM, "lab",
         "render", "mine", "cube", "--size", "48x32", "-o", "a.png"},
        folder.path().string());
  };
  const fs::path cache = place / fmt::format("glassbox-{}", getuid());
  fs::create_directory_symlink(folder.path(), cache);
  const auto refused = draw();
  CHECK(refused.exit_code == 2);
  CHECK(has(refused.err, "is not a directory that only you can write to"));
  CHECK(has(refused.err, "set HOME or XDG_CACHE_HOME"));
  fs::remove(cache);
  CHECK(draw().exit_code == 0);
}

TEST_CASE(
    "the page of a lab that makes a picture of its own opens with it, beside the reference's") {
  const Folder folder("11", "11-matching");
  folder.write("#include <", "#include <");
  const auto drawn = folder.render({"--html", "out.html", "-o", "out.png"});
  CAPTURE(drawn.out, drawn.err);
  CHECK(drawn.exit_code == 0);
  const std::string page = read_text_file(folder.path() / "out.html").value();
  CHECK(has(page, "\"opening_overlay\":\"made\""));
  CHECK(has(page, "\"pictures\":[\"reference\",\"made\"]"));
  for (const std::string id : {"reference", "made"}) CHECK(has(page, "id=\"" + id + "\""));
}

TEST_CASE("lab watch with a scene draws again when the file is saved") {
  const Folder folder;
  folder.write("+ 0.5)", "+ 0.5)");
  const pid_t watching = fork();
  if (watching == 0) {
    if (chdir(folder.path().c_str()) != 0) _exit(1);
    freopen("watch.txt", "w", stdout);
    execl(GLASSBOX_PROGRAM, "glassbox", "lab", "watch", "mine", "cube", "--size", "48x32", "-o",
          "watched.png", static_cast<char*>(nullptr));
    _exit(1);
  }
  const auto says = [&](const std::string& what) {
    for (int tenths = 0; tenths < 1200; ++tenths) {
      const auto text = read_text_file(folder.path() / "watch.txt");
      if (text && has(*text, what)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  };
  CHECK(says("to run this again"));
  folder.write("+ 0.5)", "+ 7.5)");
  CHECK(says("stage snap (snap)"));
  kill(watching, SIGTERM);
  waitpid(watching, nullptr, 0);
  CHECK(fs::exists(folder.path() / "watched.png"));
}

TEST_CASE("lab stiff says where the functions give up, beside the reference") {
  const Folder folder("2", "02-affine");
  folder.write("all = matrix_of(step) * all;", "all = matrix_of(step) * all;");
  const auto right = folder.run({"lab", "stiff", "mine", "--json", "right.json"});
  CAPTURE(right.out, right.err);
  CHECK(right.exit_code == 0);
  CHECK(has(right.out, "C-15"));
  CHECK(has(right.out, "C-16"));
  CHECK(has(right.out, "C-19"));
  const auto json = nlohmann::json::parse(read_text_file(folder.path() / "right.json").value());
  CHECK(std::count_if(json["cases"].begin(), json["cases"].end(),
                      [](const auto& each) { return each.contains("yours"); }) == 3);

  folder.write("all = matrix_of(step) * all;",
               "all = matrix_of(step) * all, all.at(0, 3) += 0.25;");
  const auto wrong = folder.run({"lab", "stiff", "mine"});
  CAPTURE(wrong.out);
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "glassbox study extremes --case C-15"));

  folder.write("all = matrix_of(step) * all;", "*static_cast<volatile int*>(nullptr) = 1;");
  const auto crashing = folder.run({"lab", "stiff", "mine"});
  CAPTURE(crashing.out);
  CHECK(crashing.exit_code == 1);
  CHECK(has(crashing.out, "SIGSEGV"));
}

// The extreme case C-25 has faces of one and two corners, which read_mesh refuses as its contract
// requires.
TEST_CASE("lab stiff asks lab 1 for no face that its contract refuses") {
  const Folder folder("1", "01-meshes");
  folder.write("newell_vector", "newell_vector");
  const auto right = folder.run({"lab", "stiff", "mine"});
  CAPTURE(right.out, right.err);
  CHECK(right.exit_code == 0);
  CHECK(has(right.out, "C-25"));
}

TEST_CASE("lab render names a picture of the wrong size") {
  const Folder folder("9", "09-stereo");
  folder.write("  return shown;",
               "  Image<Rgba8> turned(anaglyph.height, anaglyph.width, "
               "anaglyph.background);\n  turned.pixels = shown.pixels;\n  return turned;");
  const auto wrong = folder.render({"-o", "out.png"});
  CAPTURE(wrong.out, wrong.err);
  CHECK(wrong.exit_code == 1);
  CHECK(has(wrong.out, "width"));
}
