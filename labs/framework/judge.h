// The verdict on the answers of a lab: what each case is worth, and where a check first goes wrong. Nothing is run here.
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

// "right", "wrong answer", "no answer", "exception", "crash", "timeout", "limit exceeded", "malformed output", "not built", "not written yet".
const char* verdict_name(Verdict verdict);

// The first case of a check that is not right.
struct FirstFailure {
  std::size_t index = 0;
  std::string where, restated;  // of the case
  Verdict verdict = Verdict::kWrong;
  std::string text;                      // how it crashed, what it threw, what is malformed
  std::optional<Divergence> divergence;  // of a wrong answer
  // Of the field that diverges, where the case has no judge of its own.
  std::optional<Comparison> comparison;
  std::optional<Expected> expected;  // that field
  std::vector<double> actual;        // what was answered in it
};

struct CheckResult {
  std::string name, task, stage;
  bool hidden = false;
  bool whole = false;  // as Check has it
  double score = 0, max_score = 0;
  Verdict verdict = Verdict::kRight;  // of the first case that is not right
  std::vector<Verdict> cases = {};
  std::size_t right = 0;
  std::optional<FirstFailure> first = {};
  // The slip that explains every wrong answer of the check, if one does and no other: one id or none.
  std::vector<std::string> slips = {};
  std::string said = {};  // what the student's code printed
  double seconds = 0;
};

// What is said behind "13 of 14 cases right".
inline const char* note_of_whole(const CheckResult& check) {
  return check.whole && check.right < check.cases.size() ? "; the check counts as a whole" : "";
}

struct TaskResult {
  std::string id, title;
  double score = 0, max_score = 0;  // of the checks judged
};

struct LabResult {
  int number = 0;
  std::string folder, title;
  double score = 0, max_score = 0;
  double hidden_points = 0;  // of hidden checks that were not judged
  std::vector<TaskResult> tasks = {};
  std::vector<CheckResult> checks = {};
  std::string not_built = {};  // what the compiler said; empty if it was content
  std::vector<std::string> warnings = {};
};

CheckResult judge_check(const Check& check, const std::vector<Case>& cases,
                        const CheckAnswers& answers, double points_of_case);

// Whether two programs answered every case of a check in the same way: a student's and the starter, of a task that nobody has begun.
bool same_answers(const CheckAnswers& a, const CheckAnswers& b);

// No answer to any case, because the code does not compile.
CheckResult not_built_check(const Check& check, std::size_t cases, double points_of_case);

// The checks, which must be in the lab's order, summed up by task.
LabResult sum_up(const Lab& lab, std::vector<CheckResult> checks);

}  // namespace glassbox::labs
