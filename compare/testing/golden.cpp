#include <glassbox/compare/testing/golden.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <variant>

#include <glassbox/compare/pictures/approve.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/sidecar.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/compare/report/page.h>
#include <glassbox/compare/report/text.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

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
  return fs::absolute(folder != nullptr ? fs::path(folder) : fs::path("golden-failures")) / below;
}

Result<std::vector<std::byte>> encode(const StoredImage& image, const fs::path& golden) {
  if (golden.extension() == ".png") return encode_png(image);
  if (golden.extension() == ".pfm") return encode_pfm(image);
  return tl::unexpected(Error{golden.string(), "", "a golden image is a .png or a .pfm file",
                              "end its name in .png or .pfm"});
}

Result<void> make_folder_of(const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (!error) return {};
  return tl::unexpected(Error{file.parent_path().string(), "",
                              "cannot be created: " + error.message(), "check the permissions"});
}

Result<void> save_picture(const Result<std::vector<std::byte>>& bytes, const fs::path& file) {
  if (!bytes) return tl::unexpected(bytes.error());
  if (const auto made = make_folder_of(file); !made) return made;
  return write_file(file.string(), *bytes);
}

Result<void> save_picture(const StoredImage& image, const fs::path& file) {
  return save_picture(encode(image, file), file);
}

Result<void> save_picture(const PictureFile& picture, const fs::path& file) {
  return save_picture(read_file(picture.path), file);
}

// The fast check for equal pictures, which writes no file.
bool is_same(const StoredImage& image, const fs::path& golden) {
  const auto expected = read_stored(golden.string());
  return expected && *expected == image;
}

bool is_same(const PictureFile& picture, const fs::path& golden) {
  const auto image = read_stored(picture.path);
  return image && is_same(*image, golden);
}

Comparison compare_with_golden(const fs::path& golden, const fs::path& test) {
  std::error_code ignored;
  Comparison comparison = compare_pair({golden.filename().string(), golden.string(), test.string(),
                                        fs::exists(golden, ignored), true});
  // The remedy of glassbox diff, its approval option, does not exist here; the message ends with
  // how to approve.
  if (comparison.verdict == Verdict::kNew) comparison.error->remedy = "look at " + test.string();
  return comparison;
}

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

// Writes the heat map and the page beside the test's picture, and returns text that says where they
// are.
std::string write_failure_files(const FailureFiles& files, const Comparison& comparison) {
  std::string text = "  picture: " + files.picture.string() + "\n";
  const auto tell = [&text](const std::string& what, const fs::path& file,
                            const Result<void>& written) {
    text += "  " + what + ": " + (written ? file.string() : written.error().message()) + "\n";
  };
  if (comparison.differences) {
    tell("heat map", files.heat, write_heat_map(files.heat.string(), comparison));
  }
  PageOptions options;
  options.title = comparison.name;
  tell("page", files.page, write_page(files.page.string(), std::span(&comparison, 1), options));
  return text;
}

GoldenOutcome approve_golden(const fs::path& golden, const FailureFiles& files) {
  if (const auto done = approve_picture(golden.string(), files.picture.string()); !done) {
    return {false, "not approved: " + done.error().message()};
  }
  remove(files);
  return {true, "approved as the golden image " + golden.string()};
}

template <class Picture>
GoldenOutcome check(const Picture& picture, const std::string& golden_name,
                    const std::string& source_file) {
  const fs::path golden = golden_path(golden_name, source_file);
  const FailureFiles files = failure_files(failure_path(golden_name));
  if (is_same(picture, golden)) {
    remove(files);
    return {true, "equals the golden image " + golden.string()};
  }
  if (const auto kept = save_picture(picture, files.picture); !kept) {
    return {false, kept.error().message()};
  }
  const Comparison comparison = compare_with_golden(golden, files.picture);
  if (passes(comparison.verdict)) {
    remove(files);
    return {true,
            "matches the golden image " + golden.string() + "\n" + comparison_details(comparison)};
  }
  if (approval_requested()) return approve_golden(golden, files);
  return {false, "does not match the golden image " + golden.string() + "\n  " +
                     comparison_line(comparison) + "\n" + comparison_details(comparison) +
                     write_failure_files(files, comparison) +
                     "  If the picture is right, run the test again with GLASSBOX_APPROVE=1."};
}

}  // namespace

GoldenOutcome check_golden(const StoredImage& image, const std::string& golden,
                           const std::string& source_file) {
  return check(image, golden, source_file);
}

GoldenOutcome check_golden(const PictureFile& picture, const std::string& golden,
                           const std::string& source_file) {
  return check(picture, golden, source_file);
}

}  // namespace glassbox
