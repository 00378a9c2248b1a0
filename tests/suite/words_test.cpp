// Tests which words of a source are taken for programs that it starts.
#include "tests/suite/program_words.h"
#include "tests/support/catch.h"

namespace glassbox::test {

TEST_CASE("the commands of a shell script are found wherever one can begin") {
  CHECK(shell_words("cowsay hello | figlet && lolcat; toilet & sl") ==
        Words{"cowsay", "figlet", "lolcat", "toilet", "sl"});
  CHECK(shell_words("if cowsay; then figlet; else lolcat; fi") ==
        Words{"cowsay", "figlet", "lolcat"});
  CHECK(shell_words("x=$(cowsay \"$(figlet a)\") y=\"${z:-$HOME}\" lolcat b") ==
        Words{"cowsay", "figlet", "lolcat"});
  CHECK(shell_words("! exec cowsay\n(cd here && figlet)\nwhile lolcat; do sl; done") ==
        Words{"cowsay", "figlet", "lolcat", "sl"});
  CHECK(shell_words("/usr/bin/env -i A=b cowsay figlet") == Words{"env", "cowsay"});
  CHECK(shell_words("find . -name a -exec cowsay {} +") == Words{"find", "cowsay"});
  CHECK(shell_words("command -v cowsay >/dev/null 2>&1 || figlet") == Words{"cowsay", "figlet"});
  CHECK(shell_words("cowsay a \\\n  b \\\n  | figlet") == Words{"cowsay", "figlet"});
}

TEST_CASE("what is no command of a shell script is not taken for one") {
  CHECK(shell_words("# cowsay\necho cowsay 'a; figlet' \"b; lolcat\" >sl 2>&1").empty());
  CHECK(shell_words("f() { cowsay; }\nf\nA=figlet\n$sl -x\n./lolcat\ntest a") == Words{"cowsay"});
  CHECK(shell_words("cat <<'TEXT'\ncowsay | figlet\nTEXT\nsl") == Words{"cat", "sl"});
  CHECK(shell_words("a=$((1 + 2)); b=${c:+figlet}; sl") == Words{"sl"});
}

TEST_CASE("the programs that C++ sources start are found in the calls and the variables of these") {
  CHECK(cpp_words("std::system(\"cowsay a >/dev/null\");") == Words{"cowsay"});
  CHECK(cpp_words(
            "run_program(\"/bin/sh\", {\"-c\", \"cowsay \" + a + \" | fig\"\n  \"let\"}, b);") ==
        Words{"sh", "cowsay", "figlet"});
  CHECK(cpp_words("const std::string line = \"cowsay {\\\"(\\\"} && \" + b;\n"
                  "run_program(\"/bin/sh\", {\"-c\", line}, c);") == Words{"sh", "cowsay"});
  CHECK(cpp_words("std::string name = \"cowsay\";\n::posix_spawnp(&child, name.c_str(), 0);") ==
        Words{"cowsay"});
  CHECK(cpp_words("run_process({\"cowsay\", file}, {});") == Words{"cowsay"});
  CHECK(cpp_words("return R\"sh(#!/bin/sh\ncowsay \"$a\"\n)sh\";") == Words{"cowsay"});
  CHECK(cpp_words("run_program(GLASSBOX_PROGRAM, {\"info\", \"cowsay\"}, a); say(\"cowsay\");")
            .empty());
}

TEST_CASE("the programs that CMake and JavaScript files start are found") {
  CHECK(cmake_words("find_program(a NAMES cowsay)\nexecute_process(COMMAND figlet -u ${b})\n"
                    "add_test(NAME c COMMAND ${d})") == Words{"cowsay", "figlet"});
  CHECK(javascript_words(
            "execFileSync('cowsay', [a]); execFileSync(program, ['x']); \"/usr/bin/sl\"") ==
        Words{"cowsay", "sl"});
}

TEST_CASE("a source that starts programs itself is known from one that calls those") {
  CHECK(launches("  ::execv(argv[0], argv);"));
  CHECK(launches("if (std::system(a) == 0)"));
  CHECK(launches("x = popen(a, b);"));
  CHECK_FALSE(
      launches("run_program(\"/bin/sh\", a);\n// exec in words\nsystem_calls(x); c.system(y);"));
}

}  // namespace glassbox::test
