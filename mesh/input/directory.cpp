#include <glassbox/mesh/input/directory.h>

#include <algorithm>
#include <system_error>

#include <glassbox/images/read.h>
#include <glassbox/mesh/input/text.h>

namespace glassbox::obj {
namespace {

namespace fs = std::filesystem;

bool is_absolute(std::string_view name) {
  return name.starts_with('/') || (name.size() >= 2 && name[1] == ':');
}

// Whether the name, taken as text, leaves the directory in which it starts. Names that stay inside
// are accepted, even with ".." in them; the effect of links is checked with the canonical path.
bool climbs_out(std::string_view name) {
  int depth = 0;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, end);
    if (part == "..") {
      if (--depth < 0) return true;
    } else if (!part.empty() && part != ".") {
      ++depth;
    }
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

bool is_inside(const fs::path& path, const fs::path& root) {
  return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

}  // namespace

Directory::Directory(const fs::path& file, const char* kind, std::uint64_t max_bytes)
    : owner_(std::string("the ") + kind + " file"), bytes_left_(max_bytes) {
  std::error_code error;
  root_ = fs::canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), error);
  if (error) root_.clear();
}

Result<fs::path> Directory::find(std::string_view name) const {
  const auto refuse = [&](const std::string& cause) {
    return fail("", "the file " + in_quotes(name) + " " + cause,
                "put it beside " + owner_ + " and name it by a relative path");
  };
  // No file system accepts paths longer than this, and none accepts a NUL in a path.
  constexpr std::size_t kMaxLength = 4096;
  if (root_.empty() || name.empty() || name.size() > kMaxLength ||
      name.find('\0') != std::string_view::npos) {
    return refuse("does not exist");
  }
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (is_absolute(slashed)) return refuse("is an absolute path, which is not followed");
  if (climbs_out(slashed)) return refuse("lies outside the directory of " + owner_);
  std::error_code error;
  const fs::path path = fs::canonical(root_ / slashed, error);
  if (error) return refuse("does not exist");
  if (!is_inside(path, root_)) return refuse("lies outside the directory of " + owner_);
  if (!fs::is_regular_file(path, error)) return refuse("is not a regular file");
  return path;
}

Result<std::vector<std::byte>> Directory::read(const fs::path& found) {
  auto bytes = read_file(found.string(), bytes_left_);
  if (bytes) bytes_left_ -= std::min<std::uint64_t>(bytes_left_, bytes->size());
  return bytes;
}

}  // namespace glassbox::obj
