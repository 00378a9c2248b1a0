// The place where a submission is compiled and run: the strongest confinement that this machine
// offers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labs/framework/run_check.h"
#include "labs/grading/limits.h"
#include "labs/grading/process.h"

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

enum class Confinement {
  kBubblewrap,  // namespaces: no other process, no network and only named files are visible
  // only named files can be opened; the system-call filter blocks network and other processes
  kLandlock,
  // the system-call filter only; the kernel lets a compiler read every file that its user can read
  kLimits,
};

constexpr std::string_view name_of(Confinement confinement) {
  constexpr std::string_view kNames[] = {"bubblewrap", "landlock", "limits"};
  return kNames[std::size_t(confinement)];
}

class Sandbox {
public:
  // Chooses the strongest confinement that works when a real process is run in `scratch`, which
  // must exist. With `only`, no other kind is tried. It is an error if there is neither bubblewrap
  // nor a filter for system calls. kLimits does not work if the path of `scratch` has a blank, a
  // colon or a dollar sign: the library that hides files from a compiler could not be named there.
  static Result<Sandbox> choose(const std::filesystem::path& scratch,
                                std::optional<Confinement> only = {});

  Confinement confinement() const { return confinement_; }
  // The confinement in one sentence. Where it hides no files itself, try_view() comes first.
  std::string description() const;
  // Finds out whether the library `view` (BuildKit::view) hides files from this compiler, where the
  // confinement does not do so itself.
  void try_view(const std::filesystem::path& view, const std::string& compiler,
                const std::filesystem::path& scratch);
  // Gives `path` to the user that owns the files which a submission's processes write. Does nothing
  // where that user is the caller.
  bool give_to_sandbox_user(const std::filesystem::path& path) const;

  // Runs a compiler in the directory `build`, which it may write to. Apart from that it sees only
  // the system's compiler files and `readable`. Where the confinement hides no files, the library
  // `view` (BuildKit::view) does so, unless it is empty.
  RunOutcome compile(const std::vector<std::string>& command, const std::filesystem::path& build,
                     const std::vector<std::filesystem::path>& readable, const Limits& limits,
                     const std::filesystem::path& view = {}) const;
  // Whether a compiler may read the file: the rule that compile() enforces where the machine can do
  // so. On other machines the caller checks afterwards which files were read.
  static bool compiler_may_read(const std::filesystem::path& file,
                                const std::vector<std::filesystem::path>& readable);
  // Runs a statically linked program, which can open no file. Its standard input is the descriptor
  // `input` (-1: empty).
  RunOutcome run(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const Limits& limits, int input = -1) const;
  // Runs a program that was built with sanitizers. It can read the system's libraries and itself,
  // which its report needs, and make the system calls that a compiler may make. It reserves
  // terabytes of addresses, so the sanitizers themselves limit its memory.
  RunOutcome run_sanitized(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, const Limits& limits) const;

private:
  // The reason why this confinement does not work here; empty if it works.
  std::string failure_reason(const std::filesystem::path& scratch) const;
  RunOutcome launch_confined(const std::vector<std::string>& command,
                             const std::filesystem::path& directory, bool may_write,
                             const std::vector<std::filesystem::path>& readable,
                             const std::vector<std::string>& environment,
                             const Limits& limits) const;

  Confinement confinement_ = Confinement::kLimits;
  std::string bubblewrap_;  // the path of bubblewrap
  std::optional<uid_t> user_;
  bool view_works_ = false;  // whether try_view() found that the library hides files
  SystemCallFilter compiler_filter_, runner_filter_;
};

// The time that all processes of a submission have together. Safe to use from several threads.
class TimeBudget {
public:
  explicit TimeBudget(double seconds) : limited_(seconds > 0), left_(seconds) {}
  // The remaining time, but at most `most`; 0 when all is used up.
  double remaining(double most) const;
  void spend(double seconds);

private:
  mutable std::mutex mutex_;
  bool limited_;
  double left_;
};

// Runs the framework's checks in the sandbox: a Runner that calls Sandbox::run.
class SandboxRunner : public Runner {
public:
  SandboxRunner(const Sandbox& sandbox, Limits limits, bool sanitized = false,
                TimeBudget* time = nullptr)
      : sandbox_(sandbox), limits_(limits), sanitized_(sanitized), time_(time) {}
  RunOutcome run(const RunRequest& request) override;

  // How the processes ended, in order, without their output.
  const std::vector<RunOutcome>& processes() const { return processes_; }

private:
  const Sandbox& sandbox_;
  Limits limits_;
  bool sanitized_;
  TimeBudget* time_;
  std::vector<RunOutcome> processes_;
};

}  // namespace glassbox::labs::grading
