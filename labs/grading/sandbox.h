// Where a submission is compiled and run: the strongest confinement that this machine offers.
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
  kBubblewrap,  // namespaces: no other process, no network, and no file but those named
  kLandlock,  // the machine's processes and network, shut off by the system-call filter; no file but those named
  kLimits,  // the filter; a compiler reads every file that its user can read
};

constexpr std::string_view name_of(Confinement confinement) {
  constexpr std::string_view kNames[] = {"bubblewrap", "landlock", "limits"};
  return kNames[std::size_t(confinement)];
}

class Sandbox {
public:
  // Tries what there is with a real process in `scratch`, which must exist. `only`: no other than this. An error where
  // there is neither bubblewrap nor a filter for system calls.
  static Result<Sandbox> choose(const std::filesystem::path& scratch,
                                std::optional<Confinement> only = {});

  Confinement confinement() const { return confinement_; }
  // One sentence.
  std::string in_force() const;
  // Whose the files are that a submission's processes write. Gives `path` to it; nothing where it is the caller.
  bool hand_over(const std::filesystem::path& path) const;

  // A compiler in the directory `build`, which it may write to; of the rest it sees its own files and `readable`.
  RunOutcome compile(const std::vector<std::string>& command, const std::filesystem::path& build,
                     const std::vector<std::filesystem::path>& readable,
                     const Limits& limits) const;
  // Whether a compiler may read the file: as compile() rules it, where the machine can enforce that, and to be asked
  // afterwards where it cannot.
  static bool is_compilers(const std::filesystem::path& file,
                           const std::vector<std::filesystem::path>& readable);
  // A statically linked program, which sees no file at all, but what `input` is open for: its standard input (-1: empty).
  RunOutcome run(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const Limits& limits, int input = -1) const;
  // A program that was built with sanitizers. It reads the system's libraries and itself, as its report needs, and makes the
  // system calls that a compiler may. It reserves terabytes of addresses, so that its memory is limited by itself.
  RunOutcome run_sanitized(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, const Limits& limits) const;

private:
  // Empty, or why not.
  std::string trouble(const std::filesystem::path& scratch) const;
  RunOutcome launch_confined(const std::vector<std::string>& command,
                             const std::filesystem::path& directory, bool may_write,
                             const std::vector<std::filesystem::path>& readable,
                             const std::vector<std::string>& environment,
                             const Limits& limits) const;

  Confinement confinement_ = Confinement::kLimits;
  std::string bubblewrap_;  // its path
  std::optional<uid_t> user_;
  SystemCallFilter compiler_filter_, runner_filter_;
};

// The time that all processes of a submission have together. For several threads.
class TimeLeft {
public:
  explicit TimeLeft(double seconds) : limited_(seconds > 0), left_(seconds) {}
  // At most `most`; 0 when all is spent.
  double of(double most) const;
  void spend(double seconds);

private:
  mutable std::mutex mutex_;
  bool limited_;
  double left_;
};

// Sandbox::run as the framework's way of running a check.
class SandboxRunner : public Runner {
public:
  SandboxRunner(const Sandbox& sandbox, Limits limits, bool sanitized = false,
                TimeLeft* time = nullptr)
      : sandbox_(sandbox), limits_(limits), sanitized_(sanitized), time_(time) {}
  RunOutcome run(const RunRequest& request) override;

  // How the processes ended, in order, without what they wrote.
  const std::vector<RunOutcome>& processes() const { return processes_; }

private:
  const Sandbox& sandbox_;
  Limits limits_;
  bool sanitized_;
  TimeLeft* time_;
  std::vector<RunOutcome> processes_;
};

}  // namespace glassbox::labs::grading
