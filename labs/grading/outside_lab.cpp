#include "labs/grading/outside_lab.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "labs/framework/compiler.h"
#include "labs/framework/digest.h"
#include "labs/framework/student_version.h"
#include "labs/grading/program_digest.h"

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNeeded[] = {"handout.md", "student.h",  "student.cpp",
                                   "cases.h",    "runner.cpp", "checks.cpp"};

// Whether the file is a source of the judge. Files that are compiled with a student's code, or that
// draw, are not.
bool is_of_judge(const fs::path& file) {
  const std::string name = file.filename().string();
  return file.extension() == ".cpp" && name != "student.cpp" && name != "runner.cpp" &&
         name != "stages.cpp" && name != "drawing.cpp" && name != "timed.cpp" &&
         name != "measured.cpp";
}

// The judge's sources, and every header that they may include, in an order that is the same
// everywhere.
Result<std::vector<fs::path>> files_of_judge(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (is_of_judge(at->path()) || at->path().extension() == ".h") files.push_back(at->path());
  }
  if (error) return fail(folder.string(), error.message(), "check the folder's permissions");
  std::sort(files.begin(), files.end());
  return files;
}

std::string number_of(const fs::path& folder) {
  return folder.filename().string().substr(0, 2);
}

// The name of the function that is looked up in the compiled judge; it has C linkage.
std::string entry_point(const fs::path& folder) {
  return fmt::format(
      "#include \"labs/framework/lab.h\"\n"
      "namespace glassbox::labs {{ Lab lab_{0}(); }}\n"
      "extern \"C\" void glassbox_lab(glassbox::labs::Lab* lab) {{\n"
      "  *lab = glassbox::labs::lab_{0}();\n"
      "}}\n",
      number_of(folder));
}

// With -Bsymbolic and -fno-gnu-unique the folder's code calls its own functions, even where the
// program has a function of the same name, as it has if the folder is a changed copy of one of the
// program's labs. The flags for floating-point arithmetic are those of the program.
std::vector<std::string> compile_words(const Sources& sources, const std::vector<fs::path>& files,
                                       const fs::path& entry, const fs::path& made) {
  std::vector<std::string> words{compiler(),
                                 "-std=c++20",
                                 "-O1",
                                 "-DFMT_SHARED",
                                 "-fPIC",
                                 "-ffp-contract=off",
                                 "-w",
                                 "-shared",
                                 "-I",
                                 sources.outside,
                                 "-I",
                                 sources.labs.parent_path(),
                                 "-I",
                                 sources.include,
                                 "-Wl,-Bsymbolic"};
  if (words[0].find("clang") == std::string::npos) words.push_back("-fno-gnu-unique");
  for (const fs::path& file : files) {
    if (file.extension() == ".cpp") words.push_back(file);
  }
  words.insert(words.end(), {entry.string(), "-o", made.string()});
  return words;
}

Result<void> compile_judge(const Sources& sources, const fs::path& place, const fs::path& library) {
  const auto files = files_of_judge(sources.outside);
  if (!files) return tl::unexpected(files.error());
  std::error_code error;
  fs::create_directories(place, error);
  fs::permissions(place, fs::perms::owner_all, fs::perm_options::replace, error);
  // The library is made in a directory of its own and then renamed, so that it appears complete.
  std::string beside = (place / "judge-XXXXXX").string();
  if (::mkdtemp(beside.data()) == nullptr)
    return fail(place.string(), "cannot be written", "check the directory's permissions and space");
  const fs::path entry = fs::path(beside) / "entry.cpp", made = fs::path(beside) / "judge.so";
  auto done = write_if_changed(entry, entry_point(sources.outside));
  if (done) {
    const ProcessOutcome outcome =
        run_process(compile_words(sources, *files, entry, made), {300, 0, std::size_t(64) << 10});
    if (!outcome.started || outcome.timed_out || !WIFEXITED(outcome.status) ||
        WEXITSTATUS(outcome.status) != 0)
      done = fail(sources.outside.string(),
                  "the lab's checks do not compile: " +
                      (outcome.started ? outcome.printed : outcome.why_not_started),
                  "correct the file that the compiler names");
  }
  if (done) {
    fs::rename(made, library, error);
    if (error) done = fail(library.string(), error.message(), "check the directory's permissions");
  }
  fs::remove_all(beside, error);
  return done;
}

auto checks_file_error(const Sources& sources, const std::string& cause,
                       const std::string& what_to_do) {
  return fail((sources.outside / "checks.cpp").string(), cause, what_to_do);
}

// Checks that the lab's folder, number, tasks and checks are as the points and reports expect.
Result<void> check_consistency(const Sources& sources, const Lab& lab) {
  const std::string folder = sources.outside.filename().string();
  if (lab.folder != folder)
    return checks_file_error(
        sources,
        fmt::format("the lab says that its folder is called \"{}\", but it has another name",
                    lab.folder),
        fmt::format("write \"{}\", the name of the folder", folder));
  if (lab.number != std::stoi(number_of(sources.outside)))
    return checks_file_error(
        sources,
        fmt::format("the lab's number is {}, but its folder's name begins with another number",
                    lab.number),
        "write the number that the folder's name begins with");
  if (lab.tasks.empty() || lab.checks.empty())
    return checks_file_error(sources, "the lab has no task or no check",
                             "give the lab at least one task and one check");
  for (const Check& check : lab.checks) {
    const auto is_its = [&](const Task& task) { return task.id == check.task; };
    if (std::none_of(lab.tasks.begin(), lab.tasks.end(), is_its))
      return checks_file_error(
          sources,
          fmt::format("the check \"{}\" belongs to task {}, which does not exist", check.name,
                      check.task),
          "name one of the lab's tasks");
  }
  return {};
}

}  // namespace

Result<fs::path> find_outside_lab(const std::string& folder) {
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  if (error || !fs::is_directory(place, error))
    return fail(folder, "is not a folder", "name the folder of a lab, NN-name");
  if (!is_lab_path(fs::path("labs") / place.filename()))
    return fail(folder, "does not have the name of a lab", "name it NN-name, such as 40-fog");
  for (const char* name : kNeeded) {
    if (!fs::is_regular_file(place / name, error))
      return fail((fs::path(folder) / name).string(), "does not exist",
                  "docs/labs.md says which files a lab needs");
  }
  return place;
}

Result<std::string> judge_digest(const Sources& sources) {
  const auto files = files_of_judge(sources.outside);
  if (!files) return tl::unexpected(files.error());
  Digest digest;
  digest.add(program_digest()).add(compiler());
  for (const fs::path& file : *files) {
    const auto text = read_text_file(file);
    if (!text) return text;
    digest.add(file.filename().string()).add(*text);
  }
  return digest.text();
}

Result<const Lab*> load_outside_lab(const Sources& sources, const fs::path& place) {
  const auto digest = judge_digest(sources);
  if (!digest) return tl::unexpected(digest.error());
  const fs::path library = fs::absolute(place) / (*digest + ".so");
  std::error_code error;
  if (!fs::exists(library, error)) {
    const auto compiled = compile_judge(sources, fs::absolute(place), library);
    if (!compiled) return tl::unexpected(compiled.error());
  }
  void* const loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr)
    return checks_file_error(
        sources, fmt::format("the lab's compiled checks cannot be loaded: {}", ::dlerror()),
        "call only functions that lab.h, compare.h and glassbox's headers declare");
  using Make = void (*)(Lab*);
  const auto make = reinterpret_cast<Make>(::dlsym(loaded, "glassbox_lab"));
  if (make == nullptr)
    return checks_file_error(sources, ::dlerror(), "remove the file " + library.string());
  // The lab's checks are functions of the loaded library, so the lab and the library stay until the
  // program ends.
  static std::vector<std::unique_ptr<Lab>> kept;
  auto lab = std::make_unique<Lab>();
  make(lab.get());
  if (const auto whole = check_consistency(sources, *lab); !whole)
    return tl::unexpected(whole.error());
  kept.push_back(std::move(lab));
  return kept.back().get();
}

}  // namespace glassbox::labs::grading
