// A student's file compiled with its lab's stages, and asked in the grader's sandbox.
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
  std::string messages;           // why not, or the compiler's warnings
};

struct StageBuild {
  std::string folder;             // of the lab: "05-clipping"
  std::filesystem::path student;  // the student's student.cpp
  std::filesystem::path kept;     // where what was made is kept for the next time; the caller's own
  std::filesystem::path
      scratch;         // a directory that every user may pass through, and its owner alone write to
  bool timed = false;  // of the lab's timed.cpp in place of its stages.cpp
  bool starter = false;  // the lab's starter in place of the student's file
};

// Compiles what has changed: the lab's own side as it is, the student's in the sandbox. An error is what kept it from being tried.
Result<StageProgram> build_stages(const Sources& sources, const StageBuild& request,
                                  const grading::Sandbox& sandbox);

class BatchFile;

// The student's process answers. What it does wrong ends the drawing: ask() is an error then, and `broke` says what happened.
class StudentAnswers : public Answering {
public:
  StudentAnswers(const grading::Sandbox& sandbox, std::filesystem::path program, double seconds);

  Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                   std::span<const Question> questions) override;

  // How long what the question asks for takes, `rounds` times, by the stage's `prepare`: the processor's and the wall's nanoseconds
  // in turn.
  Result<Numbers> time(const DrawnStage& stage, const Question& question, int rounds);

  const std::optional<std::string>& broke() const { return broke_; }
  const std::string& said() const { return said_; }  // what the student's code printed
  double seconds() const { return seconds_; }        // that its processes took

private:
  RunOutcome run(const DrawnStage& stage, int rounds, const BatchFile& file);
  Result<std::vector<Numbers>> ask_batch(const DrawnStage& stage, int rounds,
                                         std::span<const Question> batch);

  const grading::Sandbox& sandbox_;
  std::filesystem::path program_;
  grading::Limits limits_;
  std::optional<std::string> broke_;
  std::string said_;
  double seconds_ = 0;
};

}  // namespace glassbox::labs
