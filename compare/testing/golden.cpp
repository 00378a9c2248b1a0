#include <glassbox/compare/testing/golden.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <variant>

#include <glassbox/compare/testing/picture_bytes.h>
#include <glassbox/compare/testing/run_diff.h>

namespace glassbox {
namespace golden {
namespace {

namespace fs = std::filesystem;

// ---- what the user asks for ----

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

bool approval_requested() {
  const char* value = environment("GLASSBOX_APPROVE");
  return value != nullptr && std::string(value) != "0";
}

fs::path golden_path(const std::string& golden, const std::string& source_file) {
  return fs::absolute(fs::path(source_file).parent_path() / golden).lexically_normal();
}

// The path for the files of a failure: the golden's name below the folder of failures. An absolute
// path is reduced to its last part, and a relative one loses its ".." parts.
fs::path failure_path(const std::string& golden) {
  const char* folder = environment("GLASSBOX_FAILURES");
  const fs::path name(golden);
  fs::path below;
  for (const fs::path& part : name.is_absolute() ? name.filename() : name.lexically_normal()) {
    if (part != "..") below /= part;
  }
  const fs::path failures(folder != nullptr ? folder : "golden-failures");
  return (fs::absolute(failures) / below).lexically_normal();
}

// ---- files. These functions return what went wrong, or an empty text ----

std::string read_bytes(const fs::path& path, Bytes& bytes) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);  // an error for what is no regular file
  if (!error) {
    bytes.resize(std::size_t(size));
    std::ifstream in(path, std::ios::binary);
    if (in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size))) return "";
  }
  return path.string() + ": cannot be read; check the name and the permissions";
}

// Writes beside the file and renames, so that nobody reads half a picture.
std::string write_bytes(const fs::path& path, const Bytes& bytes) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) {
    return path.parent_path().string() + ": cannot be created: " + error.message() +
           "; check the permissions";
  }
  const fs::path beside = path.string() + "." + std::to_string(::getpid()) + ".tmp";
  std::ofstream out(beside, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out.close();
  if (out) fs::rename(beside, path, error);
  if (out && !error) return "";
  fs::remove(beside, error);
  return path.string() + ": cannot be written; check the permissions and the disk";
}

// ---- the picture, which is in memory or in a file ----

// What the test has made: the content of a picture in memory, or the bytes of a file.
using Made = std::variant<Content, Bytes>;

// Like the functions above, `take` and `write` return what went wrong, or an empty text.
std::string take(const PictureView& picture, const fs::path& golden, Made& made) {
  const std::string extension = golden.extension().string();
  const std::string why_not = why_not_stored(picture, extension);
  if (!why_not.empty()) return golden.string() + ": " + why_not;
  made = content_of(picture, extension);
  return "";
}
std::string take(const PictureFile& picture, const fs::path&, Made& made) {
  return read_bytes(picture.path, made.emplace<Bytes>());
}

// The fast check for equal pictures, which writes no file and starts no program.
bool is_same(const Made& made, const fs::path& golden) {
  Bytes expected;
  if (!read_bytes(golden, expected).empty()) return false;
  const Content* content = std::get_if<Content>(&made);
  return content != nullptr ? is_stored_in(expected, *content) : expected == std::get<Bytes>(made);
}

std::string write(const Made& made, const fs::path& path) {
  const Content* content = std::get_if<Content>(&made);
  if (content != nullptr) return write_bytes(path, encode(*content));
  return write_bytes(path, std::get<Bytes>(made));
}

// Whether the golden image would be compared with itself, which no test can fail.
bool is_golden_itself(const PictureView&, const fs::path&) {
  return false;
}
bool is_golden_itself(const PictureFile& picture, const fs::path& golden) {
  std::error_code ignored;
  return fs::equivalent(picture.path, golden, ignored);
}

// ---- what a failure leaves ----

struct FailureFiles {
  fs::path picture, heat, page;
};

FailureFiles failure_files(const fs::path& test) {
  return {test, fs::path(test).replace_extension(".heat.png"),
          fs::path(test).replace_extension(".html")};
}

// A test that passes removes the files of an earlier failure.
void remove(const FailureFiles& files) {
  std::error_code ignored;
  for (const fs::path& file : {files.picture, files.heat, files.page}) fs::remove(file, ignored);
}

// Has the heat map and the page written beside the test's picture, and returns text that says where
// they are. There is no heat map of pictures that cannot be compared pixel by pixel.
std::string write_failure_files(const FailureFiles& files, const fs::path& golden,
                                const std::string& program) {
  std::error_code ignored;
  fs::remove(files.heat, ignored);
  fs::remove(files.page, ignored);
  const DiffRun run = run_diff(program, {golden.string(), files.picture.string(), "-o",
                                         files.heat.string(), "--html", files.page.string()});
  std::string text = "  picture: " + files.picture.string() + "\n";
  if (fs::exists(files.heat, ignored)) text += "  heat map: " + files.heat.string() + "\n";
  const bool has_page = fs::exists(files.page, ignored);
  return text + (has_page ? "  page: " + files.page.string() + "\n" : "  no page: " + run.text);
}

// ---- the verdict ----

GoldenOutcome approve(const FailureFiles& files, const fs::path& golden,
                      const std::string& program) {
  if (environment("CI") != nullptr) {
    return {false,
            "not approved: the environment variable CI is set, and a server cannot approve "
            "pictures; look at " +
                files.picture.string() + " and approve it on your own machine"};
  }
  const DiffRun run = run_diff(program, {golden.string(), files.picture.string(), "--approve"});
  if (run.exit_code != 0) return {false, "not approved: " + run.text};
  remove(files);
  return {true, "approved as the golden image " + golden.string()};
}

template <class Picture>
GoldenOutcome check(const Picture& picture, const std::string& golden_name,
                    const std::string& source_file, const std::string& installed) {
  const fs::path golden = golden_path(golden_name, source_file);
  const FailureFiles files = failure_files(failure_path(golden_name));
  if (is_golden_itself(picture, golden)) {
    return {false,
            golden.string() + ": is compared with itself; write the picture to another file"};
  }
  // The files of failures are written and deleted without approval.
  if (is_golden_itself(PictureFile{files.picture.string()}, golden) || files.picture == golden) {
    return {false, golden.string() +
                       ": failures would be written over the golden image; name another folder in "
                       "GLASSBOX_FAILURES"};
  }
  Made made;
  if (const std::string wrong = take(picture, golden, made); !wrong.empty()) {
    return {false, wrong};
  }
  if (is_same(made, golden)) {
    remove(files);
    return {true, "equals the golden image " + golden.string()};
  }
  if (const std::string wrong = write(made, files.picture); !wrong.empty()) {
    return {false, wrong};
  }

  const char* other = environment("GLASSBOX_PROGRAM");
  const std::string program = other != nullptr ? other : installed;
  std::error_code ignored;
  const bool is_new = !fs::exists(golden, ignored);
  // For a picture without a reference, the program would name its own option of approval.
  const DiffRun run = is_new ? DiffRun{2, "there is no such reference yet\n"}
                             : run_diff(program, {golden.string(), files.picture.string()});
  if (run.exit_code < 0) return {false, "not compared: " + run.text};
  if (run.exit_code == 0) {
    remove(files);
    return {true, "matches the golden image " + golden.string() + "\n  " + run.text};
  }
  if (approval_requested()) return approve(files, golden, program);
  return {false, "does not match the golden image " + golden.string() + "\n  " + run.text +
                     write_failure_files(files, golden, program) +
                     "  If the picture is right, run the test again with GLASSBOX_APPROVE=1."};
}

}  // namespace
}  // namespace golden

GoldenOutcome check_golden(const PictureView& picture, const std::string& golden,
                           const std::string& source_file, const std::string& program) {
  return golden::check(picture, golden, source_file, program);
}

GoldenOutcome check_golden(const PictureFile& picture, const std::string& golden,
                           const std::string& source_file, const std::string& program) {
  return golden::check(picture, golden, source_file, program);
}

}  // namespace glassbox
