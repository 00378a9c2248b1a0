#include "labs/framework/build.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <system_error>

#include "labs/framework/process.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

// -ffp-contract=off is the arithmetic of the pipeline: a product and a sum are two roundings. A stub uses no parameter.
const std::vector<std::string>& compile_flags() {
  static const std::vector<std::string> flags{
      "-std=c++20", "-O1", "-g", "-ffp-contract=off", "-Wall", "-Wextra", "-Wno-unused-parameter",
  };
  return flags;
}

BuildStep compile_step(const fs::path& source, const fs::path& build_dir, const std::string& name) {
  BuildStep step;
  step.source = source;
  step.output = build_dir / (name + ".o");
  step.dependencies = build_dir / (name + ".d");
  step.argv = {compiler()};
  const auto& flags = compile_flags();
  step.argv.insert(step.argv.end(), flags.begin(), flags.end());
  // GLM and the other libraries' headers come from the system.
  step.argv.insert(
      step.argv.end(),
      {"-I", (build_dir / "src").string(), "-isystem", (build_dir / "include").string(), "-MMD",
       "-MF", step.dependencies.string(), "-c", source.string(), "-o", step.output.string()});
  return step;
}

// With which words an output was made: another compiler or flag makes it anew.
fs::path words_file(const BuildStep& step) {
  return step.output.string() + ".words";
}

std::string words_of(const BuildStep& step) {
  std::string words;
  for (const std::string& each : step.argv) words += each + "\n";
  return words;
}

bool older_than(const fs::path& output, const fs::path& input) {
  std::error_code error;
  const auto made = fs::last_write_time(output, error);
  if (error) return true;
  const auto changed = fs::last_write_time(input, error);
  return error || changed >= made;
}

struct StepOutcome {
  ProcessOutcome process;
  bool done = false;
};

StepOutcome do_step(const BuildStep& step, double seconds) {
  std::error_code error;
  fs::remove(step.output, error);
  StepOutcome outcome;
  outcome.process = run_process(step.argv, {seconds, 0, std::size_t(1) << 20});
  outcome.done =
      outcome.process.started && !outcome.process.timed_out && outcome.process.status == 0;
  if (outcome.done) {
    outcome.done = write_if_changed(words_file(step), words_of(step)).has_value();
  } else {
    fs::remove(step.output, error);
  }
  return outcome;
}

std::string message_of(const BuildStep& step, const StepOutcome& outcome, double seconds) {
  std::string text;
  if (!outcome.process.started) {
    text = "cannot start " + step.argv[0] + ": " + outcome.process.why_not_started +
           "; install a C++20 compiler, or name one in the environment variable CXX\n";
  } else if (outcome.process.timed_out) {
    text = "the compiler was still busy after " + std::to_string(int(seconds)) + " seconds\n";
  }
  return text + outcome.process.said;
}

}  // namespace

std::string compiler() {
  if (const char* named = std::getenv("CXX"); named != nullptr && *named != '\0') return named;
  std::error_code error;
  if (fs::exists(GLASSBOX_LABS_COMPILER, error)) return GLASSBOX_LABS_COMPILER;
  return "c++";
}

Result<BuildPlan> plan_build(const Sources& sources, const BuildRequest& request) {
  const auto files = support_files(sources, request.folder, request.with_hidden);
  if (!files) return tl::unexpected(files.error());
  const auto headers = library_headers(sources, *files);
  if (!headers) return tl::unexpected(headers.error());
  const fs::path src = request.build_dir / "src";
  for (const auto& [folder, written_there] :
       {std::pair{src, &*files}, {request.build_dir / "include", &*headers}}) {
    for (const SourceFile& file : *written_there) {
      if (const auto written = write_if_changed(folder / file.path, file.text); !written)
        return tl::unexpected(written.error());
    }
  }
  BuildPlan plan;
  plan.program = request.build_dir / "runner";
  plan.steps = {
      compile_step(request.student, request.build_dir, "student"),
      compile_step(src / "runner.cpp", request.build_dir, "checks"),
      compile_step(src / "labs/framework/runner_main.cpp", request.build_dir, "main"),
  };
  plan.steps[0].student = true;
  BuildStep link;
  link.output = plan.program;
  link.argv = {compiler(), "-g"};
  for (const BuildStep& step : plan.steps) link.argv.push_back(step.output.string());
  link.argv.insert(link.argv.end(), {"-o", plan.program.string()});
  plan.steps.push_back(link);
  return plan;
}

std::vector<fs::path> dependencies_of(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const std::size_t colon = rule.find(": ");
  const auto finish = [&] {
    if (!word.empty()) files.emplace_back(word);
    word.clear();
  };
  for (std::size_t i = colon == std::string::npos ? rule.size() : colon + 2; i < rule.size(); ++i) {
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if (rule[i] == '\\' && next == '\n') {
      finish();
      ++i;
    } else if (rule[i] == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      word += next;
      ++i;
    } else if (rule[i] == ' ' || rule[i] == '\n') {
      finish();
    } else {
      word += rule[i];
    }
  }
  finish();
  return files;
}

bool is_up_to_date(const BuildStep& step) {
  std::error_code error;
  if (!fs::exists(step.output, error)) return false;
  const auto words = read_text_file(words_file(step));
  if (!words || *words != words_of(step)) return false;
  if (step.dependencies.empty()) return true;  // the link: its caller knows what it has made
  const auto text = read_text_file(step.dependencies);
  if (!text) return false;
  const std::vector<fs::path> files = dependencies_of(*text);
  return !files.empty() && std::none_of(files.begin(), files.end(), [&](const fs::path& file) {
    return older_than(step.output, file);
  });
}

Result<BuildOutcome> build_runner(const Sources& sources, const BuildRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  const auto plan = plan_build(sources, request);
  if (!plan) return tl::unexpected(plan.error());
  BuildOutcome outcome;
  outcome.program = plan->program;
  std::vector<std::pair<const BuildStep*, std::future<StepOutcome>>> running;
  for (const BuildStep& step : plan->steps) {
    if (step.source.empty() || is_up_to_date(step)) continue;
    running.emplace_back(&step, std::async(std::launch::async, do_step, step, request.seconds));
  }
  bool done = true;
  for (auto& [step, future] : running) {
    const StepOutcome made = future.get();
    outcome.messages += message_of(*step, made, request.seconds);
    outcome.timed_out = outcome.timed_out || made.process.timed_out;
    done = done && made.done;
  }
  outcome.compiled = !running.empty();
  const BuildStep& link = plan->steps.back();
  if (done && (outcome.compiled || !is_up_to_date(link))) {
    const StepOutcome made = do_step(link, request.seconds);
    outcome.messages += message_of(link, made, request.seconds);
    done = made.done;
  }
  outcome.built = done;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

}  // namespace glassbox::labs
