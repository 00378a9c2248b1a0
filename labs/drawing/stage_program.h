// Compiles a student's file with its lab's stages, and runs the program in the grader's sandbox,
// where it answers questions (inputs of the student's functions).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "labs/drawing/drawing.h"
#include "labs/framework/sources.h"
#include "labs/grading/sandbox.h"

namespace glassbox::labs {

struct StageProgram {
  std::filesystem::path program;  // empty: it did not compile
  std::string messages;           // the errors of the compiler, or its warnings
};

struct StageBuild {
  std::string folder;             // the lab's folder: "05-clipping"
  std::filesystem::path student;  // the student's student.cpp
  // where compiled files are kept for the next time; the caller owns it
  std::filesystem::path kept;
  // a directory that every user may pass through, but only its owner may write to
  std::filesystem::path scratch;
  bool timed = false;    // compiles the lab's timed.cpp in place of its stages.cpp
  bool starter = false;  // compiles the lab's starter in place of the student's file
};

// Compiles the program as far as its files have changed: the lab's own files directly, the
// student's in the sandbox. An error says what prevented the attempt.
Result<StageProgram> build_stages(const Sources& sources, const StageBuild& request,
                                  const grading::Sandbox& sandbox);

class BatchFile;

// Gets the answers from the student's process. If the student's code fails, the drawing ends: ask()
// then returns an error, and `failure` says what happened.
class StudentAnswers : public AnswerSource {
public:
  StudentAnswers(const grading::Sandbox& sandbox, std::filesystem::path program, double seconds);

  Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                   std::span<const Question> questions) override;

  // Measures `rounds` times how long the work of the question takes (the function that the stage's
  // `prepare` returns). The result is processor time and wall time in nanoseconds, in turn.
  Result<Numbers> time(const DrawnStage& stage, const Question& question, int rounds);

  const std::optional<std::string>& failure() const { return failure_; }
  const std::string& printed() const { return printed_; }  // what the student's code printed
  double seconds() const { return seconds_; }  // the time that the student's processes took

private:
  RunOutcome run(const DrawnStage& stage, int rounds, const BatchFile& file);
  Result<std::vector<Numbers>> ask_batch(const DrawnStage& stage, int rounds,
                                         std::span<const Question> batch);

  const grading::Sandbox& sandbox_;
  std::filesystem::path program_;
  grading::Limits limits_;
  std::optional<std::string> failure_;
  std::string printed_;
  double seconds_ = 0;
};

}  // namespace glassbox::labs
