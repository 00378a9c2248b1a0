#include "labs/grading/compile.h"

#include <sstream>

#include <fmt/format.h>

#include "labs/grading/assembly.h"
#include "labs/grading/messages.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;
using Ending = RunOutcome::Ending;

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

// The kind of trouble that the compiler had; empty if it succeeded.
std::string trouble_of(const RunOutcome& outcome, const Limits& limits, std::string& said) {
  switch (outcome.ending) {
    case Ending::kExit:
      return outcome.code == 0 ? "" : "compile error";
    case Ending::kTimeout:
      said = fmt::format("The compiler was still busy after {} seconds.\n{}", limits.seconds, said);
      return "compile timeout";
    case Ending::kTooMuchOutput:
      said = "The compiler printed more than is allowed.\n" + said;
      return "compile error";
    case Ending::kNotStarted:
      said = outcome.detail;
      return "grading did not finish";
    default:
      said = fmt::format("The compiler was killed by signal {}.\n{}", outcome.code, said);
      return "compile error";
  }
}

// A file that a submission included and that is neither the compiler's nor the lab's; empty if
// there is none. Where the sandbox hides files there cannot be one.
std::string foreign_file(const fs::path& build, const Kit& kit) {
  const auto rule = read_text_file(build / kFilesRead);
  if (!rule) return "a file whose name is not known";
  for (const fs::path& header : headers_of(*rule)) {
    if (!Sandbox::is_compilers(build / header, {kit.include, build})) return header.string();
  }
  return {};
}

Compiled foreign(const std::string& file) {
  return {"compile error",
          fmt::format("student.cpp includes {}, which is not part of the lab.\n", file)};
}

// The output of a compiler's part as students see it, without paths that only the grader knows.
std::string shown(const std::string& said, const Kit& kit, const fs::path& build) {
  return without(without(said, build.string() + "/"), kit.include.string() + "/");
}

// Runs one part of the compiler and collects its messages.
std::string call(const std::vector<std::string>& command, const Sandbox& sandbox, const Kit& kit,
                 const fs::path& build, std::string& said) {
  const RunOutcome outcome = sandbox.compile(command, build, {kit.include}, compile_limits());
  said += shown(outcome.said, kit, build);
  return trouble_of(outcome, compile_limits(), said);
}

// Whether the preprocessor needs only the lab's files. Where the sandbox does not hide other files,
// this is checked before any message of the compiler is shown, because a message about a file, or
// about a name in it, reveals some of its contents. The preprocessor names a file before it prints
// any message about it.
Compiled read_includes(const Sandbox& sandbox, const Kit& kit, const fs::path& build,
                       const CompileWords& words) {
  Limits limits = compile_limits();
  limits.kept_bytes = limits.said_bytes;  // every name counts, so nothing is cut off
  const RunOutcome outcome =
      sandbox.compile(preprocessor_command(kit, words, build), build, {kit.include}, limits);
  std::error_code error;
  fs::remove(build / kPreprocessed, error);
  Compiled read;
  std::istringstream lines(outcome.said);
  for (std::string line; std::getline(lines, line);) {
    // the end of g++'s output, followed by a list
    if (line.starts_with("Multiple include guards")) break;
    const std::size_t dots = line.find_first_not_of('.');
    if (dots == 0 || dots == std::string::npos || line[dots] != ' ') {
      read.said += line + "\n";
      continue;
    }
    const fs::path file = line.substr(dots + 1);
    if (!Sandbox::is_compilers(build / file, {kit.include, build})) return foreign(file.string());
  }
  read.said = outcome.ending == Ending::kTooMuchOutput ? "" : shown(read.said, kit, build);
  read.trouble = trouble_of(outcome, limits, read.said);
  if (!read.trouble.empty()) return read;
  const std::string file = foreign_file(build, kit);
  return file.empty() ? read : foreign(file);
}

struct Place {
  const Sandbox& sandbox;
  const Kit& kit;
  const fs::path& build;
};

// Links the program. `objects` are copied to the directory and removed again.
fs::path link(std::vector<std::string> words, const std::vector<fs::path>& objects,
              const std::string& program, const Place& place, std::string& said,
              const CompileWords& options) {
  std::error_code error;
  for (const fs::path& object : objects) {
    words.push_back(object.filename().string());
    const fs::path copy = place.build / words.back();
    fs::copy_file(object, copy, fs::copy_options::overwrite_existing, error);
    if (error || !place.sandbox.hand_over(copy)) {
      said = object.string() + ": cannot be copied to " + place.build.string();
      return {};
    }
  }
  const std::string trouble = call(link_command(place.kit, words, program, options), place.sandbox,
                                   place.kit, place.build, said);
  said = own_line_first(said, "");
  for (const fs::path& object : objects) fs::remove(place.build / object.filename(), error);
  return trouble.empty() ? place.build / program : fs::path();
}

}  // namespace

Compiled compile_submission(const std::string& text, const Sandbox& sandbox, const Kit& kit,
                            const fs::path& build, const CompileWords& words) {
  const auto written = write_if_changed(build / kSource, text);
  if (!written) return {"grading did not finish", written.error().message()};
  if (!sandbox.hand_over(build) || !sandbox.hand_over(build / kSource))
    return {"grading did not finish", "the build directory cannot be given to the sandbox's user"};
  Compiled compiled;
  CompileWords how = words;
  if (sandbox.confinement() == Confinement::kLimits) {
    how.quotes = false;
    const Compiled read = read_includes(sandbox, kit, build, how);
    if (!read.trouble.empty()) return {read.trouble, own_line_first(read.said, text)};
  }
  compiled.trouble = call(assembly_command(kit, how, build), sandbox, kit, build, compiled.said);
  compiled.said = own_line_first(compiled.said, text);
  if (!compiled.trouble.empty()) return compiled;
  if (const std::string file = foreign_file(build, kit); !file.empty()) return foreign(file);
  const auto assembly = read_text_file(build / kAssembly);
  if (!assembly) return {"grading did not finish", assembly.error().message()};
  if (const auto statement = foreign_statement(*assembly))
    return {"compile error",
            fmt::format(
                "student.cpp passes \"{}\" to the assembler, which a compiler never writes: remove "
                "asm statements, and attributes that set a section or an assembler name.\n",
                *statement)};
  compiled.trouble = call(object_command(kit), sandbox, kit, build, compiled.said);
  return compiled;
}

fs::path link_submission(Checks checks, const Sandbox& sandbox, const Kit& kit,
                         const fs::path& build, std::string& said, const CompileWords& words) {
  const std::string program = checks == Checks::kVisible ? "runner" : "runner-of-all";
  std::vector<fs::path> objects = kit.objects(checks);
  // A sanitizer handles signals itself.
  if (words.sanitize)
    std::erase_if(objects, [](const fs::path& each) { return each.filename() == "witness.o"; });
  return link({kObject}, objects, program, {sandbox, kit, build}, said, words);
}

fs::path link_starter(Checks checks, const Sandbox& sandbox, const Kit& kit,
                      const fs::path& build) {
  std::vector<fs::path> objects = kit.objects(checks);
  objects.push_back(kit.starter);
  std::string said;
  const std::string program = checks == Checks::kVisible ? "starter" : "starter-of-all";
  return link({}, objects, program, {sandbox, kit, build}, said, {});
}

}  // namespace glassbox::labs::grading
