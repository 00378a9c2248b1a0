// Restricts the files that a process may reach (Landlock, Linux 5.13 and later), for machines that
// cannot give it a file system of its own.
#pragma once

#include <filesystem>
#include <vector>

namespace glassbox::labs::grading {

// A set of rules in the kernel, which exists as long as its file descriptor is open.
class FileRules {
public:
  FileRules() = default;
  // Allows reading and executing only in `readable`, and writing only in `writable`; each path
  // includes everything below it. Paths that do not exist are ignored.
  FileRules(const std::vector<std::filesystem::path>& readable,
            const std::vector<std::filesystem::path>& writable);
  ~FileRules();
  FileRules(const FileRules&) = delete;
  FileRules& operator=(const FileRules&) = delete;

  bool valid() const { return ruleset_ >= 0; }
  int descriptor() const { return ruleset_; }

private:
  int ruleset_ = -1;
};

bool can_restrict_files();

// Restricts the calling process by the rules, permanently. The process must have set no_new_privs.
// Allocates nothing, so it can be used after fork.
bool apply_file_rules(int descriptor);

}  // namespace glassbox::labs::grading
