#include "labs/grading/kit.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "labs/framework/build.h"
#include "labs/framework/process.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

// As `lab check` compiles, but for the debugger's information. The whole program is static, so that it starts without opening
// a file.
const std::vector<std::string>& flags() {
  static const std::vector<std::string> words{"-std=c++20", "-O1", "-ffp-contract=off", "-static"};
  return words;
}

// The option by which a compiler stops after ten errors.
std::string ten_errors(const std::string& compiler) {
  const bool is_clang = fs::path(compiler).filename().string().find("clang") != std::string::npos;
  return is_clang ? "-ferror-limit=10" : "-fmax-errors=10";
}

Result<std::string> path_of(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* path = std::getenv("PATH");
  std::istringstream places(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string place; std::getline(places, place, ':');) {
    const std::string candidate = place + "/" + program;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return fail(program, "is not to be found in PATH",
              "install a C++20 compiler, or name one in the environment variable CXX");
}

Result<std::string> call(const std::vector<std::string>& words) {
  const ProcessOutcome outcome = run_process(words, {120, 0, std::size_t(1) << 20});
  if (outcome.started && !outcome.timed_out && WIFEXITED(outcome.status) &&
      WEXITSTATUS(outcome.status) == 0)
    return outcome.said;
  return fail(
      "the lab's own files",
      fmt::format("do not compile: {}", outcome.started ? outcome.said : outcome.why_not_started),
      "install a C++20 compiler with its static libraries, or build glassbox again");
}

// Copies what lies in `from` to the same place in `to`; false if it does not lie there.
Result<bool> copy_below(const fs::path& file, const fs::path& from, const fs::path& to) {
  const fs::path relative = file.lexically_normal().lexically_relative(from.lexically_normal());
  if (relative.empty() || *relative.begin() == "..") return false;
  const auto text = read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  const auto written = write_if_changed(to / relative, *text);
  if (!written) return tl::unexpected(written.error());
  return true;
}

Kit kit_in(const fs::path& directory, const std::string& compiler) {
  Kit kit;
  kit.compiler = compiler;
  kit.readable = directory / "for-students";
  kit.include = kit.readable / "include";
  for (const char* name : {"checks.o", "main.o", "witness.o"})
    kit.objects.push_back(kit.readable / "objects" / name);
  return kit;
}

// Whatever the mask of the caller: the user that compiles is another.
void open_to_all(const Kit& kit, const fs::path& directory) {
  using fs::perms;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(kit.readable, error), end; !error && entry != end;
       entry.increment(error)) {
    perms added = perms::group_read | perms::others_read;
    if (entry->is_directory()) added |= perms::group_exec | perms::others_exec;
    std::error_code ignored;
    fs::permissions(entry->path(), added, fs::perm_options::add, ignored);
  }
  for (const fs::path& path : {directory, kit.readable})
    fs::permissions(path, perms(0755), fs::perm_options::replace, error);
}

Result<void> fill(const Kit& kit, const Sources& sources, const std::string& folder,
                  const fs::path& directory) {
  const fs::path own = directory / "own";
  std::error_code error;
  fs::create_directories(kit.readable / "objects", error);
  fs::create_directories(kit.include, error);
  auto files = support_files(sources, folder, true);
  if (!files) return tl::unexpected(files.error());
  const auto solution = solution_text(sources, folder);
  if (!solution) return tl::unexpected(solution.error());
  files->push_back({"student.cpp", *solution});
  for (const SourceFile& file : *files) {
    if (const auto written = write_if_changed(own / file.path, file.text); !written) return written;
  }
  std::vector<std::string> words{kit.compiler};
  words.insert(words.end(), flags().begin(), flags().end());
  words.insert(words.end(), {"-I", own.string(), "-I", sources.include.string()});

  std::vector<std::string> listing = words;
  listing.insert(listing.end(), {"-MM", (own / "student.cpp").string()});
  const auto rule = call(listing);
  if (!rule) return tl::unexpected(rule.error());
  for (const fs::path& header : headers_of(*rule)) {
    for (const fs::path& root : {own, sources.include}) {
      const auto copied = copy_below(header, root, kit.include);
      if (!copied) return tl::unexpected(copied.error());
      if (*copied) break;
    }
  }
  const std::vector<fs::path> compiled{own / "runner.cpp", own / "labs/framework/runner_main.cpp",
                                       sources.labs / "grading/witness.cpp"};
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    std::vector<std::string> compiling = words;
    compiling.insert(compiling.end(), {"-c", compiled[i].string(), "-o", kit.objects[i].string()});
    if (const auto done = call(compiling); !done) return tl::unexpected(done.error());
  }
  // With the solution in it.
  fs::permissions(own, fs::perms::owner_all, fs::perm_options::replace, error);
  open_to_all(kit, directory);
  return {};
}

}  // namespace

std::vector<fs::path> headers_of(const std::string& rule) {
  std::vector<fs::path> files = dependencies_of(rule);
  if (!files.empty()) files.erase(files.begin());  // the source
  return files;
}

Result<Kit> make_kit(const Sources& sources, const std::string& folder, const fs::path& directory) {
  const auto found = path_of(compiler());
  if (!found) return tl::unexpected(found.error());
  const std::string label = folder + ", " + *found + "\n";
  std::error_code error;
  if (!fs::exists(directory, error)) {
    // Beside its place, and renamed into it. Where another was faster, its kit is as good.
    std::string beside = directory.string() + "-XXXXXX";
    fs::create_directories(directory.parent_path(), error);
    if (::mkdtemp(beside.data()) == nullptr)
      return fail(directory.string(), "cannot be made", "name a place that can be written to");
    const auto filled = fill(kit_in(beside, *found), sources, folder, beside);
    const auto labelled = filled ? write_if_changed(fs::path(beside) / "lab", label) : filled;
    if (labelled) fs::rename(beside, directory, error);
    std::error_code ignored;
    if (!labelled || error) fs::remove_all(beside, ignored);
    if (!labelled) return tl::unexpected(labelled.error());
  }
  const auto is = read_text_file(directory / "lab");
  if (is && *is == label) return kit_in(directory, *found);
  return fail(directory.string(), "is no kit of this lab and compiler",
              "name another directory, or remove this one");
}

Result<Kit> copy_kit(const Kit& kit, const fs::path& directory) {
  const Kit copy = kit_in(directory, kit.compiler);
  std::error_code error;
  fs::create_directories(directory, error);
  fs::copy(kit.readable, copy.readable, fs::copy_options::recursive, error);
  if (error) return fail(directory.string(), error.message(), "free some space there");
  open_to_all(copy, directory);
  return copy;
}

std::vector<std::string> compile_command(const Kit& kit, const std::string& source,
                                         const std::string& program) {
  std::vector<std::string> words{kit.compiler};
  words.insert(words.end(), flags().begin(), flags().end());
  words.insert(words.end(), {ten_errors(kit.compiler), "-I", kit.include.string(), source});
  for (const fs::path& object : kit.objects) words.push_back(object.string());
  words.insert(words.end(), {"-MD", "-MF", kFilesRead, "-o", program});
  return words;
}

}  // namespace glassbox::labs::grading
