// Nothing that students get solves a task: each function of student.h is replaced by a call of each
// function that is defined in their headers, with the arguments in every order, with fewer of them,
// or with their members, and must not get all points of its task.
#include <algorithm>
#include <mutex>
#include <numeric>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "labs/framework/run_in_parallel.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/handed_out.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/daily_share.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// The environment variable that has the function's name and the number of the call to paste into
// it; instead of a number, "list" prints all calls and ends the program.
constexpr const char* kPasted = "GLASSBOX_PASTED";
constexpr const char* kCall = "call: ";
constexpr const char* kEnd = "all calls";

// "a, b" becomes {"a", "b"}.
std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  static const std::regex word(R"(\w+)");
  for (std::sregex_iterator at(list.begin(), list.end(), word), end; at != end; ++at)
    words.push_back(at->str());
  return words;
}

// The lists of arguments to try: all of them in every order, and fewer of them in their order.
std::vector<std::vector<std::string>> argument_lists(std::vector<std::string> words) {
  std::vector<std::vector<std::string>> lists;
  const std::size_t count = words.size();
  for (std::size_t set = 0; set + 1 < std::size_t(1) << count; ++set) {
    lists.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      if ((set >> i & 1) == 1) lists.back().push_back(words[i]);
    }
  }
  // More than 24 orders would take too long.
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  do {
    lists.emplace_back();
    for (const std::size_t i : order) lists.back().push_back(words[i]);
  } while (count <= 4 && std::next_permutation(order.begin(), order.end()));
  return lists;
}

// The code that a task's function begins with.
std::string pasted_into(const Function& function) {
  const std::vector<std::string> words = words_of(function.arguments);
  std::string text = fmt::format(
      "  if (pasting::is_on(\"{0}\")) {{\n    pasting::Trial<decltype({0}({1}))> trial;\n"
      "    trial.right = [&] {{ return chosen().{0}({1}); }};\n",
      function.name, function.arguments);
  for (const std::vector<std::string>& list : argument_lists(words)) {
    const std::string arguments = fmt::format("{}", fmt::join(list, ", "));
    text += fmt::format("    pasting::offer_each(trial, \"{}\"{}{});\n", arguments,
                        list.empty() ? "" : ", ", arguments);
  }
  std::string tuples;
  for (const std::string& word : words)
    tuples += (tuples.empty() ? "pasting::parts(" : "), pasting::parts(") + word;
  text += fmt::format(
      "    using Tied = decltype(std::tie({0}));\n"
      "    const auto parts = std::tuple_cat({1}));\n"
      "    if constexpr (!std::is_same_v<std::remove_const_t<decltype(parts)>, Tied>)\n"
      "      pasting::offer_members(trial, parts);\n    return trial.finish();\n  }}\n",
      function.arguments, tuples);
  return text;
}

// The code of pasting.h. Its include of the project is already there.
std::string pasting() {
  const auto text = read_text_file(GLASSBOX_SOURCE_DIR "/tests/labs/framework/pasting.h");
  REQUIRE(text);
  return filled_in(filled_in(*text, "#pragma once\n", ""),
                   "#include \"labs/framework/choices.h\"\n", "");
}

// Returns a student.cpp: the solution, each function of which begins with the pasted calls.
std::string solution_with_calls(const std::string& header, const std::string& solution,
                                const HandedOut& handed_out) {
  std::string visible, offers;
  int number = 0;
  for (const auto& [name, counts] : handed_out.functions) {
    if (handed_out.left_out.count(name) == 1) continue;
    visible +=
        fmt::format("VISIBLE(V{}, {}, {}, {})\n", ++number, name, counts.first, counts.second);
    offers += fmt::format("  offer_one<V{}>(trial, arguments, a...);\n", number);
  }
  std::string before = filled_in(pasting(), "// MEMBERS", handed_out.members);
  before = filled_in(filled_in(before, "// VISIBLE", visible), "// OFFERS", offers);
  std::string text = solution_with_all_faults(header, solution, {});
  for (const Function& each : functions_of(header)) {
    const std::string call = fmt::format("  return chosen().{}({});", each.name, each.arguments);
    text = filled_in(text, call, pasted_into(each) + call);
  }
  return filled_in(text, "\nnamespace lab_", "\n" + handed_out.text + before + "\nnamespace lab_");
}

// Runs a program with one pasted call.
LimitedRunner runner_of(const std::string& function, const std::string& call) {
  return LimitedRunner(fmt::format("{}={} {}", kPasted, function, call));
}

// The calls that compile in place of a function, and the task whose checks ask for it.
struct Calls {
  std::string task;
  std::vector<std::string> names;
};

Calls calls_of(const Lab& lab, const BenchProgram& program, const std::string& function) {
  Calls calls;
  for (const Check& check : lab.checks) {
    LimitedRunner runner = runner_of(function, "list");
    RunLimits limits;
    limits.printed_bytes = std::size_t(1) << 22;
    const auto answers = run_check(runner, program.path, check.name, 1, limits, 1);
    std::istringstream lines(answers.printed);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(kCall)) calls.names.push_back(line.substr(std::string(kCall).size()));
    }
    if (answers.printed.find(kEnd) == std::string::npos) continue;
    calls.task = check.task;
    break;
  }
  return calls;
}

struct Tried {
  std::size_t calls = 0;
  std::vector<std::string> solved;  // "edge: lab_06::handed_out::area(a, b, p)"
};

// Tries all functions that the lab's headers, and `further` code in cases.h, define.
Tried try_all(const Lab& lab, const std::string& further = {}) {
  Bench& bench = Bench::for_lab(lab);
  const auto header = read_text_file(bench.sources().labs / lab.folder / "student.h");
  REQUIRE(header);
  HandedOut visible = handed_out(bench.sources(), lab);
  const std::string space = fmt::format("lab_{:02}::handed_out", lab.number);
  visible.text += fmt::format("namespace {} {{{}}}\n", space, further);
  add_definitions(visible, further, space);
  const BenchProgram program =
      bench.program(solution_with_calls(*header, bench.solution(), visible));
  Tried tried;
  std::mutex mutex;
  for (const Function& function : functions_of(*header)) {
    const Calls calls = calls_of(lab, program, function.name);
    INFO("lab " << lab.folder << ", " << function.name << ", task " << calls.task);
    CHECK_FALSE(calls.task.empty());
    if (std::getenv("VERBOSE") != nullptr)
      fmt::print("{} {} {} {}\n{}\n", lab.folder, calls.task, function.name, calls.names.size(),
                 fmt::join(calls.names, "\n"));
    tried.calls += calls.names.size();
    run_in_parallel(calls.names.size(), [&](std::size_t i) {
      LimitedRunner runner = runner_of(function.name, std::to_string(i));
      if (bench.first_wrong(runner, program, calls.task, Checks::kOfTask) != nullptr) return;
      const std::lock_guard<std::mutex> lock(mutex);
      tried.solved.push_back(function.name + ": " + calls.names[i]);
    });
  }
  return tried;
}

}  // namespace

// A program with all calls takes some 5 seconds to compile, so two of the labs are tried each
// day.
TEST_CASE("no function that students get solves a task if it is pasted in its place") {
  const char* only = std::getenv("LAB");
  const test::DailyShare share(7);
  const std::vector<Lab>& labs = all_labs();
  for (std::size_t i = 0; i < labs.size(); ++i) {
    if (only != nullptr ? std::to_string(labs[i].number) != only : !share.includes(i, labs.size()))
      continue;
    INFO("lab " << labs[i].folder << ", " << share.text());
    const Tried tried = try_all(labs[i]);
    CHECK(tried.solved == std::vector<std::string>());
    CHECK(tried.calls > 15);
  }
}

// Each of these functions solves a task of lab 11 in a way of its own.
TEST_CASE("a function that solves a task is found among those that students get") {
  const Lab& lab = all_labs().at(10);
  REQUIRE(lab.folder == "11-matching");
  const Tried tried = try_all(lab, R"(
inline int different(std::uint32_t b, std::uint32_t a) {
  int count = 0;
  for (std::uint32_t bits = a ^ b; bits != 0; bits &= bits - 1) ++count;
  return count;
}
struct Question {
  const char* what = "";
  double disparity = 0;
  Calibration by;
};
struct Reply {
  bool is_known = false;
  double number = 0;
};
inline Reply reply_to(const Question& q) {
  const double d = q.disparity + q.by.offset;
  return {true, d > 0 && d < kNone ? q.by.focal * q.by.baseline / d : kNone};
}
inline double with_choices(glassbox::labs::Choices&, double d, double f, double b, double offset) {
  return d + offset > 0 && d < kNone ? f * b / (d + offset) : kNone;
}
)");
  const std::vector<std::string> wanted{
      "hamming: lab_11::handed_out::different(a, b)",
      "hamming: lab_11::handed_out::different(b, a)",
      "depth: lab_11::handed_out::reply_to(in braces after \"\": disparity, calibration)'s member",
      "depth: lab_11::handed_out::with_choices(after choices: members)"};
  for (const std::string& each : wanted) {
    INFO(each);
    CHECK(std::count(tried.solved.begin(), tried.solved.end(), each) == 1);
  }
}
