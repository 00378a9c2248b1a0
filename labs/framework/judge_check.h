// The verdict on the answers of a lab: how many points each case gets, and where a check first goes
// wrong. Nothing is run here.
#pragma once

#include <cstddef>
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
  std::string where, restated;  // as the case has them
  Verdict verdict = Verdict::kWrong;
  std::string text;                      // how it crashed, what it threw, what is malformed
  std::optional<Divergence> divergence;  // only for a wrong answer
  // The comparison of the field that diverges, where the case has no judge of its own.
  std::optional<Comparison> comparison;
  std::optional<Expected> expected;  // what is expected of that field
  std::vector<double> actual;        // the answer's numbers for it
};

struct CheckResult {
  std::string name, task, stage;
  bool hidden = false;
  bool all_or_nothing = false;  // as in Check
  double score = 0, max_score = 0;
  Verdict verdict = Verdict::kRight;  // that of the first case that is not right
  std::vector<Verdict> cases = {};
  std::size_t right = 0;
  std::optional<FirstFailure> first = {};
  // The slip that explains every wrong answer of the check, if exactly one does: one id or none.
  std::vector<std::string> slips = {};
  std::string printed = {};  // what the student's code printed
  double seconds = 0;
};

// The text printed after "13 of 14 cases right".
inline const char* all_or_nothing_note(const CheckResult& check) {
  return check.all_or_nothing && check.right < check.cases.size()
             ? "; it gives points only if all cases are right"
             : "";
}

struct TaskResult {
  std::string id, title;
  double score = 0, max_score = 0;  // over the checks that were judged
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

// Whether two programs gave the same answer to every case of a check. If a student's program and
// the starter do, the task has not been begun.
bool same_answers(const CheckAnswers& a, const CheckAnswers& b);

// The result of a check without any answer, because the code does not compile.
CheckResult not_built_check(const Check& check, std::size_t cases, double points_of_case);

// Sums up the checks by task. They must be in the lab's order.
LabResult sum_up(const Lab& lab, std::vector<CheckResult> checks);

}  // namespace glassbox::labs
