#include "labs/grading/compile.h"

#include <sstream>

#include <fmt/format.h>

#include "labs/grading/assembly.h"
#include "labs/grading/compiler_messages.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;
using Ending = RunOutcome::Ending;

std::string remove_all(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

// How the compiler failed; empty if it succeeded.
std::string compile_failure(const RunOutcome& outcome, const Limits& limits,
                            std::string& messages) {
  switch (outcome.ending) {
    case Ending::kExit:
      return outcome.code == 0 ? "" : "compile error";
    case Ending::kTimeout:
      messages = fmt::format("The compiler was still busy after {} seconds.\n{}", limits.seconds,
                             messages);
      return "compile timeout";
    case Ending::kTooMuchOutput:
      messages = "The compiler printed more than is allowed.\n" + messages;
      return "compile error";
    case Ending::kNotStarted:
      messages = outcome.detail;
      return "grading did not finish";
    default:
      messages = fmt::format("The compiler was killed by signal {}.\n{}", outcome.code, messages);
      return "compile error";
  }
}

// A file that a submission included and that is neither the compiler's nor the lab's; empty if
// there is none. In a sandbox that hides all other files there cannot be one.
std::string foreign_file(const fs::path& build, const BuildKit& kit) {
  const auto rule = read_text_file(build / kFilesRead);
  if (!rule) return "a file whose name is not known";
  for (const fs::path& header : headers_of(*rule)) {
    if (!Sandbox::compiler_may_read(build / header, {kit.include, build})) return header.string();
  }
  return {};
}

CompileResult foreign(const std::string& file) {
  return {"compile error",
          fmt::format("student.cpp includes {}, which is not part of the lab.\n", file)};
}

// The messages of the compiler (or assembler, or linker) as students see them, without paths that
// only the grader knows.
std::string without_grader_paths(const std::string& messages, const BuildKit& kit,
                                 const fs::path& build) {
  return remove_all(remove_all(messages, build.string() + "/"), kit.include.string() + "/");
}

// Runs the compiler, the assembler or the linker in the sandbox and adds its messages to
// `messages`. Returns how it failed; empty if it did not.
std::string run_confined_compiler(const std::vector<std::string>& command, const Sandbox& sandbox,
                                  const BuildKit& kit, const fs::path& build,
                                  std::string& messages) {
  const RunOutcome outcome =
      sandbox.compile(command, build, {kit.include}, compile_limits(), kit.view);
  messages += without_grader_paths(outcome.printed, kit, build);
  return compile_failure(outcome, compile_limits(), messages);
}

// Runs the preprocessor, and fails if the submission includes a file that is not the lab's. Where
// the sandbox does not hide other files, this must happen before any message of the compiler is
// shown, because a message about a file, or about a name in it, reveals some of its contents. The
// preprocessor names a file before it prints any message about it.
CompileResult read_includes(const Sandbox& sandbox, const BuildKit& kit, const fs::path& build,
                            const CompileOptions& options) {
  Limits limits = compile_limits();
  limits.kept_bytes = limits.printed_bytes;  // all names are needed, so nothing is cut off
  const RunOutcome outcome = sandbox.compile(preprocessor_command(kit, options, build), build,
                                             {kit.include}, limits, kit.view);
  std::error_code error;
  fs::remove(build / kPreprocessed, error);
  CompileResult read;
  std::istringstream lines(outcome.printed);
  for (std::string line; std::getline(lines, line);) {
    // with this line g++ begins another list, of files without include guards
    if (line.starts_with("Multiple include guards")) break;
    const std::size_t dots = line.find_first_not_of('.');
    if (dots == 0 || dots == std::string::npos || line[dots] != ' ') {
      read.messages += line + "\n";
      continue;
    }
    const fs::path file = line.substr(dots + 1);
    if (!Sandbox::compiler_may_read(build / file, {kit.include, build}))
      return foreign(file.string());
  }
  read.messages = outcome.ending == Ending::kTooMuchOutput
                      ? ""
                      : without_grader_paths(read.messages, kit, build);
  read.failure = compile_failure(outcome, limits, read.messages);
  if (!read.failure.empty()) return read;
  const std::string file = foreign_file(build, kit);
  return file.empty() ? read : foreign(file);
}

struct BuildContext {
  const Sandbox& sandbox;
  const BuildKit& kit;
  const fs::path& build;
};

// Links the program. `objects` are copied to the build directory for the link, and removed again.
fs::path link(std::vector<std::string> words, const std::vector<fs::path>& objects,
              const std::string& program, const BuildContext& context, std::string& messages,
              const CompileOptions& options) {
  std::error_code error;
  for (const fs::path& object : objects) {
    words.push_back(object.filename().string());
    const fs::path copy = context.build / words.back();
    fs::copy_file(object, copy, fs::copy_options::overwrite_existing, error);
    if (error || !context.sandbox.give_to_sandbox_user(copy)) {
      messages = object.string() + ": cannot be copied to " + context.build.string();
      return {};
    }
  }
  const std::string failure =
      run_confined_compiler(link_command(context.kit, words, program, options), context.sandbox,
                            context.kit, context.build, messages);
  messages = student_line_first(messages, "");
  for (const fs::path& object : objects) fs::remove(context.build / object.filename(), error);
  return failure.empty() ? context.build / program : fs::path();
}

}  // namespace

CompileResult compile_submission(const std::string& text, const Sandbox& sandbox,
                                 const BuildKit& kit, const fs::path& build,
                                 const CompileOptions& options) {
  const auto written = write_if_changed(build / kSource, text);
  if (!written) return {"grading did not finish", written.error().message()};
  if (!sandbox.give_to_sandbox_user(build) || !sandbox.give_to_sandbox_user(build / kSource))
    return {"grading did not finish",
            "the build directory cannot be given to the user who runs the sandbox"};
  CompileResult compiled;
  CompileOptions used = options;
  if (sandbox.confinement() == Confinement::kLimits) {
    used.quotes = false;
    const CompileResult read = read_includes(sandbox, kit, build, used);
    if (!read.failure.empty()) return {read.failure, student_line_first(read.messages, text)};
  }
  compiled.failure = run_confined_compiler(assembly_command(kit, used, build), sandbox, kit, build,
                                           compiled.messages);
  compiled.messages = student_line_first(compiled.messages, text);
  if (!compiled.failure.empty()) return compiled;
  if (const std::string file = foreign_file(build, kit); !file.empty()) return foreign(file);
  const auto assembly = read_text_file(build / kAssembly);
  if (!assembly) return {"grading did not finish", assembly.error().message()};
  if (const auto statement = foreign_statement(*assembly))
    return {"compile error",
            fmt::format(
                "student.cpp passes \"{}\" to the assembler, a statement that no compiler writes: "
                "remove asm statements, and attributes that set a section or an assembler name.\n",
                *statement)};
  compiled.failure =
      run_confined_compiler(object_command(kit), sandbox, kit, build, compiled.messages);
  return compiled;
}

fs::path link_submission(CheckSelection checks, const Sandbox& sandbox, const BuildKit& kit,
                         const fs::path& build, std::string& messages,
                         const CompileOptions& options) {
  const std::string program = checks == CheckSelection::kVisible ? "runner" : "runner-of-all";
  std::vector<fs::path> objects = kit.objects(checks);
  // The crash reporter is left out, because a sanitizer handles signals itself.
  if (options.sanitize)
    std::erase_if(objects,
                  [](const fs::path& each) { return each.filename() == "crash_reporter.o"; });
  return link({kObject}, objects, program, {sandbox, kit, build}, messages, options);
}

fs::path link_starter(CheckSelection checks, const Sandbox& sandbox, const BuildKit& kit,
                      const fs::path& build) {
  std::vector<fs::path> objects = kit.objects(checks);
  objects.push_back(kit.starter);
  std::string messages;
  const std::string program = checks == CheckSelection::kVisible ? "starter" : "starter-of-all";
  return link({}, objects, program, {sandbox, kit, build}, messages, {});
}

}  // namespace glassbox::labs::grading
