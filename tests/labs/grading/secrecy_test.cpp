// Hidden checks stay hidden: until grades are published, nothing that a student sees depends on
// them.
#include "labs/grading/assembly.h"

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

// Returns the results of one submission.
nlohmann::json graded(const TestDirectory& directory, const std::string& text,
                      const std::vector<std::string>& options = {}) {
  write(directory.path / "one/student.cpp", text);
  std::vector<std::string> words{"grade", "one",    "--one",        "--lab", "99",
                                 "-o",    "r.json", "--time-limit", "60"};
  words.insert(words.end(), options.begin(), options.end());
  const Outcome outcome = grader(words, directory.path);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return read_json(directory.path / "r.json");
}

// Returns what Gradescope shows before publishing: neither extra_data nor tests of another
// visibility.
std::string visible_before_publishing(const nlohmann::json& results) {
  nlohmann::json seen;
  for (const auto& [key, value] : results.items()) {
    if (key != "tests" && key != "extra_data") seen[key] = value;
  }
  for (nlohmann::json test : results.at("tests")) {
    test.erase("extra_data");
    if (test.at("visibility") == "visible") seen["tests"].push_back(test);
  }
  return seen.dump();
}

// A submission that declares the runner's functions, calls all its checks when it is called first,
// and prints all inputs.
const std::string kSpy = R"cpp(#include "student.h"
#include <cstdio>
#include <functional>
#include <string>
#include <vector>
                               namespace glassbox::labs {
                               class Answer {
                               public:
                                 struct Field {
                                   std::string name;
                                   std::vector<double> values;
                                 };
                                 std::vector<Field> fields_;
                               };
                               struct RunnerCheck {
                                 std::string name;
                                 int cases = 0;
                                 std::function<void(int, Answer&)> run;
                                 std::vector<int> generated;  // of the same size as the runner's
                               };
                               std::vector<RunnerCheck> runner_checks();
                               }  // namespace glassbox::labs
                               static bool spying = false;
                               static void spy() {
                                 if (spying) return;
                                 spying = true;
                                 for (auto& check : glassbox::labs::runner_checks()) {
                                   std::printf("check %s\n", check.name.c_str());
                                   for (int i = 0; i < check.cases; ++i) {
                                     glassbox::labs::Answer answer;
                                     check.run(i, answer);
                                   }
                                 }
                               }
                               double twice(double x) {
                                 spy();
                                 std::printf("input %.9g\n", x);
                                 return 0;
                               }
                               double reciprocal(double x) {
                                 spy();
                                 std::printf("input %.9g\n", x);
                                 return 0;
                               }
)cpp";

}  // namespace

TEST_CASE(
    "a submission that calls the runner's own checks finds no hidden one in a visible check") {
  const TestDirectory directory;
  const auto results = graded(directory, kSpy);
  const std::string seen = visible_before_publishing(results);
  // It sees the visible checks, so it would have seen the others as well.
  CHECK(seen.find("check twice a number") != std::string::npos);
  CHECK(seen.find("input 8") != std::string::npos);
  CHECK(seen.find("a reciprocal undone") == std::string::npos);
  CHECK(seen.find("0.015625") == std::string::npos);
  CHECK(seen.find("input -5") == std::string::npos);
  // The hidden check was run too: its prints are shown when grades are published.
  CHECK(results.dump().find("input 0.015625") != std::string::npos);
}

TEST_CASE(
    "submissions that differ in hidden checks alone look the same until grades are published") {
  const TestDirectory directory;
  const auto right = graded(directory, submission("return 2 * x;", "return 1 / x;"));
  const auto wrong = graded(directory, submission("return 2 * x;", "return x == -5 ? 0 : 1 / x;"));
  CHECK(total(right) != total(wrong));
  CHECK(visible_before_publishing(right) == visible_before_publishing(wrong));
  CHECK(right.at("tests")[2].at("visibility") == "after_published");
}

TEST_CASE("a file that the assembler would read is refused before it reads it") {
  const std::string secret = "the secret of this test";
  const TestDirectory directory;
  write(directory.path / "secret", secret);
  const std::string file = (directory.path / "secret").string();
  const std::string right =
      "double twice(double x) { return 2 * x; }\ndouble reciprocal(double x) { return 1 / x; }\n";
  const std::string shows =
      "extern const char stolen[];\n#include <cstdio>\ndouble twice(double) { std::puts(stolen); "
      "return 0; }\n"
      "double reciprocal(double x) { return 1 / x; }\n";
  const std::vector<std::string> attacks{
      "asm(\".section .rodata\\nstolen: .incbin \\\"" + file + "\\\"\\n.byte 0\\n.text\\n\");\n",
      "asm(\".section .rodata\\nstolen: .INCBIN \\\"" + file + "\\\"\\n.byte 0\\n.text\\n\");\n",
      "asm(\".macro m x\\n.inc\\\\x \\\"" + file +
          "\\\"\\n.endm\\n.section .rodata\\nstolen: m bin\\n.byte 0\\n.text\\n\");\n",
      "asm(\".include \\\"" + file + "\\\"\");\nconst char stolen[] = \"\";\n",
      "__attribute__((section(\"x,\\\"a\\\"\\nstolen: .incbin \\\"" + file +
          "\\\"\\n.byte 0\\n.section y\"))) int hidden_away = 1;\n",
  };
  for (const std::string sandbox : {"limits", ""}) {
    for (const std::string& attack : attacks) {
      const auto options = sandbox.empty() ? std::vector<std::string>{}
                                           : std::vector<std::string>{"--sandbox", sandbox};
      const auto results = graded(directory, "#include \"student.h\"\n" + attack + shows, options);
      INFO(attack << results.dump(2));
      CHECK(results.at("extra_data").at("outcome") == "compile error");
      CHECK(results.dump().find(secret) == std::string::npos);
    }
  }
  CHECK(total(graded(directory, "#include \"student.h\"\n" + right)) == 10);
}

TEST_CASE("a compiler's message has nothing of a file that is not the lab's") {
  const TestDirectory directory;
  write(directory.path / "secret", "constexpr int kSecret = 90210;\n");
  const std::string file = "\"" + (directory.path / "secret").string() + "\"";
  const std::vector<std::string> attacks{
      "#include " + file + "\nint kSecret = 8;\n",  // the message quotes the earlier definition
      "#line 1 " + file + "\nint f() { return unknown; }\n",  // g++ quotes line 1 of that file
      "#include " + file + "\ntemplate <int> struct P;\nP<kSecret> p;\n",
      "#include " + file + "\n#error here\n",
      "#include " + file + "\n#include \"is-not-there.h\"\n",
  };
  for (const std::string sandbox : {"limits", ""}) {
    for (const std::string& attack : attacks) {
      const auto options = sandbox.empty() ? std::vector<std::string>{}
                                           : std::vector<std::string>{"--sandbox", sandbox};
      const auto results = graded(directory, "#include \"student.h\"\n" + attack, options);
      INFO(attack << results.dump(2));
      CHECK(results.at("extra_data").at("outcome") == "compile error");
      CHECK(results.dump().find("90210") == std::string::npos);
    }
  }
  // For the student's own file the message states what is wrong and where.
  const std::string own = graded(directory, "#include \"student.h\"\nint f() { return unknown; }\n",
                                 {"--sandbox", "limits"})
                              .at("output");
  CHECK(own.find("student.cpp:2:18: error: ") != std::string::npos);
  CHECK(own.find("unknown") != std::string::npos);
}

TEST_CASE("in no sandbox a compiler tells which files are on the machine") {
  const TestDirectory directory;
  write(directory.path / "secret", "constexpr int kSecret = 90210;\n");
  fs::permissions(directory.path / "secret", fs::perms(0644));
  fs::create_directories(directory.path / "closed");
  fs::permissions(directory.path / "closed", fs::perms(0700));
  const std::string there = (directory.path / "secret").string(),
                    up = "/usr/include/../../" + there.substr(1);
  std::string asks = "#include \"student.h\"\n#include <cstdio>\n#include <sys/cdefs.h>\n";
  int i = 0;
  for (const std::string& path :
       {"\"" + there + "\"", "<" + there + ">", "\"" + up + "\"", "\"" + there + "/x\"",
        "\"" + (directory.path / "closed/x").string() + "\"", std::string("\"/etc/passwd\""),
        std::string("\"/proc/self/status\"")}) {
    // The word can be put together by a macro of the system, so that no search for it finds it.
    const std::string word = i % 2 == 0 ? "__has_include" : "__CONCAT(__has, _include)";
    asks += "#if " + word + "(" + path + ")\n#warning file " + std::to_string(i++) +
            " is there\n#endif\n";
  }
  // What the lab and the system have is there as ever.
  asks += "#if !__has_include(<vector>) || !__has_include(\"student.h\")\n#error\n#endif\n";
  asks +=
      "double twice(double x) { return 2 * x; }\ndouble reciprocal(double x) { return 1 / x; }\n";
  for (const std::string sandbox : {"limits", ""}) {
    const auto options = sandbox.empty() ? std::vector<std::string>{}
                                         : std::vector<std::string>{"--sandbox", sandbox};
    const auto results = graded(directory, asks, options);
    INFO(results.dump(2));
    CHECK(total(results) == 10);
    CHECK(results.dump().find("is there") == std::string::npos);
  }
}

TEST_CASE("a foreign file is found however much is included before it") {
  const TestDirectory directory;
  write(directory.path / "secret", "constexpr int kSecret = 90210;\n");
  std::string many;
  for (const char* header : {"algorithm", "chrono", "complex", "deque", "filesystem", "fstream",
                             "functional", "future", "map", "memory", "mutex", "random", "ranges",
                             "regex", "set", "sstream", "thread", "unordered_map", "valarray"})
    many += "#include <" + std::string(header) + ">\n";
  // The preprocessor's list of includes is longer than the 16 KiB that are kept of other programs'
  // output.
  write(directory.path / "many.cpp", many);
  const Outcome listed =
      run_program("/usr/bin/env", {"g++", "-std=c++20", "-E", "-H", "-o", "/dev/null", "many.cpp"},
                  directory.path.string());
  REQUIRE(listed.exit_code == 0);
  CHECK(listed.err.size() > std::size_t(16) << 10);

  // Without the library that hides files from the compiler only this list remains.
  const fs::path kit = directory.path / "kit";
  const auto in_limits = [&](const std::string& before) {
    return graded(directory, before + solution(), {"--sandbox", "limits", "--kit", kit.string()});
  };
  CHECK(total(in_limits(many)) == 10);
  const std::string library = (kit / "compiler-view.so").string();
  REQUIRE(fs::remove(library));
  write(directory.path / "nothing.cpp", "\n");
  REQUIRE(run_program("/usr/bin/env", {"g++", "-shared", "-o", library, "nothing.cpp"},
                      directory.path.string())
              .exit_code == 0);
  const auto without = in_limits(many);
  CHECK(total(without) == 10);
  CHECK(without.at("extra_data").at("sandbox").get<std::string>().find("no library hides files") !=
        std::string::npos);
  const auto results =
      in_limits(many + "#include \"" + (directory.path / "secret").string() + "\"\n#error here\n");
  INFO(results.dump(2));
  CHECK(results.at("extra_data").at("outcome") == "compile error");
  const std::string output = results.at("output");
  CHECK(output.find("secret, which is not part of the lab") != std::string::npos);
  CHECK(output.find("90210") == std::string::npos);
}

TEST_CASE("the library that hides files is never left out in silence") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp", solution());
  const auto in_limits = [&](const fs::path& temporary, const fs::path& kit) {
    fs::create_directories(temporary);
    return run_program(
        "/usr/bin/env",
        {"TMPDIR=" + temporary.string(), TINY_GRADER, "lab", "grade", "one", "--one", "--lab", "99",
         "-o", "r.json", "--sandbox", "limits", "--kit", kit.string()},
        directory.path.string());
  };
  const fs::path kit = directory.path / "kit";
  const Outcome fine = in_limits(directory.path / "plain", kit);
  CHECK(fine.exit_code == 0);
  CHECK(fine.err.find("a library hides all files but the compiler's own") != std::string::npos);
  // The dynamic linker could not load the library from there.
  for (const char* name : {"a b", "a:b", "$ORIGIN"}) {
    const Outcome refused = in_limits(directory.path / name, kit);
    INFO(name << ": " << refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("set TMPDIR to another directory") != std::string::npos);
  }
  REQUIRE(fs::remove(kit / "compiler-view.so"));
  const Outcome missing = in_limits(directory.path / "plain", kit);
  INFO(missing.err);
  CHECK(missing.exit_code == 2);
  CHECK(missing.err.find("compiler-view.so: cannot be copied") != std::string::npos);
}

TEST_CASE("only what compilers write is assembled") {
  using labs::grading::foreign_statement;
  for (const char* fine :
       {"\t.file\t\"a.cpp\"\n\t.text\nf:\n\tmovl\t$1, %eax; ret\n", ".L1: .L2:\tnop\n",
        "# 5 \"a.cpp\" 1\n\t.ascii \"\\\".incbin\\\" ;.include\"\n", "x = 4\n.L5 = 3",
        "\t.cfi_startproc\n", "\tmov x0, #4\n", ""})
    CHECK_FALSE(foreign_statement(fine));
  for (const char* foreign :
       {".incbin \"f\"", "\tnop; .incbin \"f\"\n", "a: .incbin \"f\"\n", "a:b:\t.InCbIn \"f\"\n",
        ".include \"f\"", ".macro m\n", ".irp x,y\n", ".rept 2\n", "\".incbin\" \"f\"\n",
        "nop /* \" */ ; .incbin \"f\" /* \" */\n", ".byte '\" ; .incbin \"f\"\n",
        ".ascii \"a\nb\" ; .incbin \"f\"\n", ".ascii \"a\\\n\" ; .incbin \"f\"\n",
        "nop \f .incbin \"f\"\n", ".altmacro\n", ".linkonce\n", "{evex} nop\n", "\\x\n"}) {
    INFO(foreign);
    CHECK(foreign_statement(foreign));
  }
}

}  // namespace glassbox::test
