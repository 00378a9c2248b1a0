#include "labs/grading/build_kit.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "labs/framework/compiler.h"
#include "labs/framework/digest.h"
#include "labs/framework/run_in_parallel.h"
#include "labs/framework/strip_solution.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// The library of compiler_view.cpp in the directory of a kit.
constexpr const char* kView = "compiler-view.so";

bool is_clang(const std::string& compiler) {
  return fs::path(compiler).filename().string().find("clang") != std::string::npos;
}

// Compiler flags, the same for the lab's own files and for a student's. -ffp-contract=off gives the
// arithmetic of the pipeline: a product and a sum are rounded separately.
const std::vector<std::string>& compiler_flags() {
  static const std::vector<std::string> words{"-std=c++20", "-O1", "-ffp-contract=off"};
  return words;
}

// Flags for clang++: the assembly is in GNU syntax, without comments and without what only LLVM
// understands, and the GNU assembler assembles it.
std::vector<std::string> clang_flags(const std::string& compiler) {
  if (!is_clang(compiler)) return {};
  return {"-fno-integrated-as", "-fno-verbose-asm", "-fno-addrsig", "-fno-autolink"};
}

// Sanitizers run on code compiled with -O1 (compiler_flags()), as the other programs are: at -O0
// they would not recognise more of the errors that the optimiser changes. The assertions of the
// standard library find an index beyond the end that a sanitizer does not: in the spare memory of a
// vector, or in an array that belongs to the runner.
const std::vector<std::string>& sanitizer_flags() {
  static const std::vector<std::string> words{"-g", "-fsanitize=address,undefined",
                                              "-fno-sanitize-recover=all",
                                              "-fno-omit-frame-pointer", "-D_GLIBCXX_ASSERTIONS"};
  return words;
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

Result<std::string> find_in_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* path = std::getenv("PATH");
  std::istringstream places(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string place; std::getline(places, place, ':');) {
    const std::string candidate = place + "/" + program;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return fail(program, "is not found in PATH",
              "install a C++20 compiler, or name one in the environment variable CXX");
}

Result<std::string> run_trusted_compiler(const std::vector<std::string>& words) {
  constexpr double kSeconds = 120;
  const ProcessOutcome outcome = run_process(words, {kSeconds, 0, std::size_t(1) << 20});
  if (outcome.started && !outcome.timed_out && WIFEXITED(outcome.status) &&
      WEXITSTATUS(outcome.status) == 0)
    return outcome.printed;
  if (outcome.timed_out)
    return fail("the lab's own files",
                fmt::format("the compiler was still busy after {} seconds", kSeconds),
                "try again when the machine has less to do");
  return fail("the lab's own files",
              fmt::format("do not compile: {}",
                          outcome.started ? outcome.printed : outcome.why_not_started),
              "install a C++20 compiler with its static libraries, or build glassbox again");
}

std::vector<std::string> lab_compile_command(const std::string& compiler,
                                             const std::vector<fs::path>& includes) {
  std::vector<std::string> words{compiler};
  append(words, compiler_flags());
  for (const fs::path& include : includes) append(words, {"-I", include.string()});
  return words;
}

BuildKit kit_in(const fs::path& directory, const std::string& compiler,
                const std::string& fingerprint) {
  BuildKit kit;
  kit.compiler = compiler;
  kit.fingerprint = fingerprint;
  kit.include = directory / "include";
  const fs::path objects = directory / "objects";
  kit.view = directory / kView;
  kit.starter = objects / "starter.o";
  for (const char* name : {"main.o", "crash_reporter.o"}) {
    kit.visible.push_back(objects / name);
    kit.all.push_back(objects / name);
  }
  kit.visible.push_back(objects / "visible.o");
  kit.all.push_back(objects / "all.o");
  return kit;
}

// Makes the headers readable for every user, regardless of the caller's umask, because another user
// compiles. The objects stay readable for the caller alone.
void make_readable_for_all(const BuildKit& kit, const fs::path& directory) {
  using fs::perms;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(kit.include, error), end; !error && entry != end;
       entry.increment(error)) {
    perms added = perms::group_read | perms::others_read;
    if (entry->is_directory()) added |= perms::group_exec | perms::others_exec;
    std::error_code ignored;
    fs::permissions(entry->path(), added, fs::perm_options::add, ignored);
  }
  for (const fs::path& path : {directory, kit.include, directory / kView}) {
    if (fs::exists(path, error))
      fs::permissions(path, perms(0755), fs::perm_options::replace, error);
  }
  fs::permissions(directory / "objects", perms::owner_all, fs::perm_options::replace, error);
}

// The source texts that a kit (build_kit.h) is made from.
struct Parts {
  std::string starter;
  // student.cpp with the solution and the files around it: without hidden checks, and with them
  std::vector<SourceFile> visible, all;
  std::string crash_reporter, compiler_view;
};

Result<std::vector<SourceFile>> files_of(const Sources& sources, const std::string& folder,
                                         bool with_hidden) {
  auto files = support_files(sources, folder, with_hidden);
  if (!files) return files;
  const auto solution = solution_text(sources, folder);
  if (!solution) return tl::unexpected(solution.error());
  files->push_back({kSource, *solution});
  return files;
}

Result<Parts> parts_of(const Sources& sources, const std::string& folder) {
  auto visible = files_of(sources, folder, false);
  if (!visible) return tl::unexpected(visible.error());
  auto all = files_of(sources, folder, true);
  if (!all) return tl::unexpected(all.error());
  const auto crash_reporter = read_text_file(sources.labs / "grading/crash_reporter.cpp");
  if (!crash_reporter) return tl::unexpected(crash_reporter.error());
  const auto compiler_view = read_text_file(sources.labs / "grading/compiler_view.cpp");
  if (!compiler_view) return tl::unexpected(compiler_view.error());
  auto starter = strip_solution(visible->back().text, folder + "/student.cpp");
  if (!starter) return tl::unexpected(starter.error());
  return Parts{std::move(*starter), std::move(*visible), std::move(*all), *crash_reporter,
               *compiler_view};
}

Result<std::string> fingerprint_of(const Sources& sources, const Parts& parts,
                                   const std::string& compiler_path) {
  const auto headers = library_headers(sources, parts.all);
  if (!headers) return tl::unexpected(headers.error());
  Digest digest;
  for (const auto* files : {&parts.visible, &parts.all, &*headers}) {
    for (const SourceFile& file : *files) digest.add(file.path).add(file.text);
  }
  digest.add(parts.crash_reporter).add(parts.compiler_view).add(compiler_path);
  for (const std::string& word : compiler_flags()) digest.add(word);
  return digest.text();
}

// Writes the lab's own files to a directory and compiles them there.
class LabFileCompiler {
public:
  LabFileCompiler(const BuildKit& kit, const Sources& sources, fs::path directory)
      : kit_(kit), sources_(sources), directory_(std::move(directory)) {}

  Result<void> write_files(const std::vector<SourceFile>& files) const {
    for (const SourceFile& file : files) {
      if (const auto written = write_if_changed(directory_ / file.path, file.text); !written)
        return written;
    }
    return {};
  }
  Result<void> compile(const fs::path& source, const fs::path& object) const {
    return compile_lab_file(kit_.compiler, source, includes(), object);
  }

private:
  std::vector<fs::path> includes() const { return {directory_, sources_.include}; }

  const BuildKit& kit_;
  const Sources& sources_;
  fs::path directory_;
};

// Writes the headers that the solution includes: the lab's student.h, and those of the library.
Result<void> write_headers(const BuildKit& kit, const Sources& sources,
                           const std::vector<SourceFile>& files) {
  std::vector<SourceFile> own;
  for (const SourceFile& file : files) {
    if (file.path == "student.h" || file.path == kSource) own.push_back(file);
  }
  auto headers = library_headers(sources, own);
  if (!headers) return tl::unexpected(headers.error());
  for (const SourceFile& file : own) {
    if (file.path != kSource) headers->push_back(file);
  }
  for (const SourceFile& header : *headers) {
    if (const auto written = write_if_changed(kit.include / header.path, header.text); !written)
      return written;
  }
  return {};
}

// Removes incomplete kits beside the directory, which killed programs left: those that are older
// than an hour, since making a kit takes less.
void remove_leftovers(const fs::path& directory) {
  std::error_code error;
  const std::string name = directory.filename().string() + "-";
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator entry(directory.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string other = entry->path().filename().string();
    std::error_code ignored;
    if (other.starts_with(name) && other.size() == name.size() + 6 &&
        fs::exists(entry->path() / "objects", ignored) &&
        now - fs::last_write_time(entry->path(), ignored) > std::chrono::hours(1))
      fs::remove_all(entry->path(), ignored);
  }
}

Result<void> compile_kit(const BuildKit& kit, const Sources& sources, const Parts& parts,
                         const fs::path& directory) {
  const fs::path objects = directory / "objects", own = directory / "own";
  std::error_code error;
  fs::create_directories(objects, error);
  fs::create_directories(kit.include, error);
  fs::create_directories(own, error);
  fs::permissions(own, fs::perms::owner_all, fs::perm_options::replace, error);
  const LabFileCompiler visible(kit, sources, own / "visible"), all(kit, sources, own / "all");
  const fs::path starter = own / "visible/starter.cpp";
  if (const auto written = write_if_changed(starter, parts.starter); !written) return written;
  for (const auto& done : {visible.write_files(parts.visible), all.write_files(parts.all),
                           write_headers(kit, sources, parts.visible)}) {
    if (!done) return done;
  }
  const std::vector<std::pair<fs::path, fs::path>> compiled{
      {own / "visible/runner.cpp", objects / "visible.o"},
      {own / "all/runner.cpp", objects / "all.o"},
      {starter, kit.starter},
      {own / "visible/labs/framework/runner_main.cpp", objects / "main.o"},
      {sources.labs / "grading/crash_reporter.cpp", objects / "crash_reporter.o"}};
  std::vector<Result<void>> done(compiled.size() + 1);
  run_in_parallel(done.size(), [&](std::size_t i) {
    if (i == compiled.size()) {
      done[i] = compile_view(kit.compiler, sources, kit.view);
      return;
    }
    const auto& [source, object] = compiled[i];
    done[i] = (i == 1 ? all : visible).compile(source, object);
  });
  for (const auto& each : done) {
    if (!each) return each;
  }
  fs::remove_all(own, error);  // it contains the solution and the hidden cases
  make_readable_for_all(kit, directory);
  return {};
}

}  // namespace

Result<void> compile_lab_file(const std::string& compiler, const fs::path& source,
                              const std::vector<fs::path>& includes, const fs::path& object) {
  std::vector<std::string> words = lab_compile_command(compiler, includes);
  append(words, {"-c", source.string(), "-o", object.string()});
  const auto done = run_trusted_compiler(words);
  if (!done) return tl::unexpected(done.error());
  return {};
}

Result<void> compile_view(const std::string& compiler, const Sources& sources,
                          const fs::path& library) {
  std::vector<std::string> words = lab_compile_command(compiler, {});
  // Only the C library is named in it, because the compiler may have another C++ library of its
  // own.
  append(words,
         {"-shared", "-fPIC", "-fno-exceptions", "-Wl,--as-needed",
          (sources.labs / "grading/compiler_view.cpp").string(), "-o", library.string(), "-ldl"});
  const auto done = run_trusted_compiler(words);
  if (!done) return tl::unexpected(done.error());
  return {};
}

std::vector<fs::path> headers_of(const std::string& rule) {
  std::vector<fs::path> files = dependencies_of(rule);
  if (!files.empty()) files.erase(files.begin());  // the source file itself
  return files;
}

Result<BuildKit> make_build_kit(const Sources& sources, const std::string& folder,
                                const fs::path& directory) {
  const auto found = find_in_path(compiler());
  if (!found) return tl::unexpected(found.error());
  const auto parts = parts_of(sources, folder);
  if (!parts) return tl::unexpected(parts.error());
  const auto fingerprint = fingerprint_of(sources, *parts, *found);
  if (!fingerprint) return tl::unexpected(fingerprint.error());
  const std::string label = folder + ", " + *found + ", " + *fingerprint + "\n";
  remove_leftovers(directory);
  std::error_code error;
  if (!fs::exists(directory, error)) {
    // The kit is made in a directory beside `directory` and then renamed, so that it appears
    // complete. If another process was faster, the kit of that process is just as good.
    std::string beside = directory.string() + "-XXXXXX";
    fs::create_directories(directory.parent_path(), error);
    if (::mkdtemp(beside.data()) == nullptr)
      return fail(directory.string(), "cannot be made", "name a directory that can be written to");
    const auto filled = compile_kit(kit_in(beside, *found, *fingerprint), sources, *parts, beside);
    const auto labelled = filled ? write_if_changed(fs::path(beside) / "lab", label) : filled;
    if (labelled) fs::rename(beside, directory, error);
    std::error_code ignored;
    if (!labelled || error) fs::remove_all(beside, ignored);
    if (!labelled) return tl::unexpected(labelled.error());
  }
  const auto is = read_text_file(directory / "lab");
  if (is && *is == label) return kit_in(directory, *found, *fingerprint);
  return fail(directory.string(),
              "does not hold a kit (the lab's compiled files) for this lab, this compiler and this "
              "glassbox",
              "name another directory, or remove this directory");
}

Result<std::string> build_kit_fingerprint(const Sources& sources, const std::string& folder) {
  const auto found = find_in_path(compiler());
  if (!found) return tl::unexpected(found.error());
  const auto parts = parts_of(sources, folder);
  if (!parts) return tl::unexpected(parts.error());
  return fingerprint_of(sources, *parts, *found);
}

Result<BuildKit> copy_build_kit(const BuildKit& kit, const fs::path& directory) {
  BuildKit copy = kit;
  copy.include = directory / "include";
  std::error_code error;
  fs::create_directories(directory, error);
  fs::copy(kit.include, copy.include, fs::copy_options::recursive, error);
  if (error) return fail(directory.string(), error.message(), "free some space there");
  copy.view = directory / kView;
  fs::copy_file(kit.view, copy.view, fs::copy_options::overwrite_existing, error);
  if (error)
    return fail(kit.view.string(), "cannot be copied: " + error.message(),
                "remove the directory of this file, so that it is made again");
  make_readable_for_all(copy, directory);
  return copy;
}

// The compiler's arguments, except those for the output.
static std::vector<std::string> student_compile_arguments(const BuildKit& kit,
                                                          const CompileOptions& options,
                                                          const fs::path& build) {
  std::vector<std::string> words{kit.compiler};
  append(words, compiler_flags());
  append(words, clang_flags(kit.compiler));
  if (options.debugger) append(words, {"-O0", "-g"});
  if (options.timed) words.push_back("-O2");
  if (options.sanitize) append(words, sanitizer_flags());
  if (!options.debug_source_folder.empty())
    append(words, {"-g", fmt::format("-fdebug-prefix-map={}={}", build.string(),
                                     options.debug_source_folder)});
  // No warning about unused parameters, because the stubs of a starter do not use theirs.
  if (options.warnings) append(words, {"-Wall", "-Wextra", "-Wno-unused-parameter"});
  // The number of errors is limited: the first ones are the student's own, and later ones are often
  // caused by them.
  words.push_back(is_clang(kit.compiler) ? "-ferror-limit=10" : "-fmax-errors=10");
  // g++ quotes lines from the file that the last #line directive names, even if that is another
  // file, so a submission could make it show any file.
  if (!options.quotes)
    words.push_back(is_clang(kit.compiler) ? "-fno-caret-diagnostics"
                                           : "-fno-diagnostics-show-caret");
  append(words, {"-isystem", kit.include.string(), "-MD", "-MF", kFilesRead});
  return words;
}

std::vector<std::string> assembly_command(const BuildKit& kit, const CompileOptions& options,
                                          const fs::path& build) {
  std::vector<std::string> words = student_compile_arguments(kit, options, build);
  append(words, {"-S", kSource, "-o", kAssembly});
  return words;
}

std::vector<std::string> preprocessor_command(const BuildKit& kit, const CompileOptions& options,
                                              const fs::path& build) {
  std::vector<std::string> words = student_compile_arguments(kit, options, build);
  append(words, {"-E", "-H", kSource, "-o", kPreprocessed});
  return words;
}

std::vector<std::string> object_command(const BuildKit& kit) {
  std::vector<std::string> words{kit.compiler};
  if (is_clang(kit.compiler)) words.push_back("-fno-integrated-as");
  append(words, {"-c", kAssembly, "-o", kObject});
  return words;
}

std::vector<std::string> link_command(const BuildKit& kit, const std::vector<std::string>& objects,
                                      const std::string& program, const CompileOptions& options) {
  // -fno-lto: nothing in an object file can make the linker start a compiler (link-time
  // optimisation).
  std::vector<std::string> words{kit.compiler, "-fno-lto"};
  if (options.sanitize) {
    append(words, sanitizer_flags());
  } else {
    words.push_back("-static");  // so that the program starts without opening a file
  }
  if (!is_clang(kit.compiler)) words.push_back("-fno-use-linker-plugin");
  append(words, objects);
  append(words, {"-o", program});
  return words;
}

}  // namespace glassbox::labs::grading
