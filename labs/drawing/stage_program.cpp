#include "labs/drawing/stage_program.h"

#include <system_error>

#include "labs/framework/compiler.h"
#include "labs/framework/strip_solution.h"
#include "labs/grading/compile.h"
#include "labs/grading/submission.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using grading::Sandbox;

// The files that a student's code is compiled with: the lab's contract, its stages or the code that
// is timed, and the framework around them.
Result<std::vector<SourceFile>> stage_files(const Sources& sources, const StageBuild& request) {
  std::vector<SourceFile> files;
  const auto add = [&](const fs::path& from, const std::string& as) -> Result<void> {
    auto text = read_text_file(from);
    if (!text) return tl::unexpected(text.error());
    files.push_back({as, std::move(*text)});
    return {};
  };
  const char* part = request.timed ? "timed.cpp" : "stages.cpp";
  for (const auto& [name, as] : {std::pair{"student.h", "student.h"}, {part, "stages.cpp"}}) {
    if (const auto added = add(sources.labs / request.folder / name, as); !added)
      return tl::unexpected(added.error());
  }
  for (const char* name : {"stages.h", "stages_main.cpp"}) {
    const auto added =
        add(sources.labs / "framework" / name, std::string("labs/framework/") + name);
    if (!added) return tl::unexpected(added.error());
  }
  return files;
}

// The lab's own object files, compiled once for each lab.
struct LabObjects {
  grading::BuildKit kit;
  std::string key;  // a digest of the files it was made from
};

Result<LabObjects> compile_lab_objects(const Sources& sources, const StageBuild& request) {
  const fs::path& place = request.kept;
  const auto files = stage_files(sources, request);
  if (!files) return tl::unexpected(files.error());
  const auto headers = library_headers(sources, *files);
  if (!headers) return tl::unexpected(headers.error());
  const auto crash_reporter = read_text_file(sources.labs / "grading/crash_reporter.cpp");
  if (!crash_reporter) return tl::unexpected(crash_reporter.error());
  LabObjects own;
  const fs::path include = place / "include";
  own.kit.include = include;
  own.kit.compiler = compiler();
  const auto compiler_view = read_text_file(sources.labs / "grading/compiler_view.cpp");
  if (!compiler_view) return tl::unexpected(compiler_view.error());
  own.kit.view = place / "compiler-view.so";
  own.key = own.kit.compiler + "\n" + *crash_reporter + *compiler_view;
  for (const auto* list : {&*files, &*headers}) {
    for (const SourceFile& file : *list) {
      own.key += file.path + "\n" + file.text;
      if (const auto written = write_if_changed(include / file.path, file.text); !written)
        return tl::unexpected(written.error());
    }
  }
  const std::vector<std::pair<fs::path, const char*>> compiled{
      {include / "stages.cpp", "stages.o"},
      {include / "labs/framework/stages_main.cpp", "main.o"},
      {sources.labs / "grading/crash_reporter.cpp", "crash_reporter.o"}};
  const auto before = read_text_file(place / "key");
  for (const auto& [source, name] : compiled) {
    const fs::path& object = own.kit.visible.emplace_back(place / name);
    std::error_code error;
    if (before && *before == own.key && fs::exists(object, error)) continue;
    const auto done = grading::compile_lab_file(own.kit.compiler, source, {include}, object);
    if (!done) return tl::unexpected(done.error());
  }
  std::error_code error;
  if (!before || *before != own.key || !fs::exists(own.kit.view, error)) {
    const auto done = grading::compile_view(own.kit.compiler, sources, own.kit.view);
    if (!done) return tl::unexpected(done.error());
  }
  if (const auto written = write_if_changed(place / "key", own.key); !written)
    return tl::unexpected(written.error());
  return own;
}

Result<std::string> starter_text(const Sources& sources, const std::string& folder) {
  const auto solution = solution_text(sources, folder);
  return solution ? strip_solution(*solution, folder + "/student.cpp") : solution;
}

}  // namespace

Result<StageProgram> build_stages(const Sources& sources, const StageBuild& request,
                                  const Sandbox& sandbox) {
  const auto own = compile_lab_objects(sources, request);
  if (!own) return tl::unexpected(own.error());
  const auto text = request.starter ? starter_text(sources, request.folder)
                                    : grading::read_source(request.student);
  if (!text) return tl::unexpected(text.error());
  const std::string name = request.starter ? "starter" : "stages";
  const fs::path kept_program = request.kept / name,
                 kept_key = request.kept / (request.starter ? "starter-key" : "student-key");
  StageProgram made;
  made.program = request.scratch / name;
  const std::string key = own->key + *text;
  std::error_code error;
  const auto before = read_text_file(kept_key);
  if (before && *before == key && fs::exists(kept_program, error)) {
    fs::copy_file(kept_program, made.program, fs::copy_options::overwrite_existing, error);
    if (!error) return made;
  }

  const fs::path readable = request.scratch / "for-students", build = request.scratch / "build";
  fs::remove_all(readable, error);
  fs::remove_all(build, error);
  fs::create_directories(build, error);
  const auto kit = grading::copy_build_kit(own->kit, readable);
  if (!kit) return tl::unexpected(kit.error());
  grading::CompileOptions options;
  options.timed = request.timed;
  const grading::CompileResult compiled =
      grading::compile_submission(*text, sandbox, *kit, build, options);
  made.messages = compiled.messages;
  const fs::path linked = compiled.failure.empty()
                              ? grading::link_submission(grading::CheckSelection::kVisible, sandbox,
                                                         *kit, build, made.messages)
                              : fs::path();
  if (linked.empty()) {
    if (made.messages.empty()) made.messages = compiled.failure + "\n";
    made.program.clear();
    return made;
  }
  fs::copy_file(linked, made.program, fs::copy_options::overwrite_existing, error);
  fs::copy_file(linked, kept_program, fs::copy_options::overwrite_existing, error);
  fs::permissions(made.program, fs::perms(0755), error);
  if (const auto kept = write_if_changed(kept_key, key); !kept) return tl::unexpected(kept.error());
  return made;
}

}  // namespace glassbox::labs
