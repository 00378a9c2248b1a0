#include <glassbox/compare/pictures/approve.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

namespace fs = std::filesystem;

namespace {

// The file's size needs no limit here, because read_stored has already checked the file.
constexpr std::uint64_t kAnySize = ~std::uint64_t(0) - 1;

}  // namespace

bool on_ci_server() {
  const char* value = std::getenv("CI");
  return value != nullptr && *value != '\0';
}

Result<void> approve_picture(const std::string& reference, const std::string& test) {
  if (on_ci_server()) {
    return fail("", "the environment variable CI is set, and a server cannot approve pictures",
                "look at the picture and approve it on your own machine");
  }
  const std::string kind = fs::path(reference).extension().string();
  const std::string test_kind = fs::path(test).extension().string();
  if (kind != test_kind) {
    return tl::unexpected(Error{test, "",
                                "a " + in_quotes(test_kind) + " file cannot replace the " +
                                    in_quotes(kind) + " file " + in_quotes(reference),
                                "give both names the same extension"});
  }
  if (const auto image = read_stored(test); !image) return tl::unexpected(image.error());
  const auto bytes = read_file(test, kAnySize);
  if (!bytes) return tl::unexpected(bytes.error());
  std::error_code error;
  const fs::path folder = fs::path(reference).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) {
    return tl::unexpected(Error{folder.string(), "", "cannot be created: " + error.message(),
                                "check the permissions"});
  }
  return write_file(reference, *bytes);
}

}  // namespace glassbox
