// The verdict on the answers of a lab: how many points each case gets, and where a check first goes
// wrong. The student's program has been run before (run_check.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "labs/framework/compare.h"
#include "labs/framework/lab.h"
#include "labs/framework/protocol.h"

namespace glassbox::labs {

enum class Verdict {
  kRight,
  kWrong,
  kMissing,
  kThrew,
  kCrash,
  kTimeout,
  kLimit,
  kMalformed,
  kNotBuilt,
  kUntouched
};

// The name of a verdict: "right", "wrong answer", "no answer", "exception", "crash", "timeout",
// "limit exceeded", "malformed output", "not built", "not written yet".
const char* verdict_name(Verdict verdict);

// The first case of a check that is not right.
struct FirstFailure {
  std::size_t index = 0;
  std::string where, restated;  // as in Case
  Verdict verdict = Verdict::kWrong;
  std::string text;                      // how it crashed, what it threw, what is malformed
  std::optional<Divergence> divergence;  // only for a wrong answer
  // How the wrong field differs from what is expected; empty if the case has a judge of its own.
  std::optional<Comparison> comparison;
  std::optional<Expected> expected;  // what is expected of the wrong field
  std::vector<double> actual;        // the numbers that the wrong field has
  // only for a generated input: the choices that make it (choices.h), and how many inputs of its
  // class have wrong answers (0: not known, because the program did not answer them all)
  std::optional<std::vector<std::uint64_t>> choices;
  std::size_t wrong_inputs = 0;
};

// The verdict on an answer to one case, with the place where it is wrong. The verdict is kRight if
// it is right, and then the other members have no meaning.
FirstFailure judge_answer(const Case& input, const CaseAnswer& answer, std::size_t index);

struct CheckResult {
  std::string name, task, stage;
  bool hidden = false;
  bool all_or_nothing = false;  // as Check::all_or_nothing
  bool generated = false;       // as Check::generated
  double score = 0, max_score = 0;
  Verdict verdict = Verdict::kRight;  // the verdict on the first case that is not right
  std::vector<Verdict> cases = {};
  std::size_t right = 0;
  std::optional<FirstFailure> first = {};
  // The id of the typical mistake (slip) that explains every wrong answer of the check; empty if
  // none or more than one does.
  std::vector<std::string> slips = {};
  std::string printed = {};  // what the student's code printed
  double seconds = 0;
};

// The text that follows "13 of 14 cases right" in a report.
inline const char* all_or_nothing_note(const CheckResult& check) {
  return check.all_or_nothing && check.right < check.cases.size()
             ? "; it gives points only if all cases are right"
             : "";
}

struct TaskResult {
  std::string id, title;
  double score = 0, max_score = 0;  // sums over the checks that were judged
};

struct LabResult {
  int number = 0;
  std::string folder, title;
  double score = 0, max_score = 0;
  double hidden_points = 0;  // the points of hidden checks that were not judged
  std::vector<TaskResult> tasks = {};
  std::vector<CheckResult> checks = {};
  std::string not_built = {};  // the compiler's messages; empty if the code compiled
  std::vector<std::string> warnings = {};
};

CheckResult judge_check(const Check& check, const std::vector<Case>& cases,
                        const CheckAnswers& answers, double points_of_case);

// Whether two programs gave the same answer to every case of a check. If a student's program
// answers like the starter (the file that students begin with), the task has not been begun.
bool same_answers(const CheckAnswers& a, const CheckAnswers& b);

// The result of a check that has no answers, because the code does not compile.
CheckResult not_built_check(const Check& check, std::size_t cases, double points_of_case);

// Sums up the checks by task. They must be in the lab's order.
LabResult sum_up(const Lab& lab, std::vector<CheckResult> checks);

}  // namespace glassbox::labs
