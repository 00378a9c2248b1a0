#include "labs/grading/landlock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#define GLASSBOX_HAS_LANDLOCK 1
#endif

namespace glassbox::labs::grading {

#ifdef GLASSBOX_HAS_LANDLOCK

namespace {

// glibc has no functions for these system calls.
long create_ruleset(const landlock_ruleset_attr* rules, std::size_t size, std::uint32_t flags) {
  return ::syscall(SYS_landlock_create_ruleset, rules, size, flags);
}

// The access rights of Landlock's first version, which every kernel with Landlock knows.
constexpr std::uint64_t kReading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kEverything =
    kReading | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
    LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
    LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
    LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
constexpr std::uint64_t kOfFiles =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;

bool allow(int ruleset, const std::filesystem::path& path, std::uint64_t access) {
  const int opened = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (opened < 0) return true;  // a path that does not exist cannot be reached anyway
  struct stat status = {};
  if (::fstat(opened, &status) == 0 && !S_ISDIR(status.st_mode)) access &= kOfFiles;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = access;
  rule.parent_fd = opened;
  const long added =
      ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  ::close(opened);
  return added == 0;
}

}  // namespace

FileRules::FileRules(const std::vector<std::filesystem::path>& readable,
                     const std::vector<std::filesystem::path>& writable) {
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = kEverything;
  const int created = static_cast<int>(create_ruleset(&rules, sizeof rules, 0));
  if (created < 0) return;
  // The descriptor gets a number of at least 10, because a process that is started gets descriptors
  // with smaller numbers, which would overwrite it.
  ruleset_ = ::fcntl(created, F_DUPFD_CLOEXEC, 10);
  ::close(created);
  if (ruleset_ < 0) return;
  bool fine = allow(ruleset_, "/dev/null", kEverything);
  for (const auto& path : readable) fine = allow(ruleset_, path, kReading) && fine;
  for (const auto& path : writable) fine = allow(ruleset_, path, kEverything) && fine;
  if (fine) return;
  ::close(ruleset_);
  ruleset_ = -1;
}

bool can_restrict_files() {
  return create_ruleset(nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
}

bool apply_file_rules(int descriptor) {
  return ::syscall(SYS_landlock_restrict_self, descriptor, 0) == 0;
}

#else

FileRules::FileRules(const std::vector<std::filesystem::path>&,
                     const std::vector<std::filesystem::path>&) {}
bool can_restrict_files() {
  return false;
}
bool apply_file_rules(int) {
  return false;
}

#endif

FileRules::~FileRules() {
  if (ruleset_ >= 0) ::close(ruleset_);
}

}  // namespace glassbox::labs::grading
