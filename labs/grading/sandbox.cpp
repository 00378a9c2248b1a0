#include "labs/grading/sandbox.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "labs/grading/landlock.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// The files that a compiler reads: programs, headers and libraries, and no personal files.
const std::vector<fs::path>& compiler_files() {
  static const std::vector<fs::path> files{"/usr/bin",
                                           "/usr/include",
                                           "/usr/lib",
                                           "/usr/lib32",
                                           "/usr/lib64",
                                           "/usr/libx32",
                                           "/usr/libexec",
                                           "/usr/local/bin",
                                           "/usr/local/include",
                                           "/usr/local/lib",
                                           "/usr/x86_64-linux-gnu",
                                           "/usr/aarch64-linux-gnu",
                                           "/etc/alternatives",
                                           "/etc/ld.so.cache"};
  return files;
}

// The traditional directories of programs and libraries, which are links into /usr on most systems.
const std::vector<fs::path>& traditional_directories() {
  static const std::vector<fs::path> places{"/bin", "/lib", "/lib32", "/lib64", "/libx32"};
  return places;
}

std::string find_system_program(const char* name) {
  for (const char* directory : {"/usr/bin/", "/bin/", "/usr/local/bin/"}) {
    const std::string path = std::string(directory) + name;
    if (::access(path.c_str(), X_OK) == 0) return path;
  }
  return {};
}

// A user number that no account and no other grading uses at this moment: Debian keeps 60000-64999
// free.
uid_t unused_user_id() {
  return 61000 + static_cast<uid_t>(::getpid()) % 3900;
}

std::vector<std::string> bubblewrap_command(const std::string& bubblewrap, bool filtered) {
  std::vector<std::string> words{
      bubblewrap,   "--unshare-all", "--die-with-parent", "--new-session",
      "--hostname", "sandbox",       "--cap-drop",        "ALL"};
  if (filtered) words.insert(words.end(), {"--seccomp", std::to_string(kFilterFd)});
  return words;
}

// Whether bubblewrap could not start the program because of the limit on processes.
bool lacks_processes(const RunOutcome& outcome) {
  return outcome.ending == RunOutcome::Ending::kExit && outcome.code == 1 &&
         outcome.answers.empty() && outcome.seconds < 0.5 &&
         outcome.printed.starts_with("bwrap: ") &&
         outcome.printed.find("Resource temporarily unavailable") != std::string::npos;
}

// Launches the program. Linux still counts the processes of namespaces that it has not removed yet:
// after 200 quick runs in bubblewrap they can be 64, which is the limit. Then this waits and tries
// again, for 4 seconds at most.
RunOutcome launch_patiently(const Launch& job) {
  RunOutcome outcome = launch(job);
  for (int tries = 0; tries < 80 && job.in_bubblewrap && lacks_processes(outcome); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    outcome = launch(job);
  }
  return outcome;
}

// Whether the dynamic linker can load a library of this directory. It separates the names in
// LD_PRELOAD by blanks and colons, and replaces words that begin with a dollar sign.
bool can_be_preloaded_from(const fs::path& directory) {
  std::error_code error;
  return directory.native().find_first_of(" :$") == std::string::npos &&
         fs::weakly_canonical(directory, error).native().find_first_of(" :$") == std::string::npos;
}

std::vector<std::string> plain_environment(const std::string& temporary) {
  return {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8", "HOME=/", "TMPDIR=" + temporary};
}

}  // namespace

Result<Sandbox> Sandbox::choose(const fs::path& scratch, std::optional<Confinement> only) {
  Sandbox sandbox;
  const std::string bubblewrap = find_system_program("bwrap");
  if (can_filter_system_calls()) {
    auto compiler = compiler_filter();
    if (!compiler) return tl::unexpected(compiler.error());
    sandbox.compiler_filter_ = *compiler;
  }
  std::vector<std::optional<uid_t>> users;
  if (::geteuid() == 0) users.push_back(unused_user_id());
  users.push_back(std::nullopt);
  std::string why;  // why no kind of confinement works
  const auto does_not_work = [&](Confinement each, const std::string& reason) {
    why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", name_of(each), reason);
  };
  for (const Confinement each :
       {Confinement::kBubblewrap, Confinement::kLandlock, Confinement::kLimits}) {
    if (only && *only != each) continue;
    if (each == Confinement::kBubblewrap && bubblewrap.empty()) {
      does_not_work(each, "bwrap is not installed");
      continue;
    }
    if (each == Confinement::kLandlock && !can_restrict_files()) {
      does_not_work(each, "this kernel does not have it, or it is not switched on");
      continue;
    }
    if (each != Confinement::kBubblewrap && !can_filter_system_calls()) {
      does_not_work(each, "glassbox was built without libseccomp");
      continue;
    }
    if (each == Confinement::kLimits && !can_be_preloaded_from(scratch)) {
      does_not_work(each,
                    "the path of the temporary directory has a blank, a colon or a dollar "
                    "sign, which LD_PRELOAD does not allow: set TMPDIR to another directory");
      continue;
    }
    sandbox.confinement_ = each;
    sandbox.bubblewrap_ = bubblewrap;
    if (can_filter_system_calls()) {
      auto runner = runner_filter(each == Confinement::kBubblewrap);
      if (!runner) return tl::unexpected(runner.error());
      sandbox.runner_filter_ = *runner;
    }
    std::string reason;
    for (const auto& user : users) {
      sandbox.user_ = user;
      reason = sandbox.failure_reason(scratch);
      if (reason.empty()) return sandbox;
    }
    does_not_work(each, reason);
  }
  return fail("the sandbox", why,
              "install bubblewrap, or build glassbox with libseccomp-dev, and allow user "
              "namespaces or seccomp in the container");
}

// Tries to start a compiler. Its confinement needs more than a runner's: if a compiler can be
// started here, a runner can be too.
std::string Sandbox::failure_reason(const fs::path& scratch) const {
  const fs::path trial = scratch / "trial";
  std::error_code error;
  fs::create_directory(trial, error);
  if (error || !give_to_sandbox_user(trial))
    return "no directory for the sandbox's user can be made in " + scratch.string();
  Limits limits = compile_limits();
  limits.seconds = 10;
  const RunOutcome outcome = compile({"/usr/bin/touch", "here"}, trial, {}, limits);
  const bool fine = outcome.ending == RunOutcome::Ending::kExit && outcome.code == 0 &&
                    fs::exists(trial / "here");
  fs::remove_all(trial, error);
  if (fine) return {};
  const std::string printed = outcome.printed.substr(0, outcome.printed.find('\n'));
  return !printed.empty() ? printed : ending_text(outcome, {});
}

void Sandbox::try_view(const fs::path& view, const std::string& compiler, const fs::path& scratch) {
  view_works_ = false;
  if (confinement_ != Confinement::kLimits || view.empty()) return;
  const fs::path trial = scratch / "trial", hidden = scratch / "hidden.h";
  std::error_code error;
  fs::create_directory(trial, error);
  std::ofstream(hidden) << "\n";
  std::ofstream(trial / "trial.cpp") << "#if __has_include(\"/etc/passwd\") || __has_include(\""
                                     << hidden.string() << "\")\n#error\n#endif\n";
  fs::permissions(hidden, fs::perms(0644), error);
  fs::permissions(trial / "trial.cpp", fs::perms(0644), error);
  if (!error && give_to_sandbox_user(trial)) {
    // Without the library the compiler must find the file, or the trial says nothing.
    const std::vector<std::string> command{compiler, "-fsyntax-only", "trial.cpp"};
    const auto succeeds = [&](const fs::path& library) {
      const RunOutcome outcome = compile(command, trial, {}, compile_limits(), library);
      return outcome.ending == RunOutcome::Ending::kExit && outcome.code == 0;
    };
    view_works_ = succeeds(view) && !succeeds({});
  }
  fs::remove_all(trial, error);
  fs::remove(hidden, error);
}

std::string Sandbox::description() const {
  std::string text;
  switch (confinement_) {
    case Confinement::kBubblewrap:
      text = "bubblewrap (no network, no other processes, no files but the compiler's own)";
      break;
    case Confinement::kLandlock:
      text = "Landlock (no files but the compiler's own)";
      break;
    case Confinement::kLimits:
      text = "no rules of the kernel for files";
      text += view_works_ ? ": a library hides all files but the compiler's own from the compiler"
                          : ", and no library hides files from the compiler, so that a submission "
                            "can find out which files exist";
      break;
  }
  text += runner_filter_.empty() ? ", no system-call filter" : ", a system-call filter";
  text += ", limits on time, memory, output and files";
  return text + (user_ ? ", an unprivileged user" : ", the user who started it");
}

bool Sandbox::give_to_sandbox_user(const fs::path& path) const {
  return !user_ || ::lchown(path.c_str(), *user_, *user_) == 0;
}

// Runs the command where only the system's own files and `readable` are visible, and also
// `directory` if `may_write`.
RunOutcome Sandbox::launch_confined(const std::vector<std::string>& command,
                                    const fs::path& directory, bool may_write,
                                    const std::vector<fs::path>& readable,
                                    const std::vector<std::string>& environment,
                                    const Limits& limits) const {
  Launch job;
  job.limits = limits;
  job.user = user_;
  job.directory = directory;
  job.filter = compiler_filter_;
  job.environment = environment;
  if (confinement_ == Confinement::kBubblewrap) {
    job.in_bubblewrap = true;
    job.directory = "/";
    job.command = bubblewrap_command(bubblewrap_, !job.filter.empty());
    auto& words = job.command;
    for (const fs::path& path : compiler_files())
      words.insert(words.end(), {"--ro-bind-try", path.string(), path.string()});
    for (const fs::path& place : traditional_directories()) {
      std::error_code error;
      if (fs::is_symlink(place, error)) {
        words.insert(words.end(), {"--symlink", fs::read_symlink(place, error).string(), place});
      } else {
        words.insert(words.end(), {"--ro-bind-try", place.string(), place.string()});
      }
    }
    for (const fs::path& path : readable)
      words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    words.insert(words.end(), {"--dev", "/dev"});
    if (may_write) {
      words.insert(words.end(), {"--bind", directory.string(), directory.string()});
    } else {
      words.insert(words.end(), {"--proc", "/proc"});  // where a program finds its own path
    }
    words.insert(words.end(), {"--chdir", may_write ? directory.string() : "/", "--"});
    words.insert(words.end(), command.begin(), command.end());
    return launch_patiently(job);
  }
  job.command = command;
  if (confinement_ != Confinement::kLandlock) return launch_patiently(job);
  std::vector<fs::path> seen = compiler_files();
  seen.insert(seen.end(), traditional_directories().begin(), traditional_directories().end());
  seen.insert(seen.end(), readable.begin(), readable.end());
  std::vector<fs::path> written;
  if (may_write) {
    written.push_back(directory);
  } else {
    seen.push_back("/proc");
  }
  const FileRules rules(seen, written);
  job.file_rules = rules.descriptor();
  return launch_patiently(job);
}

RunOutcome Sandbox::compile(const std::vector<std::string>& command, const fs::path& build,
                            const std::vector<fs::path>& readable, const Limits& limits,
                            const fs::path& view) const {
  std::vector<std::string> environment = plain_environment(build.string());
  if (confinement_ == Confinement::kLimits && !view.empty()) {
    std::string seen = "/dev";
    const std::vector<fs::path> own{build};
    for (const auto* places : {&compiler_files(), &traditional_directories(), &readable, &own}) {
      std::error_code error;
      for (const fs::path& place : *places)
        seen += ":" + fs::weakly_canonical(place, error).string();
    }
    environment.push_back("LD_PRELOAD=" + view.string());
    environment.push_back("GLASSBOX_COMPILER_SEES=" + seen);
  }
  return launch_confined(command, build, true, readable, environment, limits);
}

RunOutcome Sandbox::run_sanitized(const fs::path& program,
                                  const std::vector<std::string>& arguments,
                                  const Limits& limits) const {
  Limits own = limits;
  own.memory_bytes = 0;
  std::vector<std::string> command{program.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  command.insert(command.end(), {"--out-fd", std::to_string(kAnswersFd)});
  // Leaks are not reported: a leak does not make an answer wrong, and the search for leaks needs
  // threads and tracing. g++'s sanitizers look up a program's line numbers themselves; those of
  // clang++ use llvm-symbolizer or addr2line, the first one found in PATH.
  const std::vector<std::string> environment{
      "LC_ALL=C", "PATH=/usr/bin:/bin",
      fmt::format("ASAN_OPTIONS=detect_leaks=0:handle_abort=1:hard_rss_limit_mb={}:color=never:"
                  "allow_addr2line=1",
                  limits.memory_bytes / kMiB),
      "UBSAN_OPTIONS=print_stacktrace=1:color=never:allow_addr2line=1"};
  return launch_confined(command, "/", false, {program}, environment, own);
}

bool Sandbox::compiler_may_read(const fs::path& file, const std::vector<fs::path>& readable) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(file, error);
  for (const auto* places : {&compiler_files(), &traditional_directories(), &readable}) {
    for (const fs::path& place : *places) {
      const fs::path relative = whole.lexically_relative(fs::weakly_canonical(place, error));
      if (!relative.empty() && *relative.begin() != "..") return true;
    }
  }
  return false;
}

RunOutcome Sandbox::run(const fs::path& program, const std::vector<std::string>& arguments,
                        const Limits& limits, int input) const {
  Launch job;
  job.input = input;
  job.limits = limits;
  job.user = user_;
  job.directory = "/";
  job.filter = runner_filter_;
  job.environment = {"LC_ALL=C"};
  if (confinement_ == Confinement::kBubblewrap) {
    job.in_bubblewrap = true;
    job.command = bubblewrap_command(bubblewrap_, !job.filter.empty());
    job.command.insert(job.command.end(),
                       {"--ro-bind", program.string(), "/runner", "--chdir", "/", "--", "/runner"});
  } else {
    job.command = {program.string()};
  }
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  job.command.insert(job.command.end(), {"--out-fd", std::to_string(kAnswersFd)});
  if (confinement_ != Confinement::kLandlock) return launch_patiently(job);
  const FileRules rules({program}, {});
  job.file_rules = rules.descriptor();
  return launch_patiently(job);
}

double TimeBudget::remaining(double most) const {
  const std::lock_guard lock(mutex_);
  return limited_ ? std::clamp(left_, 0.0, most) : most;
}

void TimeBudget::spend(double seconds) {
  const std::lock_guard lock(mutex_);
  left_ -= seconds;
}

RunOutcome SandboxRunner::run(const RunRequest& request) {
  Limits limits = limits_;
  if (time_ != nullptr) limits.seconds = time_->remaining(limits_.seconds);
  RunOutcome outcome;
  if (limits.seconds <= 0) {
    outcome.ending = RunOutcome::Ending::kTimeout;
  } else {
    outcome = sanitized_ ? sandbox_.run_sanitized(request.program, request.arguments, limits)
                         : sandbox_.run(request.program, request.arguments, limits);
    if (time_ != nullptr) time_->spend(outcome.seconds);
  }
  if (outcome.ending == RunOutcome::Ending::kTimeout && limits.seconds < limits_.seconds)
    outcome.detail = "the time limit of the whole submission is reached";
  processes_.push_back({outcome.ending, outcome.code, outcome.detail, {}, {}, outcome.seconds});
  return outcome;
}

}  // namespace glassbox::labs::grading
