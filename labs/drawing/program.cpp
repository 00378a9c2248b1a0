#include "labs/drawing/program.h"

#include <sys/wait.h>

#include <system_error>

#include <fmt/format.h>

#include "labs/framework/build.h"
#include "labs/framework/process.h"
#include "labs/grading/kit.h"
#include "labs/grading/submission.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using grading::Sandbox;

// As a lab is checked and graded, so that the numbers are the same. Static: it starts without opening a file.
const std::vector<std::string>& flags() {
  static const std::vector<std::string> words{"-std=c++20", "-O1", "-ffp-contract=off", "-static"};
  return words;
}

// What a student's code is compiled with: the lab's contract and stages, and the framework around them.
Result<std::vector<SourceFile>> stage_files(const Sources& sources, const std::string& folder) {
  std::vector<SourceFile> files;
  const auto add = [&](const fs::path& from, const std::string& as) -> Result<void> {
    auto text = read_text_file(from);
    if (!text) return tl::unexpected(text.error());
    files.push_back({as, std::move(*text)});
    return {};
  };
  for (const char* name : {"student.h", "stages.cpp"}) {
    if (const auto added = add(sources.labs / folder / name, name); !added)
      return tl::unexpected(added.error());
  }
  for (const char* name : {"stages.h", "stages_main.cpp"}) {
    const auto added =
        add(sources.labs / "framework" / name, std::string("labs/framework/") + name);
    if (!added) return tl::unexpected(added.error());
  }
  return files;
}

// The lab's own side, compiled once for each lab.
struct OwnSide {
  fs::path include;
  std::vector<fs::path> objects;
  std::string key;  // of what it was made from
};

Result<void> compile_own(const fs::path& source, const fs::path& include, const fs::path& object) {
  std::vector<std::string> words{compiler()};
  words.insert(words.end(), flags().begin(), flags().end());
  words.insert(words.end(), {"-I", include.string(), "-c", source.string(), "-o", object.string()});
  const ProcessOutcome made = run_process(words, {120, 0, std::size_t(1) << 20});
  if (made.started && !made.timed_out && made.status == 0) return {};
  return fail("the lab's own files",
              "do not compile: " + (made.started ? made.said : made.why_not_started),
              "install a C++20 compiler with its static libraries, or name one in the environment "
              "variable CXX");
}

Result<OwnSide> own_side(const Sources& sources, const std::string& folder, const fs::path& place) {
  const auto files = stage_files(sources, folder);
  if (!files) return tl::unexpected(files.error());
  const auto headers = library_headers(sources, *files);
  if (!headers) return tl::unexpected(headers.error());
  const auto witness = read_text_file(sources.labs / "grading/witness.cpp");
  if (!witness) return tl::unexpected(witness.error());
  OwnSide own;
  own.include = place / "include";
  own.key = compiler() + "\n" + *witness;
  for (const auto* list : {&*files, &*headers}) {
    for (const SourceFile& file : *list) {
      own.key += file.path + "\n" + file.text;
      if (const auto written = write_if_changed(own.include / file.path, file.text); !written)
        return tl::unexpected(written.error());
    }
  }
  const std::vector<std::pair<fs::path, const char*>> compiled{
      {own.include / "stages.cpp", "stages.o"},
      {own.include / "labs/framework/stages_main.cpp", "main.o"},
      {sources.labs / "grading/witness.cpp", "witness.o"}};
  const auto before = read_text_file(place / "key");
  for (const auto& [source, name] : compiled) {
    own.objects.push_back(place / name);
    std::error_code error;
    if (before && *before == own.key && fs::exists(own.objects.back(), error)) continue;
    if (const auto done = compile_own(source, own.include, own.objects.back()); !done)
      return tl::unexpected(done.error());
  }
  if (const auto written = write_if_changed(place / "key", own.key); !written)
    return tl::unexpected(written.error());
  return own;
}

// Whatever the caller's mask: the user that compiles is another.
void open_to_all(const fs::path& folder) {
  std::error_code error;
  const auto opened = fs::perms::group_read | fs::perms::others_read;
  const auto passed = opened | fs::perms::group_exec | fs::perms::others_exec;
  fs::permissions(folder, passed, fs::perm_options::add, error);
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    std::error_code ignored;
    fs::permissions(at->path(), at->is_directory() ? passed : opened, fs::perm_options::add,
                    ignored);
  }
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

std::string foreign_file(const fs::path& build, const fs::path& readable) {
  const auto rule = read_text_file(build / grading::kFilesRead);
  if (!rule) return "a file that is not named";
  for (const fs::path& header : grading::headers_of(*rule)) {
    if (!Sandbox::is_compilers(build / header, {readable, build})) return header.string();
  }
  return {};
}

}  // namespace

Result<StageProgram> build_stages(const Sources& sources, const StageBuild& request,
                                  const Sandbox& sandbox) {
  const auto own = own_side(sources, request.folder, request.kept);
  if (!own) return tl::unexpected(own.error());
  const auto text = grading::read_submitted(request.student.parent_path(), "student.cpp");
  if (!text) return tl::unexpected(text.error());
  StageProgram made;
  made.program = request.scratch / "stages";
  const std::string key = own->key + *text;
  std::error_code error;
  const auto before = read_text_file(request.kept / "student-key");
  if (before && *before == key && fs::exists(request.kept / "stages", error)) {
    fs::copy_file(request.kept / "stages", made.program, fs::copy_options::overwrite_existing,
                  error);
    if (!error) return made;
  }

  const fs::path readable = request.scratch / "for-students", build = request.scratch / "build";
  fs::remove_all(readable, error);
  fs::remove_all(build, error);
  fs::create_directories(build, error);
  fs::create_directories(readable, error);
  fs::copy(own->include, readable / "include", fs::copy_options::recursive, error);
  std::vector<std::string> words{compiler()};
  words.insert(words.end(), flags().begin(), flags().end());
  words.insert(words.end(), {"-I", (readable / "include").string(), "student.cpp"});
  for (const fs::path& object : own->objects) {
    fs::copy_file(object, readable / object.filename(), error);
    words.push_back((readable / object.filename()).string());
  }
  words.insert(words.end(), {"-MD", "-MF", grading::kFilesRead, "-o", "stages"});
  open_to_all(readable);
  const auto written = write_if_changed(build / "student.cpp", *text);
  if (!written) return tl::unexpected(written.error());
  if (error || !sandbox.hand_over(build) || !sandbox.hand_over(build / "student.cpp"))
    return fail(build.string(), "cannot be handed over to the sandbox", "free some space there");
  const grading::Limits limits = grading::compile_limits();
  const RunOutcome compiled = sandbox.compile(words, build, {readable}, limits);
  made.messages =
      without(without(compiled.said, build.string() + "/"), (readable / "include").string() + "/");
  const bool fine = compiled.ending == RunOutcome::Ending::kExit && compiled.code == 0;
  if (!fine && made.messages.empty())
    made.messages = ending_text(compiled, {limits.seconds, limits.output_bytes, 0}) + "\n";
  if (fine) made.foreign_file = foreign_file(build, readable);
  if (!fine || !made.foreign_file.empty()) {
    made.program.clear();
    return made;
  }
  fs::copy_file(build / "stages", made.program, fs::copy_options::overwrite_existing, error);
  fs::copy_file(build / "stages", request.kept / "stages", fs::copy_options::overwrite_existing,
                error);
  fs::permissions(made.program, fs::perms(0755), error);
  if (const auto kept = write_if_changed(request.kept / "student-key", key); !kept)
    return tl::unexpected(kept.error());
  return made;
}

}  // namespace glassbox::labs
